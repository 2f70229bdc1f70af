# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One process for one piece of work: a command that prints JSON, with a time limit and without a throw."""

from __future__ import annotations

import json
import resource
import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Sequence

LONGEST_SECONDS = 1800.0
Outcome = dict[str, Any]


@dataclass(frozen=True)
class Programs:
    """Where the compiled programs of the benchmark lie."""

    folder: Path

    def path(self, name: str) -> Path:
        """The program of that name, there or not."""
        return self.folder / f"bonedecimate-{name}"

    def has(self, name: str) -> bool:
        """Whether it was built: those that need CGAL may be missing."""
        return self.path(name).is_file()


def run(command: Sequence[object], seconds: float = LONGEST_SECONDS, cpu_seconds: int | None = None) -> tuple[str, str]:
    """Runs the command: why it failed, empty if it did not, and what it printed. cpu_seconds: limit of processor time."""
    def limit() -> None:
        if cpu_seconds is not None:
            resource.setrlimit(resource.RLIMIT_CPU, (cpu_seconds, cpu_seconds + 5))

    try:
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=seconds, check=False,
                              errors="replace", preexec_fn=limit)
    except subprocess.TimeoutExpired:
        return f"not done after {seconds:.0f} s", ""
    except OSError as failure:
        return str(failure), ""
    if -done.returncode == signal.SIGXCPU:
        return f"not done after {cpu_seconds} s of processor time", ""
    if done.returncode < 0:
        return f"ended by {signal.Signals(-done.returncode).name}", ""
    if done.returncode > 0:
        said = done.stderr.strip().splitlines()
        return said[-1] if said else f"ended with code {done.returncode}", ""
    return "", done.stdout


def processor_seconds() -> float:
    """Of all commands so far."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def call(command: Sequence[object], seconds: float = LONGEST_SECONDS, cpu_seconds: int | None = None) -> Outcome:
    """Runs the command and returns the JSON it printed last, or {"failure": why}."""
    failure, printed = run(command, seconds, cpu_seconds)
    if failure:
        return {"failure": failure}
    begin = max(printed.rfind("\n{"), 0 if printed.startswith("{") else -1)
    try:
        outcome: Outcome = json.loads(printed[begin:])
    except ValueError:
        return {"failure": "printed no JSON"}
    return outcome
