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
        completed = run(program)
        self.assertEqual((completed.returncode, completed.stderr), (0, ""))

    def test_without_vtk_before(self):
        self.assert_runs("from bonedecimate import vtkBoneDecimate; vtkBoneDecimate().GetTargetReduction()")

    def test_after_vtk(self):
        self.assert_runs("import vtk; from bonedecimate import vtkBoneDecimate; vtkBoneDecimate()")

    def test_before_vtk(self):
        self.assert_runs(
            "from bonedecimate import vtkBoneDecimate; import vtk;"
            "assert isinstance(vtkBoneDecimate(), vtk.vtkPolyDataAlgorithm)"
        )

    def test_of_the_whole_package(self):
        self.assert_runs("import bonedecimate; bonedecimate.vtkBoneDecimate()")

    def test_with_a_star(self):
        self.assert_runs("from bonedecimate import *; vtkBoneDecimate()")

    def test_does_not_bring_all_of_vtk(self):
        self.assert_runs("import sys, bonedecimate; assert 'vtkmodules.vtkRenderingCore' not in sys.modules")

    def test_of_the_module_behind_it_gives_the_same_classes(self):
        self.assert_runs("from bonedecimate.vtkFiltersBoneDecimate import vtkBoneDecimate; import bonedecimate;"
                         "assert vtkBoneDecimate is bonedecimate.vtkBoneDecimate")

    def test_of_names_of_the_wheel_says_so(self):
        for code in ("import bonedecimate; bonedecimate.decimate", "from bonedecimate import decimate"):
            self.assertRegex(run(code).stderr, "ImportError: bonedecimate.decimate is in the wheel, .* install one of them")

    def test_knows_its_superclass(self):
        self.assert_runs(
            "from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm;"
            "from bonedecimate import vtkBoneDecimate;"
            "assert isinstance(vtkBoneDecimate(), vtkPolyDataAlgorithm);"
            "assert vtkBoneDecimate().IsA('vtkPolyDataAlgorithm')"
        )


if __name__ == "__main__":
    unittest.main()
