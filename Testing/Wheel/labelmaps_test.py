# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of label maps in the wheel: closed, with common walls, where the volume says. Needs no VTK."""

import collections
import unittest

import numpy as np

import bonedecimate
from bonedecimate import LabelMap, extract_label, extract_surfaces

SHAPE = (9, 11, 14)  # z, y, x
SPACING, ORIGIN = (0.5, 0.75, 1.5), (-20.0, 3.0, 100.0)


def halves():
    """Labels 2 and 7: the halves of an ellipsoid."""
    z, y, x = np.indices(SHAPE)
    inside = ((x - 6.5) / 6) ** 2 + ((y - 5) / 4.5) ** 2 + ((z - 4) / 3.5) ** 2 < 1
    return np.where(inside, np.where(x < 7, 2, 7), 0).astype(np.int16)


def volume(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def unmatched_edges(triangles):
    """Edges that are not there once in each direction."""
    edges = collections.Counter(map(tuple, np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]).tolist()))
    return [edge for edge, count in edges.items() if count != 1 or edges[edge[::-1]] != 1]


def of_network(samples=36):
    """Two uneven bodies, 1 and 2, on the grid of a network."""
    z, y, x = np.indices((samples,) * 3).astype(float)
    waves = 2 * np.sin(x / 2) * np.cos(y / 2.5) * np.sin(z / 3)
    first = np.sqrt((x - 12) ** 2 + (y - 13) ** 2 + (z - 16) ** 2) + waves < 10
    second = np.sqrt((x - 25) ** 2 + (y - 22) ** 2 + (z - 19) ** 2) + waves < 10
    return np.where(first, 1, np.where(second, 2, 0)).astype(np.uint8)


class ModelGrid(unittest.TestCase):
    def setUp(self):
        self.network = of_network()
        nearest = ((np.arange(36 * 9 // 4) + 0.5) / 2.25).astype(int)  # centers aligned
        self.file = LabelMap(self.network[np.ix_(nearest, nearest, nearest)], spacing=(0.8, 0.8, 0.8), origin=ORIGIN)

    def test_is_that_of_the_network(self):
        found = extract_surfaces(self.file)
        expected = extract_surfaces(self.network, spacing=(1.8, 1.8, 1.8), origin=np.add(ORIGIN, 0.8 * 1.25 / 2), model_grid="off")
        np.testing.assert_allclose(found.points, expected.points, atol=1e-9)
        np.testing.assert_array_equal(found.triangles, expected.triangles)
        self.assertIn("1.8 x 1.8 x 1.8 mm", found.model_grid_found)
        self.assertEqual(found.grid.dimensions, (36, 36, 36))
        fine = extract_surfaces(self.file, model_grid="off")
        self.assertEqual((fine.grid.dimensions, fine.model_grid_found), (self.file.grid.dimensions, ""))

    def test_is_what_is_kept_and_compared(self):
        result = bonedecimate.decimate(extract_surfaces(self.file), max_error=0.9, keep_voxels="On", label_map=self.file)
        self.assertEqual(bonedecimate.check_voxels(result, self.file).changed, 0)
        self.assertLess(bonedecimate.check_voxels(result, self.file).compared, self.file.labels.size / 5)

    def test_may_be_requested(self):
        for spacing in (1.8, (1.8, 1.8, 1.8), "1.8"):
            np.testing.assert_array_equal(self.file.on_model_grid(spacing).labels, self.network)
        for wrong in (2.6, "coarse", -1, (1, 2)):
            with self.assertRaises(ValueError):
                extract_surfaces(self.file, model_grid=wrong)


class Surfaces(unittest.TestCase):
    def test_are_where_the_volume_says(self):
        found = extract_surfaces(halves(), spacing=SPACING, origin=ORIGIN)
        z, y, x = np.nonzero(halves())
        for axis, indices in enumerate((x, y, z)):
            low, high = indices.min() - 0.5, indices.max() + 0.5
            self.assertAlmostEqual(found.points[:, axis].min(), ORIGIN[axis] + SPACING[axis] * low)
            self.assertAlmostEqual(found.points[:, axis].max(), ORIGIN[axis] + SPACING[axis] * high)
        self.assertEqual(found.label_values.tolist(), [2, 7, 0])
        self.assertEqual({tuple(pair) for pair in found.boundary_labels.tolist()}, {(2, 0), (7, 0), (2, 7)})
        self.assertEqual((found.points.dtype, found.triangles.dtype), (np.float64, np.int32))
        middles = found.grid_points / 2 * SPACING + ORIGIN
        is_on_edge = (found.grid_points % 2).sum(axis=1) == 1
        np.testing.assert_allclose(found.points[is_on_edge], middles[is_on_edge])

    def test_of_each_label_are_closed_and_face_outward(self):
        found = extract_surfaces(halves(), spacing=SPACING, origin=ORIGIN)
        for label in (2, 7):
            points, triangles = found.label(label)
            self.assertEqual(unmatched_edges(triangles), [])
            voxels = (halves() == label).sum() * np.prod(SPACING)
            self.assertAlmostEqual(volume(points - ORIGIN, triangles) / voxels, 1, delta=0.12)
        with self.assertRaisesRegex(ValueError, "no triangle has the label 5; there are 0, 2, 7"):
            found.label(5)

    def test_stay_closed_label_by_label_through_decimation(self):
        found = extract_surfaces(halves(), spacing=SPACING)
        pairs, rows = found.walls
        small = bonedecimate.decimate(*found, labels=rows, target_reduction=0.5)
        self.assertLess(len(small.triangles), 0.7 * len(found.triangles))
        for label in (2, 7):
            _points, triangles = extract_label(small.points, small.triangles, pairs[small.labels], label)
            self.assertEqual(unmatched_edges(triangles), [])

    def test_take_every_type_and_order(self):
        expected = extract_surfaces(halves(), spacing=SPACING, origin=ORIGIN)
        kinds = [np.int8, np.uint8, np.uint16, np.int32, np.uint32, np.int64, np.uint64, np.float32, np.float64, ">i4"]
        maps = [{"label_map": halves().astype(kind)} for kind in kinds]
        maps += [{"label_map": np.asfortranarray(halves())}, {"label_map": halves().tolist()},
                 {"label_map": halves().transpose(), "axes": "xyz"}, {"label_map": halves().transpose().copy(), "axes": "xyz"}]
        for arguments in maps:
            found = extract_surfaces(**arguments, spacing=SPACING, origin=ORIGIN)
            np.testing.assert_array_equal(found.points, expected.points)
            np.testing.assert_array_equal(found.triangles, expected.triangles)
            np.testing.assert_array_equal(found.boundary_labels, expected.boundary_labels)
        self.assertEqual(extract_surfaces(halves() > 0).label_values.tolist(), [1, 0])

    def test_take_an_affine_matrix(self):
        turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, -1.0]])
        affine = np.eye(4)
        affine[:3, :3], affine[:3, 3] = turn * SPACING, ORIGIN
        found = extract_surfaces(halves().transpose(), axes="xyz", affine=affine)
        expected = extract_surfaces(halves(), spacing=SPACING, origin=ORIGIN, direction=turn)
        np.testing.assert_allclose(found.points, expected.points, atol=1e-12)
        self.assertGreater(volume(*found.label(2)), 0)
        np.testing.assert_array_equal(found.grid.direction, turn)

    def test_are_those_of_chosen_labels(self):
        found = extract_surfaces(halves(), labels=[7])
        np.testing.assert_array_equal(found.points, extract_surfaces(halves() == 7).points)
        self.assertEqual(extract_surfaces(halves(), background=7).label_values.tolist(), [0, 2, 7])

    def test_are_open_or_closed_at_the_end_of_the_array(self):
        full = np.ones((3, 4, 5), np.uint8)
        self.assertEqual(unmatched_edges(extract_surfaces(full).triangles), [])
        self.assertEqual(len(extract_surfaces(full, closed=False).triangles), 0)

    def test_are_the_same_for_any_number_of_threads(self):
        noise = np.random.default_rng(4).integers(0, 5, (40, 9, 8))
        one = extract_surfaces(noise, threads=1)
        for threads in (2, 4, 8):
            other = extract_surfaces(noise, threads=threads)
            self.assertEqual(one.points.tobytes() + one.triangles.tobytes(), other.points.tobytes() + other.triangles.tobytes())

    def test_report_progress_and_may_be_aborted(self):
        heard = []
        extract_surfaces(halves(), progress=heard.append, threads=1)  # with more, others may do the last parts of so small a map
        self.assertEqual((heard, heard[-1]), (sorted(heard), 1))
        with self.assertRaises(bonedecimate.Aborted):
            extract_surfaces(halves(), progress=lambda fraction: False)
        with self.assertRaises(ZeroDivisionError):
            extract_surfaces(halves(), progress=lambda fraction: 1 / 0)

    def test_reject_what_is_no_label_map(self):
        part = halves() + 0.5
        for error, arguments in (
                (ValueError, {"label_map": part}), (ValueError, {"label_map": np.full(SHAPE, np.nan)}),
                (ValueError, {"label_map": halves()[0]}), (TypeError, {"label_map": halves().astype(str)}),
                (TypeError, {"label_map": halves().astype(complex)}), (ValueError, {"label_map": np.zeros((0, 3, 3), int)}),
                (ValueError, {"label_map": np.full((1, 1, 1), 2**63, np.uint64)}),
                (ValueError, {"spacing": (1, 1)}), (ValueError, {"spacing": 0.5}), (ValueError, {"origin": 0}), (ValueError, {"spacing": (1, 0, 1)}), (ValueError, {"origin": (0, 0, np.inf)}),
                (ValueError, {"direction": np.ones((3, 3))}), (ValueError, {"axes": "yxz"}), (ValueError, {"labels": []}),
                (TypeError, {"labels": [1.5]}), (ValueError, {"background": 2**63}), (ValueError, {"threads": -1}),
                (TypeError, {"closed": "no"}), (ValueError, {"affine": np.eye(3)}), (ValueError, {"affine": np.zeros((4, 4))}),
                (ValueError, {"affine": np.eye(4), "spacing": SPACING}),
                (ValueError, {"label_map": halves()[:1], "closed": False})):
            with self.subTest(**arguments), self.assertRaises(error):
                extract_surfaces(**{"label_map": halves(), **arguments})

    def test_with_one_number_as_spacing_are_rejected(self):
        with self.assertRaisesRegex(ValueError, "spacing has 3 numbers, not one"):
            LabelMap(halves(), spacing=0.5)

    def test_of_gray_values_need_chosen_labels(self):
        gray = LabelMap(np.arange(11 * 11 * 11).reshape(11, 11, 11), axes="zyx")
        for make in (extract_surfaces, bonedecimate.segments):
            with self.assertRaisesRegex(ValueError, "more than 1,000 different values, which are no labels: gray values have to be segmented first"):
                make(gray)
        self.assertEqual(extract_surfaces(gray, labels=[700]).label_values.tolist(), [700, 0])
        self.assertEqual(list(bonedecimate.segments(gray, choose=[700], target_reduction=0)), ["label_700"])

    def test_of_one_label_reject_arrays_that_do_not_fit(self):
        found = extract_surfaces(halves())
        with self.assertRaises(ValueError):
            extract_label(found.points, found.triangles, found.boundary_labels[1:], 2)
        with self.assertRaises(ValueError):
            extract_label(found.points[:-1], found.triangles, found.boundary_labels, 2)
        with self.assertRaisesRegex(ValueError, "no triangle has the label 3; there are 0, 2, 7"):
            extract_label(found.points, found.triangles, found.boundary_labels, 3)


class Pieces(unittest.TestCase):
    def setUp(self):
        self.labels = halves()
        self.labels[4, 5, 3:5] = 0  # a cavity in 2
        self.labels[4, 5, 10] = 2  # an island in 7
        self.labels[8, 10, 13] = 7  # and one in the open
        self.bones = bonedecimate.LabelMap(self.labels, spacing=SPACING)
        self.voxel = float(np.prod(SPACING))

    def test_change_on_request_alone(self):
        same, changes = bonedecimate.change_pieces(self.bones)
        np.testing.assert_array_equal(same.labels, self.labels)
        self.assertEqual(changes, {})
        cleaned, changes = bonedecimate.change_pieces(self.bones, island_volume=1.5 * self.voxel, cavity_volume=2 * self.voxel)
        np.testing.assert_array_equal(cleaned.labels, halves())
        self.assertEqual(changes, {2: (1, 1, 1, 2), 7: (1, 1, 0, 0)})
        self.assertEqual((self.labels[4, 5, 3], cleaned.labels.dtype), (0, self.labels.dtype))
        self.assertEqual(bonedecimate.extract_surfaces(cleaned).grid.spacing.tolist(), list(SPACING))

    def test_of_other_labels_stay(self):
        cleaned, changes = bonedecimate.change_pieces(self.bones, labels=[7], island_size=1.6, cavity_volume=9)
        expected = self.labels.copy()
        expected[8, 10, 13] = 0
        np.testing.assert_array_equal(cleaned.labels, expected)
        self.assertEqual(changes, {7: (1, 1, 0, 0)})

    def test_that_are_the_largest_stay(self):
        with self.assertWarnsRegex(UserWarning, "the largest piece of label 2 is below a limit of islands, too; it stays"):
            cleaned, _changes = bonedecimate.change_pieces(self.bones, island_area=1e9)
        self.assertEqual(np.unique(cleaned.labels).tolist(), [0, 2, 7])

    def test_reject_limits_that_are_none(self):
        for name in ("island_size", "island_area", "island_volume", "cavity_volume"):
            for error, value in ((ValueError, -1), (ValueError, np.nan), (TypeError, "1")):
                with self.subTest(name, value=value), self.assertRaises(error):
                    bonedecimate.change_pieces(self.bones, **{name: value})
        with self.assertRaises(ValueError):
            bonedecimate.change_pieces(self.labels)
        with self.assertRaisesRegex(ValueError, "larger than 2"):
            bonedecimate.change_pieces(bonedecimate.LabelMap(np.full((1, 1, 1), 2**63, np.uint64)), cavity_volume=1)


if __name__ == "__main__":
    unittest.main()
