# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels of triangles from an array of cells or points: what LabelArrays does on the side of C++."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .polydata import Surface, array_names, numbers
from .surfaces import named_labels


def labels_of(data: vtkPolyData, surface: Surface, name: str) -> tuple[NDArray[np.int64], list[str]]:
    """For each triangle the index of its label in a list of names. Raises ValueError without an array of whole numbers."""
    cells = data.GetCellData().GetArray(name)
    array = cells if cells is not None else data.GetPointData().GetArray(name)
    if array is None:
        raise ValueError(f"the input has no cell or point array '{name}' of whole numbers (of cells there are: {array_names(data.GetCellData())}; "
                         f"of points: {array_names(data.GetPointData())})")
    return labels_from_array(data, surface, array, cells is not None)


def labels_from_array(data: vtkPolyData, surface: Surface, array: vtkDataArray,
                      is_of_cells: bool) -> tuple[NDArray[np.int64], list[str]]:
    """The same of an array of cells or points."""
    needed = data.GetNumberOfCells() if is_of_cells else data.GetNumberOfPoints()
    named = named_labels(numbers(array)) if array.GetNumberOfTuples() >= needed else None
    if named is None:
        raise ValueError(f"the input has no cell or point array '{array.GetName()}' of whole numbers")
    ids, names = named
    if is_of_cells:
        indices = ids[surface.cell_of_triangle]
    else:
        corners = np.asarray(surface.triangles)
        isThere = (corners >= 0) & (corners < needed)  # the core rejects the others
        a, b, c = np.where(isThere, ids[np.where(isThere, corners, 0)], 0).T
        indices = np.where(b == c, b, np.where((a == b) | (a == c), a, np.minimum(np.minimum(a, b), c)))
    return np.ascontiguousarray(indices), names
