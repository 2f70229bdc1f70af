# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Label maps of a tilted gantry, and of layers with positions of their own, against winding numbers. Needs no VTK but for images."""

import unittest

import numpy as np

from bonedecimate import LabelMap, VoxelGrid, change_pieces, check_voxels, decimate, extract_surfaces, smooth
from labelmaps_test import ORIGIN, SPACING, halves

COUNT = len(halves())
LAYERS = np.cumsum([0, *(1.0 if k < COUNT // 2 else 2.5 for k in range(COUNT - 1))])
TILTED = np.array([[0.8, 0.6, 0], [-0.6, 0.8, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, 1, 0.3], [0, 0, np.sqrt(1 - 0.09)]])
GRIDS = {"tilted": {"direction": TILTED}, "uneven": {"layers": LAYERS}, "both": {"direction": TILTED, "layers": LAYERS}}


def is_inside(surface, grid):
    """Of each voxel: how often the surface winds around its row, a little beside the center, from there on."""
    points, triangles = surface
    heights = np.arange(COUNT) * SPACING[2] if grid.layers is None else grid.layers
    corners = ((points - ORIGIN) @ np.linalg.inv(grid.direction).T / [*SPACING[:2], 1])[triangles]
    z, y = np.indices(halves().shape[:2]).reshape(2, -1, 1)
    z, y = heights[z] + 1.4e-5, y + 1.7e-5

    def side(k):
        (_, uy, uz), (_, vy, vz) = corners[:, k].T, corners[:, (k + 1) % 3].T
        return (vy - uy) * (z - uz) - (vz - uz) * (y - uy)
    sides = np.stack([side(1), side(2), side(0)])
    area = sides.sum(axis=0)
    is_crossed = (sides > 0).all(axis=0) | (sides < 0).all(axis=0)
    position = np.einsum("krt,tk->rt", sides, corners[:, :, 0]) / np.where(area == 0, 1, area)
    is_ahead = position[:, None] > np.arange(halves().shape[2])[:, None]
    return ((is_ahead & is_crossed[:, None]) * np.sign(area)[:, None]).sum(axis=2).reshape(-1) == 1


class Grids(unittest.TestCase):
    def each(self):
        for where in GRIDS.values():
            yield LabelMap(halves(), spacing=SPACING, origin=ORIGIN, **where)

    def expect_labels(self, result, grid):
        found = sum(label * is_inside(result.label(label), grid) for label in (2, 7))
        np.testing.assert_array_equal(found, halves().ravel())

    def test_every_voxel_keeps_its_label(self):
        for bones in self.each():
            surfaces = extract_surfaces(bones)
            self.expect_labels(surfaces, bones.grid)
            self.expect_labels(smooth(surfaces), bones.grid)
            for keywords in ({"target_reduction": 0.9}, {"max_error": 0.25}, {"keep_voxels": "On", "max_error": 2.0}):
                small = decimate(surfaces, **keywords)
                self.assertLess(len(small.triangles), len(surfaces.triangles))
                self.assertEqual((small.report["voxels.guard"], small.report["voxels.changed"]), ("on", 0))
                self.expect_labels(small, bones.grid)
            coarse = decimate(surfaces, target_reduction=0.9, keep_voxels="Off")
            found = sum(label * is_inside(coarse.label(label), bones.grid) for label in (2, 7))
            self.assertEqual(check_voxels(coarse, bones).changed, np.count_nonzero(found != halves().ravel()))
            with self.assertRaisesRegex(ValueError, "another voxel grid"):
                decimate(surfaces, label_map=LabelMap(halves(), spacing=SPACING, origin=ORIGIN), max_error=0.25)

    def test_an_affine_matrix_may_be_sheared(self):
        affine = np.eye(4)
        affine[:3, :3], affine[:3, 3] = TILTED * SPACING, ORIGIN
        found = extract_surfaces(LabelMap(halves(), axes="zyx", affine=affine))
        expected = extract_surfaces(halves(), spacing=SPACING, origin=ORIGIN, direction=TILTED)
        np.testing.assert_allclose(found.points, expected.points, atol=1e-12)

    def test_voxels_of_positions_are_those_of_their_layers(self):
        grid = VoxelGrid(halves().shape[::-1], spacing=SPACING, origin=ORIGIN, direction=TILTED, layers=LAYERS)
        at = np.array(ORIGIN) + TILTED @ [2 * SPACING[0], 3 * SPACING[1], 0.5 * (LAYERS[-2] + LAYERS[-1])]
        np.testing.assert_allclose(grid.to_voxels(at[None]), [[2, 3, COUNT - 1.5]])

    def test_layers_that_are_none_are_rejected(self):
        for layers in (LAYERS[:-1], LAYERS[::-1], LAYERS + 1, np.where(np.arange(COUNT) == 2, np.nan, LAYERS)):
            with self.assertRaises(ValueError):
                LabelMap(halves(), layers=layers)

    def test_islands_have_the_volume_of_their_layers(self):
        labels = np.zeros((COUNT, 9, 9), int)
        labels[:, 6:, 6:] = 1
        labels[1, 1, 1] = labels[COUNT - 2, 1, 1] = 1
        _cleaned, changes = change_pieces(LabelMap(labels, layers=LAYERS), island_volume=2)
        self.assertEqual(changes[1].island_voxels, 1)


if __name__ == "__main__":
    unittest.main()
