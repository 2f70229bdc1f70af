# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs with a largest error, which our modes prove."""

from __future__ import annotations

import itertools
import statistics
from pathlib import Path
from typing import Any, Iterator, Sequence

from . import machine
from .bones import Bone
from .contest import Verifier
from .workers import Outcome, Programs, call

ERRORS = (0.1, 0.2, 0.5, 1.0)  # mm


def with_error(programs: Programs, verifier: Verifier, bone: Bone, modes: Sequence[str], rounds: int,
               folder: Path) -> Iterator[dict[str, Any]]:
    """Each mode with each proved largest error, on two threads, and once without the intersection guard."""
    result = folder / "result.ply"
    for guard, error, mode in itertools.product(("on", "off"), ERRORS, modes):
        others = machine.Others()
        runs = [call([programs.path("run"), bone.file, result, "core", mode, 2, "--error", error, "--IntersectionGuard", guard])
                for _ in range(rounds if guard == "on" else 1)]
        failed = next((run for run in runs if "failure" in run), None)
        outcome = failed or {**runs[-1], "seconds": median(runs, "seconds"), "cpu_seconds": median(runs, "cpu_seconds"),
                             "certificate_seconds": statistics.median(run["proved"]["own_seconds"] for run in runs),
                             "runs": len(runs), "others": others.cores(), "measured": verifier.compare(bone.file, result)}
        yield {"bone": bone.name, "input": bone.triangles, "error": error, "mode": mode, "guard": guard, "measured": {}, **outcome}


def median(outcomes: Sequence[Outcome], key: str) -> float | None:
    """Of the outcomes that have it; None if none has."""
    values = [outcome[key] for outcome in outcomes if key in outcome]
    return statistics.median(values) if values else None
