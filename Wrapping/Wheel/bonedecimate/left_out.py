# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What of a mesh is no surface to be proved, in the words of the filter (LeftOutCells.h)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .polydata import Cells
    from .surfaces import LeftOut

LEFT_OUT = "BoneDecimateLeftOut"  # field array of readers: kind, count and noun of each entry, and where its first is


def left_out_polygons(cells: NDArray, corners: list[NDArray]) -> LeftOut:
    """@param corners Of each cell the positions, which are at most two different ones."""
    shapes = []
    for points in corners:
        if len(points):
            others = points[(points != points[0]).any(axis=1)]
            last = others[0] if len(others) else points[0]
            shapes.append([points[0], last, last])
    polygons = "polygon" if len(cells) == 1 else "polygons"
    return ("polygons", len(cells), f"{polygons} of fewer than three different corners", f"cell {cells[0]}", _corners(shapes))


def left_out_curves(verts: Cells, lines: Cells, points: NDArray, found: list[LeftOut]) -> None:
    for kind, cells, one, is_line in (("lines", lines, "line", True), ("vertices", verts, "vertex cell", False)):
        right = np.flatnonzero(~cells.wrong)
        if len(right):
            _, ids = cells.keep(~cells.wrong)
            first = points[ids]
            last = first
            if is_line and len(ids):
                ends = np.cumsum(cells.sizes[right]) - 1
                following = np.arange(len(ids)) + 1
                following[ends[ends >= 0]] -= 1
                last = first[following]
            found.append((kind, len(right), one if len(right) == 1 else one + "s", f"cell {cells.numbers[right[0]]}",
                          _corners(np.stack([first, last, last], axis=1))))
    wrong = np.concatenate([lines.numbers[lines.wrong], verts.numbers[verts.wrong]])
    if len(wrong):
        what = ("line or vertex that names points that are not there" if len(wrong) == 1
                else "lines and vertices that name points that are not there")
        found.append(("lines", len(wrong), what, f"cell {wrong[0]}", _corners([])))


def left_out_of_reader(data: vtkPolyData) -> list[LeftOut]:
    array = data.GetFieldData().GetAbstractArray(LEFT_OUT)
    texts = [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array is not None else []
    return [(kind, int(count), what, where, _corners([]))
            for kind, count, what, where in zip(texts[::4], texts[1::4], texts[2::4], texts[3::4])]


def _corners(shapes: object) -> NDArray[np.float64]:
    return np.ascontiguousarray(shapes, dtype=np.float64).reshape(-1, 3, 3)
