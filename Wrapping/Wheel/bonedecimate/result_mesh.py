# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A result of arrays as a vtkPolyData with the arrays and the report that the filter gives to its output."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import _core
from .label_arrays import BOUNDARY_LABELS, LABEL_VALUES, add_grid
from .polydata import for_vtk, points_of, set_triangles
from .run import set_report
from .surface_report import REPORT

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from vtkmodules.vtkCommonDataModel import vtkFieldData

    from .results import Result

# Of points: the array of the result, the option that names it, its unit.
OF_POINTS = (("distance", "DistanceArrayName", "mm"), ("running_error", "RunningErrorArrayName", "mm"),
             ("point_count", "PointCountArrayName", "points"), ("error_bound", "ErrorBoundArrayName", "mm"))


def mesh_of(result: Result) -> vtkPolyData:
    mesh = vtkPolyData()
    set_triangles(result.triangles, mesh)
    mesh.SetPoints(points_of(result.points, result.points.dtype == np.float32))
    for name, option, unit in OF_POINTS:
        _add(mesh.GetPointData(), result.report["options." + option], getattr(result, name), unit)
    _add(mesh.GetPointData(), "OriginalPointIds", result.nearest_point)
    _add(mesh.GetCellData(), "OriginalCellIds", result.triangle_at_centroid)
    if result.labels.dtype.kind in "iufb":
        _add(mesh.GetCellData(), "Labels", result.labels)
    _add(mesh.GetCellData(), BOUNDARY_LABELS, result.boundary_labels)
    _add(mesh.GetFieldData(), LABEL_VALUES, result.label_values)
    if result.grid is not None:
        add_grid(result.grid, mesh)
    entries, text = result.report_of_surface
    set_report({"entries": entries, "json": text}, REPORT, "bonedecimate.", _core.key_figures(), mesh)
    return mesh


def _add(data: vtkFieldData, name: str, values: NDArray, unit: str = "") -> None:
    """Nothing for an empty array."""
    if len(values):
        array = numpy_to_vtk(np.ascontiguousarray(for_vtk(values)), deep=True)
        array.SetName(name)
        if unit:
            array.SetComponentName(0, unit)
        data.AddArray(array)
