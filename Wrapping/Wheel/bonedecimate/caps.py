# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Closed boundaries, as vtkBoneCap makes them in C++: the core finds loops and caps, VTK triangulates their contours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkContourTriangulator

from . import _core
from .options import number
from .polydata import Cells, cell_array, new_array, numbers, points_of, surface_of
from .transfer import id_list

IS_CAP = "BoneCap"
LOOPS = ("planes", "all")


def close_boundaries(data: vtkPolyData, loops: str, plane_tolerance: float, output: vtkPolyData) -> tuple[dict, list[str]]:
    """Fills output with the surface and its caps; counts, and warnings."""
    if loops not in LOOPS:
        raise ValueError(f"loops is 'planes' or 'all', not {loops!r}")
    if data.GetNumberOfStrips():
        raise ValueError("the mesh has triangle strips; mesh.triangulate() makes triangles of them")
    surface = surface_of(data)
    caps = _core.close_boundaries(
        surface.points, surface.triangles, loops == "all", number("plane_tolerance", plane_tolerance, 0, 1e30, "mm"), _triangulate)
    output.ShallowCopy(data)
    _append_cells(caps, surface.cell_of_triangle, data, output)
    if len(caps["points"]):
        _append_points(caps, surface.points, data, output)
    is_open = caps["open_loops"]
    return caps, surface.warnings + ([f"{is_open} boundaries stay open"] if is_open else [])


def _triangulate(points: NDArray, starts: NDArray, normal: tuple[float, float, float]) -> NDArray[np.int32]:
    """Rows of point ids; none if VTK finds no triangles."""
    following = np.arange(1, len(points) + 1)
    following[starts[1:] - 1] = starts[:-1]
    outlines = vtkPolyData()
    outlines.SetPoints(points_of(points, False))
    outlines.SetLines(cell_array(np.full(len(points), 2), np.stack([np.arange(len(points)), following], axis=1).ravel()))
    polygons = vtkCellArray()
    vtkContourTriangulator.TriangulateContours(outlines, 0, len(points), polygons, normal)
    cells = Cells(polygons, 0, len(points))
    is_good = len(cells.sizes) > 0 and (cells.sizes == 3).all() and not cells.wrong.any()
    return np.ascontiguousarray(cells.ids.reshape(-1, 3) if is_good else np.empty((0, 3)), dtype=np.int32)


def _append_cells(caps: dict, cell_of_triangle: NDArray, data: vtkPolyData, output: vtkPolyData) -> None:
    """Behind the polygons, with the arrays of a neighboring cell."""
    polygons = Cells(data.GetPolys(), 0, data.GetNumberOfPoints())
    triangles = caps["triangles"].astype(np.int64)
    output.SetPolys(cell_array(np.concatenate([polygons.sizes, np.full(len(triangles), 3)]),
                               np.concatenate([polygons.ids, triangles.ravel()])))
    before = data.GetNumberOfCells()
    sources = np.concatenate([np.arange(before), cell_of_triangle[caps["neighbors"]]])
    _copy(data.GetCellData(), sources, output.GetCellData())
    output.GetCellData().RemoveArray(IS_CAP)  # of an earlier run
    is_cap = new_array(vtkUnsignedCharArray, (np.arange(len(sources)) >= before).astype(np.uint8))
    is_cap.SetName(IS_CAP)
    output.GetCellData().AddArray(is_cap)


def _append_points(caps: dict, points: NDArray, data: vtkPolyData, output: vtkPolyData) -> None:
    """Behind the points, with the arrays of one of those that they are between."""
    before = data.GetNumberOfPoints()
    more = vtkPoints()
    more.SetDataType(data.GetPoints().GetDataType())
    more.SetNumberOfPoints(before + len(caps["points"]))
    positions = np.concatenate([points, caps["points"]])
    numbers(more.GetData())[...] = positions.astype(np.float32) if more.GetDataType() == VTK_FLOAT else positions
    output.SetPoints(more)
    _copy(data.GetPointData(), np.concatenate([np.arange(before), np.minimum(caps["ends"], before - 1)]), output.GetPointData())


def _copy(source, ids: NDArray, target) -> None:
    target.CopyAllOn()
    target.CopyAllocate(source, len(ids))
    target.CopyData(source, id_list(ids), id_list(np.arange(len(ids))))
