# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Bytes of one result in each format, beside those of gltfpack."""

from __future__ import annotations

import gzip
import os
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator

if TYPE_CHECKING:
    from .features import Lab

Row = dict[str, Any]
ERRORS = (0.2, 0.05)  # mm
GLTFPACK = Path(os.environ.get("NODE_PACKAGES", "node"), "node_modules", "gltfpack", "cli.js")
PACKED = {"gltfpack": (), "gltfpack -cc": ("-cc",), "gltfpack -cc -vp 16": ("-cc", "-vp", "16")}


def size(file: Path) -> int:
    """Bytes of a file."""
    return file.stat().st_size


def zipped(file: Path) -> int:
    """Bytes as `gzip -9` leaves them, which web servers do."""
    return len(gzip.compress(file.read_bytes(), 9, mtime=0))


def packed(plain: Path) -> Row:
    """Bytes of what gltfpack makes of a file; none without it."""
    made = {}
    for name, words in PACKED.items():
        target = plain.with_name("packed.glb")
        if GLTFPACK.is_file():
            subprocess.run(["node", GLTFPACK, "-i", plain, "-o", target, *words], check=True, stdout=subprocess.DEVNULL)
            made[name] = size(target)
    return made


def file_sizes(lab: Lab) -> Iterator[Row]:
    """Of each bone and of the whole bone of the CT."""
    formats = ("glb", "3mf", "vtp", "obj", "stl")
    for bone in (lab.bone("cranium"), *lab.bones()):
        for error in ERRORS:
            also = [word for extension in formats[1:] for word in ("--also", lab.folder / f"result.{extension}")]
            common = ("--mode", "Fast", "--max-error", error, "--measure", "off")
            done = lab.run(bone.file, *common, *also, result="result.glb")
            lab.run(bone.file, *common, "--glb-compression", "meshopt", result="small.glb")
            files = {extension: lab.folder / f"result.{extension}" for extension in formats}
            small = lab.folder / "small.glb"
            yield {"input": bone.name, "largest error, mm": error, "triangles": done.triangles, "GLB": size(files["glb"]), "GLB, gzip": zipped(files["glb"]),
                   "GLB, meshopt": size(small), "GLB, meshopt, gzip": zipped(small), **packed(files["glb"]),
                   **{extension.upper(): size(files[extension]) for extension in formats[1:]}}
