# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Asked for a largest error: what our modes prove, what peers that can be asked give, and the fewest triangles at which any
peer stays within it, found by trial."""

from __future__ import annotations

import itertools
import sys
from pathlib import Path
from typing import Any, Iterator, Sequence

from .bones import Bone
from .contest import Judge
from .contestants import WORKER, Contestant
from .workers import Answer, Programs, ask

ERRORS = (0.1, 0.2, 0.5, 1.0)  # mm
TAKE_ERRORS = ("vtk", "meshoptimizer", "meshlib")  # peer_worker.py
BY_TRIAL = ("cgal", "vtk", "meshlab-topology", "meshoptimizer", "meshlib")  # those nearest to the original, and the default
CLOSE_ENOUGH = 1.05  # triangles between the trial that stays within the error and the next that does not
FEWEST = 0.003  # of the triangles: where trials begin


def our_promises(programs: Programs, judge: Judge, bone: Bone, modes: Sequence[str], folder: Path) -> Iterator[dict[str, Any]]:
    """Each mode that proves its largest error asked for one, on two threads, with and without the guard of gaps, beside
    CGAL's Lindstrom-Turk in the same run."""
    beside = ask([programs.path("cgal"), bone.file, folder / "peer.ply", bone.counts()[0]]) if programs.has("cgal") else {}
    for guard, error, mode in itertools.product(("on", "off"), ERRORS, modes):
        answer = ask([programs.path("run"), bone.file, folder / "result.ply", "core", mode, 2, "--error", error,
                      "--KeepClearance", guard])
        judged = {} if "failure" in answer else judge.compare(bone.file, folder / "result.ply")
        yield {"bone": bone.name, "input": bone.triangles, "error": error, "mode": mode, "guard": guard, "judged": judged,
               "peer_faces": bone.counts()[0], "peer_seconds": beside.get("seconds"), **answer}


class Trials:
    """A peer on a bone at number after number of triangles; none twice."""

    def __init__(self, programs: Programs, judge: Judge, bone: Bone, peer: Contestant, result: Path) -> None:
        self.programs, self.judge, self.bone, self.peer, self.result = programs, judge, bone, peer, result
        self.tried: dict[int, Answer] = {}  # by the number that was asked for

    def fewest(self, error: float) -> Answer:
        """What stays within the error, sampled, with CLOSE_ENOUGH fewer that do not; empty if only the input does."""
        within = min((n for n in self.tried if self._is_within(n, error)), default=self.bone.triangles)
        beyond = max((n for n in self.tried if n < within), default=max(4, round(FEWEST * self.bone.triangles)))
        while within > CLOSE_ENOUGH * beyond:
            middle = round((within * beyond) ** 0.5)
            if self._is_within(middle, error):
                within = middle
            else:
                beyond = middle
        return self.tried.get(within, {})

    def _is_within(self, count: int, error: float) -> bool:
        if count not in self.tried:
            answer = self.peer.run(self.programs, self.bone.file, self.result, count)
            if "failure" not in answer:
                answer["judged"] = self.judge.compare(self.bone.file, self.result)
            self.tried[count] = answer
        distance = self.tried[count].get("judged", {}).get("hausdorff")
        return distance is not None and distance <= error


def of_peers(programs: Programs, judge: Judge, bone: Bone, peers: Sequence[Contestant], folder: Path) -> Iterator[dict[str, Any]]:
    """A line for each peer and error: what it gives when asked for the error, and its fewest triangles by trial."""
    result = folder / "result.ply"
    for peer in peers:
        if peer.key not in BY_TRIAL:
            continue
        trials = Trials(programs, judge, bone, peer, result)
        for error in ERRORS:
            asked: Answer = {}
            if peer.key in TAKE_ERRORS:
                asked = ask([sys.executable, "-B", WORKER, peer.key, bone.file, result, f"{error}mm"])
                asked["judged"] = {} if "failure" in asked else judge.compare(bone.file, result)
            yield {"bone": bone.name, "error": error, "who": peer.key, "name": peer.name, "asked": asked,
                   "by_trial": trials.fewest(error)}
