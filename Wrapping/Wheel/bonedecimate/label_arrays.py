# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The arrays in which a vtkPolyData keeps from which label map it was extracted: what LabelMapArrays does on the side of C++."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray, vtkTypeInt64Array
from vtkmodules.vtkCommonDataModel import vtkFieldData, vtkPolyData

from .polydata import Surface, new_array, numbers, surface_of
from .voxels import LARGEST_COORDINATE, LEAST_DETERMINANT, SurfaceSource, VoxelGrid, indices_of, values_in

BOUNDARY_LABELS, GRID_POINT, LABEL_VALUES = "BoundaryLabels", "GridPoint", "LabelValues"
LAYERS = "VoxelGridLayers"  # of the field data, if the distance of layers changes: mm from the first one
# Of the field data: name, number of components.
GRID = (("VoxelGridDimensions", 3), ("VoxelGridSpacing", 3), ("VoxelGridOrigin", 3), ("VoxelGridDirection", 9))


def surface_with_source(data: vtkPolyData) -> Surface:
    """The surface with what the arrays say of its label map."""
    surface = surface_of(data)
    surface.source = _source_of(data, surface)
    return surface


def _source_of(data: vtkPolyData, surface: Surface) -> SurfaceSource | None:
    """None without a grid and boundary labels. Raises ValueError if an array does not have the shape or the values it needs."""
    centers = _find(data.GetPointData(), GRID_POINT, 3, data.GetNumberOfPoints())  # in this order, as the last problem counts in C++
    pairs = _find(data.GetCellData(), BOUNDARY_LABELS, 2, data.GetNumberOfCells())
    values = _find(data.GetFieldData(), LABEL_VALUES, 1, None)
    values = np.empty(0, np.int64) if values is None else values[:, 0].astype(np.int64)
    indices = None
    if pairs is not None:
        pairs = pairs.astype(np.int64)
        values = values if len(values) else values_in(pairs, 0)
        indices = indices_of(pairs[surface.cell_of_triangle], values, (BOUNDARY_LABELS, LABEL_VALUES), "the array ")
    grid = _grid_of(data.GetFieldData())
    if grid is None and indices is None:
        return None
    return SurfaceSource(grid, values, indices, None if centers is None else np.ascontiguousarray(centers, dtype=np.int32))


def pass_label_arrays(source: SurfaceSource, pairs: NDArray[np.int32], output: vtkPolyData) -> None:
    """Of a result: its own BoundaryLabels if those of the input were not passed, zeros for vertices and lines, and no GridPoint."""
    output.GetPointData().RemoveArray(GRID_POINT)
    if not len(pairs) or output.GetCellData().HasArray(BOUNDARY_LABELS):
        return
    values = np.zeros((output.GetNumberOfCells(), 2), np.int64)
    values[output.GetNumberOfCells() - output.GetNumberOfPolys():] = source.values_of(pairs)
    _add(output.GetCellData(), vtkTypeInt64Array, BOUNDARY_LABELS, values)


def add_grid(grid: VoxelGrid, data: vtkPolyData) -> None:
    """Replaces the field arrays of a grid."""
    fields = data.GetFieldData()
    _add(fields, vtkIntArray, "VoxelGridDimensions", np.array([grid.dimensions]))
    for name, values in (("Spacing", grid.spacing), ("Origin", grid.origin), ("Direction", grid.direction)):
        _add(fields, vtkDoubleArray, "VoxelGrid" + name, values.reshape(1, -1))
    if grid.layers is None:
        fields.RemoveArray(LAYERS)
    else:
        _add(fields, vtkDoubleArray, LAYERS, grid.layers.reshape(-1, 1))


def _add(fields: vtkFieldData, kind, name: str, values: NDArray) -> None:
    array = new_array(kind, values)
    array.SetName(name)
    fields.AddArray(array)


def _find(fields: vtkFieldData, name: str, components: int, tuples: int | None) -> NDArray | None:
    """The values of an array; None if it is not there."""
    array = fields.GetArray(name)
    if array is None:
        return None
    if array.GetNumberOfComponents() != components or tuples not in (None, array.GetNumberOfTuples()):
        raise ValueError(f"the array {name} does not have the number of components or tuples that it needs")
    values = numbers(array)
    if not (np.abs(values.astype(np.float64)) <= LARGEST_COORDINATE).all():
        raise ValueError(f"the array {name} has a value that is not finite or beyond 1e30")
    return values


def _grid_of(fields: vtkFieldData) -> VoxelGrid | None:
    arrays = [_find(fields, name, components, 1) for name, components in GRID]
    if any(array is None for array in arrays):
        return None
    dimensions, spacing, origin, direction = (array[0].astype(np.float64) for array in arrays)
    rows = direction.reshape(3, 3)
    for is_valid, name, problem in (
            ((dimensions >= 1).all(), "Dimensions", "has a number that is not positive"),
            ((spacing > 0).all(), "Spacing", "has a number that is not positive"),
            (np.abs((rows**2).sum(axis=0) - 1).max() <= 1e-6 and abs(np.linalg.det(rows)) >= LEAST_DETERMINANT, "Direction",
             "does not have unit vectors that are not in one plane as columns")):
        if not is_valid:
            raise ValueError(f"the array VoxelGrid{name} {problem}")
    layers = _find(fields, LAYERS, 1, int(dimensions[2]))
    try:
        return VoxelGrid(np.trunc(dimensions), spacing=spacing, origin=origin, direction=rows,
                         layers=None if layers is None else layers[:, 0])
    except ValueError as problem:
        raise ValueError(f"the array {LAYERS}: {problem}" if "layers" in str(problem) else str(problem)) from problem

