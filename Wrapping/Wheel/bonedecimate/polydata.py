# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkPolyData as the core's surface: what SurfaceConversion does on the side of C++.

    triangles            as they are
    polygons, strips     triangulated by the core, each triangle with the cell it came from
    ids out of range     -1, which the core rejects with their number
    vertices, lines      kept aside, with the points that they use

The modules of VTK are those that the user has; nothing here depends on their version.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkAbstractArray, vtkDoubleArray, vtkFloatArray, vtkIdTypeArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData

from . import _core
from .left_out import left_out_curves, left_out_of_reader, left_out_polygons
from .surfaces import LeftOut, indices
from .voxels import SurfaceSource


def numbers(array) -> NDArray:
    """The values of a vtkDataArray, shared if they can be."""
    if not array.HasStandardMemoryLayout():
        plain = vtkAbstractArray.CreateArray(array.GetDataType())
        plain.DeepCopy(array)
        array = plain
    if array.GetNumberOfValues() == 0:
        return np.empty((array.GetNumberOfTuples(), array.GetNumberOfComponents()))
    return np.asarray(memoryview(array)).reshape(array.GetNumberOfTuples(), array.GetNumberOfComponents())


def for_vtk(values: NDArray) -> NDArray:
    """The same values as numbers that VTK has, in the byte order of this system."""
    if values.dtype.kind == "b":
        return values.astype(np.uint8)
    if values.dtype.kind == "f" and values.dtype.itemsize not in (4, 8):
        return values.astype(np.float64)
    return values.astype(values.dtype.newbyteorder("="), copy=False)


def array_names(data: vtkDataSetAttributes) -> str:
    """Of the arrays, for a sentence that one is missing."""
    names = [f"'{data.GetArrayName(i)}'" for i in range(data.GetNumberOfArrays()) if data.GetArrayName(i)]
    return ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "") if names else "none"


def new_array(kind, values: NDArray):
    """An array of that class with a row of the values a tuple."""
    array = kind()
    array.SetNumberOfComponents(values.shape[1] if values.ndim == 2 else 1)
    array.SetNumberOfTuples(len(values))
    if values.size:
        with np.errstate(over="ignore"):
            numbers(array)[...] = values.reshape(len(values), -1)
    return array


class Cells:
    """A vtkCellArray as offsets and point ids."""

    def __init__(self, cells, first: int, points: int) -> None:
        count = cells.GetNumberOfCells() if cells else 0
        self.first = first  # number of the first of them in the data set
        self.offsets = numbers(cells.GetOffsetsArray())[:, 0].astype(np.int64) if count else np.zeros(1, np.int64)
        self.ids = np.empty(0, np.int64)
        if count:
            self.ids = numbers(cells.GetConnectivityArray())[:, 0].astype(np.int64)[self.offsets[0]:self.offsets[-1]]
            self.offsets -= self.offsets[0]
        misses = np.concatenate([[0], np.cumsum((self.ids < 0) | (self.ids >= points))])
        self.wrong = misses[self.offsets[1:]] > misses[self.offsets[:-1]]

    @property
    def sizes(self) -> NDArray:
        return np.diff(self.offsets)

    @property
    def numbers(self) -> NDArray:
        return self.first + np.arange(len(self.sizes))

    def keep(self, mask: NDArray) -> tuple[NDArray, NDArray]:
        """Sizes and ids of some."""
        return self.sizes[mask], self.ids[np.repeat(mask, self.sizes)]


def cell_array(sizes: NDArray, ids: NDArray) -> vtkCellArray:
    cells = vtkCellArray()
    offsets = np.concatenate([[0], np.cumsum(sizes)])
    cells.SetData(new_array(vtkIdTypeArray, offsets), new_array(vtkIdTypeArray, ids))
    return cells


@dataclass
class Surface:
    """What goes into the core."""

    points: NDArray[np.float64]
    is_single: bool
    triangles: NDArray[np.int32] = field(default_factory=lambda: np.empty((0, 3), np.int32))
    cell_of_triangle: NDArray[np.int64] = field(default_factory=lambda: np.empty(0, np.int64))
    warnings: list[str] = field(default_factory=list)
    left_out: list[LeftOut] = field(default_factory=list)  # what is no part of the surface
    source: SurfaceSource | None = None  # what is known of its label map


def surface_of(data: vtkPolyData) -> Surface:
    count = data.GetNumberOfPoints()
    points = numbers(data.GetPoints().GetData()) if count else np.empty((0, 3))
    is_single = count > 0 and data.GetPoints().GetDataType() == VTK_FLOAT
    surface = Surface(np.ascontiguousarray(points, dtype=np.float64), is_single)
    first = data.GetNumberOfVerts() + data.GetNumberOfLines()
    polys = Cells(data.GetPolys(), first, count)
    strips = Cells(data.GetStrips(), first + data.GetNumberOfPolys(), count)
    if len(strips.sizes) == 0 and (polys.sizes == 3).all():
        fits = np.where(polys.ids < count, polys.ids, -1)
        surface.triangles, surface.cell_of_triangle = indices(fits.reshape(-1, 3)), polys.numbers
        _leave_out_curves(data, surface)
        return surface
    wrong = np.concatenate([polys.numbers[polys.wrong], strips.numbers[strips.wrong]])
    if len(wrong):  # VTK would crash on it
        surface.triangles, surface.cell_of_triangle = np.full((len(wrong), 3), -1, np.int32), wrong
    else:
        _triangulate(polys, strips, surface)
    _leave_out_curves(data, surface)
    return surface


def _leave_out_curves(data: vtkPolyData, surface: Surface) -> None:
    """Lines, vertices, and what the reader of the file left out."""
    verts, lines = passed_cells(data)
    left_out_curves(verts, lines, surface.points, surface.left_out)
    surface.left_out += left_out_of_reader(data)
    wrong = np.concatenate([verts.numbers[verts.wrong], lines.numbers[lines.wrong]])
    if len(wrong):
        surface.warnings.append(f"{len(wrong)} vertices and lines name points that are not there and were left out, "
                                f"the first is cell {wrong[0]}")


def _triangulate(polys: Cells, strips: Cells, surface: Surface) -> None:
    triangles, cells, left_out, shapes = [], [], [], []
    for group, are_strips in ((polys, False), (strips, True)):
        corners, found = _core.triangulate(surface.points, group.offsets, group.ids, are_strips)
        triangles.append(corners)
        cells.append(group.numbers[found])
        without = np.delete(np.arange(len(group.sizes)), np.unique(found))
        left_out.append(group.numbers[without])
        shapes += [surface.points[group.ids[group.offsets[cell]:group.offsets[cell + 1]]] for cell in without]
    surface.triangles, surface.cell_of_triangle = np.concatenate(triangles), np.concatenate(cells)
    lost = np.concatenate(left_out)
    if len(lost):
        surface.left_out.append(left_out_polygons(lost, shapes))
        polygons, were = ("polygon", "was") if len(lost) == 1 else ("polygons", "were")
        surface.warnings.append(f"{len(lost)} {polygons} of fewer than three different corners {were} left out, "
                                f"the first is cell {lost[0]}")


def passed_cells(data: vtkPolyData) -> tuple[Cells, Cells]:
    """Vertices and lines."""
    count = data.GetNumberOfPoints()
    return Cells(data.GetVerts(), 0, count), Cells(data.GetLines(), data.GetNumberOfVerts(), count)


@dataclass
class Passed:
    """Vertices and lines on their way to the output: the input's ids of what is no part of the surface."""

    points: NDArray[np.int64]  # those after the surface's, in the order in which the cells use them
    cells: NDArray[np.int64]  # those before the triangles
    verts: vtkCellArray
    lines: vtkCellArray


def passed(data: vtkPolyData, own: int) -> Passed:
    """@param own How many points the surface has."""
    groups = passed_cells(data)
    kept = [cells.keep(~cells.wrong) for cells in groups]
    ids = np.concatenate([kept[0][1], kept[1][1]])
    used, first, inverse = np.unique(ids, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    new = own + rank[inverse.reshape(-1)]
    middle = len(kept[0][1])
    return Passed(used[order], np.concatenate([cells.numbers[~cells.wrong] for cells in groups]),
                  cell_array(kept[0][0], new[:middle]), cell_array(kept[1][0], new[middle:]))


def points_of(positions: NDArray, single: bool) -> vtkPoints:
    points = vtkPoints()
    points.SetData(new_array(vtkFloatArray if single else vtkDoubleArray, positions))
    return points


def set_triangles(triangles: NDArray, output: vtkPolyData) -> None:
    output.SetPolys(cell_array(np.full(len(triangles), 3), triangles.reshape(-1)))
