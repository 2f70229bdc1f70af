# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the README's programs as printed and compares the documentation with the program."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

SOURCE = pathlib.Path(os.environ["SOURCE_DIR"])
BINARY = os.environ["BINARY_DIR"]
PROGRAM = os.environ["PROGRAM"]


def block(language):
    """The README's first block in that language."""
    text = (SOURCE / "README.md").read_text(encoding="utf-8")
    return re.search(rf"```{language}\n(.*?)```", text, re.DOTALL).group(1)


def run(*words, **keywords):
    done = subprocess.run(words, capture_output=True, text=True, **keywords)
    assert done.returncode == 0, f"{words}:\n{done.stdout}\n{done.stderr}"
    return done.stdout


class Readme(unittest.TestCase):
    def test_python_program_runs_as_printed(self):
        printed = run(sys.executable, "-c", block("python"))
        self.assertIn("2000 triangles", printed)
        self.assertLess(float(printed.splitlines()[1].split()[0]), 1.0)

    def test_cpp_program_builds_against_the_installed_package_and_runs(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            run("cmake", "--install", BINARY, "--prefix", str(folder / "prefix"))
            (folder / "shrink.cxx").write_text(block("cpp"), encoding="utf-8")
            (folder / "CMakeLists.txt").write_text(block("cmake"), encoding="utf-8")
            run("cmake", "-G", "Ninja", "-S", name, "-B", str(folder / "build"),
                f"-DCMAKE_PREFIX_PATH={folder / 'prefix'}")
            run("cmake", "--build", str(folder / "build"))
            self.write_sphere(folder / "in.stl")
            run(str(folder / "build" / "shrink"), str(folder / "in.stl"), str(folder / "out.vtp"))
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(str(folder / "out.vtp"))
            reader.Update()
            self.assertEqual(reader.GetOutput().GetNumberOfPolys(), 784 * 0.2 // 2 * 2)

    @staticmethod
    def write_sphere(path):
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(28)
        sphere.SetPhiResolution(16)
        writer = vtkSTLWriter()
        writer.SetInputConnection(sphere.GetOutputPort())
        writer.SetFileName(str(path))
        writer.Write()

    def test_documented_options_are_the_programs(self):
        documented = (SOURCE / "Documentation" / "options.md").read_text(encoding="utf-8")
        self.assertIn(run(PROGRAM, "--options-markdown").strip(), documented)


if __name__ == "__main__":
    unittest.main()
