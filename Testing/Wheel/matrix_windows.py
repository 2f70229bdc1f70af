#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel for Windows with each Python for Windows, in Wine: every test of this folder, with VTK, PyVista and numpy from PyPI, and
results compared with the bytes of the C++ filter of this system. Utilities/check_windows.sh --wheel calls it; not part of the tests.

    xvfb-run -a -s -noreset Testing/Wheel/matrix_windows.py [--build BUILD] [VERSION...]

WINEPREFIX is the folder of Wine. The wheels are in build/windows-python/wheels afterwards.
"""

import argparse
import os
import pathlib
import shutil
import sys

import matrix
from matrix import HERE, ROOT, needed

UTILITIES = ROOT / "Utilities"
PYTHON = UTILITIES / "windows" / "python"  # runs that of WINDOWS_PYTHON
FOLDER = ROOT / "build" / "windows-python"
VERSIONS = """import platform
from importlib.metadata import version
print(f"Python {platform.python_version()}, VTK {version('vtk')}, PyVista {version('pyvista')}, numpy {version('numpy')}")"""
OTHERS = ["highdicom", "meshio", "nibabel", "pydicom", "pynrrd", "SimpleITK", "tifffile", "trimesh"]  # for tests alone


def build_wheel(version):
    """One for each Python, but one for all from 3.12 on."""
    folder = FOLDER / "wheels" / min(version, "3.12")
    if not folder.exists():
        needed(UTILITIES / "build_wheel.sh", "--windows", folder, PYTHON=sys.executable)
    (wheel,) = folder.glob("*.whl")
    print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB", flush=True)
    return wheel


def install(wheel, version, pip):
    """Downloaded here, installed by pip for Windows into that Python. Returns the versions."""
    wanted = [f"{wheel}[pyvista,progress]", *OTHERS]
    downloads = FOLDER / "downloads" / version
    # pip downloads what the packages require on this system; on Windows tqdm requires colorama, too.
    needed(pip, "-q", "download", "--disable-pip-version-check", "--platform", "win_amd64", "--only-binary", ":all:",
           "--python-version", version, "-d", downloads, *wanted, "colorama")
    offline = [PYTHON, "-m", "pip", "-q", "install", "--disable-pip-version-check", "--no-warn-script-location", "--no-index",
               "--find-links", downloads]
    needed(*offline, *wanted)
    needed(*offline, "--force-reinstall", "--no-deps", wheel)  # also where the same version was there
    shutil.rmtree(downloads)
    return needed(PYTHON, "-c", VERSIONS).strip()


def check(version, reference, pip):
    os.environ["WINDOWS_PYTHON"] = needed(UTILITIES / "windows" / "fetch_python.py", version).strip()
    packages = install(build_wheel(version), version, pip)
    (tests, skipped, same), wrong = matrix.run_tests(PYTHON, reference)
    print(f"{packages}: {tests - skipped} tests, {skipped} skipped, {same} runs as those of the C++ filter{wrong}", flush=True)
    return not wrong and same > 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="of the C++ filter, wrapped for /usr/bin/python3")
    parser.add_argument("versions", metavar="VERSION", nargs="*", default=["3.11", "3.13"], help="3.11, 3.12, ...")
    options = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(FOLDER / "wheels", ignore_errors=True)
    matrix.write_reference(options.build, "/usr/bin/python3", FOLDER / "reference.json")
    needed(sys.executable, "-m", "venv", FOLDER / "tools")
    pip = FOLDER / "tools" / "bin" / "pip"
    return 0 if all([check(version, FOLDER / "reference.json", pip) for version in options.versions]) else 1


if __name__ == "__main__":
    sys.exit(main())
