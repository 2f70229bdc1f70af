# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Voxels that a surface encloses and distances between surfaces, by VTK: on grids that are sheared, or whose layers have positions of their own."""

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def _flattened(surface, matrix):
    """@param matrix From (i, j, mm along the third axis) to mm, (4, 4)."""
    transform = vtk.vtkTransform()
    transform.SetMatrix(numpy.linalg.inv(matrix).ravel())
    moved = vtk.vtkTransformPolyDataFilter()
    moved.SetTransform(transform)
    moved.SetInputData(surface)
    moved.SetOutputPointsPrecision(vtk.vtkAlgorithm.DOUBLE_PRECISION)
    moved.Update()
    return moved.GetOutput()


def enclosed(surface, shape, matrix, layers):
    """Which voxels (z, y, x) have their center inside of a closed surface. @param layers mm along the third axis, of each layer."""
    flat = _flattened(surface, matrix)
    inside = []
    for height in layers:
        stencil = vtk.vtkPolyDataToImageStencil()
        stencil.SetInputData(flat)
        stencil.SetTolerance(0.0)
        stencil.SetOutputOrigin(0.0, 0.0, height)
        stencil.SetOutputWholeExtent(0, shape[2] - 1, 0, shape[1] - 1, 0, 0)
        image = vtk.vtkImageStencilToImage()
        image.SetInputConnection(stencil.GetOutputPort())
        image.SetInsideValue(1)
        image.SetOutsideValue(0)
        image.SetOutputScalarTypeToUnsignedChar()
        image.Update()
        inside.append(vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).reshape(shape[1:]) > 0)
    return numpy.array(inside)


def wrong_voxels(surface, is_label, matrix, layers):
    """How many voxels are on another side of the surface than the label map says."""
    return int((enclosed(surface, is_label.shape, matrix, layers) != is_label).sum())


def largest_distance(one, other):
    """mm, from the points and centroids of each surface to the other: a lower bound of the distance of both."""
    largest = 0.0
    for moving, fixed in ((one, other), (other, one)):
        locator = vtk.vtkStaticCellLocator()
        locator.SetDataSet(fixed)
        locator.BuildLocator()
        centers = vtk.vtkCellCenters()
        centers.SetInputData(moving)
        centers.Update()
        point, cell, sub, squared = [0.0] * 3, vtk.reference(0), vtk.reference(0), vtk.reference(0.0)
        for points in (moving.GetPoints(), centers.GetOutput().GetPoints()):
            for position in vtk_to_numpy(points.GetData()):
                locator.FindClosestPoint(position.tolist(), point, cell, sub, squared)
                largest = max(largest, float(squared))
    return largest**0.5
