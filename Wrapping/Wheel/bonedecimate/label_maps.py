# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of segmentations: an array of labels in, all surfaces with common walls out."""

from __future__ import annotations

import numbers
import os
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .checks import label_value
from .options import switch, thread_count
from .progress import Aborted, Progress, listener
from .surfaces import points_from, triangles_from
from .voxels import IDENTITY, LabelMap, VoxelGrid, has_grid, is_default, label_map_from, pairs_from

if TYPE_CHECKING:
    from .voxels import LabelMapLike


class LabelSurfaces:
    """The surfaces of all labels of a label map as one set of n points and m triangles.

    `decimate`, `smooth`, `certify` and `check_voxels` take it as a surface, with what it knows of the label map. Unpacks into its
    points and triangles, which know nothing of it: ``points, triangles = extract_surfaces(...)``.
    """

    points: NDArray[np.float64]  #: (n, 3), mm
    triangles: NDArray[np.int32]  #: (m, 3), counter-clockwise seen from the second of `boundary_labels`
    boundary_labels: NDArray[np.int64]  #: (m, 2), the labels on both sides: the smaller first, the background second
    grid_points: NDArray[np.int32]  #: (n, 3), x, y, z: twice the voxel coordinates of the middle of a grid edge, face or cell
    label_values: NDArray[np.int64]  #: the labels, ascending, and at the end the background
    grid: VoxelGrid  #: of the label map, or of that of a network from which it was copied
    model_grid_found: str  #: what was found of the grid of a network, in one sentence; empty: nothing

    def __init__(self, outcome: dict, grid: VoxelGrid, model_grid_found: str = "") -> None:
        for name in ("points", "triangles", "boundary_labels", "grid_points", "label_values"):
            setattr(self, name, outcome[name])
        self.grid, self.model_grid_found = grid, model_grid_found

    @property
    def walls(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """The different pairs of labels, (k, 2), and for each triangle the row of its pair, which `decimate` takes as labels."""
        pairs, rows = np.unique(self.boundary_labels, axis=0, return_inverse=True)
        return pairs, rows.reshape(-1)

    def label(self, value: int) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Points and triangles of the closed surface of one label, as `extract_label` gives them. Raises ValueError if there is none."""
        return extract_label(self.points, self.triangles, self.boundary_labels, value)

    def __iter__(self) -> Iterator[NDArray]:
        return iter((self.points, self.triangles))

    def __repr__(self) -> str:
        return f"<bonedecimate.LabelSurfaces: {len(self.label_values) - 1} labels, {len(self.triangles)} triangles>"


def extract_surfaces(
    label_map: LabelMapLike,
    *,
    axes: Literal["zyx", "xyz"] | None = None,
    spacing: Sequence[float] = (1, 1, 1),
    origin: Sequence[float] = (0, 0, 0),
    direction: ArrayLike = IDENTITY,
    affine: ArrayLike | None = None,
    layers: Sequence[float] | None = None,
    labels: Iterable[int] | None = None,
    background: int = 0,
    closed: bool = True,
    model_grid: str | float | Sequence[float] = "auto",
    threads: int = 0,
    progress: bool | Progress | None = None,
) -> LabelSurfaces:
    """The surfaces of all labels of a segmentation, with walls once. Voxelized again, every voxel has the label it had.

    Parameters
    ----------
    label_map : `LabelMap`, image of VTK, SimpleITK or nibabel, or (nz, ny, nx) array of whole numbers
        An image is where it says, in LPS: see `LabelMap.from_image`. An array is made a `LabelMap` with axes, spacing, origin, direction, affine and layers.
    axes, spacing, origin, direction, affine, layers
        As `LabelMap` takes them: the order of the indices, and where the voxels are, mm. Of an array only.
    labels : whole numbers, optional
        The labels to extract; all others count as background. Default: all.
    background : int
        The label of voxels that belong to nothing.
    closed : bool
        Close labels that touch the end of the array, half a voxel outside of the outermost voxel centers. False: surfaces are
        open there and end at these centers.
    model_grid : "auto", "off", number or three numbers, mm
        Take the coarser map of a network from which the labels were copied, and its grid: see `LabelMap.on_model_grid`.
    threads, progress
        As `decimate` takes them.

    Raises
    ------
    TypeError
        Labels that are no numbers, options of a wrong type.
    ValueError
        Shapes, labels with a fraction, spacings that are not positive, axes in one plane, layers that do not ascend from 0.
    Aborted
        The progress function returned False.
    """
    if not has_grid(no_path(label_map)):
        label_map = LabelMap(label_map, axes=axes, spacing=spacing, origin=origin, direction=direction, affine=affine, layers=layers)
    elif axes is not None or affine is not None or layers is not None or not is_default(spacing, origin, direction):
        raise ValueError("a LabelMap and an image have their own axes, spacing, origin, direction and layers")
    label_map = label_map_from(label_map, None).on_model_grid(model_grid)
    chosen, grid = present_labels(label_map, chosen_labels(labels), background), label_map.grid
    with listener(progress) as heard:
        outcome = _core.extract_surfaces(
            label_map.labels, *grid.to_core(), chosen,
            label_value("background", background), switch("closed", closed), thread_count(threads), heard)
    if outcome["aborted"]:
        raise Aborted("the extraction was stopped")
    if outcome["problem"]:
        raise ValueError(_of_array(label_map) + outcome["problem"])
    return LabelSurfaces(outcome, grid, label_map.model_grid_found)


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

    Raises
    ------
    TypeError, ValueError
        Arrays of a wrong type or shape; a label that no triangle has.
    """
    corners, (positions, _single) = triangles_from(triangles), points_from(points)
    pairs = pairs_from(boundary_labels, len(corners))
    if len(corners) and not (0 <= corners.min() and corners.max() < len(positions)):
        raise ValueError("a triangle has an index of a point that is not there")
    return _core.extract_label(positions, corners, pairs, _known_label(pairs, label))[:2]


def no_path(label_map: LabelMapLike) -> LabelMapLike:
    """The same. Raises TypeError for a path, which only segments reads."""
    if isinstance(label_map, (str, os.PathLike)):
        raise TypeError("extract_surfaces takes an image or array; segments(path) reads files")
    return label_map


def _known_label(pairs: NDArray[np.int64], label: int) -> int:
    """The label, if a triangle has it. Raises ValueError otherwise."""
    value = label_value("label", label)
    if not (pairs == value).any():
        raise ValueError(f"no triangle has the label {value}; there are {', '.join(map(str, np.unique(pairs)))}")
    return value


def present_labels(label_map: LabelMap, chosen: list[int], background: int) -> list[int]:
    """Those that are chosen. Raises ValueError if no voxel has one of them, or any label if none is chosen."""
    present = [int(label) for label in np.unique(label_map.labels) if label != background]
    if not present:
        raise ValueError(f"{_of_array(label_map)}the label map has no label: every voxel is background")
    if chosen and not set(chosen) & set(present):
        raise ValueError(f"{_of_array(label_map)}no voxel has label {', '.join(map(str, chosen))}; there are {', '.join(map(str, present[:20]))}")
    return chosen


def _of_array(label_map: LabelMap) -> str:
    """What a sentence about it begins with."""
    return f"array '{label_map.array_name}': " if label_map.array_name else ""


def chosen_labels(labels: Iterable[int] | None) -> list[int]:
    """None of them is all."""
    if isinstance(labels, (str, numbers.Number)):
        raise TypeError(f"labels are a list of whole numbers, [1] for one, not {labels!r}")
    chosen = [] if labels is None else [label_value("labels", each) for each in labels]
    if labels is not None and not chosen:
        raise ValueError("labels are None for all, or at least one label")
    return chosen
