# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Brush and comparison inside ParaView: an implicit function, a selection, two surfaces."""

import math
import unittest

from paraview import simple

import specimens
import surfaces


def corners(surface):
    """The triangles as their corners' coordinates, first the least."""
    found = set()
    for ids in specimens.triangles_of(surface):
        positions = [surface.GetPoint(i) for i in ids]
        least = positions.index(min(positions))
        found.add(tuple(positions[least:] + positions[:least]))
    return found


def near(triangle, middle, radius):
    return any(math.dist(corner, middle) <= radius for corner in triangle)


class Brush(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        surfaces.load()
        cls.surface = specimens.torus(60, 40)
        cls.bone = surfaces.source(cls.surface)

    def test_a_ball_is_constrained_bit_for_bit_and_the_rest_is_not(self):
        brush = simple.BoneTolerance(Input=self.bone)
        brush.ImplicitFunction.Center = [13, 0, 0]
        brush.ImplicitFunction.Radius = 4
        decimate = simple.BoneDecimate(Input=brush, ToleranceArrayName="Tolerance", TargetReduction=0.5)
        before, after = corners(self.surface), corners(surfaces.output(decimate))
        constrained = {triangle for triangle in before if near(triangle, (13, 0, 0), 4)}
        self.assertGreater(len(constrained), 50)
        self.assertLessEqual(constrained, after)
        self.assertEqual(len(after), len(before) // 2)

    def test_moving_the_ball_moves_what_is_constrained(self):
        brush = simple.BoneTolerance(Input=self.bone)
        brush.ImplicitFunction.Radius = 4
        counts = []
        for middle in ([13, 0, 0], [100, 0, 0]):
            brush.ImplicitFunction.Center = middle
            values = surfaces.output(brush).GetPointData().GetArray("Tolerance")
            counts.append(sum(values.GetValue(i) == 0 for i in range(values.GetNumberOfValues())))
        self.assertGreater(counts[0], 0)
        self.assertEqual(counts[1], 0)

    def test_selected_cells_are_constrained(self):
        ids = [3, 500, 501]
        selection = simple.IDSelectionSource(IDs=[number for cell in ids for number in (-1, cell)], FieldType="CELL")
        brush = simple.BoneTolerance(Input=self.bone, Selection=selection, Choice="Selection")
        decimate = simple.BoneDecimate(Input=brush, ToleranceArrayName="Tolerance", TargetReduction=0.8)
        wanted = specimens.polydata(self.surface.GetPoints(), self.surface.GetPolys())
        kept = {tuple(wanted.GetPoint(i) for i in specimens.triangles_of(wanted)[cell]) for cell in ids}
        after = corners(surfaces.output(decimate))
        for triangle in kept:
            least = triangle.index(min(triangle))
            self.assertIn(triangle[least:] + triangle[:least], after)

    def test_two_surfaces_are_compared(self):
        decimate = simple.BoneDecimate(Input=self.bone, MaximumError=0.1)
        compare = simple.BoneSurfaceDistance(Input=self.bone, Result=decimate, Tolerance=0.1)
        self.assertEqual(surfaces.report(compare)["bonedecimate.certificate.status"], "proved")
        self.assertIn("SignedDistance (mm)", simple.OutputPort(compare, 1).PointData.keys())


if __name__ == "__main__":
    unittest.main()
