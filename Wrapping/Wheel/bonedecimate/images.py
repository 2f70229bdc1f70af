# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkImageData as a label map: what ImageLabels does on the side of C++."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData

from .polydata import array_names, numbers
from .voxels import LabelMap


def label_map_of(image: vtkImageData, name: str | None = None) -> LabelMap:
    """@param name Of a point array; None: the active scalars of the points."""
    data = image.GetPointData()
    array = data.GetScalars() if name is None else data.GetArray(name)
    if array is None:
        of_cells = image.GetCellData().GetScalars() if name is None else image.GetCellData().GetArray(name)
        there_are = f" (there are: {array_names(data)})"
        raise ValueError(f"labels are point data of an image, one for each voxel; these are cell data: '{of_cells.GetName()}'" if of_cells is not None else
                         "the image has no labels: it has no active scalars of points" + there_are if name is None else
                         f"the image has no point array '{name}'" + there_are)
    if array.GetNumberOfComponents() != 1:
        raise ValueError(f"the array {array.GetName()} has several components; labels have one")
    matrix = image.GetDirectionMatrix()
    direction = np.array([[matrix.GetElement(row, column) for column in range(3)] for row in range(3)])
    spacing = np.array(image.GetSpacing())
    origin = np.array(image.GetOrigin()) + direction @ (spacing * image.GetExtent()[::2])
    layers = image.GetFieldData().GetArray("VoxelGridLayers")
    try:
        found = LabelMap(numbers(array).reshape(image.GetDimensions()[::-1]), axes="zyx", spacing=spacing, origin=origin,
                         direction=direction, layers=None if layers is None else numbers(layers).reshape(-1))
    except ValueError as problem:
        raise ValueError(f"array '{array.GetName()}': {problem}") from None
    found.array_name = array.GetName() or ""
    return found
