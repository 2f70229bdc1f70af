# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Levels of detail: one run, recorded, and every stage of it at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .arrays import Result, check, gives_single
from .options import number, read, takes_options, thread_count
from .progress import Progress, listener
from .surfaces import Surface, input_from, surface_from, warn

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import LevelOptions
    from .surfaces import SurfaceLike


class Levels:
    """A recorded run. Lengths are millimeters."""

    marks: NDArray[np.float64]  #: (k, 3), from fine to coarse: triangles, largest and mean distance (NaN: not measured)
    result: Result | None  #: of the run that was recorded; None if the levels were opened from a log

    def __init__(self, core: _core.Levels, result: Result | None) -> None:
        self._core, self.result = core, result
        self.marks = np.array(core.marks(), dtype=np.float64).reshape(-1, 3)

    def at(self, *, triangles: int | None = None, error: float | None = None,
           on: SurfaceLike | None = None) -> tuple[NDArray, NDArray[np.int32]]:
        """The points (n, 3), mm, and triangles (m, 3) of a level.

        Parameters
        ----------
        triangles : int
            The first level of no more triangles than that; the last one, with a warning, if there is none.
        error : float, mm
            Instead: the coarsest mark whose measured distance to the input is no larger; the input, with a warning, if there
            is none.
        on : mesh or (points, triangles), optional
            A surface with the same triangles and other points (a registered bone) that takes the level over.

        Raises
        ------
        TypeError
            Values of a wrong type.
        ValueError
            Neither of the two numbers or both, values out of range, an error of levels without measured distances, other
            triangles, points that are not finite.
        """
        if (triangles is None) == (error is None):
            raise ValueError("a level is selected by triangles or by error, one of them")
        level = self._by_triangles(triangles) if error is None else self._by_error(error)
        if on is None:
            points, corners = self._core.at(level)
        else:
            points, corners = self._core.on(level, *surface_from(on, "on")[:2])
        return points.astype(np.float32) if self._core.is_single else points, corners

    def _by_triangles(self, triangles: int) -> int:
        wanted = number("triangles", triangles, 0, np.iinfo(np.int32).max, "triangles", is_whole=True)
        level = self._core.by_triangles(wanted)
        count = self._core.triangles_at(level)
        if count > wanted:
            warn([f"the coarsest level has {count} triangles, more than {wanted}"], 3)
        return level

    def _by_error(self, error: float) -> int:
        largest = number("error", error, 0, 1e30, "mm")
        if np.isnan(self.marks[:, 1]).any():
            raise ValueError("these levels were recorded without distances; ask for a number of triangles")
        level = self._core.by_error(largest)
        if level == 0:
            warn([f"no mark is within {largest:g} mm of the input; this is the whole input"], 3)
        return level

    @property
    def log(self) -> bytes:
        """For `open_levels`, and the file of ``bonedecimate levels --record`` (Documentation/how-to/levels.md)."""
        return self._core.log()

    def __reduce__(self) -> str:
        raise TypeError("levels cannot be pickled: keep levels.log, which open_levels reads")

    def __repr__(self) -> str:
        return f"<bonedecimate.Levels: {self._core.collapses} collapses, {len(self.marks)} marks>"


@takes_options("Arrays", "RecordedLevels")
def record_levels(points: ArrayLike | SurfaceLike, triangles: ArrayLike | None = None, *, progress: bool | Progress | None = None,
                  **options: Unpack[LevelOptions]) -> Levels:
    """Runs once and keeps every stage of it.

    Parameters
    ----------
    points, triangles, progress
        As `decimate` takes them; so are the options, of the coarsest level, and what is raised. Levels do not keep voxels: a
        surface that knows its label map is rejected unless `keep_voxels` is "Off", and is then recorded without it.
    **options
    """
    surface = input_from(points, triangles)
    values = read(options, record_levels)
    _reject_label_map(surface, values)
    with listener(progress) as heard:
        outcome, levels = _core.record_levels(*surface[:2], values, surface.is_single, list(surface.left_out), heard)
    outcome["warnings"] = surface.warnings + outcome["warnings"]
    check(outcome, 2)
    return Levels(levels, Result(outcome, gives_single(values, surface.is_single)))


def _reject_label_map(surface: Surface, values: _core.Options) -> None:
    if surface.source is not None and surface.source.grid is not None and values.text("KeepVoxels") != "Off":
        raise ValueError("levels do not keep voxels; keep_voxels=\"Off\" records this surface without its label map")


def open_levels(points: ArrayLike, triangles: ArrayLike, log: bytes, *, threads: int = 0) -> Levels:
    """The levels of a log again, with the very points and triangles that were recorded.

    Raises TypeError if the log is not bytes, ValueError if it is no log, damaged, or of another surface.
    """
    if not isinstance(log, (bytes, bytearray, memoryview)):
        raise TypeError(f"log is bytes, not a {type(log).__name__}")
    surface = input_from(points, triangles)
    return Levels(_core.open_levels(*surface[:2], bytes(log), thread_count(threads)), None)
