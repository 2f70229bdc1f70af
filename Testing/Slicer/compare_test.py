# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripted module compares two models through the program, and installs its Python package; nodes and Slicer are stand-ins.

Needs VTK, but no Slicer. The program is that of BONEDECIMATE_PROGRAM.
"""

import importlib
import os
import pathlib
import re
import subprocess
import sys
import types
import unittest
from unittest.mock import MagicMock, patch

import numpy as np
import vtk

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Applications" / "Slicer" / "BoneDecimator"))
from BoneDecimatorLib.checks import DecimationError  # noqa: E402
from BoneDecimatorLib.comparison import Comparison, bounds_text, comparison_lines  # noqa: E402
from BoneDecimatorLib.engines import PACKAGE_VERSION, ProgramEngine, WheelEngine  # noqa: E402
from BoneDecimatorLib.logic import BoneDecimatorLogic  # noqa: E402
from BoneDecimatorLib.surfaces import DISTANCE  # noqa: E402

PROGRAM = ProgramEngine(os.environ["BONEDECIMATE_PROGRAM"])


class Node:
    """A model node of a scene."""

    def __init__(self, surface, transform=None):
        self.surface, self.transform = surface, transform

    def IsA(self, name):  # noqa: N802
        return name == "vtkMRMLModelNode"

    def GetPolyData(self):  # noqa: N802
        return self.surface

    def SetAndObservePolyData(self, surface):  # noqa: N802
        self.surface = surface

    def GetTransformNodeID(self):  # noqa: N802
        return self.transform


def square(height):
    """Of 10 mm, at a height."""
    source = vtk.vtkPlaneSource()
    source.SetOrigin(0, 0, height)
    source.SetPoint1(10, 0, height)
    source.SetPoint2(0, 10, height)
    source.Update()
    return source.GetOutput()


def box():
    source = vtk.vtkCubeSource()
    source.Update()
    return source.GetOutput()


class Comparisons(unittest.TestCase):
    def setUp(self):
        self.logic = BoneDecimatorLogic(None, PROGRAM)

    def compare(self, reference, result, tolerance=None):
        return self.logic.compare(Node(reference), Node(result), tolerance)[1]

    def test_have_proved_bounds_means_and_the_status_of_a_tolerance(self):
        for tolerance, status in ((0.8, "proved"), (0.7, "violated")):
            lines = self.compare(square(0.0), square(0.75), tolerance)
            lower, upper = (float(bound) for bound in re.search(r": ([\d.]+) to ([\d.]+) mm$", lines[0]).groups())
            self.assertTrue(lower <= 0.75 <= upper <= 0.7502, lines[0])
            self.assertEqual(lines[1], f"tolerance of {tolerance:g} mm: {status}")
            self.assertIn("mean 0.7500 mm", lines[2])
            self.assertTrue(lines[4].startswith("open boundaries, reference to result"), lines)
        self.assertFalse(any("tolerance" in line for line in self.compare(square(0.0), square(0.75))))

    def test_name_the_surface_that_alone_has_boundaries(self):
        lines = self.compare(box(), square(0.0))
        self.assertEqual(lines[-1], "only the result has open boundaries")
        self.assertEqual(len(lines), 4)

    def test_have_bounds_that_are_rounded_outwards(self):
        self.assertEqual(bounds_text({"lower": 0.12345, "upper": 0.12341}), "0.1234 to 0.1235 mm")
        self.assertEqual(bounds_text({"lower": 0.1, "upper": None}), "not known")

    def test_give_both_models_the_distances_that_the_engine_measures(self):
        engine = MagicMock()
        report = {"lower": 0.5, "upper": 0.5, "boundaries": "neither", "status": "not_requested"}
        engine.compare.return_value = Comparison(report, (np.full(4, 0.5), np.full(8, 0.25)))
        reference, result = Node(square(0.0)), Node(box())
        result.surface.GetPoints().SetNumberOfPoints(8)
        nodes, _lines = BoneDecimatorLogic(None, engine).compare(reference, result)
        self.assertEqual(nodes, [reference, result])
        for node, distance in ((reference, 0.5), (result, 0.25)):
            self.assertEqual(node.surface.GetPointData().GetArray(DISTANCE).GetTuple1(0), distance)

    def test_of_what_cannot_be_compared_are_rejected_with_a_sentence(self):
        one = Node(box())
        for reference, result, tolerance, says in ((None, one, None, "Choose a model"), (one, one, None, "two models"),
                                                   (Node(box(), "turned"), one, None, "different transforms"),
                                                   (Node(vtk.vtkPolyData()), one, None, "no surface"),
                                                   (Node(box()), one, -1.0, "^The tolerance takes a number")):
            with self.assertRaisesRegex(DecimationError, says):
                self.logic.compare(reference, result, tolerance)

    def test_lines_say_what_was_not_compared(self):
        report = {"lower": 0.0, "upper": 0.0, "boundaries": "neither", "left_out": [{"sentence": "2 lines"}]}
        self.assertEqual(comparison_lines(report)[-1], "not compared: 2 lines")


class Package(unittest.TestCase):
    """The section that installs it."""

    def setUp(self):
        self.slicer, self.qt = MagicMock(), MagicMock()
        self.modules = {"slicer": types.ModuleType("slicer"), "qt": self.qt}
        self.modules["slicer"].util, self.modules["slicer"].app = self.slicer.util, self.slicer.app
        self.addCleanup(sys.modules.pop, "BoneDecimatorLib.package_widgets", None)

    def press(self, action, **modules):
        """@return The section, and the errors."""
        errors = []

        def attempt(work):
            try:
                work()
            except DecimationError as problem:
                errors.append(str(problem))

        with patch.dict(sys.modules, {**self.modules, **modules}):
            sys.modules.pop("BoneDecimatorLib.package_widgets", None)
            module = importlib.import_module("BoneDecimatorLib.package_widgets")
            self.installed = MagicMock()
            section = module.PackageWidgets(MagicMock(), attempt, self.installed)
            attempt(lambda: getattr(section, action)())
        return section, errors

    def test_version_is_that_of_the_project(self):
        project = re.search(r"project\(vtkBoneDecimate VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
        self.assertEqual(PACKAGE_VERSION, project)

    def test_new_versions_of_slicer_show_the_progress_themselves(self):
        packaging = types.ModuleType("slicer.packaging")
        packaging.pip_install = MagicMock()
        _, errors = self.press("on_install", **{"slicer.packaging": packaging})
        packaging.pip_install.assert_called_once_with([f"bonedecimate=={PACKAGE_VERSION}"], requester="Bone Decimator")
        self.slicer.util.pip_install.assert_not_called()
        self.installed.assert_called_once_with()
        self.assertEqual(errors, [])

    def test_older_ones_get_a_dialog_that_is_closed_in_any_case(self):
        for problem in (None, subprocess.CalledProcessError(1, "pip")):
            self.slicer.reset_mock()
            self.slicer.util.pip_install.side_effect = problem
            _, errors = self.press("on_install")
            self.slicer.util.pip_install.assert_called_once_with([f"bonedecimate=={PACKAGE_VERSION}"])
            self.slicer.util.createProgressDialog.return_value.close.assert_called_once_with()
            self.assertEqual(len(errors), 0 if problem is None else 1)
            self.assertEqual(self.installed.called, problem is None)
        self.assertIn("'Install from a file'", errors[0])

    def test_a_file_is_installed_without_a_network(self):
        self.qt.QFileDialog.getOpenFileName.return_value = "/my wheels/bonedecimate.whl"
        self.press("on_file")
        self.slicer.util.pip_install.assert_called_once_with(["/my wheels/bonedecimate.whl"])
        self.slicer.reset_mock()
        self.qt.QFileDialog.getOpenFileName.return_value = ""
        self.press("on_file")
        self.slicer.util.pip_install.assert_not_called()

    def test_the_section_says_what_works(self):
        section, _ = self.press("expand")
        section.tell(None)
        self.assertIn("Nothing works yet", section.text.text)
        section.tell(PROGRAM)
        self.assertIn("Segments, levels of detail", section.text.text)
        with patch("importlib.metadata.version", return_value="0.0.9"):
            section.tell(WheelEngine())
        self.assertIn("made for version " + PACKAGE_VERSION, section.text.text)
        with patch("importlib.metadata.version", return_value=PACKAGE_VERSION):
            section.tell(WheelEngine())
        self.assertTrue(section.text.text.endswith("everything works."))


if __name__ == "__main__":
    unittest.main()
