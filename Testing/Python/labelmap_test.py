# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of label maps from Python."""

import unittest

from vtkmodules.vtkCommonCore import VTK_SHORT
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges

from bonedecimate import vtkBoneDecimate, vtkBoneSurfaces

SIZE = 12


def image():
    """A ball of two halves, labels 1 and 5."""
    labels = vtkImageData()
    labels.SetDimensions(SIZE, SIZE, SIZE)
    labels.SetSpacing(0.5, 0.5, 1.0)
    labels.AllocateScalars(VTK_SHORT, 1)
    for z in range(SIZE):
        for y in range(SIZE):
            for x in range(SIZE):
                inside = (x - 5.5) ** 2 + (y - 5.5) ** 2 + (z - 5.5) ** 2 < 20
                labels.SetScalarComponentFromDouble(x, y, z, 0, 0 if not inside else 1 if x < 6 else 5)
    return labels


def boundary_edges(surface):
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


class SurfacesOfLabels(unittest.TestCase):
    def test_have_the_arrays_of_the_label_map(self):
        surfaces = vtkBoneSurfaces(number_of_threads=2)
        surfaces.SetInputData(image())
        surfaces.Update()
        output = surfaces.GetOutput()
        labels = output.GetCellData().GetArray("BoundaryLabels")
        walls = {labels.GetTuple(cell) for cell in range(output.GetNumberOfCells())}
        self.assertEqual(walls, {(1, 0), (5, 0), (1, 5)})
        fields = output.GetFieldData()
        values = fields.GetArray("LabelValues")
        self.assertEqual([values.GetValue(i) for i in range(values.GetNumberOfTuples())], [1, 5, 0])
        self.assertEqual(fields.GetArray("VoxelGridSpacing").GetTuple(0), (0.5, 0.5, 1.0))
        self.assertEqual(fields.GetArray("VoxelGridDimensions").GetTuple(0), (SIZE, SIZE, SIZE))
        self.assertEqual(fields.GetArray("VoxelGridDirection").GetTuple(0), (1, 0, 0, 0, 1, 0, 0, 0, 1))
        self.assertEqual(output.GetPointData().GetArray("GridPoint").GetNumberOfComponents(), 3)

    def test_are_closed_label_by_label_before_and_after_decimation(self):
        surfaces = vtkBoneSurfaces()
        surfaces.SetInputData(image())
        decimate = vtkBoneDecimate(label_array_name="BoundaryLabels", target_reduction=0.5)
        decimate.SetInputConnection(surfaces.GetOutputPort())
        decimate.Update()
        for whole in (surfaces.GetOutput(), decimate.GetOutput()):
            for label in (1, 5):
                single = vtkPolyData()
                self.assertTrue(vtkBoneSurfaces.ExtractLabel(whole, label, single))
                self.assertEqual(boundary_edges(single), 0)
            self.assertFalse(vtkBoneSurfaces.ExtractLabel(whole, 7, vtkPolyData()))

    def test_of_chosen_labels(self):
        surfaces = vtkBoneSurfaces(background_label=1, closed=False)
        surfaces.AddLabel(5)
        self.assertEqual((surfaces.number_of_labels, surfaces.GetLabel(0), surfaces.closed), (1, 5, False))
        surfaces.SetInputData(image())
        surfaces.Update()
        self.assertEqual(surfaces.GetOutput().GetFieldData().GetArray("LabelValues").GetTuple(0), (5,))

    def test_tell_their_defaults(self):
        for name in vars(vtkBoneSurfaces):
            if name.startswith("Set"):
                with self.subTest(name):
                    self.assertRegex(getattr(vtkBoneSurfaces, name).__doc__, r"[Dd]efault")


if __name__ == "__main__":
    unittest.main()
