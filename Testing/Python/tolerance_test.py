# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The brush from Python: choose, constrain the rest, simplify."""

import unittest

from vtkmodules.vtkCommonDataModel import vtkSphere

from surfaces import decimating, torus
from bonedecimate import vtkBoneTolerance


def brushed():
    """The torus with all points outside of a ball constrained."""
    ball = vtkSphere()
    ball.SetCenter(10, 0, 0)
    ball.SetRadius(9)
    brush = vtkBoneTolerance()
    brush.SetInputData(torus())
    brush.SetChoiceToImplicitFunction()
    brush.SetImplicitFunction(ball)
    brush.InvertedOn()
    brush.Update()
    return brush.GetOutput()


def triangles(surface):
    return {
        tuple(surface.GetPoint(surface.GetCell(i).GetPointId(k)) for k in range(3))
        for i in range(surface.GetNumberOfCells())
    }


class Tolerance(unittest.TestCase):
    def test_of_zero_leaves_what_is_outside_the_brush(self):
        surface = brushed()
        values = surface.GetPointData().GetArray("Tolerance")
        decimate = decimating(surface, TargetReduction=0.2, ToleranceArrayName="Tolerance")
        decimate.Update()
        after = triangles(decimate.GetOutput())
        self.assertLess(len(after), surface.GetNumberOfCells())
        for i in range(surface.GetNumberOfCells()):
            corners = [surface.GetCell(i).GetPointId(k) for k in range(3)]
            if any(values.GetValue(corner) == 0 for corner in corners):
                self.assertIn(tuple(surface.GetPoint(corner) for corner in corners), after)

    def test_properties_have_their_defaults(self):
        tolerance = vtkBoneTolerance()
        self.assertEqual(tolerance.GetChoice(), vtkBoneTolerance.EVERYTHING)
        self.assertEqual((tolerance.GetInsideTolerance(), tolerance.GetOutsideTolerance()), (0.0, -1.0))
        self.assertEqual((tolerance.GetFeather(), tolerance.GetFoldAngle()), (0.0, 30.0))
        self.assertEqual((tolerance.GetChoiceArrayName(), tolerance.GetToleranceArrayName()), ("Choice", "Tolerance"))
        self.assertFalse(tolerance.GetInverted())

    def test_labels_can_be_read_back(self):
        tolerance = vtkBoneTolerance()
        tolerance.AddLabel(7)
        self.assertEqual((tolerance.GetNumberOfLabels(), tolerance.GetLabel(0)), (1, 7))
        tolerance.RemoveAllLabels()
        self.assertEqual(tolerance.GetNumberOfLabels(), 0)

    def test_every_setter_tells_its_default(self):
        for name in vars(vtkBoneTolerance):
            if name.startswith("Set") and not name.startswith("SetChoiceTo"):
                with self.subTest(name):
                    self.assertRegex(getattr(vtkBoneTolerance, name).__doc__, r"[Dd]efault")


if __name__ == "__main__":
    unittest.main()
