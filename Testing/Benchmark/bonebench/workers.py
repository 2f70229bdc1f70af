# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One process for one piece of work: a command that prints JSON, with a time limit and without a throw."""

from __future__ import annotations

import json
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


def call(command: Sequence[object], seconds: float = LONGEST_SECONDS) -> Outcome:
    """Runs the command and returns the JSON it printed last, or {"failure": why}."""
    words = [str(word) for word in command]
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return {"failure": f"not done after {seconds:.0f} s"}
    except OSError as failure:
        return {"failure": str(failure)}
    if done.returncode != 0:
        said = done.stderr.strip().splitlines()
        return {"failure": said[-1] if said else f"ended with code {done.returncode}"}
    begin = max(done.stdout.rfind("\n{"), 0 if done.stdout.startswith("{") else -1)
    try:
        outcome: Outcome = json.loads(done.stdout[begin:])
    except ValueError:
        return {"failure": "printed no JSON"}
    return outcome
