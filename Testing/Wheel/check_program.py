#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The program of a portable wheel, installed where nothing of this system is seen, against the program that is linked with Debian's libraries.

    check_program.py WHEEL [PROGRAM]      PROGRAM by default build/release/bin/bonedecimate, beside bonedecimate-phantom; needs python3-vtk9

Runs all commands of Documentation/reference/command-line.md with both and compares the surfaces they write: the same points and triangles, bit for bit.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import time

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "Testing" / "Readme"))
from code_blocks import block  # noqa: E402

LARGEST_WHEEL = 25e6  # bytes
OF_SYSTEM = re.compile(r"linux-vdso|lib(c|m|dl|rt|pthread)\.so|/ld-linux")


def run(*words, path="/usr/bin:/bin", folder=None):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, cwd=folder,
                          env={"PATH": str(path), "HOME": str(folder or "/")})
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))} failed ({done.returncode}):\n{done.stdout}{done.stderr}")
    return done.stdout


def install(wheel, folder):
    """The folder of the environment's programs."""
    subprocess.run([sys.executable, "-m", "venv", folder], check=True)
    begin = time.monotonic()
    subprocess.run([folder / "bin" / "pip", "-q", "install", "--disable-pip-version-check", wheel], check=True)
    installed = time.monotonic()
    print(run("bonedecimate", "demo", path=folder / "bin", folder=folder), end="")
    print(f"{wheel.stat().st_size / 1e6:.1f} MB; pip install {installed - begin:.1f} s, demo {time.monotonic() - installed:.1f} s")
    return folder / "bin"


def write_inputs(programs, folder):
    """Those that the page's commands name."""
    folder.mkdir()
    run(programs / "bonedecimate-phantom", "ct.mha", "--size", "small", folder=folder)
    run(programs / "bonedecimate-phantom", "labels.mha", "--size", "small", "--labels", folder=folder)
    run(programs / "bonedecimate", "ct.mha", "skull.stl", "--iso", "226", "--target-reduction", "0.2", folder=folder)
    run(programs / "bonedecimate", "labels.mha", "bones", "--segments", "all", "--format", "stl", "--target-reduction", "0", folder=folder)


def contents(file):
    """What two files of the same surface have in common: a VTP has the seconds of its run."""
    if file.suffix != ".vtp":
        return [file.read_bytes()]
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    surface = reader.GetOutput()
    return [vtk_to_numpy(array).tobytes() for array in (surface.GetPoints().GetData(), surface.GetPolys().GetConnectivityArray())]


def surfaces(folder):
    return {str(file.relative_to(folder)): contents(file) for file in folder.rglob("*") if file.suffix in (".stl", ".vtp")}


def problems(wheel, program):
    if wheel.stat().st_size > LARGEST_WHEEL:
        yield f"{wheel.name} is larger than {LARGEST_WHEEL / 1e6:.0f} MB"
    commands = block(ROOT / "Documentation" / "reference" / "command-line.md", "Commands", "sh")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scripts = install(wheel, folder / "environment")
        needed = run("ldd", scripts / "bonedecimate").splitlines()
        yield from (f"the program needs{line}" for line in needed if not OF_SYSTEM.search(line))
        if "(Python wheel)" not in run("bonedecimate", "--version", path=scripts):
            yield "--version does not say that this is the program of the wheel"
        found = {}
        for kind, programs in (("wheel", scripts), ("Debian", program.parent)):
            write_inputs(program.parent, folder / kind)
            run("sh", "-e", "-c", commands, path=f"{programs}:/usr/bin:/bin", folder=folder / kind)
            found[kind] = surfaces(folder / kind)
        if '<section class="viewer">' not in (folder / "wheel" / "small.html").read_text(encoding="utf-8"):
            yield "the page has no interactive view"
    for file in sorted(found["wheel"].keys() | found["Debian"].keys()):
        if found["wheel"].get(file) != found["Debian"].get(file):
            yield f"{file} differs"
    print(f"{len(found['Debian'])} surfaces compared")


def main(wheel, program=ROOT / "build" / "release" / "bin" / "bonedecimate"):
    wrong = list(problems(pathlib.Path(wheel).resolve(), pathlib.Path(program).resolve()))
    print("\n".join(wrong) or "the same bytes")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
