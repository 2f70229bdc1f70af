# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Remeshing by this project and by peers to the same number of triangles."""

from __future__ import annotations

import importlib.util
import sys
from dataclasses import dataclass
from pathlib import Path

from .contestants import WORKER
from .workers import Outcome, Programs, call

CLOSE_ENOUGH = 0.01  # of the number of triangles
TRIALS = 6  # of a length


@dataclass(frozen=True)
class Remesher:
    """Another program: its key for peer_worker.py, name, Python module ("" for CGAL's), and whether it takes a length or a count."""

    key: str
    name: str
    module: str
    takes_length: bool

    def is_here(self, programs: Programs) -> bool:
        """Whether it is installed or built."""
        return importlib.util.find_spec(self.module) is not None if self.module else programs.has(self.key)

    def run(self, programs: Programs, surface: Path, result: Path, goal: float) -> Outcome:
        """One run, in a process of its own. goal: mm, or a number of triangles."""
        if not self.module:
            return call([programs.path(self.key), surface, result, goal])
        return call([sys.executable, "-B", WORKER, self.key, surface, result,
                     f"{goal:.9f}mm" if self.takes_length else round(goal)])


QUADRIC = Remesher("meshlab", "MeshLab quadric", "pymeshlab", False)
ISOTROPIC = Remesher("meshlab-remeshing", "MeshLab isotropic remeshing", "pymeshlab", True)
PYACVD = Remesher("pyacvd", "pyacvd", "pyacvd", False)
CGAL = Remesher("cgal-remeshing", "CGAL isotropic remeshing", "", True)
MESHLIB = Remesher("meshlib-remeshing", "MeshLib remesh", "meshlib", True)
PEERS = (QUADRIC, ISOTROPIC, CGAL, PYACVD, MESHLIB)


def to_count(programs: Programs, peer: Remesher, surface: Path, result: Path, count: int, length: float) -> Outcome:
    """Runs the peer until its result has the number of triangles within 1 %. length: mm, where the search begins.

    The number goes with the inverse square of the length. Kept is the last result; the last of six trials may be farther off.
    """
    goal = length if peer.takes_length else float(count)
    outcome: Outcome = {}
    for _ in range(TRIALS if peer.takes_length else 1):
        outcome = peer.run(programs, surface, result, goal)
        if "failure" in outcome or not outcome["triangles"]:
            return outcome
        ratio = outcome["triangles"] / count
        if abs(ratio - 1.0) <= CLOSE_ENOUGH:
            break
        goal *= ratio ** 0.5
    return outcome


def ours(programs: Programs, surface: Path, result: Path, mode: str, **options: float) -> Outcome:
    """One run of a mode; error is the largest error in mm, faces the number of triangles, others are named as the core names them."""
    words = [word for name, value in options.items() for word in (f"--{name}", value)]
    return call([programs.path("run"), surface, result, "core", mode, 2, *words])
