# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""How long `certify` takes: for a proved result, and for one of another program that lost fragments."""

from __future__ import annotations

import importlib.util
import json
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator

from .bones import Bone, count_triangles
from .contestants import Contestant

if TYPE_CHECKING:
    from .features import Lab

Row = dict[str, Any]
ROUNDS = 3
ERROR = 0.5  # mm
FAR_COUNT = 134000
STEPS = {f"within {ERROR:g} mm: yes or no": ("--tolerance", ERROR, "--first-proof", "--no-means"),
         "largest distance to a millionth": ("--no-means",), "the same with averages": ()}
FAR_STEPS = {"largest distance to 0.001 mm": ("--gap", 6e-5, "--no-means")}


def timed(command: list[str]) -> tuple[float, float]:
    """Seconds and processor seconds of a process."""
    begin = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)} ended with {process.returncode}")
    return time.monotonic() - begin, used.ru_utime + used.ru_stime


def rows_of(lab: Lab, bone: Bone, result: Path, name: str, steps: dict[str, tuple[object, ...]]) -> Iterator[Row]:
    """Each question about a pair, on two threads."""
    file = lab.folder / "certificate.json"
    for question, words in steps.items():
        command = [lab.programs.folder / "bonedecimate", "certify", bone.file, result, "--quiet", "--threads", 2, "--json", file, *words]
        runs = []
        for _ in range(ROUNDS):
            whole, cpu = timed([str(word) for word in command])
            proved = json.loads(file.read_text(encoding="utf-8"))
            runs.append((proved["seconds"], whole, cpu))
        seconds, whole, cpu = (statistics.median(values) for values in zip(*runs))
        yield {"result": name, "triangles": f"{bone.triangles:,} / {count_triangles(result):,}", "question": question, "s": seconds,
               "s, whole command": whole, "CPU s": cpu, "at least, mm": proved["lower"], "at most, mm": proved["upper"]}


def certify(lab: Lab) -> Iterator[Row]:
    """The cranium with a proved result and with one that is far away."""
    bone = lab.bone("cranium")
    near, far = lab.folder / "near.ply", lab.folder / "far.ply"
    lab.run(bone.file, "--mode", "Fast", "--max-error", ERROR, "--measure", "off", result=near.name)
    yield from rows_of(lab, bone, near, f"`Fast`, {ERROR:g} mm", STEPS)
    if lab.with_meshlib and importlib.util.find_spec("meshlib"):
        Contestant("meshlib", "MeshLib").run(lab.programs, bone.file, far, FAR_COUNT)
        yield from rows_of(lab, bone, far, "MeshLib, by number", FAR_STEPS)
