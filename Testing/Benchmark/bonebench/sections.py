# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What only our modes do: growth to 10 million triangles, numbers of threads, the thesis's error mode."""

from __future__ import annotations

import statistics
from dataclasses import replace
from pathlib import Path
from typing import Any, Iterator, Sequence

from .bones import Bone, Workshop
from .contest import Verifier
from .contestants import our_contestants, our_kernels, our_modes, ours
from .workers import Programs, call

KEPT_IN_GROWTH = 0.2  # of the triangles
GROWTH_SIZES = (100_000, 300_000, 1_000_000, 3_000_000, 10_000_000)
THREADS = (1, 2, 4, 8)


def growth(programs: Programs, workshop: Workshop, modes: Sequence[str], sizes: Sequence[int],
           rounds: int, folder: Path) -> Iterator[dict[str, Any]]:
    """Specimens of each size to a fifth: median seconds and most bytes, input and output included, per input triangle."""
    for size in sizes:
        bone = workshop.bone(f"specimen-{size}", (KEPT_IN_GROWTH,))
        if bone is None:
            continue
        contestants = [contestant for contestant in our_contestants(list(modes), our_modes(programs, "parallel")) if contestant.through == "core"]
        runs: dict[str, list[dict[str, Any]]] = {contestant.key: [] for contestant in contestants}
        for _ in range(rounds):
            for contestant in contestants:
                runs[contestant.key].append(contestant.run(programs, bone.file, folder / "result.ply", bone.counts()[0]))
        for contestant in contestants:
            good = [run for run in runs[contestant.key] if "failure" not in run]
            if good:
                yield {
                    "bone": bone.name, "triangles": bone.triangles, "key": contestant.key, "mode": contestant.mode,
                    "threads": contestant.threads, "kept": good[0]["triangles"], "runs": len(good),
                    "seconds": statistics.median(run["seconds"] for run in good),
                    "cpu_seconds": statistics.median(run["cpu_seconds"] for run in good),
                    "bytes": max(run["input_bytes"] + run["peak_bytes"] for run in good)}


def threads(programs: Programs, bone: Bone, modes: Sequence[str], rounds: int, folder: Path) -> list[dict[str, Any]]:
    """The same job on 1, 2, 4 and 8 threads and with each set of kernels in turn; the bytes that come out must be equal."""
    contestants = [contestant for mode in modes for contestant in
                   [ours(mode, count) for count in THREADS]
                   + [replace(ours(mode), key=f"{mode}-{name}", kernels=name) for name in our_kernels(programs)]]
    runs: dict[str, list[dict[str, Any]]] = {contestant.key: [] for contestant in contestants}
    for _ in range(rounds):
        for contestant in contestants:
            runs[contestant.key].append(contestant.run(programs, bone.file, folder / "result.ply", bone.counts()[0]))
    return [{
        "bone": bone.name, "requested": bone.counts()[0], "mode": contestant.mode,
        "threads": contestant.threads, "kernels": contestant.kernels,
        "seconds": statistics.median(run["seconds"] for run in good),
        "cpu_seconds": statistics.median(run["cpu_seconds"] for run in good),
        "checksums": sorted({run["checksum"] for run in good})}
        for contestant in contestants if (good := [run for run in runs[contestant.key] if "failure" not in run])]


def error_mode(programs: Programs, verifier: Verifier, bone: Bone, modes: Sequence[str], errors: Sequence[float],
               folder: Path) -> list[dict[str, Any]]:
    """Each mode with a largest error in mm instead of a number of triangles, once: the thesis's second table."""
    rows = []
    for error in errors:
        for mode in modes:
            outcome = call([programs.path("run"), bone.file, folder / "result.ply", "core", mode, 1, "--error", error])
            measured = {} if "failure" in outcome else verifier.compare(bone.file, folder / "result.ply")
            rows.append({"bone": bone.name, "error": error, "mode": mode, "measured": measured, **outcome})
    return rows
