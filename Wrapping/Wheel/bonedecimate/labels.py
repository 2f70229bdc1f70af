# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels of triangles from an array of cells or points: what LabelArrays does on the side of C++."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .polydata import Surface, numbers
from .surfaces import named_labels


def labels_of(data: vtkPolyData, surface: Surface, name: str) -> tuple[NDArray[np.int64], list[str]]:
    """Of each triangle a position in a list of names. Raises ValueError without an array of whole numbers."""
    cells = data.GetCellData().GetArray(name)
    array = cells if cells is not None else data.GetPointData().GetArray(name)
    needed = data.GetNumberOfCells() if cells is not None else data.GetNumberOfPoints()
    named = named_labels(numbers(array)) if array is not None and array.GetNumberOfTuples() >= needed else None
    if named is None:
        raise ValueError(f"the input has no cell or point array '{name}' of whole numbers")
    ids, names = named
    if cells is not None:
        places = ids[surface.cell_of_triangle]
    else:
        corners = np.asarray(surface.triangles)
        isThere = (corners >= 0) & (corners < needed)  # what is not is refused later
        a, b, c = np.where(isThere, ids[np.where(isThere, corners, 0)], 0).T
        places = np.where(b == c, b, np.where((a == b) | (a == c), a, np.minimum(np.minimum(a, b), c)))
    return np.ascontiguousarray(places), names
