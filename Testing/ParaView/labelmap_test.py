# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of label maps inside ParaView: the panel's properties reach the filter."""

import unittest

from paraview import simple
from vtkmodules.vtkCommonCore import VTK_SHORT
from vtkmodules.vtkCommonDataModel import vtkImageData

import surfaces

SIZE = 10


def image():
    """Two bars that touch, labels 4 and 9; each touches an end of the image."""
    labels = vtkImageData()
    labels.SetDimensions(SIZE, SIZE, SIZE)
    labels.AllocateScalars(VTK_SHORT, 1)
    labels.GetPointData().GetScalars().SetName("Segments")
    for z in range(SIZE):
        for y in range(SIZE):
            for x in range(SIZE):
                inside = 3 < y < 7 and 3 < z < 7
                labels.SetScalarComponentFromDouble(x, y, z, 0, 0 if not inside else 4 if x < 5 else 9)
    return labels


def walls(output):
    array = output.GetCellData().GetArray("BoundaryLabels")
    return {array.GetTuple(cell) for cell in range(output.GetNumberOfCells())}


class LabelMap(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        surfaces.load()
        cls.image = surfaces.source(image())

    def test_surfaces_have_common_walls(self):
        extracted = simple.BoneSurfaces(Input=self.image, LabelArray=["POINTS", "Segments"])
        self.assertEqual(walls(surfaces.output(extracted)), {(4, 0), (9, 0), (4, 9)})

    def test_labels_can_be_chosen(self):
        extracted = simple.BoneSurfaces(Input=self.image, LabelArray=["POINTS", "Segments"], Labels=[9])
        self.assertEqual(walls(surfaces.output(extracted)), {(9, 0)})
        extracted.Labels = []
        extracted.BackgroundLabel = 4
        self.assertEqual(walls(surfaces.output(extracted)), {(0, 4), (9, 4), (0, 9)})

    def test_the_grid_of_a_network_can_be_requested(self):
        extracted = simple.BoneSurfaces(Input=self.image, LabelArray=["POINTS", "Segments"], ModelGrid="off")
        self.assertEqual(surfaces.output(extracted).GetFieldData().GetArray("VoxelGridSpacing").GetTuple(0), (1.0, 1.0, 1.0))
        extracted.ModelGrid = "1,1.5,1.5"
        self.assertNotEqual(surfaces.output(extracted).GetFieldData().GetArray("VoxelGridSpacing").GetTuple(0)[1], 1.0)

    def test_surfaces_can_be_open(self):
        extracted = simple.BoneSurfaces(Input=self.image, LabelArray=["POINTS", "Segments"])
        closed = surfaces.output(extracted).GetNumberOfCells()
        extracted.Closed = 0
        self.assertLess(surfaces.output(extracted).GetNumberOfCells(), closed)

    def test_open_boundaries_are_capped(self):
        extracted = simple.BoneSurfaces(Input=self.image, LabelArray=["POINTS", "Segments"], Labels=[4], Closed=0)
        cap = simple.BoneCap(Input=extracted)
        capped = surfaces.output(cap)
        cap.UpdatePipelineInformation()
        cap.SMProxy.UpdatePropertyInformation()
        loops = [cap.GetProperty(name).GetData() for name in ("NumberOfClosedLoops", "NumberOfOpenLoops")]
        self.assertEqual(loops, [1, 0])
        marks = capped.GetCellData().GetArray("BoneCap")
        caps = [cell for cell in range(capped.GetNumberOfCells()) if marks.GetTuple1(cell) == 1]
        self.assertEqual(len(caps), capped.GetNumberOfCells() - surfaces.output(extracted).GetNumberOfCells())
        for cell in caps:
            self.assertEqual(capped.GetCell(cell).GetBounds()[:2], (0.0, 0.0))

    def test_small_pieces_change_on_request(self):
        labels = image()
        labels.SetScalarComponentFromDouble(2, 5, 5, 0, 9)  # an island in 4
        labels.SetScalarComponentFromDouble(7, 5, 5, 0, 0)  # a cavity in 9
        pieces = simple.BoneLabelPieces(Input=surfaces.source(labels), LabelArray=["POINTS", "Segments"])
        for limits, island, cavity in (({}, 9, 0), ({"IslandVolume": 1.5}, 4, 0), ({"CavityVolume": 1}, 4, 9),
                                       ({"Labels": [9], "CavityVolume": 0}, 4, 0), ({"Labels": [4]}, 9, 0)):
            for name, value in limits.items():
                setattr(pieces, name, value)
            found = surfaces.output(pieces)
            self.assertEqual([found.GetScalarComponentAsDouble(x, 5, 5, 0) for x in (2, 7)], [island, cavity])

    def test_changed_voxels_are_counted(self):
        extracted = simple.BoneSurfaces(Input=self.image, LabelArray=["POINTS", "Segments"])
        decimated = simple.BoneDecimate(Input=extracted, TargetReduction=0.97, KeepVoxels="Off")
        for surface, is_changed in ((extracted, False), (decimated, True)):
            check = simple.BoneVoxelCheck(Input=surface, Segmentation=self.image, LabelArray=["POINTS", "Segments"])
            check.UpdatePipeline()
            check.UpdatePropertyInformation()
            compared, changed = (check.SMProxy.GetProperty(f"NumberOf{name}Voxels").GetElement(0) for name in ("Compared", "Changed"))
            self.assertGreaterEqual(compared, SIZE ** 3)  # and those outside that the surface touches
            self.assertEqual(changed > 0, is_changed)


if __name__ == "__main__":
    unittest.main()
