# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the figures were measured on."""

from __future__ import annotations

import os
import platform
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


def busy_with_other_work() -> str:
    """A sentence when others use the processor, else nothing. To be asked before the first run."""
    load, cores = os.getloadavg()[0], os.cpu_count() or 1
    if load < 0.5 * cores:
        return ""
    return f"The machine was busy with other work (load {load:.1f} on {cores} cores): do not quote the seconds of this run."
