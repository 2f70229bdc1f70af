# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the README and examples of other pages as printed and compares the documentation with the program."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter

from code_blocks import Runner, block, blocks_of

SOURCE = pathlib.Path(os.environ["SOURCE_DIR"])
PAGES = SOURCE / "Documentation"
README = SOURCE / "README.md"
sys.path.append(str(SOURCE / "Utilities" / "site"))
import gallery  # noqa: E402
PROGRAM = os.environ["PROGRAM"]
PHANTOM = os.environ["PHANTOM"]
PATH = os.pathsep.join([str(pathlib.Path(PROGRAM).parent), os.environ["PATH"]])
FIRST, TWO = "# vtkBoneDecimate", "Two commands on Debian 12"


def run(*words, **keywords):
    done = subprocess.run(words, capture_output=True, text=True, **keywords)
    assert done.returncode == 0, f"{words}:\n{done.stdout}\n{done.stderr}"
    return done.stdout


class Readme(unittest.TestCase):
    def test_every_block_is_run(self):
        self.assertEqual([found[:2] for found in blocks_of(README)], [(FIRST, "sh"), (FIRST, "text"), (TWO, "sh")])

    def test_first_command_prints_what_the_page_says(self):
        with tempfile.TemporaryDirectory() as name:
            runner = Runner(pathlib.Path(name), PATH=PATH)
            runner.run("sh", block(README, FIRST, "sh"))
            self.assertEqual(runner.run("text", block(README, FIRST, "text")), [])

    def test_two_commands_are_there(self):
        for line in block(README, TWO, "sh").splitlines():
            self.assertTrue(os.access(SOURCE / line.split()[0], os.X_OK), line)

    def test_commands_run_as_printed(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.write_sphere(folder / "skull.stl", 40.0, 160, 80)
            (folder / "bones").mkdir()
            for bone in ("left.stl", "right.stl"):
                self.write_sphere(folder / "bones" / bone, 20.0, 60, 30)
            run(PHANTOM, str(folder / "ct.mha"), "--size", "small")
            run(PHANTOM, str(folder / "labels.mha"), "--size", "small", "--labels")
            run("sh", "-e", "-c", block(PAGES / "reference" / "command-line.md", "Commands", "sh"), cwd=name, env={**os.environ, "PATH": PATH})
            report = json.loads((folder / "small.json").read_text(encoding="utf-8"))
            self.assertEqual(report["output"]["triangles"], 20000)
            for file in ("small.vtp", "small.html", "small.stl", "part.stl", "bone.vtp", "segments/label_3.vtp", "small/left.stl", "small/right.stl", "closed.stl"):
                self.assertTrue((folder / file).is_file(), file)

    def test_commands_of_the_gallery_are_those_of_its_script_and_accepted(self):
        commands = [line.split()[1:] for _, _, text in blocks_of(PAGES / "how-to" / "gallery.md") for line in text.splitlines()]
        self.assertGreater(len(commands), 5)
        drawn = [set(panel.words.split()) - {"{}.vtp", "{}/", "--format", "vtp"} for picture in gallery.PICTURES.values() for panel in picture.panels]
        for words in commands:
            self.assertIn(set(words) - {"bone.vtp", "bones/"}, drawn)
        with tempfile.TemporaryDirectory() as name:
            for file, words in (("ct.mha", ["--size", "small"]), ("labels.mha", ["--size", "small", "--labels"]), ("trabeculae.mha", ["--trabeculae", "16"])):
                run(PHANTOM, file, *words, cwd=name)
            for words in commands:
                self.assertIn("ends at", run(PROGRAM, *words, "--explain", cwd=name), words)

    def test_python_program_runs_as_printed(self):
        printed = run(sys.executable, "-c", block(PAGES / "how-to" / "python.md", "VTK", "python"))
        self.assertIn("2000 triangles", printed)
        self.assertLess(float(printed.splitlines()[1].split()[0]), 1.0)

    @staticmethod
    def write_sphere(path, radius=0.5, theta=28, phi=16):
        sphere = vtkSphereSource()
        sphere.SetRadius(radius)
        sphere.SetThetaResolution(theta)
        sphere.SetPhiResolution(phi)
        writer = vtkSTLWriter()
        writer.SetFileTypeToBinary()
        writer.SetInputConnection(sphere.GetOutputPort())
        writer.SetFileName(str(path))
        writer.Write()

    def test_documented_options_are_the_programs(self):
        documented = (PAGES / "reference" / "options.md").read_text(encoding="utf-8")
        self.assertIn(run(PROGRAM, "--options-markdown").strip(), documented)


if __name__ == "__main__":
    unittest.main()
