# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts deliberate bugs into the guarantee, one after the other, and sees whether the attack finds them.

    mutants.py --list                 what is changed, and that it is still there to be changed
    mutants.py FOLDER [--only WORD] [--runs N] [SURFACE.ply ...]

FOLDER holds a copy of the source and its build. Ends with 1 if a bug was not found in N runs (4000), or if the attack breaks
the error bound without any.
"""

from __future__ import annotations

import argparse
import pathlib
import shutil
import subprocess
import sys
import time
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = "Filters/Core/ErrorBound/"


class Mutant(NamedTuple):
    """A bug: a replacement of text in a file."""

    name: str
    file: str
    right: str
    wrong: str


MUTANTS = (
    Mutant("a limit that is a twentieth too large", FOLDER + "ErrorLimits.cxx", "error * (1.0 - RelativeSlack) - slack",
           "error * 1.05 - slack"),
    Mutant("no slack for points that are rounded when they are written", FOLDER + "ErrorLimits.cxx",
           "return AbsoluteSlack * size + rounding;", "return 0.0 * (size + rounding);"),
    Mutant("the most tolerant corner of an original counts", FOLDER + "ErrorLimits.h",
           ": std::min({ this->Values[c[0]]", ": std::max({ this->Values[c[0]]"),
    Mutant("originals are not checked", FOLDER + "Prover.cxx", "&& this->OriginalsAreNear(mesh) &&", "&&"),
    Mutant("new faces are not checked", FOLDER + "Prover.cxx", "&& this->NewFacesAreNear();", ";"),
    Mutant("boundaries are not checked", FOLDER + "Prover.cxx", "this->BoundaryIsNear(mesh) &&", ""),
    Mutant("two corners of an original are enough", FOLDER + "Prover.cxx",
           "& this->Points[points[1]].Near & this->Points[points[2]].Near;", "& this->Points[points[1]].Near;"),
    Mutant("two corners of a piece are enough", FOLDER + "CommonFaceProof.cxx",
           "piece[0].Near & piece[1].Near & piece[2].Near;", "piece[0].Near & piece[1].Near;"),
    Mutant("half of a piece is forgotten", FOLDER + "CommonFaceProof.cxx",
           "  this->Open.push_back(piece);\n  this->Open.back()[edge] = middle;\n", ""),
    Mutant("the faces that cover an original are not stored", FOLDER + "Prover.cxx",
           "coverage.Add(item.Id, coverings[i]);", "(void)coverings;"),
    Mutant("an even number of layers is a cover", FOLDER + "PlaneCover.h", "return this->IsOdd;", "return true;"),
    Mutant("a boundary over the face is allowed", FOLDER + "PlaneCover.cxx", "return twin != None;", "return true;"),
    Mutant("any distance from the face is allowed", FOLDER + "PlaneCover.cxx",
           "(farthest > limit * limit && !this->IsNearOver(shape, limit)) ||", "farthest < -limit ||"),
    Mutant("one end of a boundary is enough", FOLDER + "BoundaryProof.cxx", "isNear(this->Candidates[i], 0) &&",
           "isNear(this->Candidates[i], 0) ||"),
    Mutant("half of a face is forgotten", FOLDER + "FaceProof.cxx",
           "  half.Corners[next] = piece.Corners[next];\n  half.Corners[edge] = middle;\n  this->Open.push_back(half);\n",
           ""),
)


def problems() -> list[str]:
    """Mutants whose text does not occur exactly once."""
    found = []
    for mutant in MUTANTS:
        count = (ROOT / mutant.file).read_text(encoding="utf-8").count(mutant.right)
        if count != 1:
            found.append(f"{mutant.name}: {mutant.file} has {count} times: {mutant.right}")
    return found


def copy_source(folder: pathlib.Path) -> pathlib.Path:
    """Copies the sources of the core and of the attack."""
    source = folder / "source"
    if source.exists():
        shutil.rmtree(source)
    ignored = shutil.ignore_patterns("build", ".git", "images", "__pycache__")
    # With new times of modification, so that the build does not keep the bug of an earlier run.
    shutil.copytree(ROOT, source, ignore=ignored, copy_function=shutil.copyfile)
    return source


def build(folder: pathlib.Path) -> None:
    """Builds the attack from the current source."""
    words = ["cmake", "--build", folder / "build", "--target", "bonedecimate-attack"]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stdout[-4000:] + done.stderr[-4000:])


def configure(folder: pathlib.Path) -> None:
    """Configures an optimized build of the core alone."""
    words = ["cmake", "-S", folder / "source", "-B", folder / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DBONEDECIMATE_CORE_ONLY=ON"]
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)


def attack(folder: pathlib.Path, runs: int, surfaces: list[pathlib.Path]) -> tuple[bool, str]:
    """Whether the attack found a violation, and its output."""
    words = [folder / "build" / "bin" / "bonedecimate-attack", str(runs), "1", *surfaces]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    said = (done.stdout + done.stderr).strip()
    if done.returncode not in (0, 1):
        said = f"ended with {done.returncode} {said}"
    return done.returncode != 0, said


def try_mutant(mutant: Mutant, folder: pathlib.Path, runs: int, surfaces: list[pathlib.Path]) -> bool:
    """Whether the attack found the bug."""
    file = folder / "source" / mutant.file
    right = file.read_text(encoding="utf-8")
    file.write_text(right.replace(mutant.right, mutant.wrong), encoding="utf-8")
    build(folder)
    start = time.monotonic()
    found, said = attack(folder, runs, surfaces)
    file.write_text(right, encoding="utf-8")
    print(f"{'found' if found else 'NOT FOUND'} in {time.monotonic() - start:.1f} s: {mutant.name}: {said}", flush=True)
    return found


def main() -> int:
    """Lists or tries them."""
    parser = argparse.ArgumentParser(prog="mutants.py", description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=pathlib.Path)
    parser.add_argument("surfaces", nargs="*", type=pathlib.Path)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--runs", type=int, default=4000)
    arguments = parser.parse_intermixed_args()  # options may be between the folder and the surfaces
    chosen = [mutant for mutant in MUTANTS if arguments.only in mutant.name]
    if arguments.list or arguments.folder is None or problems():
        print(*(problems() or [f"{mutant.name}: {mutant.file}" for mutant in chosen]), sep="\n")
        return 1 if problems() else 0
    copy_source(arguments.folder)
    configure(arguments.folder)
    build(arguments.folder)
    broken, said = attack(arguments.folder, arguments.runs, arguments.surfaces)
    print(f"without a bug: {said}", flush=True)
    results = [try_mutant(mutant, arguments.folder, arguments.runs, arguments.surfaces) for mutant in chosen]
    print(f"{sum(results)} of {len(results)} found")
    return 1 if broken or not all(results) else 0


if __name__ == "__main__":
    sys.exit(main())
