# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the figures were measured on."""

from __future__ import annotations

import os
import platform
import resource
import subprocess
import time
from pathlib import Path
from typing import Any


def _line(path: str, key: str) -> str:
    file = Path(path)
    lines = file.read_text(encoding="utf-8", errors="replace").splitlines() if file.is_file() else []
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith(key)), "")


def describe() -> dict[str, Any]:
    """Processor, cores that may be used, memory and system; no name of the machine."""
    memory = _line("/proc/meminfo", "MemTotal").split()
    release = Path("/etc/os-release")
    words = dict(line.split("=", 1) for line in release.read_text(encoding="utf-8").splitlines() if "=" in line) \
        if release.is_file() else {}
    return {"processor": _line("/proc/cpuinfo", "model name") or platform.machine(),
            "cores": len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count(),
            "memory_gb": int(memory[0]) / 1e6 if memory else 0.0,
            "system": words.get("PRETTY_NAME", platform.system()).strip('"')}


def commit() -> str:
    """The commit of the sources, with a mark if they were changed since."""
    command = ["git", "-C", str(Path(__file__).parent), "describe", "--always", "--abbrev=8", "--dirty=, changed", "--exclude=*"]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip() or "unknown"


def _busy_seconds() -> float:
    """Of all cores together since the system started, time taken by other guests of a host included."""
    stat = Path("/proc/stat")
    if not stat.is_file():
        return 0.0
    user, nice, system, _idle, _wait, hard, soft, stolen = map(int, stat.read_text(encoding="utf-8").split()[1:9])
    return (user + nice + system + hard + soft + stolen) / os.sysconf("SC_CLK_TCK")


def _own_seconds() -> float:
    """Of this program and of those it has run."""
    used = [resource.getrusage(kind) for kind in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)


BUSY = "Other programs used"
QUIET = 0.1  # cores that others may use beside figures in seconds


class Others:
    """How much of the processor other processes use from now on."""

    def __init__(self) -> None:
        self.since = time.monotonic(), _busy_seconds() - _own_seconds()

    def cores(self) -> float:
        """The average number of cores."""
        begin, used = self.since
        return (_busy_seconds() - _own_seconds() - used) / max(1.0, time.monotonic() - begin)

    def complaint(self) -> str:
        """A sentence where that disturbs the times, else nothing."""
        cores = self.cores()
        return f"{BUSY} {cores:.1f} of {os.cpu_count()} cores during this run: do not quote its seconds." if cores > QUIET else ""
