# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package is imported like any other, whatever was imported before."""

import subprocess
import sys
import unittest


def run(program):
    """Runs a program in an interpreter of its own, since a module is loaded only once."""
    return subprocess.run([sys.executable, "-B", "-c", program], capture_output=True, text=True, check=False)


class Import(unittest.TestCase):
    def assert_runs(self, program):
        answer = run(program)
        self.assertEqual((answer.returncode, answer.stderr), (0, ""))

    def test_without_vtk_before(self):
        self.assert_runs("from vtkbonedecimate import vtkBoneDecimate; vtkBoneDecimate().GetTargetReduction()")

    def test_after_vtk(self):
        self.assert_runs("import vtk; from vtkbonedecimate import vtkBoneDecimate; vtkBoneDecimate()")

    def test_before_vtk(self):
        self.assert_runs(
            "from vtkbonedecimate import vtkBoneDecimate; import vtk;"
            "assert isinstance(vtkBoneDecimate(), vtk.vtkPolyDataAlgorithm)"
        )

    def test_of_the_whole_package(self):
        self.assert_runs("import vtkbonedecimate; vtkbonedecimate.vtkBoneDecimate()")

    def test_with_a_star(self):
        self.assert_runs("from vtkbonedecimate import *; vtkBoneDecimate()")

    def test_does_not_bring_all_of_vtk(self):
        self.assert_runs("import sys, vtkbonedecimate; assert 'vtkmodules.vtkRenderingCore' not in sys.modules")

    def test_knows_its_superclass(self):
        self.assert_runs(
            "from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm;"
            "from vtkbonedecimate import vtkBoneDecimate;"
            "assert isinstance(vtkBoneDecimate(), vtkPolyDataAlgorithm);"
            "assert vtkBoneDecimate().IsA('vtkPolyDataAlgorithm')"
        )


if __name__ == "__main__":
    unittest.main()
