# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The report's figures of triangle shapes are those of vtkMeshQuality, and MinimumAngle holds by its measure."""

import json
import unittest

from surfaces import decimating, torus
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality


def quality(surface, measure):
    """Least, mean and largest value of one of the measures."""
    mesh = vtkMeshQuality()
    mesh.SetInputData(surface)
    getattr(mesh, f"SetTriangleQualityMeasureTo{measure}")()
    mesh.Update()
    values = mesh.GetOutput().GetCellData().GetArray("Quality")
    numbers = [values.GetValue(i) for i in range(values.GetNumberOfTuples())]
    return min(numbers), sum(numbers) / len(numbers), max(numbers), numbers


class Shapes(unittest.TestCase):
    def decimated(self, **options):
        self.surface = torus()
        decimate = decimating(self.surface, **options)
        decimate.Update()
        return decimate.GetOutput(), json.loads(decimate.GetReportAsJson())

    def test_figures_are_those_of_vtk(self):
        result, report = self.decimated(MaximumError=0.3)
        for side, surface in (("input", self.surface), ("output", result)):
            shape = report[side]["shape"]
            smallest, _, _, angles = quality(surface, "MinAngle")
            self.assertAlmostEqual(shape["smallest_angle"], smallest, 3)
            self.assertAlmostEqual(shape["largest_angle"], quality(surface, "MaxAngle")[2], 3)
            for name, measure in (("radius", "RadiusRatio"), ("aspect", "AspectRatio")):
                _, mean, largest, _ = quality(surface, measure)
                self.assertAlmostEqual(shape[f"mean_{name}_ratio"], mean, 4)
                self.assertAlmostEqual(shape[f"largest_{name}_ratio"] / largest, 1.0, 4)
            bins = [sum(10 * i <= angle < 10 * i + 10 for angle in angles) for i in range(6)]
            self.assertEqual(sum(shape["smallest_angles"]), len(angles))
            self.assertLessEqual(max(abs(a - b) for a, b in zip(shape["smallest_angles"], bins)), 1)

    def test_the_least_angle_holds(self):
        _, without = self.decimated(MaximumError=0.3)
        result, report = self.decimated(MaximumError=0.3, MinimumAngle=25.0)
        self.assertLess(without["output"]["shape"]["smallest_angle"], 25.0)
        self.assertGreaterEqual(quality(result, "MinAngle")[0], 25.0)
        self.assertEqual(report["angles"]["below_minimum"], 0)
        self.assertEqual(report["proof"]["status"], "proved")


if __name__ == "__main__":
    unittest.main()
