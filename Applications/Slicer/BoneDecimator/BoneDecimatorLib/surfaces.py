# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays as vtkPolyData."""

import json

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

REPORT, DISTANCE, COLORS = "BoneDecimateReport", "Distance", "Colors"  # names of arrays


def polydata_of(points, corners):
    """@param points (n, 3), mm. @param corners (m, 3), of triangles."""
    surface = vtk.vtkPolyData()
    positions = vtk.vtkPoints()
    positions.SetData(numpy_to_vtk(points, deep=True))
    cells = vtk.vtkCellArray()
    offsets = np.arange(0, 3 * len(corners) + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(corners.astype(np.int64).ravel(), deep=True))
    surface.SetPoints(positions)
    surface.SetPolys(cells)
    return surface


def set_distance(surface, distance):
    """mm, of each point to the surface before simplification."""
    array = numpy_to_vtk(distance, deep=True)
    array.SetName(DISTANCE)
    surface.GetPointData().AddArray(array)


def set_colors(surface, colors):
    """@param colors (m, 3), from 0 to 1, of triangles."""
    array = numpy_to_vtk(np.rint(255 * colors).astype(np.uint8), deep=True)
    array.SetName(COLORS)
    surface.GetCellData().AddArray(array)


def set_report(surface, report):
    """@param report Nested dictionaries."""
    text = vtk.vtkStringArray()
    text.SetName(REPORT)
    text.InsertNextValue(json.dumps(report))
    surface.GetFieldData().AddArray(text)


def report_of(surface):
    """The report of the run as nested dictionaries; empty if there is none."""
    array = surface.GetFieldData().GetAbstractArray(REPORT)
    return json.loads(array.GetValue(0)) if array is not None and array.GetNumberOfValues() > 0 else {}
