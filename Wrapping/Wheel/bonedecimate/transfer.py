# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays of the input at the positions of the result's points and cells, as DataTransfer does it in C++.

    point, not moved            the tuple of its input point
    point, floating values      blended in the nearest input triangle; normals get their length back
    point, anything else        the tuple of the nearest input point: ids, labels, text and bits are never blended
    triangle                    the tuple of the input cell nearest to its centroid
    vertices, lines             their own tuples

Tuples are copied by VTK, whatever the type of the array; only blending is done here, with the core's maps.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT, vtkAbstractArray, vtkDataArray, vtkIdList, vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

from .passed_names import passed_name
from .polydata import Passed, Surface, cell_array, new_array, numbers

SHORTEST_NORMAL = 1e-6
ORIGINAL_POINTS, ORIGINAL_CELLS = "OriginalPointIds", "OriginalCellIds"


def transfer_arrays(outcome: dict, surface: Surface, passing: Passed, names: tuple[set[str], set[str]], data: vtkPolyData,
                    output: vtkPolyData) -> None:
    """Every array of points and cells, with its components, information and attribute, but maps of an earlier run.

    @param names Of the point arrays that this run adds, and of those of the input that are left out.
    """
    own, left_out = names
    ids = id_list(np.concatenate([outcome["nearest_point"], passing.points]))
    for index, source, target in _arrays(data.GetPointData(), ids, own, left_out | {ORIGINAL_POINTS}):
        if _is_blended(data.GetPointData(), source):
            _blend(outcome, surface, source, target, source is data.GetPointData().GetNormals())
        _add_like(data.GetPointData(), index, target, output.GetPointData())
    cells = id_list(_cell_sources(outcome, surface, passing))
    for index, _, target in _arrays(data.GetCellData(), cells, set(), {ORIGINAL_CELLS}):
        _add_like(data.GetCellData(), index, target, output.GetCellData())


def add_maps(outcome: dict, surface: Surface, passing: Passed, output: vtkPolyData) -> None:
    points = np.concatenate([outcome["nearest_point"], passing.points])
    _add_ids(ORIGINAL_POINTS, points, output.GetPointData())
    _add_ids(ORIGINAL_CELLS, _cell_sources(outcome, surface, passing), output.GetCellData())


def add_input_map(outcome: dict, copy: vtkPolyData) -> None:
    _add_ids("ResultPointIds", outcome["output_point"], copy.GetPointData())


def recompute_normals(output: vtkPolyData) -> None:
    """Point normals of the result as it is, in index_of_copy of those the input had."""
    surface = vtkPolyData()
    surface.SetPoints(output.GetPoints())
    surface.SetPolys(output.GetPolys())
    compute = vtkPolyDataNormals()
    compute.SetInputData(surface)
    compute.SplittingOff()  # points stay as they are
    compute.ConsistencyOff()
    compute.Update()
    output.GetPointData().SetNormals(compute.GetOutput().GetPointData().GetNormals())


def id_list(ids: NDArray) -> vtkIdList:
    """By way of a cell, which VTK copies at once."""
    found = vtkIdList()
    cell_array(np.array([len(ids)]), ids).GetCellAtId(0, found)
    return found


def _cell_sources(outcome: dict, surface: Surface, passing: Passed) -> NDArray:
    """Of each output cell: the input cell that it represents."""
    return np.concatenate([passing.cells, surface.cell_of_triangle[outcome["triangle_at_centroid"]]])


def _add_ids(name: str, ids: NDArray, data) -> None:
    array = new_array(vtkIdTypeArray, ids)
    array.SetName(name)
    data.AddArray(array)


def _arrays(data, ids: vtkIdList, own: set[str], without: set[str]):
    """Each array to be passed on: its index, itself, and one like it with the tuples of the ids."""
    for index in range(data.GetNumberOfArrays()):
        source = data.GetAbstractArray(index)
        name = passed_name(source, own, data)
        if name is None or name in without:
            continue
        # Of its type and not of its class: arrays that compute their values cannot hold others.
        target = vtkAbstractArray.CreateArray(source.GetDataType())
        if source.GetName() is not None:
            target.SetName(name)
        target.SetNumberOfComponents(source.GetNumberOfComponents())
        target.CopyComponentNames(source)
        if source.HasInformation():
            target.CopyInformation(source.GetInformation())
        target.SetNumberOfTuples(ids.GetNumberOfIds())
        source.GetTuples(ids, target)
        yield index, source, target


def _add_like(data, index: int, array, output) -> None:
    """In the order of the input, active as what it was."""
    index_of_copy = output.AddArray(array)
    attribute = data.IsArrayAnAttribute(index)
    if attribute >= 0:
        output.SetActiveAttribute(index_of_copy, attribute)


def _is_blended(data, array) -> bool:
    return (isinstance(array, vtkDataArray) and array.GetDataType() in (VTK_FLOAT, VTK_DOUBLE)
            and array is not data.GetGlobalIds() and array is not data.GetPedigreeIds())


def _blend(outcome: dict, surface: Surface, source, target, is_normal: bool) -> None:
    """Points that lie where their input point does keep its tuple."""
    nearest = outcome["nearest_point"]
    moved = np.flatnonzero((outcome["points"] != surface.points[nearest]).any(axis=1))
    if not len(moved):
        return
    given, rows = numbers(source), numbers(target)
    corners = surface.triangles[outcome["nearest_triangle"][moved]]
    weights = outcome["barycentric"][moved]
    values = np.zeros((len(moved), given.shape[1]))
    with np.errstate(all="ignore"):
        for corner in range(3):
            weight = weights[:, corner, None]
            # A corner without weight may be anything, not a number too.
            values += np.where(weight == 0, 0.0, weight * given[corners[:, corner]].astype(np.float64))
        rows[moved] = values
        if is_normal:
            _normalize(given, rows, moved, nearest)


def _normalize(given: NDArray, rows: NDArray, moved: NDArray, nearest: NDArray) -> None:
    """Between opposite normals there is none: then that of the nearest point."""
    normals = rows[moved].astype(np.float64)
    x, y, z = normals.T
    length = np.sqrt(x * x + y * y + z * z)
    rows[moved] = np.where((length < SHORTEST_NORMAL)[:, None], given[nearest[moved]], normals / length[:, None])
