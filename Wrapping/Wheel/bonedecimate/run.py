# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A run on vtkPolyData, with everything that the C++ filter gives out; for the filter, PyVista and the program."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkDataArray, vtkDoubleArray, vtkIntArray, vtkStringArray, vtkTypeInt64Array
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import _core
from .arrays import gives_single
from .label_arrays import pass_label_arrays, surface_with_source
from .labels import labels_from_array, labels_of
from .left_out import LEFT_OUT
from .polydata import Passed, Surface, array_names, passed, points_of, set_triangles
from .progress import Progress
from .surface_report import REPORT
from .surfaces import surface_from
from .passed_names import array_warnings, arrays_with_seams, keep_user_arrays, own_point_arrays
from .transfer import add_input_map, add_maps, recompute_normals, transfer_arrays

if TYPE_CHECKING:
    from .surfaces import SurfaceLike

ENTRY_ARRAYS = {int: vtkTypeInt64Array, float: vtkDoubleArray, str: vtkStringArray}


class InputArrays(NamedTuple):
    """Arrays of the input that are chosen without a name; a name among the options takes precedence."""
    tolerances: vtkDataArray | None = None  # of points
    labels: vtkDataArray | None = None
    labels_are_of_cells: bool = False


def run(data: vtkPolyData, options: _core.Options, progress: Progress | None, reference: SurfaceLike | None = None,
        arrays: InputArrays = InputArrays(), prepared: _core.PreparedSurface | None = None) -> tuple[dict, Surface]:
    """The result of the core, with the warnings of both. Raises ValueError if the input lacks an array that is named.

    @param reference The surface that the input was made from, if the largest error is proved against it.
    @param prepared Keeps what runs over regions of the same surface have in common.
    """
    is_filled = data.GetNumberOfPoints() > 0
    name = options.get("ToleranceArrayName")
    array = data.GetPointData().GetArray(name) if name else arrays.tolerances
    tolerances = _values_of(data, array, name) if is_filled and (name or array is not None) else None
    name = options.get("EdgeLengthArrayName")
    edge_lengths = _values_of(data, data.GetPointData().GetArray(name), name) if is_filled and name else None
    surface = surface_with_source(data)
    if surface.source is not None and surface.source.grid is None:
        surface.source = None
    name = options.get("LabelArrayName")
    labels = None
    if is_filled and name:
        labels = labels_of(data, surface, name)
    elif is_filled and arrays.labels is not None:
        labels = labels_from_array(data, surface, arrays.labels, arrays.labels_are_of_cells)
    has_arrays = data.GetPointData().GetNumberOfArrays() + data.GetCellData().GetNumberOfArrays() > 0
    origins = options.get("MakeMaps") or (options.get("PassArrays") and has_arrays)
    first = None if reference is None else surface_from(reference, "reference")
    outcome = _core.decimate(surface.points, surface.triangles, options, surface.is_single, origins, tolerances,
                             surface.cell_of_triangle, first and first[:2], progress, labels,
                             surface.source and surface.source.to_core(), prepared, edge_lengths,
                             list((surface if first is None else first).left_out))
    outcome["warnings"] = (surface.warnings + (first.warnings if first else []) + array_warnings(data, options)
                           + outcome["warnings"])
    return outcome, surface


def fill_output(outcome: dict, surface: Surface, options: _core.Options, data: vtkPolyData, output: vtkPolyData) -> None:
    single = gives_single(options, surface.is_single)
    passing = passed(data, len(outcome["points"]))
    positions = outcome["points"]
    if len(passing.points):
        positions = np.concatenate([positions, surface.points[passing.points]])
    output.SetVerts(passing.verts)
    output.SetLines(passing.lines)
    set_triangles(outcome["triangles"], output)
    output.SetPoints(points_of(positions, single))
    _add_input_arrays(outcome, surface, options, passing, data, output)
    _add_own_arrays(outcome, options, output)
    if surface.source is not None:
        pass_label_arrays(surface.source, outcome["boundary_labels"], output)
    output.GetFieldData().PassData(data.GetFieldData())
    output.GetFieldData().RemoveArray(LEFT_OUT)
    bound = {"entries": outcome["entries_of_surface"], "json": outcome["json_of_surface"]}
    set_report(bound, REPORT, "bonedecimate.", _core.key_figures(), output)


def fill_input_copy(outcome: dict, options: _core.Options, data: vtkPolyData, output: vtkPolyData) -> None:
    """The input with the distance of each of its points to the result, and the map, if the options request them."""
    output.ShallowCopy(data)
    keep_user_arrays(output, options)
    for key, name in (("input_distance", "InputDistanceArrayName"), ("input_error_bound", "InputErrorBoundArrayName")):
        if len(outcome[key]):
            add_point_array(output, options.get(name), "mm", outcome[key], vtkDoubleArray)
    if options.get("MakeMaps") and len(outcome["output_point"]):
        add_input_map(outcome, output)


def set_report(outcome: dict, json_name: str, prefix: str, key_figures: list[str], output: vtkPolyData) -> None:
    """The report as one JSON text of the field data, its key figures as arrays of their own; replaces those of earlier runs."""
    fields = output.GetFieldData()
    for i in reversed(range(fields.GetNumberOfArrays())):
        name = fields.GetArrayName(i) or ""
        if name.startswith(prefix) or name in (json_name, "BoneDecimateCertificate"):
            fields.RemoveArray(i)
    figures = [entry for entry in outcome["entries"] if entry[0] in key_figures]
    for name, unit, value in [(json_name, "", outcome["json"]), *((prefix + name, *rest) for name, *rest in figures)]:
        array = ENTRY_ARRAYS[type(value)]()
        array.InsertNextValue(value)
        array.SetName(name)
        if unit:
            array.SetComponentName(0, unit)
        fields.AddArray(array)


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


def _values_of(data: vtkPolyData, array: vtkDataArray | None, name: str) -> NDArray[np.float64]:
    if array is None or array.GetNumberOfComponents() != 1:
        raise ValueError(f"the input has no point array '{name}' of one component (there are: {array_names(data.GetPointData())})")
    values = vtkDoubleArray()
    values.DeepCopy(array)  # of any type of number
    return np.array(memoryview(values)) if values.GetNumberOfTuples() else np.empty(0)


def _add_input_arrays(outcome: dict, surface: Surface, options: _core.Options, passing: Passed, data: vtkPolyData,
                      output: vtkPolyData) -> None:
    """What the input knew, carried over. Aborted runs do not know where their points lie."""
    is_known = len(outcome["nearest_point"]) == len(outcome["points"])
    if options.get("PassArrays") and is_known:
        transfer_arrays(outcome, surface, passing, (own_point_arrays(options), arrays_with_seams(data, options)), data, output)
    if options.get("MakeMaps") and is_known:
        add_maps(outcome, surface, passing, output)
    if options.get("RecomputeNormals"):
        recompute_normals(output)


def _add_own_arrays(outcome: dict, options: _core.Options, output: vtkPolyData) -> None:
    if len(outcome["distance"]) or not len(outcome["points"]):
        add_point_array(output, options.get("DistanceArrayName"), "mm", outcome["distance"], vtkDoubleArray)
        add_point_array(output, options.get("RunningErrorArrayName"), "mm", outcome["running_error"], vtkDoubleArray)
    add_point_array(output, options.get("PointCountArrayName"), "points", outcome["point_count"], vtkIntArray, 1)
    if len(outcome["error_bound"]):
        add_point_array(output, options.get("ErrorBoundArrayName"), "mm", outcome["error_bound"], vtkDoubleArray)


def endings(outcome: dict) -> list[str]:
    """A sentence if the progress function ended the run."""
    is_ended = outcome["stop"] == _core.StopReason.Aborted
    return ["the progress function ended the run: the mesh is decimated in part, and nothing is proved"] if is_ended else []
