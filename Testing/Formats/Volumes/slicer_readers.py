# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes and segmentations by 3D Slicer's core (slicer-core)."""

import numpy as np

from readers import LPS, array_of, matrix_of, optional
from truth import NotRead, Reading

slicer_core = optional("slicer_core")


def volume(path, choice):
    import vtk
    storage, node = slicer_core.vtkMRMLVolumeArchetypeStorageNode(), slicer_core.vtkMRMLScalarVolumeNode()
    storage.SetFileName(str(path))
    storage.SetCenterImage(0)
    if not storage.ReadData(node) or node.GetImageData() is None:
        raise NotRead("it is not read")
    matrix = vtk.vtkMatrix4x4()
    node.GetIJKToRASMatrix(matrix)
    affine = matrix_of(matrix)
    return Reading(array_of(node.GetImageData()), affine[:3, 3] * LPS, affine[:3, :3].T * LPS, is_in_units=True, is_turned=True)


def volume_in_mm(path, choice):
    reading = volume(path, choice)
    reading.is_in_units = False
    return reading


def segmentation(path, choice):
    import vtk
    scene = slicer_core.vtkMRMLScene()
    node = scene.AddNewNodeByClass("vtkMRMLSegmentationNode")
    storage = slicer_core.vtkMRMLSegmentationStorageNode()
    storage.SetFileName(str(path))
    if not storage.ReadData(node):
        raise NotRead("it is not read")
    inner = node.GetSegmentation()
    image = slicer_core.vtkOrientedImageData()
    node.GenerateMergedLabelmapForAllSegments(image, slicer_core.vtkSegmentation.EXTENT_UNION_OF_SEGMENTS)
    count = inner.GetNumberOfSegments()
    segments = [inner.GetNthSegment(i) for i in range(count)]
    # It has numbers from 1 on in its label map, and the labels of the file in its segments.
    labels = [one.GetLabelValue() for one in segments]
    layers = [inner.GetLayerIndex(inner.GetNthSegmentID(i)) for i in range(count)]
    final = list(range(1, count + 1)) if max(layers) > 0 and len(set(labels)) < count else labels
    merged = array_of(image).astype(np.int64)
    voxels = np.zeros_like(merged)
    for i, label in enumerate(final):
        voxels[merged == i + 1] = label
    names = [(label, one.GetName(), one.GetColor()) for label, one in zip(final, segments)]
    matrix = vtk.vtkMatrix4x4()
    image.GetImageToWorldMatrix(matrix)
    affine = matrix_of(matrix)
    origin = (affine[:3, :3] @ np.array(image.GetExtent()[::2]) + affine[:3, 3]) * LPS
    return Reading(voxels, origin, affine[:3, :3].T * LPS, names)
