# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Segmentations on one, two and four ranks: walls stay closed where ranks meet and are as smooth there, voxels keep their labels.

What the ranks wrote is joined and checked here: by the certificate against the surface before smoothing, and by the voxel check
against the segmentation.
"""

import math
import unittest

from bonedecimate import vtkBoneSurfaces, vtkBoneVoxelCheck
from vtkmodules.vtkCommonDataModel import vtkPolyData

import cases
import label_images
import specimens
from parallel_runs import RANKS, bad_edges, distance, is_proved, joined, parts, report_of

GUARDED = ("label-smoothed", "label-image", "label-images", "label-error", "label-crumbs", "label-kept", "label-preset",
           "label-thesis", "label-millimeters")


def changed_voxels(surface, image):
    check = vtkBoneVoxelCheck()
    check.SetInputData(0, surface)
    check.SetInputData(1, image)
    check.Update()
    assert check.GetNumberOfComparedVoxels() >= math.prod(label_images.SIZE)
    return check.GetNumberOfChangedVoxels()


def one_label(surface, label):
    single = vtkPolyData()
    assert vtkBoneSurfaces.ExtractLabel(surface, label, single)
    return single


def corners_of(surface):
    """The triangles as positions, in no order, each with its labels."""
    labels = surface.GetCellData().GetArray("BoundaryLabels")
    triangles = []
    for number, ids in enumerate(specimens.triangles_of(surface)):
        corners = [surface.GetPoint(i) for i in ids]
        first = corners.index(min(corners))
        triangles.append((labels.GetTuple(number), *corners[first:], *corners[:first]))
    return sorted(triangles)


def angles(surface, positions, reach):
    """Mean angles in degrees between neighbors of the same labels: near the positions, and far from them."""
    normals, pairs = {}, {}
    labels = surface.GetCellData().GetArray("BoundaryLabels")
    for number, ids in enumerate(specimens.triangles_of(surface)):
        a, b, c = (surface.GetPoint(i) for i in ids)
        u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        length = math.hypot(*n)
        normals[number] = [x / length for x in n] if length > 0 else None
        for k in range(3):
            pairs.setdefault(frozenset((ids[k], ids[(k + 1) % 3])), []).append(number)
    near, far = [], []
    for edge, both in pairs.items():
        if len(both) == 2 and labels.GetTuple(both[0]) == labels.GetTuple(both[1]) and all(normals[i] for i in both):
            ends = [surface.GetPoint(i) for i in edge]
            middle = [sum(values) / 2 for values in zip(*ends)]
            cosine = sum(x * y for x, y in zip(*(normals[i] for i in both)))
            there = min(math.dist(middle, position) for position in positions) < reach
            (near if there else far).append(math.degrees(math.acos(max(-1.0, min(1.0, cosine)))))
    return sum(near) / len(near), sum(far) / len(far)


def shared_positions(surfaces):
    """Of points that more than one surface has."""
    seen = [{surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())} for surface in surfaces]
    return {point for i, points in enumerate(seen) for point in points if any(point in other for other in seen[:i])}


class ParallelLabels(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cases = cases.label_cases()
        cls.image = label_images.image()
        extract = vtkBoneSurfaces()
        extract.SetInputData(cls.image)
        extract.Update()
        cls.before = extract.GetOutput()
        cls.whole = {}
        for name in cls.cases:
            for ranks in RANKS:
                surface = joined(parts(name, ranks))
                surface.GetFieldData().ShallowCopy(cls.before.GetFieldData())
                cls.whole[name, ranks] = surface
                print(f"{name:18} {ranks} ranks: {surface.GetNumberOfPolys():6} triangles, {changed_voxels(surface, cls.image):4} "
                      f"voxels changed, {distance(cls.before, surface):.4f} mm", flush=True)

    def test_every_label_stays_closed(self):
        for (name, ranks), surface in self.whole.items():
            for label in label_images.LABELS:
                single = joined([one_label(surface, label)])
                with self.subTest(name, ranks=ranks, label=label):
                    self.assertEqual(bad_edges(single, True), 0)

    def test_smoothing_is_that_of_one_process_bit_for_bit(self):
        alone = corners_of(self.whole["label-smoothed", 1])
        self.assertNotEqual(alone, corners_of(self.before))
        for name in ("label-smoothed", "label-image", "label-images"):
            for ranks in RANKS[1:]:
                self.assertEqual(corners_of(self.whole[name, ranks]), alone)

    def test_every_voxel_keeps_its_label(self):
        for name in GUARDED:
            for ranks in RANKS:
                with self.subTest(name, ranks=ranks):
                    self.assertEqual(changed_voxels(self.whole[name, ranks], self.image), 0)

    def test_the_report_counts_the_voxels_of_the_whole_on_every_rank(self):
        for name in self.cases:
            for ranks in RANKS:
                changed = changed_voxels(self.whole[name, ranks], self.image)
                for surface in parts(name, ranks):
                    with self.subTest(name, ranks=ranks):
                        voxels = report_of(surface)["voxels"]
                        self.assertEqual(voxels["changed"], changed)
                        self.assertEqual(voxels["guard"], "on" if name in GUARDED else "off")
        self.assertGreater(changed_voxels(self.whole["label-free", 2], self.image), 0)

    def test_the_error_holds_against_the_surface_before_smoothing(self):
        # The report has one bound of all distances; with tolerances of points it may be anything up to the largest error.
        for name, most in (("label-error", cases.ERROR), ("label-crumbs", cases.ERROR), ("label-free", cases.ERROR),
                           ("label-preset", 0.4), ("label-tolerance", cases.TOLERANCE), ("label-millimeters", 0.3)):
            for ranks in RANKS:
                with self.subTest(name, ranks=ranks):
                    self.assertTrue(is_proved(self.before, self.whole[name, ranks], most))
                    for surface in parts(name, ranks):
                        if surface.GetNumberOfPolys() > 0:
                            self.assertLessEqual(report_of(surface)["proof"]["if_unchanged"]["upper"], cases.ERROR if name == "label-tolerance" else most)

    def test_an_error_costs_few_triangles(self):
        for name in ("label-error", "label-crumbs", "label-preset", "label-millimeters"):
            for ranks in RANKS[1:]:
                with self.subTest(name, ranks=ranks):
                    self.assertLessEqual(
                        self.whole[name, ranks].GetNumberOfPolys(), 1.1 * self.whole[name, 1].GetNumberOfPolys())

    def test_surfaces_are_smooth_where_ranks_meet(self):
        shared = shared_positions(parts("label-smoothed", 4))
        for name in ("label-smoothed", "label-error"):
            surface = self.whole[name, 4]
            near, far = angles(surface, shared, 1.0)
            print(f"{name}: {near:.1f} degrees where ranks meet, {far:.1f} far from there", flush=True)
            self.assertLess(near, 1.25 * far)

    def test_work_is_shared_and_something_is_removed(self):
        for ranks in RANKS[1:]:
            sizes = [part.GetNumberOfPolys() for part in parts("label-smoothed", ranks)]
            self.assertEqual(sum(sizes), self.before.GetNumberOfPolys())
            self.assertLess(max(sizes) - min(sizes), 2)
            for name in ("label-error", "label-crumbs", "label-kept", "label-free"):
                self.assertLess(self.whole[name, ranks].GetNumberOfPolys(), 0.7 * self.before.GetNumberOfPolys())


if __name__ == "__main__":
    unittest.main()
