# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A run on vtkPolyData, with everything that the C++ filter gives out; for the filter, PyVista and the program."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray, vtkStringArray, vtkTypeInt64Array
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import _core
from .arrays import gives_single
from .labels import labels_of
from .polydata import Passed, Surface, passed, points_of, set_triangles, surface_of
from .progress import Progress
from .surfaces import surface_from
from .transfer import add_input_map, add_maps, recompute_normals, transfer_arrays

if TYPE_CHECKING:
    from .surfaces import SurfaceLike

ENTRY_ARRAYS = {int: vtkTypeInt64Array, float: vtkDoubleArray, str: vtkStringArray}


def run(data: vtkPolyData, options: _core.Options, progress: Progress | None,
        reference: SurfaceLike | None = None) -> tuple[dict, Surface]:
    """What the core says of it, its warnings and ours together. Raises ValueError without the arrays that are named.

    @param reference What the input was made from, if the largest error is promised against that.
    """
    name = options.get("ToleranceArrayName")
    tolerances = _point_values(data, name) if name and data.GetNumberOfPoints() else None
    surface = surface_of(data)
    name = options.get("LabelArrayName")
    labels = labels_of(data, surface, name) if name and data.GetNumberOfPoints() else None
    has_arrays = data.GetPointData().GetNumberOfArrays() + data.GetCellData().GetNumberOfArrays() > 0
    origins = options.get("MakeMaps") or (options.get("PassArrays") and has_arrays)
    first = None if reference is None else surface_from(reference, "reference")
    answer = _core.decimate(surface.points, surface.triangles, options, surface.is_single, origins, tolerances,
                            surface.cell_of_triangle, first and first[:2], progress, labels)
    answer["warnings"] = surface.warnings + (first.warnings if first else []) + answer["warnings"]
    return answer, surface


def fill_output(answer: dict, surface: Surface, options: _core.Options, data: vtkPolyData, output: vtkPolyData) -> None:
    single = gives_single(options, surface.is_single)
    passing = passed(data, len(answer["points"]))
    places = answer["points"]
    if len(passing.points):
        places = np.concatenate([places, surface.points[passing.points]])
    output.SetVerts(passing.verts)
    output.SetLines(passing.lines)
    set_triangles(answer["triangles"], output)
    output.SetPoints(points_of(places, single))
    _add_input_arrays(answer, surface, options, passing, data, output)
    _add_own_arrays(answer, options, output)
    output.GetFieldData().PassData(data.GetFieldData())
    remove_entries("bonedecimate.", output)
    add_entries(answer["entries"], "bonedecimate.", output)


def fill_input_copy(answer: dict, options: _core.Options, data: vtkPolyData, output: vtkPolyData) -> None:
    """The input with the distance of each of its points to the result, and the map, if they were asked for."""
    output.ShallowCopy(data)
    for key, name in (("input_distance", "InputDistanceArrayName"), ("input_error_bound", "InputErrorBoundArrayName")):
        if len(answer[key]):
            add_point_array(output, options.get(name), "mm", answer[key], vtkDoubleArray)
    if options.get("MakeMaps") and len(answer["output_point"]):
        add_input_map(answer, output)


def remove_entries(prefix: str, output: vtkPolyData) -> None:
    """What an earlier run said of its result is not true of this one."""
    fields = output.GetFieldData()
    for i in reversed(range(fields.GetNumberOfArrays())):
        if (fields.GetArrayName(i) or "").startswith(prefix):
            fields.RemoveArray(i)


def add_entries(entries: list, prefix: str, output: vtkPolyData) -> None:
    """One array of field data an entry of a report."""
    for name, unit, value in entries:
        array = ENTRY_ARRAYS[type(value)]()
        array.InsertNextValue(value)
        array.SetName(prefix + name)
        if unit:
            array.SetComponentName(0, unit)
        output.GetFieldData().AddArray(array)


def add_point_array(output: vtkPolyData, name: str, unit: str, values: NDArray, kind, rest: float = 0) -> None:
    """@param rest Of the points after those of the surface."""
    array = kind()
    array.SetName(name)
    array.SetNumberOfTuples(output.GetNumberOfPoints())
    array.Fill(rest)
    if len(values):
        np.asarray(memoryview(array))[:len(values)] = values
    array.SetComponentName(0, unit)
    output.GetPointData().AddArray(array)


def _point_values(data: vtkPolyData, name: str) -> NDArray[np.float64]:
    array = data.GetPointData().GetArray(name)
    if array is None or array.GetNumberOfComponents() != 1:
        raise ValueError(f"the input has no point array '{name}' of one component")
    values = vtkDoubleArray()
    values.DeepCopy(array)  # of any type of number
    return np.array(memoryview(values)) if values.GetNumberOfTuples() else np.empty(0)


def _add_input_arrays(answer: dict, surface: Surface, options: _core.Options, passing: Passed, data: vtkPolyData,
                      output: vtkPolyData) -> None:
    """What the input knew, carried over. Aborted runs do not know where their points lie."""
    is_known = len(answer["nearest_point"]) == len(answer["points"])
    if options.get("PassArrays") and is_known:
        own = {options.get(name + "ArrayName") for name in ("Distance", "RunningError", "PointCount", "ErrorBound")}
        transfer_arrays(answer, surface, passing, own | {"OriginalPointIds", "OriginalCellIds"}, data, output)
    if options.get("MakeMaps") and is_known:
        add_maps(answer, surface, passing, output)
    if options.get("RecomputeNormals"):
        recompute_normals(output)


def _add_own_arrays(answer: dict, options: _core.Options, output: vtkPolyData) -> None:
    if len(answer["distance"]) or not len(answer["points"]):
        add_point_array(output, options.get("DistanceArrayName"), "mm", answer["distance"], vtkDoubleArray)
        add_point_array(output, options.get("RunningErrorArrayName"), "mm", answer["running_error"], vtkDoubleArray)
    add_point_array(output, options.get("PointCountArrayName"), "points", answer["point_count"], vtkIntArray, 1)
    if len(answer["error_bound"]):
        add_point_array(output, options.get("ErrorBoundArrayName"), "mm", answer["error_bound"], vtkDoubleArray)
