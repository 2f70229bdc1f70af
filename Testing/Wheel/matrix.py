#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The portable wheel with each Python and each VTK: a fresh environment from PyPI, the tests of this folder in it,
results compared with the bytes of the C++ filter. Prints a table for Documentation/results/systems.md; not part of the tests.

    xvfb-run -a Testing/Wheel/matrix.py [--build BUILD | --reference FILE] [--wheels FOLDER] [--vtk 9.2,9.4,...] [--tests NAME,...] PYTHON...

A PYTHON needs its headers, as those of pyenv or uv have; the C++ filter is that of BUILD. Old VTKs draw only where
there is a screen, any will do. A field of the table takes a download of 200 MB and a minute of the processor.
"""

import argparse
import concurrent.futures
import itertools
import os
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
NO_WHEEL = "no wheel of VTK"


def run(*words, **surroundings):
    return subprocess.run([str(word) for word in words], env={**os.environ, **surroundings}, check=False, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def needed(*words, **surroundings):
    done = run(*words, **surroundings)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}:\n{done.stdout}")
    return done.stdout


def version_of(python):
    return needed(python, "-c", "import platform; print(platform.python_version())").strip()


def minor_of(python):
    return tuple(int(part) for part in version_of(python).split(".")[:2])


def write_reference(build, python, path):
    (package,) = build.glob("lib*/**/python3*/dist-packages")
    needed(python, "-B", HERE / "write_reference.py", path, PYTHONPATH=str(package))


def build_wheels(pythons, folder):
    """One for each Python, but one for all from 3.12 on."""
    shutil.rmtree(folder, ignore_errors=True)
    builders = {min(minor_of(python), (3, 12)): python for python in sorted(pythons, key=minor_of, reverse=True)}
    for python in builders.values():
        needed(ROOT / "Utilities" / "build_wheel.sh", "--portable", folder, PYTHON=python)
    for wheel in sorted(folder.glob("*.whl")):
        print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB", flush=True)


def make_environment(python, vtk, wheels, folder):
    """What pip installed of what matters, or None where there is no such VTK for this Python."""
    shutil.rmtree(folder, ignore_errors=True)
    needed(python, "-m", "venv", folder)
    pip = [folder / "bin" / "python", "-m", "pip", "-q", "--disable-pip-version-check"]
    needed(*pip, "install", "--no-index", "--no-deps", "--find-links", wheels, "bonedecimate")
    installed = run(*pip, "install", "--only-binary", ":all:", f"vtk=={vtk}.*", "bonedecimate[pyvista,progress]")
    if "No matching distribution found for vtk" in installed.stdout:
        return None
    if installed.returncode != 0:
        return installed.stdout
    listed = dict(line.split("==") for line in needed(*pip, "freeze").splitlines() if "==" in line)
    return {name: listed[name] for name in ("vtk", "pyvista", "numpy")}


def run_tests(python, reference, names=("*",)):
    """Tests run, tests skipped, runs that were as those of the C++ filter; what went wrong. Of the files NAME_test.py."""
    numbers, wrong = [0, 0, 0], ""
    for file in sorted(path for name in names for path in HERE.glob(f"{name}_test.py")):
        done = run(python, "-B", file, SOURCE_DIR=str(ROOT), REFERENCE=str(reference))
        for i, pattern in enumerate((r"Ran (\d+) test", r"skipped=(\d+)", r"(\d+) runs as those of the C\+\+")):
            numbers[i] += sum(map(int, re.findall(pattern, done.stdout)))
        if done.returncode != 0:
            wrong += f"\n{file.name}:\n{done.stdout}"
    return numbers, wrong


def field(python, vtk, options, folder):
    """What the table says of this Python with this VTK, and whether that is good."""
    environment = make_environment(python, vtk, options.wheels, folder)
    if environment is None:
        return NO_WHEEL, True
    if isinstance(environment, str):
        print(environment, flush=True)
        return "**not installed**", False
    (tests, skipped, same), wrong = run_tests(folder / "bin" / "python", options.reference, options.tests)
    shutil.rmtree(folder)
    found = f"{tests - skipped} tests, {same} runs" + (f", {skipped} skipped" if skipped else "")
    with_what = ", ".join(f"{name} {version}" for name, version in environment.items())
    print(f"Python {version_of(python)}, {with_what}: {found}{', FAILED' if wrong else ''}{wrong}", flush=True)
    return ("**failed**: " if wrong else "") + found, not wrong


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="of the C++ filter")
    parser.add_argument("--build-python", default="/usr/bin/python3", help="the Python that BUILD was wrapped for")
    parser.add_argument("--reference", type=pathlib.Path, help="already written by write_reference.py; else it is, with BUILD")
    parser.add_argument("--wheels", type=pathlib.Path, help="already built; else they are, into BUILD/matrix/wheels")
    parser.add_argument("--vtk", type=lambda text: text.split(","), default=["9.2", "9.4", "9.6", "9.7"])
    parser.add_argument("--tests", type=lambda text: text.split(","), default=["*"], help="names of files, without _test.py; default: all")
    parser.add_argument("pythons", metavar="PYTHON", nargs="+")
    return parser.parse_args()


def main():
    options = parse_arguments()
    folder = options.build.resolve() / "matrix"
    folder.mkdir(exist_ok=True)
    if options.reference is None:
        options.reference = folder / "reference.json"
        write_reference(options.build.resolve(), options.build_python, options.reference)
    if options.wheels is None:
        options.wheels = folder / "wheels"
        build_wheels(options.pythons, options.wheels)
    environments = list(itertools.product(options.pythons, options.vtk))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:  # one downloads while the other computes
        found = list(pool.map(lambda at: field(*at, options, folder / f"environment-{environments.index(at)}"), environments))
    fields = {at: text for at, (text, _) in zip(environments, found)}
    rows = [[version_of(python), *(fields[python, vtk] for vtk in options.vtk)] for python in options.pythons]
    for row in (["Python", *(f"VTK {vtk}" for vtk in options.vtk)], ["---"] * (len(options.vtk) + 1), *rows):
        print(f"| {' | '.join(row)} |")
    return 0 if all(good for _, good in found) else 1


if __name__ == "__main__":
    sys.exit(main())
