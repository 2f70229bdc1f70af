# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs with a largest error: what our modes prove, the results of peers with an option for it, and the fewest triangles at
which a peer stays within it, found by trial."""

from __future__ import annotations

import itertools
import statistics
import sys
from pathlib import Path
from typing import Any, Iterator, Sequence

from .bones import Bone
from .contest import Verifier
from .contestants import TOLERANCE_WORKER, Contestant
from .workers import Outcome, Programs, call

ERRORS = (0.1, 0.2, 0.5, 1.0)  # mm
TAKE_ERRORS = ("vtk", "meshoptimizer", "meshlib")  # tolerance_worker.py
BY_TRIAL = ("cgal", "vtk", "meshlab-topology", "meshoptimizer", "meshlib")  # those nearest to the original, and the default
CLOSE_ENOUGH = 1.05  # triangles between the trial that stays within the error and the next that does not
FEWEST = 0.003  # of the triangles: where trials begin


def with_error(programs: Programs, verifier: Verifier, bone: Bone, modes: Sequence[str], rounds: int,
               folder: Path) -> Iterator[dict[str, Any]]:
    """Each mode with each proved largest error, on two threads: in turn with CGAL's Lindstrom-Turk without an error, round after
    round, and once without the intersection guard."""
    result = folder / "result.ply"
    for guard, error, mode in itertools.product(("on", "off"), ERRORS, modes):
        runs, beside = [], []
        for _ in range(rounds if guard == "on" else 1):
            if programs.has("cgal"):
                beside.append(call([programs.path("cgal"), bone.file, folder / "peer.ply", bone.counts()[0]]))
            runs.append(call([programs.path("run"), bone.file, result, "core", mode, 2, "--error", error,
                              "--IntersectionGuard", guard]))
        failed = next((run for run in runs if "failure" in run), None)
        outcome = failed or {**runs[-1], "seconds": median(runs, "seconds"), "cpu_seconds": median(runs, "cpu_seconds"),
                             "certificate_seconds": statistics.median(run["proved"]["own_seconds"] for run in runs),
                             "runs": len(runs), "measured": verifier.compare(bone.file, result)}
        yield {"bone": bone.name, "input": bone.triangles, "error": error, "mode": mode, "guard": guard, "measured": {},
               "peer_faces": bone.counts()[0], "peer_seconds": median(beside, "seconds"), **outcome}


def median(outcomes: Sequence[Outcome], key: str) -> float | None:
    """Of the outcomes that have it; None if none has."""
    values = [outcome[key] for outcome in outcomes if key in outcome]
    return statistics.median(values) if values else None


class Trials:
    """A peer on a bone at number after number of triangles; none twice."""

    def __init__(self, programs: Programs, verifier: Verifier, bone: Bone, peer: Contestant, result: Path) -> None:
        self.programs, self.verifier, self.bone, self.peer, self.result = programs, verifier, bone, peer, result
        self.tried: dict[int, Outcome] = {}  # by requested number of triangles

    def fewest(self, error: float) -> Outcome:
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
            outcome = self.peer.run(self.programs, self.bone.file, self.result, count)
            if "failure" not in outcome:
                outcome["measured"] = self.verifier.compare(self.bone.file, self.result)
            self.tried[count] = outcome
        distance = self.tried[count].get("measured", {}).get("hausdorff")
        return distance is not None and distance <= error


def of_peers(programs: Programs, verifier: Verifier, bone: Bone, peers: Sequence[Contestant],
             folder: Path) -> Iterator[dict[str, Any]]:
    """A line for each peer and error: the result of its option for an error, and its fewest triangles by trial."""
    result = folder / "result.ply"
    for peer in peers:
        if peer.key not in BY_TRIAL:
            continue
        trials = Trials(programs, verifier, bone, peer, result)
        for error in ERRORS:
            by_error: Outcome = {}
            if peer.key in TAKE_ERRORS:
                by_error = call([sys.executable, "-B", TOLERANCE_WORKER, peer.key, bone.file, result, error])
                by_error["measured"] = {} if "failure" in by_error else verifier.compare(bone.file, result)
            yield {"bone": bone.name, "error": error, "key": peer.key, "name": peer.name, "by_error": by_error,
                   "by_trial": trials.fewest(error)}
