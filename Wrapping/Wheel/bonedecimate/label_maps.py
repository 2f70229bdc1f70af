# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of segmentations: an array of labels in, all surfaces with common walls out."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from operator import index
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .arrays import Aborted
from .options import switch, thread_count
from .progress import Progress, listener
from .surfaces import points_from, triangles_from

IDENTITY = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


class LabelSurfaces:
    """The surfaces of all labels of a label map as one set of n points and m triangles.

    Unpacks into its points and triangles: ``points, triangles = extract_surfaces(...)``.
    """

    points: NDArray[np.float64]  #: (n, 3), mm
    triangles: NDArray[np.int32]  #: (m, 3), counter-clockwise seen from the second of `boundary_labels`
    boundary_labels: NDArray[np.int64]  #: (m, 2), the labels on both sides: the smaller first, the background second
    grid_points: NDArray[np.int32]  #: (n, 3), x, y, z: twice the voxel coordinates of the middle of a grid edge, face or cell
    label_values: NDArray[np.int64]  #: the labels, ascending, and at the end the background
    origin: NDArray[np.float64]  #: (3,), mm, x, y, z
    spacing: NDArray[np.float64]  #: (3,), mm, x, y, z
    direction: NDArray[np.float64]  #: (3, 3), the columns are the axes

    def __init__(self, outcome: dict, origin: NDArray[np.float64], spacing: NDArray[np.float64]) -> None:
        for name in ("points", "triangles", "boundary_labels", "grid_points", "label_values", "direction"):
            setattr(self, name, outcome[name])
        self.origin, self.spacing = origin, spacing

    @property
    def walls(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """The different pairs of labels, (k, 2), and for each triangle the row of its pair, which `decimate` takes as labels."""
        pairs, rows = np.unique(self.boundary_labels, axis=0, return_inverse=True)
        return pairs, rows.reshape(-1)

    def label(self, value: int) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Points and triangles of the closed surface of one label, as `extract_label` gives them."""
        return extract_label(self.points, self.triangles, self.boundary_labels, value)

    def __iter__(self) -> Iterator[NDArray]:
        return iter((self.points, self.triangles))

    def __repr__(self) -> str:
        return f"<bonedecimate.LabelSurfaces: {len(self.label_values) - 1} labels, {len(self.triangles)} triangles>"


def extract_surfaces(
    label_map: ArrayLike,
    *,
    axes: Literal["zyx", "xyz"] = "zyx",
    spacing: Sequence[float] = (1, 1, 1),
    origin: Sequence[float] = (0, 0, 0),
    direction: ArrayLike = IDENTITY,
    affine: ArrayLike | None = None,
    labels: Iterable[int] | None = None,
    background: int = 0,
    closed: bool = True,
    threads: int = 0,
    progress: bool | Progress | None = None,
) -> LabelSurfaces:
    """The surfaces of all labels of a segmentation, with walls once. Voxelized again, every voxel has the label it had.

    Parameters
    ----------
    label_map : (nz, ny, nx) array of whole numbers
        Of any type; bool is one label, floating-point numbers must have no fraction.
    axes : "zyx" or "xyz"
        The order of the indices: ``label_map[z, y, x]`` as of ``SimpleITK.GetArrayFromImage``, or ``label_map[x, y, z]`` as of
        nibabel's ``image.dataobj``. All parameters below and all results are in the order x, y, z in both cases.
    spacing : three numbers, mm
        Of the voxels along x, y, z: ``GetSpacing()`` of SimpleITK.
    origin, direction : three numbers, mm; (3, 3) array, or nine numbers row by row
        Center of the first voxel, and the axes as columns: ``GetOrigin()`` and ``GetDirection()``.
    affine : (4, 4) array, optional
        From voxels x, y, z to mm instead of these three: nibabel's ``image.affine``. Without shear.
    labels : whole numbers, optional
        The labels to extract; all others count as background. Default: all.
    background : int
        The label of voxels that belong to nothing.
    closed : bool
        Close labels that touch the end of the array, half a voxel outside of the outermost voxel centers. False: surfaces are
        open there and end at these centers.
    threads, progress
        As `decimate` takes them.

    Raises
    ------
    TypeError
        Labels that are no numbers, options of a wrong type.
    ValueError
        Shapes, labels with a fraction, spacings that are not positive, axes that are not perpendicular.
    Aborted
        The progress function returned False.
    """
    volume = _volume_from(label_map, axes)
    grid = _grid_from(spacing, origin, direction, affine)
    chosen = _labels_from(labels)
    with listener(progress) as heard:
        outcome = _core.extract_surfaces(volume, *(each.tolist() for each in grid), chosen, _label("background", background),
                                         switch("closed", closed), thread_count(threads), heard)
    if outcome["aborted"]:
        raise Aborted("the extraction was stopped")
    if outcome["problem"]:
        raise ValueError(outcome["problem"])
    return LabelSurfaces(outcome, *grid[:2])


def extract_label(
    points: ArrayLike, triangles: ArrayLike, boundary_labels: ArrayLike, label: int,
) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """The surface of one label out of surfaces of several, decimated or not: its points, mm, and triangles, outward.

    Points are duplicated where the label touches itself, so that the surface is manifold.

    Parameters
    ----------
    points : (n, 3) array of float, mm
    triangles : (m, 3) array of int
    boundary_labels : (m, 2) array of int
        The labels on both sides of each triangle; the normal points from the first to the second.
    label : int
    """
    corners, (positions, _single) = triangles_from(triangles), points_from(points)
    pairs = np.ascontiguousarray(boundary_labels, dtype=np.int64)
    if pairs.shape != (len(corners), 2):
        raise ValueError(f"boundary_labels have the shape ({len(corners)}, 2), not {pairs.shape}")
    if len(corners) and not (0 <= corners.min() and corners.max() < len(positions)):
        raise ValueError("a triangle has an index of a point that is not there")
    return _core.extract_label(positions, corners, pairs, _label("label", label))[:2]


def _volume_from(label_map: ArrayLike, axes: str) -> NDArray[np.integer]:
    """Integers with indices z, y, x, one after the other."""
    volume = np.asarray(label_map)
    if axes not in ("zyx", "xyz"):
        raise ValueError(f"axes are 'zyx' or 'xyz', not {axes!r}")
    if volume.ndim != 3:
        raise ValueError(f"a label map has three dimensions, not {volume.ndim}")
    if volume.dtype.kind not in "biuf":
        raise TypeError(f"a label map has whole numbers, not {volume.dtype}")
    if axes == "xyz":
        volume = volume.transpose()
    if volume.dtype.kind == "f":
        whole = np.isfinite(volume) & (volume == np.floor(volume)) & (np.abs(volume) <= 2**53)
        if not whole.all():
            raise ValueError("a label map has whole numbers; some have a fraction, or are not finite")
        volume = volume.astype(np.int64)
    kind = np.uint8 if volume.dtype.kind == "b" else volume.dtype.newbyteorder("=")
    return np.ascontiguousarray(volume, dtype=kind)


def _grid_from(spacing, origin, direction, affine) -> list[NDArray[np.float64]]:
    """Origin, spacing and direction."""
    if affine is not None:
        if tuple(spacing) != (1, 1, 1) or tuple(origin) != (0, 0, 0) or direction is not IDENTITY:
            raise ValueError("affine replaces spacing, origin and direction: not both")
        spacing, origin, direction = _decomposed(affine)
    return [_numbers(name, values, count) for name, values, count in
            (("origin", origin, 3), ("spacing", spacing, 3), ("direction", direction, 9))]


def _labels_from(labels: Iterable[int] | None) -> list[int]:
    """None of them is all."""
    chosen = [] if labels is None else [_label("labels", each) for each in labels]
    if labels is not None and not chosen:
        raise ValueError("labels are None for all, or at least one label")
    return chosen


def _numbers(name: str, values: ArrayLike, count: int) -> NDArray[np.float64]:
    numbers = np.asarray(values, dtype=np.float64)
    if numbers.size != count or numbers.shape not in ((count,), (3, count // 3)):
        raise ValueError(f"{name} has {count} numbers, not the shape {numbers.shape}")
    return numbers.reshape(-1)


def _label(name: str, value: int) -> int:
    number = index(value)
    if not -2**63 <= number < 2**63:
        raise ValueError(f"{name} takes whole numbers from -2^63 to 2^63 - 1, not {number}")
    return number


def _decomposed(affine: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Spacing, origin and direction."""
    matrix = np.asarray(affine, dtype=np.float64)
    if matrix.shape != (4, 4):
        raise ValueError(f"affine has the shape (4, 4), not {matrix.shape}")
    spacing = np.sqrt((matrix[:3, :3] ** 2).sum(axis=0))
    if not (np.isfinite(spacing).all() and (spacing > 0).all()):
        raise ValueError("affine has an axis without length")
    return spacing, matrix[:3, 3], matrix[:3, :3] / spacing
