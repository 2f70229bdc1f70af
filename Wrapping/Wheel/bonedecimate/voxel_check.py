# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A surface voxelized and compared with a label map, by code that has nothing in common with what makes surfaces."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .checks import label_value
from .options import thread_count
from .progress import Aborted, Progress, listener
from .surfaces import Surface, surface_from, warn
from .voxels import LabelMap, SurfaceSource, label_map_from, pairs_from, values_in, with_boundary_labels

if TYPE_CHECKING:
    from .surfaces import SurfaceLike
    from .voxels import LabelMapLike

LARGEST_EXTENT = 65536  # voxels; a surface beyond that belongs to another grid


class LabelChanges(NamedTuple):
    """Voxels of one label."""

    voxels: int  # in the label map
    lost: int  # in the label map but not in the surface
    gained: int  # the reverse


class VoxelChanges:
    """The voxels to which a surface gives another label than a label map does."""

    compared: int  #: voxels
    changed: int
    first_changed: tuple[int, int, int] | None  #: indices x, y, z of the first one along z, y, x; None if none is changed
    of_label: dict[int, LabelChanges]  #: by label, the background last

    def __init__(self, outcome: dict, values: NDArray[np.int64]) -> None:
        self.compared, self.changed = outcome["compared"], outcome["changed"]
        self.first_changed = tuple(outcome["first_changed"]) if self.changed else None
        self.of_label = {value: LabelChanges(*row) for value, row in zip(values.tolist(), outcome["of_label"].tolist())}

    def entries(self) -> list[tuple[str, str, int]]:
        """As the report of a run has them: name, unit, value."""
        entries = [("voxels.compared", "", self.compared), ("voxels.changed", "", self.changed)]
        entries += [(f"voxels.first_changed.{axis}", "", voxel) for axis, voxel in enumerate(self.first_changed or ())]
        return entries + [(f"voxels.of_{label}.{name}", "", count) for label, changes in self.of_label.items()
                          for name, count in changes._asdict().items()]

    def __repr__(self) -> str:
        return f"<bonedecimate.VoxelChanges: {self.changed} of {self.compared} voxels>"


def check_voxels(
    surface: SurfaceLike,
    label_map: LabelMapLike,
    *,
    boundary_labels: ArrayLike | None = None,
    label: int | None = None,
    background: int | None = None,
    threads: int = 0,
    progress: bool | Progress | None = None,
) -> VoxelChanges:
    """Voxelizes a surface on the grid of a label map and counts the voxels to which it gives another label.

    Parameters
    ----------
    surface : what `extract_surfaces`, `decimate` or `smooth` returned, mesh, or (points, triangles)
        Of an open surface the outermost voxels are not compared.
    label_map : `LabelMap`, vtkImageData, or (nz, ny, nx) array of whole numbers
        An array is on the grid of the surface, which a pair (points, triangles) does not have. Labels that the surface does not
        have count as background.
    boundary_labels : (m, 2) array of whole numbers, optional
        The labels on both sides of each triangle; the normal points from the first to the second. Default: those of the surface.
    label : whole number, optional
        The label inside of a surface without boundary labels. Default: every label but the background, counted as label 1, and
        the background as 0.
    background : whole number, optional
        The label of voxels that belong to nothing. Default: that of the surface, or 0.
    threads, progress
        As `decimate` takes them.

    Raises
    ------
    TypeError
        Something that is no surface, labels that are no whole numbers.
    ValueError
        Shapes, points that are not finite or more than 65536 voxels away from the first voxel, indices out of range.
    Aborted
        The progress function returned False.
    """
    found = surface_from(surface, "surface", with_source=True)
    warn(found.warnings, 2)
    volume, source = _compared(found, label_map, boundary_labels, label, background)
    with listener(progress) as heard:
        return _changes_of(found, volume, source, thread_count(threads), heard)


def differences(found: Surface, label_map: LabelMap, threads: int) -> list[str]:
    """Between an input with its label map, in a sentence; empty if there are none."""
    changes = changes_from(found, label_map, threads)
    if not changes.changed:
        return []
    return [f"label_map and the surface differ in {changes.changed} of {changes.compared} voxels, the first is "
            f"{changes.first_changed} (x, y, z); the labels of the surface count"]


def changes_from(found: Surface, label_map: LabelMapLike, threads: int) -> VoxelChanges:
    """Without boundary labels, every label but 0 is inside."""
    return _changes_of(found, *_compared(found, label_map, None, None, None), threads, None)


def _changes_of(found: Surface, volume: NDArray[np.integer], source: SurfaceSource, threads: int,
               heard: Progress | None) -> VoxelChanges:
    _raise_unusable(found, source)
    outcome = _core.check_voxels(volume, source.to_core(), found.points, found.triangles, threads, heard)
    if outcome["aborted"]:
        raise Aborted("the check was stopped")
    return VoxelChanges(outcome, source.label_values)


def _compared(found: Surface, label_map: LabelMapLike, boundary_labels: ArrayLike | None, label: int | None,
              background: int | None) -> tuple[NDArray[np.integer], SurfaceSource]:
    """The voxels, and the labels of the surface on their grid."""
    known = found.source
    labels = label_map_from(label_map, known and known.grid)
    source = SurfaceSource(labels.grid, np.empty(0, np.int64))
    nothing = 0 if background is None else label_value("background", background)
    if boundary_labels is not None:
        pairs = pairs_from(boundary_labels, len(found.triangles))
        source = with_boundary_labels(source, pairs, len(pairs), values_in(pairs, nothing))
    elif known is not None and known.boundary_labels is not None:
        if background not in (None, known.label_values[-1]):
            raise ValueError(f"the surface has the background {known.label_values[-1]}, not {background}")
        source = known._replace(grid=labels.grid, grid_points=None)
    if source.boundary_labels is not None:
        if label is not None:
            raise ValueError("label is for a surface without boundary labels")
        return labels.labels, source
    if label is None:
        return (labels.labels != nothing).astype(np.uint8), source._replace(label_values=np.array([1, 0]))
    if label_value("label", label) == nothing:
        raise ValueError(f"label and background are both {nothing}")
    return labels.labels, source._replace(label_values=np.array([label, nothing]))


def _raise_unusable(found: Surface, source: SurfaceSource) -> None:
    if not len(found.triangles):
        return
    if found.triangles.min() < 0 or found.triangles.max() >= len(found.points):
        raise ValueError("a triangle of the surface has an index of a point that is not there")
    corners = found.points[np.unique(found.triangles)]
    if not np.isfinite(corners).all():
        raise ValueError("the surface has a point that is not finite")
    if np.abs(source.grid.to_voxels(corners)).max() > LARGEST_EXTENT:
        raise ValueError(f"the surface has a point more than {LARGEST_EXTENT} voxels away from the first voxel of the label map")
