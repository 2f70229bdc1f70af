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
from .voxels import LabelMap, SurfaceSource, VoxelGrid, label_map_from, pairs_from, values_in, with_boundary_labels

if TYPE_CHECKING:
    from .surfaces import SurfaceLike
    from .voxels import LabelMapLike

NO_GRID = "boundary_labels need a voxel grid, which label_map gives; labels need none"
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
    left_out: list[int]  #: labels of the map that the surface does not have; their voxels count as background

    def __init__(self, outcome: dict, values: NDArray[np.int64], left_out: NDArray[np.int64]) -> None:
        self.left_out = left_out.tolist()
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
    label_map : `LabelMap`, image of VTK, SimpleITK or nibabel, or (nz, ny, nx) array of whole numbers
        An array is on the grid of the surface, which a pair (points, triangles) does not have. Labels that the surface does not
        have count as background.
    boundary_labels : (m, 2) array of whole numbers, optional
        The labels on both sides of each triangle; the normal points from the first to the second. Default: those of the surface.
    label : whole number, optional
        The label inside of a surface without boundary labels. Default: the only one that the label map has beside the background.
    background : whole number, optional
        The label of voxels that belong to nothing. Default: that of the surface, or 0.
    threads, progress
        As `decimate` takes them.

    Raises
    ------
    TypeError
        Something that is no surface, labels that are no whole numbers.
    ValueError
        Shapes, points that are not finite or more than 65536 voxels away from the first voxel, indices out of range, a label map
        of several labels without the labels of the surface.
    Aborted
        The progress function returned False.
    """
    found = surface_from(surface, "surface", with_source=True)
    warn(found.warnings, 2)
    comparison = Comparison(found, label_map, boundary_labels, label, background)
    with listener(progress) as heard:
        return comparison.changes(thread_count(threads), heard)


def with_label_map(surface: Surface, boundary_labels: ArrayLike | None,
                   label_map: LabelMapLike | VoxelGrid | None) -> tuple[Surface, Comparison | None]:
    """The surface with what it and the parameters know of the label map, and its comparison with the map if that is given."""
    source, labels = source_with(surface, label_map)
    if source is not None and source.grid is None:
        source = None
    if boundary_labels is not None:
        if source is None:
            raise ValueError(NO_GRID)
        source = with_boundary_labels(source, boundary_labels, len(surface.triangles))
    found = surface._replace(source=source)
    return found, None if labels is None else Comparison(found, labels)


def source_with(surface: Surface, label_map: LabelMapLike | VoxelGrid | None) -> tuple[SurfaceSource | None, LabelMap | None]:
    """What is known of the label map of a surface, by itself or by a parameter, and the map if it is given."""
    known = surface.source
    if label_map is None:
        return known, None
    labels = None if isinstance(label_map, VoxelGrid) else label_map_from(label_map, known and known.grid)
    grid = label_map if labels is None else labels.grid
    if known is None:
        return SurfaceSource(grid, np.empty(0, np.int64)), labels
    if known.grid is not None and not known.grid.is_same_as(grid):
        raise ValueError(f"label_map has another voxel grid than the surface: {grid!r}, {known.grid!r}")
    return known._replace(grid=known.grid or grid), labels


class Comparison:
    """A surface and the labels that it has on the grid of a label map."""

    def __init__(self, surface: Surface, label_map: LabelMapLike, boundary_labels: ArrayLike | None = None,
                 label: int | None = None, background: int | None = None) -> None:
        known = surface.source
        self.surface, self.map = surface, label_map_from(label_map, known and known.grid)
        values = np.unique(self.map.labels)  # of the map
        if values.size and int(values[-1]) > np.iinfo(np.int64).max:
            raise ValueError("label_map has a label beyond 2^63 - 1")
        self.values = values.astype(np.int64)
        nothing = 0 if background is None else label_value("background", background)
        source = SurfaceSource(self.map.grid, np.empty(0, np.int64))
        if boundary_labels is not None:
            pairs = pairs_from(boundary_labels, len(surface.triangles))
            source = with_boundary_labels(source, pairs, len(pairs), values_in(pairs, nothing))
        elif known is not None and known.boundary_labels is not None:
            if background not in (None, known.label_values[-1]):
                raise ValueError(f"the surface has the background {known.label_values[-1]}, not {background}")
            source = source._replace(label_values=known.label_values, boundary_labels=known.boundary_labels)
        else:
            source = source._replace(label_values=np.array([self._enclosed(label, nothing), nothing], np.int64))
            label = None
        if label is not None:
            raise ValueError("label is for a surface without boundary labels")
        self.source = source

    def changes(self, threads: int, heard: Progress | None = None) -> VoxelChanges:
        _raise_unusable(self.surface, self.source)
        outcome = _core.check_voxels(self.map.labels, self.source.to_core(), *self.surface[:2], threads, heard)
        if outcome["aborted"]:
            raise Aborted("the check was stopped")
        return VoxelChanges(outcome, self.source.label_values, np.setdiff1d(self.values, self.source.label_values))

    def differences(self, threads: int) -> list[str]:
        """In a sentence; empty if there are none."""
        changes = self.changes(threads)
        if not changes.changed:
            return []
        return [f"label_map and the surface differ in {changes.changed} of {changes.compared} voxels, the first is "
                f"{changes.first_changed} (x, y, z); the labels of the surface count"]

    def _enclosed(self, label: int | None, background: int) -> int:
        """The label inside of a surface without boundary labels."""
        others = self.values[self.values != background].tolist()
        if label is not None:
            value = label_value("label", label)
            if value == background:
                raise ValueError(f"label and background are both {background}")
            if value not in others:
                raise ValueError(f"the label map has no voxel with the label {value}")
            return value
        if len(others) > 1:
            first = ", ".join(map(str, others[:10])) + (", ..." if len(others) > 10 else "")
            raise ValueError(f"label_map has the labels {first}, and the surface does not say which of them it encloses: give "
                             "boundary_labels, or a LabelMap of one label (labels == 3)")
        return others[0] if others else background + 1


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
