# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The panel's code on a scene, with widgets that only remember their values.

Needs the wheels slicer-core and bonedecimate; run.sh installs them and calls this.
"""

import os
import pathlib
import sys
import time
import types
import unittest
from unittest.mock import MagicMock, patch

sys.path[:0] = [os.environ["SLICER_MODULE"], str(pathlib.Path(__file__).resolve().parents[1] / "Support")]
from option_rows import another_value, case_of  # noqa: E402
from segmentation_test import halves, scene_with  # noqa: E402


class Toolkit(types.ModuleType):
    """A module whose classes make a new widget at each call."""

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        made = MagicMock(side_effect=lambda *_arguments, **_keywords: MagicMock())
        setattr(self, name, made)
        return made


def panel_module():
    """BoneDecimator.py with such widgets."""
    for name in ("qt", "ctk", "slicer"):
        sys.modules[name] = Toolkit(name)
    base = types.ModuleType("slicer.ScriptedLoadableModule")
    base.ScriptedLoadableModule = base.ScriptedLoadableModuleTest = object
    base.ScriptedLoadableModuleWidget = type("Widget", (), {"setup": lambda self: setattr(self, "layout", MagicMock())})
    sys.modules["slicer.ScriptedLoadableModule"] = base
    import BoneDecimator
    return BoneDecimator


MODULE = panel_module()
from BoneDecimatorLib.option_table import value_of  # noqa: E402
from BoneDecimatorLib.option_widgets import SIGNALS, VALUES  # noqa: E402


class Panel(unittest.TestCase):
    def setUp(self):
        self.scene, self.node, self.ids = scene_with(**halves())
        MODULE.slicer.mrmlScene = self.scene
        MODULE.slicer.util = MagicMock()
        MODULE.slicer.util.errorDisplay.side_effect = self.fail
        MODULE.slicer.util.createProgressDialog.return_value.wasCanceled = False
        self.panel = MODULE.BoneDecimatorWidget()
        self.panel.setup()
        for name, value in (("source", self.node), ("volume", None), ("target", None), ("brush", None)):
            getattr(self.panel, name).currentNode.return_value = value
        self.panel.segments.selectedSegmentIDs.return_value = ()
        for name, value in (("tolerance", 0.2), ("triangles", 0), ("ownSmoothing", 0.15), ("featureAngle", 180.0), ("radius", 10.0),
                            ("feather", 2.0)):
            getattr(self.panel, name).value = value
        for name, text in (("smoothing", "none"), ("modelGrid", "auto"), ("kind", MODULE.MODELS), ("where", MODULE.EVERYWHERE), ("caps", MODULE.CAPS[0])):
            getattr(self.panel, name).currentText = text
        self.panel._onChange()

    def press(self, action):
        self.panel._try(action)

    def test_segments_become_models_and_are_undone(self):
        self.press(self.panel._onSimplify)
        self.assertEqual([node.GetName() for node in self.panel.results], ["left", "right"])
        self.assertIn("proved", self.panel.text.text)
        self.press(self.panel._onHeatMap)
        self.assertTrue(self.panel.results[1].GetDisplayNode().GetScalarVisibility())
        self.press(self.panel._onToggle)
        self.assertFalse(self.panel.results[1].GetDisplayNode().GetVisibility())
        self.press(self.panel._onUndo)
        self.assertEqual(self.panel.results, [])

    def test_selected_segments_become_closed_surfaces(self):
        self.panel.kind.currentText = MODULE.CLOSED_SURFACES
        self.panel.segments.selectedSegmentIDs.return_value = (self.ids["left"],)
        self.press(self.panel._onSimplify)
        self.assertEqual(self.panel.results, [])
        self.assertTrue(self.node.GetSegmentation().ContainsRepresentation("Closed surface"))

    def test_presets_take_the_voxels_of_the_segmentation(self):
        self.press(lambda: self.panel._onPreset("half a voxel"))
        self.assertAlmostEqual(self.panel.tolerance.value, 0.25)
        for text, wanted in (("none", 0.0), ("automatic", "automatic"), ("one voxel", 0.5), ("own distance", 0.15)):
            self.panel.smoothing.currentText = text
            found = self.panel.request().smoothing
            self.assertEqual(found if isinstance(found, str) else round(found, 9), wanted)

    def test_the_grid_of_a_network_is_that_of_the_control_and_for_segments_alone(self):
        self.assertEqual(self.panel.request().model_grid, "auto")
        for text in ("off", "1.5"):
            self.panel.modelGrid.currentText = text
            with patch.object(type(self.panel.logic.engine), "decimate_segments", side_effect=MODULE.DecimationError("seen")) as run:
                MODULE.slicer.util.errorDisplay.side_effect = None
                self.press(self.panel._onSimplify)
            self.assertEqual(run.call_args.args[-1], text)
        for node, is_enabled in ((self.node, True), (None, False)):
            self.panel._onSource(node)
            self.assertEqual(self.panel.modelGrid.enabled, is_enabled)

    def test_eight_controls_come_first_and_all_other_options_in_sections(self):
        first = ["Mode", "Tolerance", "", "Triangles", "Smoothing", "Keep voxels", "Where", "Number of threads"]
        self.assertEqual([call.args[0] for call in self.panel.first.addRow.call_args_list if isinstance(call.args[0], str)], first)
        table = self.panel.table
        self.assertLessEqual({row["group"] for row in table.panel_rows() if row["name"] != "NumberOfThreads"}, set(self.panel.options.SECTIONS))

    def test_the_angle_of_kept_edges_is_requested(self):
        self.panel.featureAngle.value = 45.0
        self.assertEqual(self.panel.request().feature_angle, 45.0)

    def set_option(self, name, text):
        """As a user does, in its widget."""
        row, widget = self.panel.options.of_flag[self.panel.table.rows[name]["flag"]]
        setattr(widget, VALUES[row["kind"]], value_of(row, text))
        self.panel._onChange()
        return widget

    def test_options_of_the_table_have_widgets_that_are_requested_and_reach_the_filter(self):
        self.panel.source.currentNode.return_value = None
        table, engine = self.panel.table, self.panel.logic.engine
        for row in table.panel_rows():
            self.panel.tolerance.value = 0.0
            for name, text in case_of(table.rows, row).items():
                if name == "MaximumError":
                    self.panel.tolerance.value = float(text)
                else:
                    widget = self.set_option(name, text)
            with self.subTest(option=row["name"]):
                self.assertTrue(widget.enabled)
                getattr(widget, SIGNALS[row["kind"]]).connect.assert_called_once_with(self.panel._onChange)
                self.assertIn(f"Default: {row['default']}", widget.toolTip)
                self.panel.triangles.value = 100
                decimate = engine._filter_of(self.panel.request().options(table), keep=False)
                value = value_of(row, another_value(row))
                found = getattr(decimate, "Get" + row["name"])()
                self.assertEqual(row["choices"][found] if row["choices"] else found, value)
            for name in case_of(table.rows, row):
                if name != "MaximumError":
                    self.set_option(name, table.rows[name]["default"])

    def test_options_without_effect_are_disabled_and_not_requested(self):
        chordal = self.set_option("ChordalError", "0.1")
        self.assertFalse(chordal.enabled)
        self.assertNotIn("chordal-error", self.panel.request().extra)
        self.set_option("EdgeLength", "3")
        self.assertTrue(chordal.enabled)
        self.assertEqual(self.panel.request().extra["chordal-error"], 0.1)
        tunnels = self.set_option("TunnelSize", "2")
        self.assertFalse(tunnels.enabled, "segments have no tunnels to close")
        self.panel.source.currentNode.return_value = None
        self.panel._onChange()
        self.assertTrue(tunnels.enabled)

    def test_modes_and_choices_are_those_of_the_table(self):
        self.panel.mode.addItems.assert_called_once_with(self.panel.table.modes)
        self.panel.keepVoxels.addItems.assert_called_once_with(self.panel.table.rows["KeepVoxels"]["choices"])
        self.assertEqual(self.panel.mode.currentText, self.panel.table.rows["Mode"]["default"])

    def test_without_an_engine_the_sections_of_options_say_so(self):
        with patch("BoneDecimatorLib.logic.find_engine", side_effect=MODULE.NoEngine("There is no engine.")):
            panel = MODULE.BoneDecimatorWidget()
            panel.setup()
            panel._onChange()
            self.assertEqual([note.text for note in panel.options.notes], ["There is no engine."] * len(panel.options.SECTIONS))
            self.assertEqual(panel.options.values(), {})
            self.assertIn("Nothing works yet", panel.package.text.text)
        panel._fillOptions()
        self.assertEqual(set(panel.options.values()), {row["flag"] for row in panel.table.panel_rows()})
        self.assertFalse(panel.options.notes[0].visible)

    def test_a_model_becomes_a_new_one(self):
        self.press(self.panel._onSimplify)
        model = self.panel.results[0]
        self.panel.source.currentNode.return_value = model
        self.press(self.panel._onSimplify)
        self.assertIsNot(self.panel.results[0], model)
        self.panel.target.setCurrentNode.assert_called_with(self.panel.results[0])

    def test_open_boundaries_are_closed_into_a_new_model(self):
        self.press(self.panel._onSimplify)
        model = self.panel.results[0]
        self.panel.source.currentNode.return_value = model
        self.press(self.panel._onCap)
        closed = self.panel.results[0]
        self.assertEqual(closed.GetName(), f"{model.GetName()} closed")
        self.assertTrue(closed.GetPolyData().GetCellData().HasArray("BoneCap"))
        self.assertIn("triangles of caps", self.panel.text.text)
        self.panel.source.setCurrentNode.assert_called_with(closed)

    def test_two_models_are_compared_and_colored(self):
        self.press(self.panel._onSimplify)
        first, second = self.panel.results
        self.panel.compare.reference.currentNode.return_value, self.panel.compare.result.currentNode.return_value = first, second
        self.panel.compare.tolerance.value = 100.0
        self.press(self.panel._onCompare)
        self.assertIn("tolerance of 100 mm: proved", self.panel.compare.text.text)
        for model in (first, second):
            distances = model.GetPolyData().GetPointData().GetArray("Distance")
            self.assertEqual(distances.GetNumberOfTuples(), model.GetPolyData().GetNumberOfPoints())
            self.assertGreaterEqual(distances.GetRange()[0], 0.0)
            self.assertTrue(model.GetDisplayNode().GetScalarVisibility())

    def test_an_installed_package_is_used_at_once(self):
        self.assertIn("everything works", self.panel.package.text.text)
        before = len(self.panel.options.of_flag)
        old = self.panel.logic.engine
        self.panel._onInstalled()
        self.assertIsNot(self.panel.logic.engine, old)
        self.assertEqual(len(self.panel.options.of_flag), before)
        self.panel.mode.addItems.assert_called_once_with(self.panel.table.modes)

    def test_live_preview_comes_and_goes(self):
        self.panel._onLive(True)
        time.sleep(0.5)
        self.assertTrue(self.panel.preview.tick())
        self.assertIn("triangles", self.panel.previewText.text)
        self.assertEqual(self.scene.GetNumberOfNodesByClass("vtkMRMLModelNode"), 1)
        self.panel.source.currentNode.return_value = None
        self.panel.preview.changed()
        time.sleep(0.5)
        self.assertTrue(self.panel.preview.tick())
        self.assertIn("Choose a model", self.panel.previewText.text)
        self.panel._onLive(False)
        self.assertEqual(self.scene.GetNumberOfNodesByClass("vtkMRMLModelNode"), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
