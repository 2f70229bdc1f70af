# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the example of Documentation/tutorials/paraview.md on a surface named Contour1."""

import os
import pathlib
import sys
import unittest

from paraview import simple

import specimens
import surfaces

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "Testing" / "Readme"))
from code_blocks import block  # noqa: E402


class Example(unittest.TestCase):
    def test_example_decimates_the_contour_with_a_proved_error(self):
        contour = surfaces.source(specimens.torus(60, 40))
        simple.RenameSource("Contour1", contour)
        names = {}
        text = block(PROJECT / "Documentation" / "tutorials" / "paraview.md", "First bone", "python").replace('"BoneDecimate.so"', repr(os.environ["PLUGIN"]))
        exec(compile(text, "paraview.md", "exec"), names)
        report = surfaces.report(names["bone"])
        self.assertLess(report["bonedecimate.output.triangles"], report["bonedecimate.input.triangles"])
        self.assertLessEqual(report["bonedecimate.proof.if_unchanged.upper"], 0.3)


if __name__ == "__main__":
    unittest.main()
