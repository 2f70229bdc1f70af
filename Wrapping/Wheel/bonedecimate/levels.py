# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Levels of detail: one run, recorded, and every stage of it at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .arrays import Result, _points, _triangles, check
from .options import WITHOUT_ARRAYS, read
from .progress import Progress, listener

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import ArrayOptions


class Levels:
    """A recorded run. Lengths are millimetres."""

    marks: NDArray[np.float64]  #: (k, 3), from fine to coarse: triangles, largest and mean distance (NaN: not measured)
    result: Result | None  #: of the run that was recorded; None if the levels were opened from a log

    def __init__(self, core: _core.Levels, single: bool, result: Result | None) -> None:
        self._core, self._single, self.result = core, single, result
        self.marks = np.array(core.marks(), dtype=np.float64).reshape(-1, 3)

    def at(self, *, triangles: int | None = None, error: float | None = None,
           on: tuple[ArrayLike, ArrayLike] | Result | None = None) -> tuple[NDArray, NDArray[np.int32]]:
        """The points (n, 3), mm, and triangles (m, 3) of a level.

        Parameters
        ----------
        triangles : int
            The first level of no more triangles than that; the last one if there is none.
        error : float, mm
            Instead: the coarsest mark whose measured distance to the input is no larger; the input if there is none.
        on : (points, triangles), optional
            A surface with the same triangles and other points (a registered bone) that takes the level over.

        Raises
        ------
        ValueError
            Neither of the two numbers or both, other triangles, points that are not finite.
        """
        if (triangles is None) == (error is None):
            raise ValueError("a level is wanted by triangles or by error, one of them")
        level = self._core.by_error(float(error)) if triangles is None else self._core.by_triangles(int(triangles))
        if on is None:
            points, corners = self._core.at(level)
        else:
            others, theirs = on
            points, corners = self._core.on(level, _points(others)[0], _triangles(theirs))
        return points.astype(np.float32) if self._single else points, corners

    @property
    def log(self) -> bytes:
        """For `open_levels`, and the file of ``bonedecimate levels --record`` (Documentation/levels.md)."""
        return self._core.log()

    def __repr__(self) -> str:
        return f"<bonedecimate.Levels: {self._core.collapses} collapses, {len(self.marks)} marks>"


def record_levels(points: ArrayLike, triangles: ArrayLike, *, progress: bool | Progress | None = None,
                  **options: Unpack[ArrayOptions]) -> Levels:
    """Runs once and keeps every stage of it.

    Parameters
    ----------
    points, triangles, progress
        As `decimate` takes them.
    **options
        ``mode``, ``target_faces`` or ``target_reduction`` (of the coarsest level), ``max_error`` (mm, kept by every level),
        ``measure=False`` (marks without distances), ``threads``. The others have no use here.
    """
    corners = _triangles(triangles)
    places, isSingle = _points(points)
    values = read(options, WITHOUT_ARRAYS)
    precision = values.text("OutputPointsPrecision")
    single = precision == "Single" or (precision == "Default" and isSingle)
    with listener(progress) as heard:
        answer, levels = _core.record_levels(places, corners, values, isSingle, heard)
    check(answer)
    return Levels(levels, single, Result(answer, single))


def open_levels(points: ArrayLike, triangles: ArrayLike, log: bytes, *, threads: int = 0) -> Levels:
    """The levels of a log again, with the very points and triangles that were recorded.

    Raises ValueError if the log is none, damaged, or of another surface.
    """
    places, isSingle = _points(points)
    return Levels(_core.open_levels(places, _triangles(triangles), bytes(log), threads), isSingle, None)
