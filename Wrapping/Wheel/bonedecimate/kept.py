# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the filter keeps between updates."""

from __future__ import annotations

from . import _core


class KeepsPrepared:
    """The part of vtkBoneDecimate that keeps what runs over regions of the same surface have in common."""

    _prepared: _core.PreparedSurface | None = None
    _keeps_prepared = True

    def SetKeepPrepared(self, keep: bool) -> None:
        """Whether the filter keeps what it prepared of its input and the results of regions, so that the next update with other
        tolerances runs only the regions that are new. No result depends on it. Off releases the memory. Default on."""
        self._keeps_prepared = bool(keep)
        if not keep:
            self._prepared = None

    def GetKeepPrepared(self) -> bool:
        return self._keeps_prepared

    def KeepPreparedOn(self) -> None:
        self.SetKeepPrepared(True)

    def KeepPreparedOff(self) -> None:
        self.SetKeepPrepared(False)

    keep_prepared = property(GetKeepPrepared, SetKeepPrepared, doc="Whether what was prepared is kept for the next update.")

    def ReleasePrepared(self) -> None:
        """Releases what is kept, until the next update."""
        if self._prepared is not None:
            self._prepared.release()

    def GetPreparedMemory(self) -> int:
        """Approximate memory of what is kept, bytes."""
        return 0 if self._prepared is None else self._prepared.memory

    prepared_memory = property(GetPreparedMemory, doc="Approximate memory of what is kept, bytes.")

    def _kept(self) -> _core.PreparedSurface | None:
        """For a run; None: nothing is to be kept."""
        if self._keeps_prepared and self._prepared is None:
            self._prepared = _core.PreparedSurface()
        return self._prepared
