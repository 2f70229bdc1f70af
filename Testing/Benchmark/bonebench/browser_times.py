# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""How long the package for npm takes in Node.js, which has Chromium's engine, beside meshoptimizer's simplifier and the program."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator

if TYPE_CHECKING:
    from .features import Lab

Row = dict[str, Any]
ROOT = Path(__file__).resolve().parents[3]
WASM = ROOT / "build" / "wasm"  # of Utilities/check_wasm.sh
SCRIPT = ROOT / "Testing" / "Browser" / "benchmark.mjs"
COUNT = 134000


def browser(lab: Lab) -> Iterator[Row]:
    """The cranium to a fifth of its triangles; nothing without the package."""
    if not (WASM / "npm").is_dir():
        print("the table browser is left out: Utilities/check_wasm.sh --build makes the package")
        return
    bone = lab.bone("cranium")
    said = subprocess.run(["node", "--no-experimental-fetch", SCRIPT, WASM, bone.file, str(COUNT)], check=True, capture_output=True, encoding="utf-8").stdout
    for line in said.splitlines():
        name, seconds, triangles, lower, upper = line.split()
        yield {"program": name if name == "meshoptimizer" else f"package, `{name}`", "s": float(seconds), "triangles": int(float(triangles)),
               "at least, mm": float(lower), "at most, mm": float(upper)}
    for mode in ("Fast", "Balanced"):
        done = lab.run(bone.file, "--mode", mode, "--target-triangles", COUNT, "--measure", "off")
        yield {"program": f"program, `{mode}`", "s": done.report["seconds"]["total"], "triangles": done.triangles, "at least, mm": "", "at most, mm": ""}
