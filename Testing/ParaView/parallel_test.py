# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One, two and four ranks of pvbatch: the result hangs together, reaches the number, keeps the error, and is repeatable.

What the ranks wrote is joined and checked here, by the system's VTK and by the certificate, which knows no run.
"""

import hashlib
import os
import unittest

from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkFiltersCore import vtkMassProperties

import cases
import specimens
from parallel_runs import (FOLDER, RANKS, bad_edges, comparison, distance, intersecting_pairs, is_proved, joined, parts,
                           report_of, run)

BOUNDED = ("error", "open", "shells", "scattered", "labels", "point-labels")  # by 0.1 mm


def of_bone(surface, bone):
    """Its triangles, with an open boundary all around."""
    bones = surface.GetCellData().GetArray("bone")
    chosen = vtkCellArray()
    for number, corners in enumerate(specimens.triangles_of(surface)):
        if bones.GetValue(number) == bone:
            chosen.InsertNextCell(3, corners)
    return specimens.polydata(surface.GetPoints(), chosen)


def area_of(surface):
    properties = vtkMassProperties()
    properties.SetInputData(surface)
    return properties.GetSurfaceArea()


def values_of(surface, name):
    array = surface.GetPointData().GetArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfTuples())] if array else []


class Parallel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cases = cases.cases()
        cls.whole = {(name, ranks): joined(parts(name, ranks)) for name in cls.cases for ranks in RANKS}
        for (name, ranks), surface in cls.whole.items():
            print(f"{name:10} {ranks} ranks: {surface.GetNumberOfPolys():6} triangles, {bad_edges(surface, True):4} open edges, "
                  f"{distance(cls.cases[name][0], surface):.4f} mm", flush=True)

    def test_nothing_comes_apart(self):
        for (name, ranks), surface in self.whole.items():
            with self.subTest(name, ranks=ranks):
                before = self.cases[name][0]
                if name == "open":
                    self.assertLessEqual(bad_edges(surface, True), bad_edges(before, True))
                    self.assertGreater(bad_edges(surface, True), 0)
                else:
                    self.assertEqual(bad_edges(surface, True), 0)
                self.assertEqual(bad_edges(surface, False), 0)

    def test_numbers_are_meant_of_the_whole_surface(self):
        for name, wanted in (("reduction", 1920), ("fast", 1500), ("blocks", 1920)):
            for ranks in RANKS:
                with self.subTest(name, ranks=ranks):
                    self.assertEqual(self.whole[name, ranks].GetNumberOfPolys(), wanted)

    def test_the_error_holds_of_the_whole_surface(self):
        for name in BOUNDED:
            for ranks in RANKS:
                with self.subTest(name, ranks=ranks):
                    self.assertTrue(is_proved(self.cases[name][0], self.whole[name, ranks], 0.1))

    def test_an_error_costs_few_triangles(self):
        for name in BOUNDED:
            alone = self.whole[name, 1].GetNumberOfPolys()
            for ranks in RANKS[1:]:
                with self.subTest(name, ranks=ranks):
                    self.assertLessEqual(self.whole[name, ranks].GetNumberOfPolys(), 1.1 * alone)

    @unittest.skipUnless(os.environ.get("VERIFY_PROGRAM"), "CGAL counts intersecting pairs and is not here")
    def test_no_triangles_of_different_ranks_intersect(self):
        for name in BOUNDED:
            for ranks in RANKS:
                with self.subTest(name, ranks=ranks):
                    self.assertEqual(intersecting_pairs(self.whole[name, ranks]), 0)

    def test_what_needs_the_whole_surface_is_rejected(self):
        for name in cases.rejected():
            with self.subTest(name):
                self.assertEqual([part.GetNumberOfPolys() for part in parts(name, 2)], [0, 0])

    def test_every_option_counts_or_is_rejected(self):
        for name, (*_, shows) in cases.allowed().items():
            found = parts(name, 2)  # strips go to the first rank, so that the other one may have nothing left
            with self.subTest(name):
                self.assertGreater(sum(part.GetNumberOfPolys() for part in found), 0)
                self.assertTrue(all(shows(part) for part in found if part.GetNumberOfPolys() > 0))

    def test_components_are_pruned_as_those_of_the_whole_surface(self):
        alone = report_of(parts("pruned", 1)[0])
        self.assertEqual(alone["pruned"]["components"], 2)
        for ranks in RANKS[1:]:
            whole = self.whole["pruned", ranks]
            self.assertLess(whole.GetBounds()[1], 60.0)  # one small torus was at 80 mm, one at 120 mm
            self.assertGreater(whole.GetBounds()[1], 40.0)
            for number, surface in enumerate(parts("pruned", ranks)):
                report = report_of(surface)
                with self.subTest(ranks=ranks, number=number):
                    self.assertEqual(report["input"]["triangles"], alone["input"]["triangles"])
                    self.assertEqual(report["pruned"]["triangles"], alone["pruned"]["triangles"])
                    for one, other in zip(report["pruned"]["list"], alone["pruned"]["list"], strict=True):
                        for name in ("triangles", "size", "area", "volume"):
                            self.assertAlmostEqual(one[name], other[name], 9)

    def test_labels_keep_their_outlines_and_cost_few_triangles(self):
        before = self.cases["labels"][0]
        alone = self.whole["labels", 1].GetNumberOfPolys()
        for ranks in RANKS:
            after = self.whole["labels", ranks]
            self.assertFalse(after.GetCellData().HasArray("bonedecimate.labels"))
            self.assertLessEqual(after.GetNumberOfPolys(), 1.1 * alone)
            for bone in (0, 1):
                with self.subTest(ranks=ranks, bone=bone):
                    self.assertTrue(is_proved(of_bone(before, bone), of_bone(after, bone), 0.1))

    def test_strips_are_reduced(self):
        for name in ("reduction", "error", "fast", "open"):
            for surface in parts(name, 4):
                with self.subTest(name):
                    parallel = report_of(surface)["parallel"]
                    before, after = parallel["strip_triangles_before"], parallel["strip_triangles_after"]
                    self.assertGreater(before, 0)
                    self.assertLess(after, before)

    def test_the_report_is_that_of_the_whole_surface_on_every_rank(self):
        for surface in parts("error", 4):
            report = report_of(surface)
            self.assertEqual(report["input"]["triangles"], 9600)
            self.assertEqual(report["output"]["triangles"], self.whole["error", 4].GetNumberOfPolys())
            self.assertLessEqual(report["proof"]["if_unchanged"]["upper"], 0.1)
            self.assertEqual(report["parallel"]["processes"], 4)
            self.assertIn("seconds", report["parallel"]["missing"])
            self.assertEqual(surface.GetFieldData().GetArray("bonedecimate.proof.if_unchanged.upper").GetValue(0), report["proof"]["if_unchanged"]["upper"])

    def test_ranks_report_the_figures_that_one_reports(self):
        for name in ("error", "reduction", "open", "pruned", "labels"):
            alone = report_of(parts(name, 1)[0])
            for ranks in RANKS[1:]:
                whole = self.whole[name, ranks]
                for surface in parts(name, ranks):
                    report = report_of(surface)
                    with self.subTest(name, ranks=ranks):
                        self.assertEqual(report["stop_reason"], alone["stop_reason"])
                        self.assertEqual(report.get("proof", {}).get("if_unchanged", {}).get("status"),
                                         alone.get("proof", {}).get("if_unchanged", {}).get("status"))
                        for side in ("input", "output"):
                            self.assertEqual(report[side]["components"], alone[side]["components"])
                        self.assertAlmostEqual(report["input"]["area"], alone["input"]["area"], 6)
                        self.assertAlmostEqual(report["output"]["area"], area_of(whole), 6)
                        distances = [value for part in parts(name, ranks) for value in values_of(part, "Distance (mm)")]
                        self.assertEqual(report["distance"]["output_to_input"]["max"], max(distances))
                        self.assertAlmostEqual(report["distance"]["output_to_input"]["mean"], sum(distances) / len(distances), 12)

    def test_bounds_and_distances_are_true_of_the_input(self):
        for name in BOUNDED:
            before = self.cases[name][0]
            for surface in parts(name, 4):
                if surface.GetNumberOfPolys() == 0:
                    continue
                data = surface.GetPointData()
                bounds, distances = (data.GetArray(array + " (mm)") for array in ("ErrorBound", "Distance"))
                compare = comparison(before, surface)
                compare.SetMeasureBoundaries(False)
                compare.Update()
                true = compare.GetOutputDataObject(1).GetPointData().GetArray("SignedDistance")
                for i in range(surface.GetNumberOfPoints()):
                    self.assertLess(abs(abs(true.GetValue(i)) - distances.GetValue(i)), 1e-5)
                    self.assertLessEqual(abs(true.GetValue(i)), bounds.GetValue(i) + 1e-9)

    def test_every_triangle_says_its_block(self):
        blocks = {1: {1, 2}, 2: {1, 2}}
        for ranks, wanted in blocks.items():
            for surface in parts("blocks", ranks):
                index = surface.GetCellData().GetArray("BlockIndex")
                self.assertEqual({index.GetValue(i) for i in range(index.GetNumberOfValues())}, wanted)

    def test_the_same_partition_gives_the_same_bytes(self):
        names = ("reduction", "error")
        run(2, FOLDER / "again", names)
        for name in names:
            for first, second in zip(parts(name, 2), parts(name, 2, FOLDER / "again")):
                self.assertEqual(specimens.portrait(first)["Polys"], specimens.portrait(second)["Polys"])
                digests = [hashlib.sha256(repr(specimens.portrait(one)).encode()).hexdigest() for one in (first, second)]
                self.assertEqual(*digests)


if __name__ == "__main__":
    unittest.main()
