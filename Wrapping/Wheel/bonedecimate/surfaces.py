# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What people give as a surface, checked and made what the core takes. Needs no VTK."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .checks import numeric_array
from .voxels import SurfaceSource, source_of

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .arrays import Result
    from .label_maps import LabelSurfaces

    # Types that a function takes as a surface.
    SurfaceLike = Union[vtkPolyData, tuple[ArrayLike, ArrayLike], Result, LabelSurfaces]

LARGEST_LABEL = 2.0**53  # beyond, doubles leave whole numbers out


# What was left out: kind, count, noun, where the first is, and the corners (k, 3, 3) of its triangles, mm.
LeftOut = tuple[str, int, str, str, NDArray[np.float64]]


class Surface(NamedTuple):
    points: NDArray[np.float64]  # (n, 3), mm
    triangles: NDArray[np.int32]  # (m, 3)
    is_single: bool  # whether the points were single precision
    warnings: list[str]  # what was left out of a mesh
    source: SurfaceSource | None = None  # what is known of its label map
    left_out: Sequence[LeftOut] = ()  # of a mesh: what is no part of the surface


def input_from(points: ArrayLike | SurfaceLike, triangles: ArrayLike | None) -> Surface:
    """Of two arrays, or of a surface alone."""
    if triangles is None:
        return surface_from(points, "surface", with_source=True)
    corners = triangles_from(triangles)
    positions, is_single = points_from(points)
    return Surface(positions, corners, is_single, [])


def surface_from(given: object, name: str, with_source: bool = False) -> Surface:
    """Of a mesh (vtkPolyData, PyVista), a pair (points, triangles), or what decimate or extract_surfaces returned.

    @param name Of the argument, for messages.
    """
    if hasattr(given, "GetPolys") and hasattr(given, "GetStrips"):
        from .label_arrays import surface_with_source  # imports VTK, which is there
        from .polydata import surface_of
        found = surface_with_source(given) if with_source else surface_of(given)
        return Surface(found.points, found.triangles, found.is_single, [f"{name}: {text}" for text in found.warnings],
                       found.source, found.left_out)
    is_pair = isinstance(given, (tuple, list)) and len(given) == 2
    if is_pair or (hasattr(given, "points") and hasattr(given, "triangles")):
        points, triangles = given if is_pair else (given.points, given.triangles)
        positions, is_single = points_from(points, f"points of {name}")
        corners = triangles_from(triangles, f"triangles of {name}")
        source = source_of(given, len(positions), len(corners)) if with_source else None
        return Surface(positions, corners, is_single, [], source)
    kind = f"an array of shape {given.shape}" if isinstance(given, np.ndarray) else f"a {type(given).__name__}"
    raise TypeError(f"{name} is a mesh (vtkPolyData or pyvista.PolyData), a pair (points, triangles) of shapes (n, 3) and "
                    f"(m, 3), or what decimate or extract_surfaces returned, not {kind}")


def warn(texts: list[str], stacklevel: int) -> None:
    """@param stacklevel As of warnings.warn in the calling function: 2 is its caller."""
    for text in texts:
        warnings.warn(text, stacklevel=stacklevel + 1)


def points_from(points: ArrayLike, name: str = "points") -> tuple[NDArray[np.float64], bool]:
    """The points in double precision, and whether they were single."""
    array = numeric_array(points, name)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} are of shape (n, 3), not {array.shape}")
    is_single = array.dtype.kind == "f" and array.dtype.itemsize == 4
    return np.ascontiguousarray(array, dtype=np.float64), is_single


def triangles_from(triangles: ArrayLike, name: str = "triangles") -> NDArray[np.int32]:
    """Indices that do not fit become -1, which the core rejects with their number."""
    array = numeric_array(triangles, name)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} are of shape (m, 3), not {array.shape}")
    if array.size and array.dtype.kind not in "iu":
        raise TypeError(f"{name} are integers, not {array.dtype}")
    return indices(array)


def indices(array: NDArray) -> NDArray[np.int32]:
    """As the core counts; -1 for what it cannot count."""
    fits = (array >= 0) & (array < np.iinfo(np.int32).max)
    counted = np.full(array.shape, -1, dtype=np.int32)  # np.where would give -1 the type of the array, which may have none
    np.copyto(counted, array, where=fits, casting="unsafe")
    return np.ascontiguousarray(counted)


def tolerances_from(tolerances: ArrayLike | None, count: int, name: str = "tolerances") -> NDArray[np.float64] | None:
    """One finite number, mm, for each of the points."""
    if tolerances is None:
        return None
    if isinstance(tolerances, str):
        raise TypeError(f"{name} are an array; {name[:-1]}_array names one of the mesh")
    array = numeric_array(tolerances, name)
    if array.ndim == 0:
        limit = "max_error" if name == "tolerances" else "edge_length"
        raise ValueError(f"{name} are one for each of {count} points; {limit} is one for all")
    if array.shape != (count,):
        raise ValueError(f"{name} are one for each of {count} points, not of shape {array.shape}")
    wrong = np.flatnonzero(~np.isfinite(array))
    if len(wrong):
        raise ValueError(f"{len(wrong)} {name} are NaN or infinite, the first is that of point {wrong[0]}")
    return np.ascontiguousarray(array, dtype=np.float64)


def edge_lengths_from(lengths: ArrayLike | None, count: int, options: _core.Options) -> NDArray[np.float64] | None:
    """The same; they need an upper limit among the options."""
    if lengths is not None and not options.get("EdgeLength"):
        raise ValueError("edge_lengths need edge_length, an upper limit for all")
    return tolerances_from(lengths, count, "edge_lengths")


NamedLabels = tuple[NDArray[np.int64], list[str]]


def labels_from(labels: ArrayLike | None, count: int, what: str = "triangles") -> tuple[NDArray | None, NamedLabels | None]:
    """One whole number for each of the triangles (or cells): as they were given, and as `named_labels` has them."""
    if labels is None:
        return None, None
    array = numeric_array(labels, "labels", "biuf")
    if array.shape != (count,):
        raise ValueError(f"labels are one for each of {count} {what}, not of shape {array.shape}")
    named = named_labels(array[:, None])
    if named is None:
        raise ValueError("labels are whole numbers of at most 2^53")
    return array, named


def named_labels(rows: NDArray) -> NamedLabels | None:
    """Of each row of values a position in the list of names, and that list; None if a value is not a whole number."""
    values = rows.astype(np.float64)
    if not np.all((np.abs(values) <= LARGEST_LABEL) & (np.floor(values) == values)):
        return None
    tuples, ids = np.unique(values.astype(np.int64), axis=0, return_inverse=True)
    names = ["_".join(str(value) for value in row) for row in tuples.tolist()]
    return np.ascontiguousarray(ids.reshape(-1), dtype=np.int64), names

