# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs on surfaces that know their label map, and the check of their voxels, against winding numbers. Needs no VTK."""

import json
import unittest
import warnings

import numpy as np

import bonedecimate
from bonedecimate import LabelMap, VoxelGrid, certify, check_voxels, decimate, extract_surfaces, record_levels, smooth
from labelmaps_test import ORIGIN, SPACING, halves, unmatched_edges

TURN = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
MAP = LabelMap(halves(), spacing=SPACING, origin=ORIGIN, direction=TURN)
ONE = LabelMap(halves() > 0, spacing=SPACING, origin=ORIGIN, direction=TURN)
COARSE = {"target_reduction": 0.9, "keep_voxels": "Off"}


def is_inside(surface):
    """Of each voxel: how often the surface winds around its row, a little beside the center, from there on."""
    points, triangles = surface
    corners = ((points - ORIGIN) @ TURN / SPACING)[triangles]  # voxels
    z, y = np.indices(halves().shape[:2]).reshape(2, -1, 1) + np.array([1.4e-5, 1.7e-5])[:, None, None]

    def side(k):
        (_, uy, uz), (_, vy, vz) = corners[:, k].T, corners[:, (k + 1) % 3].T
        return (vy - uy) * (z - uz) - (vz - uz) * (y - uy)
    sides = np.stack([side(1), side(2), side(0)])
    area = sides.sum(axis=0)
    is_crossed = (sides > 0).all(axis=0) | (sides < 0).all(axis=0)
    position = np.einsum("krt,tk->rt", sides, corners[:, :, 0]) / np.where(area == 0, 1, area)
    is_ahead = position[:, None] > np.arange(halves().shape[2])[:, None]
    return ((is_ahead & is_crossed[:, None]) * np.sign(area)[:, None]).sum(axis=2).reshape(-1) == 1


def labels_by_winding(result):
    return sum(label * is_inside(result.label(label)) for label in (2, 7))


class Runs(unittest.TestCase):
    def test_keep_every_voxel_of_what_extract_surfaces_returned(self):
        surfaces = extract_surfaces(MAP)
        for keywords in ({"target_reduction": 0.9}, {"max_error": 0.25}, {"keep_voxels": "On", "max_error": 2.0}):
            small = decimate(surfaces, **keywords)
            self.assertLess(len(small.triangles), len(surfaces.triangles))
            self.assertEqual((small.report["voxels.guard"], small.report["voxels.changed"]), ("on", 0))
            np.testing.assert_array_equal(labels_by_winding(small), halves().ravel())
        # A bound above half a voxel turns "Auto" off, and points and triangles alone know nothing.
        self.assertEqual(decimate(surfaces, max_error=0.6).report["voxels.guard"], "off")
        self.assertNotIn("voxels.changed", decimate(*surfaces, target_reduction=0.9).report)

    def test_labels_of_64_bits_are_exact_or_rejected(self):
        surface = extract_surfaces(ONE)
        wide = LabelMap(4 * ONE.labels.astype(np.uint64), spacing=SPACING, origin=ORIGIN, direction=TURN)
        self.assertEqual(check_voxels(tuple(surface), wide, label=np.uint64(4)).changed, 0)
        with self.assertRaisesRegex(ValueError, "the label map has no voxel with the label 5"):
            check_voxels(tuple(surface), wide, label=5)
        beyond = LabelMap(np.where(ONE.labels, np.uint64(2**64 - 3), np.uint64(0)), spacing=SPACING, origin=ORIGIN, direction=TURN)
        with self.assertRaisesRegex(ValueError, "label"):
            check_voxels(tuple(surface), beyond, label=-3)

    def test_a_background_that_the_labels_cannot_hold_is_rejected(self):
        for background in (300, -1):
            with self.assertRaisesRegex(ValueError, "does not hold the background"):
                bonedecimate.change_pieces(LabelMap(np.ones((8, 8, 8), np.uint8), axes="zyx"), background=background, island_volume=2)

    def test_changed_labels_of_a_result_leave_the_input_alone(self):
        surfaces = extract_surfaces(MAP)
        decimate(surfaces, target_reduction=0.5).label_values[:] = 77
        self.assertNotIn(77, surfaces.label_values)

    def test_count_the_voxels_that_they_change_by_label(self):
        small = decimate(extract_surfaces(MAP), **COARSE)
        found = labels_by_winding(small)
        self.assertEqual(small.report["voxels.guard"], "off")
        self.assertGreater(small.report["voxels.changed"], 0)
        self.assertEqual(small.report["voxels.changed"], np.count_nonzero(found != halves().ravel()))
        for label in (2, 7):
            self.assertEqual(small.report[f"voxels.of_{label}.lost"], np.count_nonzero((halves().ravel() == label) & (found != label)))

    def test_return_surfaces_that_know_their_label_map(self):
        surfaces = extract_surfaces(MAP)
        smoothed = smooth(surfaces)
        self.assertEqual((smoothed.report["smoothing.in_voxels"], smoothed.report["voxels.changed"]), (1, 0))
        self.assertGreater(smoothed.report["smoothing.largest_displacement"], 0)
        np.testing.assert_array_equal(labels_by_winding(smoothed), halves().ravel())
        small = decimate(smoothed, target_reduction=0.8, keep_voxels="On")
        self.assertEqual(small.report["voxels.changed"], 0)
        self.assertEqual(small.label_values.tolist(), [2, 7, 0])
        self.assertEqual({tuple(pair) for pair in small.boundary_labels.tolist()}, {(2, 0), (7, 0), (2, 7)})
        for label in (2, 7):
            self.assertEqual(unmatched_edges(small.label(label)[1]), [])
        self.assertEqual(certify(surfaces, decimate(surfaces, auto_smooth=True, max_error=0.4), tolerance=0.4).status, "proved")

    def test_keep_sharp_edges_by_their_angle(self):
        block = extract_surfaces(np.pad(np.ones((9, 9, 9), np.int16), 2))
        for angle, is_kept in ((45, True), (120, False)):
            report = smooth(block, feature_angle=angle).report
            self.assertEqual(report["smoothing.sharp_points"] > 0, is_kept)
            self.assertEqual(report["voxels.changed"], 0)

    def test_take_label_maps_of_surfaces_that_others_made(self):
        # As skimage.measure.marching_cubes has vertices: single precision, z, y, x in voxels.
        z_y_x = extract_surfaces(halves() > 0).points[:, ::-1].astype(np.float32)
        corners = extract_surfaces(halves() > 0).triangles[:, ::-1]
        points = ORIGIN + (z_y_x[:, ::-1] * SPACING) @ TURN.T
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            small = decimate(points, corners[:, ::-1], label_map=ONE, target_reduction=0.9)
            same = decimate(points, corners[:, ::-1], label_map=ONE.grid, target_reduction=0.9)
        self.assertEqual((small.report["voxels.guard"], small.report["voxels.changed"]), ("on", 0))
        self.assertEqual(small.points.tobytes() + small.triangles.tobytes(), same.points.tobytes() + same.triangles.tobytes())
        self.assertEqual(check_voxels(small, ONE).changed, 0)
        with self.assertWarnsRegex(UserWarning, r"differ in \d+ of \d+ voxels") as heard:
            decimate(z_y_x, corners, label_map=LabelMap(halves() > 0))
        self.assertEqual(heard.filename, __file__)
        with self.assertRaisesRegex(ValueError, "voxel grid"):
            decimate(points, corners, keep_voxels="On")
        surfaces = extract_surfaces(MAP)
        small = decimate(*surfaces, label_map=MAP, boundary_labels=surfaces.boundary_labels, target_reduction=0.9)
        np.testing.assert_array_equal(small.boundary_labels, decimate(surfaces, target_reduction=0.9).boundary_labels)

    def test_are_the_same_for_any_number_of_threads(self):
        surfaces = extract_surfaces(MAP)
        one, *others = (decimate(surfaces, auto_smooth=True, keep_voxels="On", threads=threads) for threads in (1, 2, 4))
        for other in others:
            for name in ("points", "triangles", "boundary_labels"):
                self.assertEqual(getattr(one, name).tobytes(), getattr(other, name).tobytes())
            self.assertEqual(check_voxels(one, MAP, threads=1).entries(), check_voxels(one, MAP, threads=4).entries())

    def test_of_levels_reject_label_maps(self):
        surfaces = extract_surfaces(ONE)
        with self.assertRaisesRegex(ValueError, "levels do not keep voxels"):
            record_levels(surfaces)
        levels = record_levels(surfaces, keep_voxels="Off", target_reduction=0.5)
        self.assertEqual(levels.log, record_levels(*surfaces, target_reduction=0.5, keep_voxels="Off").log)

    def test_reject_what_does_not_fit(self):
        surfaces, pairs = extract_surfaces(MAP), extract_surfaces(MAP).boundary_labels
        shifted = LabelMap(halves(), spacing=SPACING)
        for error, words, arguments, keywords in (
                (ValueError, "another voxel grid", [surfaces], {"label_map": shifted}),
                (ValueError, "an array alone is enough only", surfaces, {"label_map": halves()}),
                (ValueError, r"the shape \(14, 11, 9\)", [surfaces], {"label_map": halves().T}),
                (ValueError, "need a voxel grid", surfaces, {"boundary_labels": pairs}),
                (ValueError, "of shape", surfaces, {"boundary_labels": pairs[1:], "label_map": MAP}),
                (TypeError, "numbers, not float64", surfaces, {"boundary_labels": pairs + 0.5, "label_map": MAP}),
                (ValueError, "does not say which of them", surfaces, {"label_map": MAP}),
                (TypeError, r"not an array of shape \(\d+, 3\)", [surfaces.points], {})):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                decimate(*arguments, **keywords)
        surfaces.boundary_labels = pairs + 1
        with self.assertRaisesRegex(ValueError, "a label that is not one of label_values"):
            decimate(surfaces)


class Checks(unittest.TestCase):
    def test_count_what_a_surface_of_several_labels_changes(self):
        small = decimate(extract_surfaces(MAP), **COARSE)
        found, wanted = labels_by_winding(small), halves().ravel()
        changes = check_voxels(small, halves())  # an array on the grid of the surface
        self.assertEqual(changes.changed, np.count_nonzero(found != wanted))
        self.assertEqual(list(changes.of_label), [2, 7, 0])
        for label in (2, 7, 0):
            self.assertEqual(changes.of_label[label].lost, np.count_nonzero((wanted == label) & (found != label)))
            self.assertEqual(changes.of_label[label].gained, np.count_nonzero((wanted != label) & (found == label)))
        z, y, x = np.unravel_index(np.flatnonzero(found != wanted)[0], halves().shape)
        self.assertEqual(changes.first_changed, (x, y, z))
        for surface in (small, extract_surfaces(MAP)):
            again = check_voxels(tuple(surface), MAP, boundary_labels=surface.boundary_labels)
            self.assertEqual(again.entries(), check_voxels(surface, MAP).entries())
        self.assertEqual(check_voxels(extract_surfaces(MAP), halves()).changed, 0)
        self.assertIsNone(check_voxels(extract_surfaces(MAP), halves()).first_changed)

    def test_count_what_a_surface_of_one_label_changes(self):
        seven = extract_surfaces(MAP).label(7)
        self.assertEqual(check_voxels(seven, MAP, label=7).changed, 0)
        self.assertEqual(check_voxels(seven, MAP, label=2).of_label[2].lost, np.count_nonzero(halves() == 2))
        self.assertEqual(check_voxels(seven, MAP, label=7).left_out, [2])
        with self.assertRaisesRegex(ValueError, "the labels 2, 7, and the surface does not say which"):
            check_voxels(seven, MAP)
        other = LabelMap(np.where(halves() == 7, 255, 3), spacing=SPACING, origin=ORIGIN, direction=TURN)
        changes = check_voxels(seven, other, background=3)
        self.assertEqual(changes.of_label, {255: (np.count_nonzero(halves() == 7), 0, 0),
                                            3: (changes.compared - np.count_nonzero(halves() == 7), 0, 0)})
        self.assertEqual(changes.left_out, [])

    def test_are_part_of_certificates(self):
        surfaces = extract_surfaces(MAP)
        small = decimate(surfaces, **COARSE)
        certificate = certify(surfaces, small, label_map=halves())
        self.assertEqual(certificate.voxels.changed, check_voxels(small, MAP).changed)
        self.assertEqual(certificate.report["voxels.changed"], certificate.voxels.changed)
        self.assertEqual(json.loads(certificate.report_as_json)["voxels"]["of_7"]["lost"], certificate.voxels.of_label[7].lost)
        self.assertIsNone(certify(surfaces, small).voxels)

    def test_may_be_aborted(self):
        with self.assertRaises(bonedecimate.Aborted):
            check_voxels(extract_surfaces(MAP), MAP, progress=lambda fraction: False)

    def test_reject_what_cannot_be_voxelized(self):
        points, triangles = extract_surfaces(ONE)
        for words, surface, keywords in (
                ("not there", (points[:-1], triangles), {}), ("not there", (points, triangles - 1), {}),
                ("not finite", (np.where(points == points[7], np.nan, points), triangles), {}),
                ("65536 voxels away", (points + 1e6, triangles), {}), ("65536 voxels away", (points * 1e200, triangles), {}),
                ("both 0", (points, triangles), {"label": 0}), ("without boundary labels", extract_surfaces(MAP), {"label": 7}),
                ("the background 0, not 5", extract_surfaces(MAP), {"background": 5}),
                ("of shape", (points, triangles), {"boundary_labels": [[1, 0]]})):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                check_voxels(surface, ONE, **keywords)
        with self.assertRaisesRegex(TypeError, "surface is a mesh"):
            check_voxels(points, MAP)


class Grids(unittest.TestCase):
    def test_are_where_the_map_says(self):
        grid = VoxelGrid((14, 11, 9), spacing=SPACING, origin=ORIGIN, direction=TURN)
        self.assertTrue(grid.is_same_as(MAP.grid))
        affine = np.eye(4)
        affine[:3, :3], affine[:3, 3] = TURN * SPACING, ORIGIN
        self.assertTrue(VoxelGrid((14, 11, 9), affine=affine).is_same_as(MAP.grid))
        np.testing.assert_allclose(grid.to_voxels(ORIGIN + np.array([-1.5, 1.0, 4.5])), (2, 2, 3))
        rounded = VoxelGrid((1, 1, 1), direction=np.round(np.linalg.qr(np.arange(9).reshape(3, 3) ** 2 + 1.0)[0], 5)).direction
        np.testing.assert_allclose(rounded @ rounded.T, np.eye(3), atol=1e-15)

    def test_reject_what_is_no_grid(self):
        for keywords in ({"dimensions": (0, 1, 1)}, {"dimensions": (1, 1)}, {"dimensions": (1.5, 1, 1)}, {"dimensions": (2**31, 1, 1)},
                         {"spacing": (1, -1, 1)}, {"spacing": (1, np.nan, 1)}, {"origin": (0, np.inf, 0)},
                         {"direction": np.ones((3, 3))}, {"direction": np.full((3, 3), np.nan)}):
            with self.subTest(**keywords), self.assertRaises(ValueError):
                VoxelGrid(**{"dimensions": (2, 2, 2), **keywords})
        with self.assertRaises(ValueError):
            extract_surfaces(MAP, spacing=(2, 2, 2))


if __name__ == "__main__":
    unittest.main()
