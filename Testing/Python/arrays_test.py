# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The output's arrays seen through numpy."""

import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from surfaces import POINTS, decimating, torus


def column(surface, name):
    return vtk_to_numpy(surface.GetPointData().GetArray(name))


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.input = torus()
        cls.decimate = decimating(cls.input, TargetReduction=0.5, MeasureInputDistances=True)
        cls.decimate.Update()
        cls.output = cls.decimate.GetOutput()

    def test_have_one_number_for_each_point(self):
        for name in ("Distance", "RunningError", "InputPointCount"):
            self.assertEqual(column(self.output, name).shape, (self.output.GetNumberOfPoints(),))
        self.assertTrue(numpy.issubdtype(column(self.output, "InputPointCount").dtype, numpy.integer))

    def test_have_their_unit_as_the_name_of_the_component(self):
        self.assertEqual(self.output.GetPointData().GetArray("Distance").GetComponentName(0), "mm")

    def test_of_point_counts_add_up_to_the_input(self):
        self.assertEqual(column(self.output, "InputPointCount").sum(), POINTS)

    def test_of_distances_agree_with_the_report(self):
        self.assertAlmostEqual(
            column(self.output, "Distance").max(), self.decimate.GetReportValue("distance.output_to_input.point_max")
        )

    def test_on_the_second_port_have_one_distance_for_each_input_point(self):
        distances = column(self.decimate.GetOutput(1), "DistanceToResult")
        self.assertEqual(distances.shape, (POINTS,))
        self.assertTrue((distances >= 0).all())
        self.assertGreater(distances.max(), 0)

    def test_of_single_precision_points_are_floats(self):
        decimate = decimating(self.input, OutputPointsPrecision=vtkAlgorithm.SINGLE_PRECISION)
        decimate.Update()
        self.assertEqual(vtk_to_numpy(decimate.GetOutput().GetPoints().GetData()).dtype, numpy.float32)
        self.assertEqual(vtk_to_numpy(self.output.GetPoints().GetData()).dtype, numpy.float64)


if __name__ == "__main__":
    unittest.main()
