# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts deliberate bugs into the proofs of error and voxels, one after the other, and sees what finds them.

    mutants.py --list                 what is changed, and that it is still there to be changed
    mutants.py FOLDER [--only PATTERN] [--runs N] [SURFACE.ply ...]

FOLDER holds a copy of the source and its build. Bugs in the error bound are looked for by the attack on surfaces, those in the draft and
in the certificate by it and by unit tests, those in what lets nothing pass through anything by the attack on near parts and by unit tests, all others by the
attack on label maps and by unit tests. Ends with 1 if neither finds a bug in N runs (4000), or if an attack finds a violation without any.
"""

from __future__ import annotations

import argparse
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import time

from deliberate_bugs import MUTANTS, Mutant

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_MEMORY = 4 << 30  # bytes


def attack_of(mutant: Mutant) -> str:
    """The attack that looks for it."""
    return mutant.kind if mutant.tests else "surfaces"


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


def build(folder: pathlib.Path, target: str = "bonedecimate-attack") -> None:
    """Builds a program from the current source."""
    words = ["cmake", "--build", folder / "build", "--target", target]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stdout[-4000:] + done.stderr[-4000:])


def configure(folder: pathlib.Path) -> None:
    """Configures an optimized build of the core alone."""
    words = ["cmake", "-S", folder / "source", "-B", folder / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DBONEDECIMATE_CORE_ONLY=ON"]
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)


def limit_memory() -> None:
    """A bug can make lists that grow without end."""
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def run(words: list) -> tuple[bool, str]:
    """Whether a program failed, and its output."""
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False, timeout=1800, preexec_fn=limit_memory)
    except subprocess.TimeoutExpired:
        return True, "does not end"
    said = (done.stdout + done.stderr).strip()
    if done.returncode not in (0, 1):
        said = f"ended with {done.returncode} {said}"
    return done.returncode != 0, said


def attack(folder: pathlib.Path, kind: str, runs: int, surfaces: list[pathlib.Path]) -> tuple[bool, str]:
    """Whether an attack found a violation, and its output."""
    program = folder / "build" / "bin" / "bonedecimate-attack"
    return run([program, str(runs), "1", *surfaces] if kind == "surfaces" else [program, f"--{kind}", str(runs), "1"])


def unit_tests(folder: pathlib.Path, chosen: str) -> tuple[bool, str]:
    """Whether unit tests failed, and how many."""
    build(folder, "BoneDecimateCoreTests")
    failed, said = run([folder / "build" / "bin" / "BoneDecimateCoreTests", f"--gtest_filter={chosen}", "--gtest_brief=1"])
    names = [line.split("]", 1)[1].strip().split(" (")[0].split(",")[0]
             for line in said.splitlines() if line.startswith("[  FAILED  ]")]
    return failed, f"{len(names)} unit tests fail: {', '.join(names[:3])}" if failed else "no unit test fails"


def try_mutant(mutant: Mutant, folder: pathlib.Path, runs: int, surfaces: list[pathlib.Path]) -> bool:
    """Whether the bug was found."""
    file = folder / "source" / mutant.file
    right = file.read_text(encoding="utf-8")
    file.write_text(right.replace(mutant.right, mutant.wrong), encoding="utf-8")
    build(folder)
    start = time.monotonic()
    kind = attack_of(mutant)
    found, said = attack(folder, kind, runs, surfaces)
    print(f"{'found' if found else 'NOT FOUND'} by the attack on {kind} in {time.monotonic() - start:.1f} s: {mutant.name}: {said}",
          flush=True)
    if mutant.tests:
        failed, said = unit_tests(folder, mutant.tests)
        print(f"    {said}", flush=True)
        found = found or failed
    file.write_text(right, encoding="utf-8")
    return found


def main() -> int:
    """Lists or tries them."""
    parser = argparse.ArgumentParser(prog="mutants.py", description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=pathlib.Path)
    parser.add_argument("surfaces", nargs="*", type=pathlib.Path)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--only", default="", help="a regular expression that their names contain")
    parser.add_argument("--runs", type=int, default=4000)
    arguments = parser.parse_intermixed_args()  # options may be between the folder and the surfaces
    chosen = [mutant for mutant in MUTANTS if re.search(arguments.only, mutant.name)]
    if arguments.list or arguments.folder is None or problems():
        print(*(problems() or [f"{mutant.name}: {mutant.file}" for mutant in chosen]), sep="\n")
        return 1 if problems() else 0
    copy_source(arguments.folder)
    configure(arguments.folder)
    build(arguments.folder)
    kinds = sorted({attack_of(mutant) for mutant in chosen})
    rights = [attack(arguments.folder, kind, arguments.runs, arguments.surfaces) for kind in kinds]
    print("without a bug:", *(said for _, said in rights), sep="\n", flush=True)
    results = [try_mutant(mutant, arguments.folder, arguments.runs, arguments.surfaces) for mutant in chosen]
    print(f"{sum(results)} of {len(results)} found")
    return 1 if any(broken for broken, _ in rights) or not all(results) else 0


if __name__ == "__main__":
    sys.exit(main())
