# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The bones: out of the CT of Debian's package invesalius-examples, phantoms of our own, files of the caller."""

from __future__ import annotations

import plistlib
import subprocess
import tarfile
from dataclasses import dataclass
from pathlib import Path

from .workers import Outcome, Programs, call

HU = 226  # threshold of bone
# Ranges of voxels along x, y and z.
CROPS = {
    "first crop": ((60, 190), (20, 150), (5, 75)),
    "thin bone": ((70, 150), (110, 190), (10, 60)),
    "vault": ((150, 230), (60, 140), (50, 105)),
    "orbit": ((60, 130), (20, 90), (10, 50)),
    "skull base": ((90, 170), (70, 150), (6, 51)),
    "occiput": ((80, 180), (150, 222), (30, 90)),
}
CRANIUM = Path("/usr/share/doc/invesalius-examples/examples/Cranium.inv3")


@dataclass(frozen=True)
class Bone:
    """A surface and the numbers of triangles it is brought to: counts, or fractions of its own below 1."""

    name: str
    file: Path
    triangles: int
    goals: tuple[float, ...]

    def counts(self) -> list[int]:
        """The goals as even numbers of triangles."""
        return [int(goal) if goal >= 1 else 2 * round(goal * self.triangles / 2) for goal in self.goals]


class Workshop:
    """Makes bones in a folder and keeps them for the next run."""

    def __init__(self, programs: Programs, folder: Path) -> None:
        self.programs = programs
        self.folder = folder
        self.complaints: list[str] = []

    def bone(self, name: str, goals: tuple[float, ...]) -> Bone | None:
        """A bone by name: cranium, maxilla, frontal, vault, small-leg, specimen-TRIANGLES."""
        if name.startswith("specimen-"):
            return self._made(name, goals, "specimen", name.split("-", 1)[1])
        if name == "small-leg":
            return self._made(name, goals, "whole", str(self._phantom()))
        volume = self._cranium()
        if volume is None:
            self.complaints.append(f"{name} is left out: Debian's package invesalius-examples is not installed.")
            return None
        return self._made(name, goals, "whole" if name == "cranium" else name, str(volume))

    def file(self, path: Path, goals: tuple[float, ...]) -> Bone | None:
        """A surface of the caller; made anew every time, for it may have changed."""
        (self.folder / f"{path.stem}.ply").unlink(missing_ok=True)
        return self._made(path.stem, goals, "file", str(path))

    def _made(self, name: str, goals: tuple[float, ...], kind: str, source: str) -> Bone | None:
        target = self.folder / f"{name}.ply"
        if not target.is_file():
            partial = target.with_suffix(".partial")
            outcome: Outcome = call([self.programs.path("bone"), kind, source, partial])
            if "failure" in outcome:
                self.complaints.append(f"{name} is left out: {outcome['failure']}.")
                return None
            partial.rename(target)
        return Bone(name, target, count_triangles(target), goals)

    def _phantom(self) -> Path:
        volume = self.folder / "phantom-small.mha"
        if not volume.is_file():
            subprocess.run([self.programs.path("phantom"), volume, "--size", "small"], check=True)
        return volume

    def _cranium(self) -> Path | None:
        """The CT as MetaImage: InVesalius keeps it as a tar of the voxels and a property list."""
        header = self.folder / "cranium.mhd"
        if header.is_file() or not CRANIUM.is_file():
            return header if header.is_file() else None
        with tarfile.open(CRANIUM) as project:
            parts = {Path(member.name).name: member for member in project if member.isfile()}
            words = plistlib.loads(read_member(project, parts["main.plist"]))
            voxels = read_member(project, parts["matrix.dat"])
        (self.folder / "matrix.dat").write_bytes(voxels)
        shape = " ".join(str(count) for count in reversed(words["matrix"]["shape"]))
        spacing = " ".join(str(step) for step in words["spacing"])
        header.write_text(
            f"ObjectType = Image\nNDims = 3\nDimSize = {shape}\nElementSpacing = {spacing}\nElementType = MET_SHORT\n"
            "ElementByteOrderMSB = False\nElementDataFile = matrix.dat\n", encoding="ascii")
        return header


def read_member(archive: tarfile.TarFile, member: tarfile.TarInfo) -> bytes:
    """The bytes of one file in a tar."""
    stream = archive.extractfile(member)
    if stream is None:
        raise ValueError(f"{member.name} is no file")
    return stream.read()


def count_triangles(ply: Path) -> int:
    """From the header alone."""
    with ply.open("rb") as file:
        for line in file:
            if line.startswith(b"element face"):
                return int(line.split()[2])
    raise ValueError(f"{ply} has no faces")
