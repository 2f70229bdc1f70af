# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Label maps without small islands and cavities."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

from . import _core
from .checks import label_value
from .label_maps import chosen_labels
from .options import number
from .surfaces import warn
from .voxels import LabelMap, label_map_from

if TYPE_CHECKING:
    from .voxels import LabelMapLike


class PieceChanges(NamedTuple):
    """What changed of one label."""

    islands: int = 0  # that were removed
    island_voxels: int = 0
    cavities: int = 0  # that were filled
    cavity_voxels: int = 0


def change_pieces(
    label_map: LabelMapLike,
    *,
    labels: Iterable[int] | None = None,
    background: int = 0,
    island_size: float = 0.0,
    island_area: float = 0.0,
    island_volume: float = 0.0,
    cavity_volume: float = 0.0,
) -> tuple[LabelMap, dict[int, PieceChanges]]:
    """A label map without small islands and with small cavities filled, and what changed of each label.

    An island is a piece of a label, connected by faces of voxels, other than the largest one; it gets the label
    that has the largest part of its boundary. A cavity is a piece of background,
    connected by faces or edges, that does not reach the end of the array and touches one label alone; it gets that label.
    Islands are removed first. A Python warning says which labels have a largest piece that is too small, too; it stays.

    >>> cleaned, changes = bonedecimate.change_pieces(bones, island_volume=50, cavity_volume=50)

    Parameters
    ----------
    label_map : `LabelMap`, or image of VTK, SimpleITK or nibabel
        It does not change.
    labels : whole numbers, optional
        Those whose pieces are looked at. Default: all but the background.
    background : int
        The label of voxels that belong to nothing.
    island_size, island_area, island_volume : float, mm, mm2, mm3
        An island is removed if the longest side of its box of voxels, the area of its voxels' faces or its volume is below the limit.
        0, the default, is off. Range: 0 to 1e30.
    cavity_volume : float, mm3
        A cavity of at most this volume is filled. 0, the default, is off. Range: 0 to 1e30.

    Raises
    ------
    TypeError, ValueError
        As `extract_surfaces` does; limits out of range.
    """
    given, chosen, nothing = label_map_from(label_map, None), chosen_labels(labels), label_value("background", background)
    islands = [number(name, value, 0, 1e30, unit) for name, value, unit in (
        ("island_size", island_size, "mm"), ("island_area", island_area, "mm2"), ("island_volume", island_volume, "mm3"))]
    changed = LabelMap.on(given.grid, given.labels.copy())
    removed, filled = _core.change_pieces(
        changed.labels, *given.grid.to_core(), chosen, nothing, islands, number("cavity_volume", cavity_volume, 0, 1e30, "mm3"))
    warn([f"the largest piece of label {label} is below a limit of islands, too; it stays"
          for label, _pieces, _voxels, is_small in removed if is_small], 2)
    changes = {label: PieceChanges() for label in chosen}
    for label, pieces, voxels, _is_small in removed:
        changes[label] = PieceChanges(pieces, voxels)
    for label, pieces, voxels, _is_small in filled:
        changes[label] = changes.get(label, PieceChanges())._replace(cavities=pieces, cavity_voxels=voxels)
    return changed, changes
