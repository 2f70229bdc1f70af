# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces as arrays, and as VTK's data sets."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from vtkmodules import vtkFiltersCore
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData


class Surface(NamedTuple):
    """Points (n, 3), mm, and triangles (m, 3)."""

    points: np.ndarray
    triangles: np.ndarray


def image_of(values: np.ndarray, spacing: Any, origin: Any = (0.0, 0.0, 0.0)) -> vtkImageData:
    """Of values with indices z, y, x."""
    image = vtkImageData()
    image.SetDimensions(*values.shape[::-1])
    image.SetSpacing(*spacing)
    image.SetOrigin(*origin)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=True))
    return image


def arrays_of(surface: vtkPolyData) -> Surface:
    if surface.GetNumberOfPolys() == 0:
        return Surface(np.empty((0, 3)), np.empty((0, 3), np.int64))
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    return Surface(points, vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(np.int64))


def polydata_of(surface: Surface) -> vtkPolyData:
    points, cells, polydata = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(surface.points, float), deep=True))
    offsets = np.arange(0, 3 * len(surface.triangles) + 1, 3, dtype=np.int64)
    corners = np.ascontiguousarray(surface.triangles, np.int64).ravel()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(corners, deep=True))
    polydata.SetPoints(points)
    polydata.SetPolys(cells)
    return polydata


def isosurface(image: vtkImageData, value: float) -> vtkPolyData:
    """Marching cubes, without triangles of zero area."""
    contour = vtkFiltersCore.vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, value)
    contour.ComputeNormalsOff()
    contour.ComputeGradientsOff()
    contour.ComputeScalarsOff()
    clean = vtkFiltersCore.vtkCleanPolyData()
    clean.SetInputConnection(contour.GetOutputPort())
    clean.SetTolerance(0.0)
    clean.ConvertPolysToLinesOff()
    clean.Update()
    return clean.GetOutput()
