# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkBoneSurfaceDistance from Python."""

import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy

from surfaces import POINTS, decimating, torus
from bonedecimate import vtkBoneSurfaceDistance


class Distance(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.decimate = decimating(torus(), TargetReduction=0.5)
        cls.decimate.Update()
        cls.distance = vtkBoneSurfaceDistance()
        cls.distance.SetInputData(0, torus())
        cls.distance.SetInputConnection(1, cls.decimate.GetOutputPort())
        cls.distance.SetTolerance(5.0)
        cls.distance.Update()

    def test_is_proved(self):
        self.assertEqual(self.distance.GetStatus(), vtkBoneSurfaceDistance.PROVED)
        self.assertEqual(self.distance.GetStatusAsString(), "proved")
        self.assertGreater(self.distance.GetLowerBound(), 0)
        self.assertLessEqual(self.distance.GetLowerBound(), self.distance.GetUpperBound())

    def test_is_no_less_than_what_was_sampled(self):
        sampled = max(
            self.decimate.GetReportValue(f"distance.{way}.max") for way in ("output_to_input", "input_to_output")
        )
        self.assertLessEqual(sampled, self.distance.GetUpperBound())

    def test_has_a_report(self):
        names = [self.distance.GetReportEntryName(i) for i in range(self.distance.GetNumberOfReportEntries())]
        self.assertIn("reference_to_result.upper", names)
        self.assertEqual(self.distance.GetReportText("boundaries"), "neither")
        self.assertEqual(self.distance.GetReportEntryUnit("upper"), "mm")

    def test_has_a_signed_distance_at_each_point(self):
        for port, count in ((0, POINTS), (1, self.decimate.GetOutput().GetNumberOfPoints())):
            data = self.distance.GetOutput(port).GetPointData()
            signed = vtk_to_numpy(data.GetArray("SignedDistance"))
            side = vtk_to_numpy(data.GetArray("Side"))
            self.assertEqual((signed.size, side.size), (count, count))
            self.assertTrue(((signed < 0) == (side < 0)).all())
            self.assertLessEqual(abs(signed).max(), self.distance.GetUpperBound())


if __name__ == "__main__":
    unittest.main()
