# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter in a script as short as people write it, and its report."""

import json
import math
import unittest

from surfaces import POINTS, TRIANGLES, decimating, torus
from bonedecimate import vtkBoneDecimate


class Script(unittest.TestCase):
    def test_of_ten_lines(self):
        import vtk

        sphere = vtk.vtkSphereSource()
        sphere.SetThetaResolution(64)
        sphere.SetPhiResolution(64)
        triangles = vtk.vtkCleanPolyData()
        triangles.SetInputConnection(sphere.GetOutputPort())
        decimate = vtkBoneDecimate()
        decimate.SetInputConnection(triangles.GetOutputPort())
        decimate.SetTargetReduction(0.8)
        decimate.Update()
        self.assertEqual(decimate.GetOutput().GetNumberOfPolys(), 64 * 62 * 2 // 5 // 2 * 2)


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.decimate = decimating(torus(), TargetReduction=0.5)
        cls.decimate.Update()

    def test_counts_both_surfaces(self):
        values = {
            "input.triangles": TRIANGLES,
            "input.points": POINTS,
            "output.triangles": TRIANGLES // 2,
            "output.components": 1,
            "output.boundary_edges": 0,
            "output.euler_number": 0,
        }
        for name, value in values.items():
            self.assertEqual(self.decimate.GetReportValue(name), value, name)

    def test_has_distances_in_millimeters(self):
        for direction in ("output_to_input", "input_to_output"):
            path = "distance." + direction
            self.assertGreater(self.decimate.GetReportValue(path + ".max"), 0)
            self.assertLessEqual(
                self.decimate.GetReportValue(path + ".mean"), self.decimate.GetReportValue(path + ".rms")
            )
            self.assertEqual(self.decimate.GetReportEntryUnit(path + ".max"), "mm")

    def test_says_why_the_run_ended(self):
        self.assertEqual(self.decimate.GetStopReason(), vtkBoneDecimate.TARGET_REACHED)
        self.assertEqual(self.decimate.GetReportText("stop_reason"), "target_reached")
        self.assertEqual(self.decimate.GetReportText("stop_sentence"), self.decimate.GetStopReasonAsString())

    def test_is_one_text_of_the_field_data(self):
        field_data = self.decimate.GetOutput().GetFieldData()
        text = field_data.GetAbstractArray("BoneDecimateReport").GetValue(0)
        report = json.loads(text)
        whole = json.loads(self.decimate.GetReportAsJson())
        self.assertEqual({**report, "proof": None, "units": None}, {**whole, "proof": None, "units": None})
        report = whole
        for i in range(self.decimate.GetNumberOfReportEntries()):
            name = self.decimate.GetReportEntryName(i)
            value = report
            for word in name.split("."):
                value = value[int(word)] if isinstance(value, list) else value[word]
            if isinstance(value, str):
                self.assertEqual(value, self.decimate.GetReportText(name), name)
            else:
                self.assertEqual(value, self.decimate.GetReportValue(name), name)
            self.assertEqual(report["units"].get(name, ""), self.decimate.GetReportEntryUnit(name), name)

    def test_returns_nothing_for_unknown_names(self):
        self.assertTrue(math.isnan(self.decimate.GetReportValue("nonsense")))
        self.assertEqual(self.decimate.GetReportText("nonsense"), "")


if __name__ == "__main__":
    unittest.main()
