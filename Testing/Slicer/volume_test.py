# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Segmentations that 3D Slicer's core wrote are read as its own export to a label map has them.

Needs the wheel slicer-core; run.sh installs it and calls this.
"""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np
import slicer_core
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from segmentation_test import ball, scene_with

RAS = np.array([-1.0, -1.0, 1.0])


def exported(node):
    """Voxel by position in LPS, rounded, of Slicer's merged label map; labels from 1 on in the order of segments."""
    image = slicer_core.vtkOrientedImageData()
    node.GenerateMergedLabelmapForAllSegments(image, slicer_core.vtkSegmentation.EXTENT_UNION_OF_SEGMENTS)
    matrix = vtk.vtkMatrix4x4()
    image.GetImageToWorldMatrix(matrix)
    to_ras = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    extent = image.GetExtent()
    voxels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(np.array(image.GetDimensions())[::-1])
    z, y, x = np.nonzero(voxels)
    indices = np.stack([x + extent[0], y + extent[2], z + extent[4]], axis=-1)
    positions = (indices @ to_ras[:3, :3].T + to_ras[:3, 3]) * RAS
    return {tuple(position): label for position, label in zip(np.round(positions, 3).tolist(), voxels[z, y, x].tolist())}


class SlicerFiles(unittest.TestCase):
    def read(self, node):
        with tempfile.TemporaryDirectory() as folder:
            path, raw = pathlib.Path(folder) / "bones.seg.nrrd", pathlib.Path(folder) / "raw"
            storage = slicer_core.vtkMRMLSegmentationStorageNode()
            storage.SetFileName(str(path))
            self.assertTrue(storage.WriteData(node))
            completed = subprocess.run([os.environ["DUMP_VOLUME"], path, raw], check=True, capture_output=True, encoding="utf-8")
            found = json.loads(completed.stdout)
            self.assertEqual(found["problem"], "")
            kind = {"unsigned char": np.uint8, "unsigned short": np.uint16, "short": np.int16, "int": np.int32}[found["type"]]
            voxels = np.fromfile(raw, kind).reshape(found["size"][::-1])
        z, y, x = np.nonzero(voxels)
        positions = np.stack([x, y, z], axis=-1) @ np.array(found["steps"]) + found["origin"]
        return found, {tuple(position): label for position, label in
                       zip(np.round(positions, 3).tolist(), voxels[z, y, x].tolist())}

    def test_have_the_voxels_names_and_colors_of_the_scene(self):
        for second, overlaps in ((ball(6, (24, 16, 16)), True), (ball(3, (28, 28, 28)), False)):
            _scene, node, _ids = scene_with(Femur=ball(10), Screw=second)
            found, labels = self.read(node)
            self.assertEqual([segment["name"] for segment in found["segments"]], ["Femur", "Screw"])
            np.testing.assert_allclose([segment["color"] for segment in found["segments"]], [[0, 0.5, 0.75], [0.25, 0.5, 0.75]],
                                       atol=1e-6)
            self.assertEqual(labels, exported(node))
            self.assertEqual("more than one segment" in found["note"], overlaps)


if __name__ == "__main__":
    unittest.main(verbosity=2)
