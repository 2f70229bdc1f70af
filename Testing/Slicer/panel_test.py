# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The panel's code on a scene, with widgets that only remember their values.

Needs the wheels slicer-core and bonedecimate; run.sh installs them and calls this.
"""

import os
import sys
import time
import types
import unittest
from unittest.mock import MagicMock

sys.path.insert(0, os.environ["SLICER_MODULE"])
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
                            ("feather", 2.0), ("minimumAngle", 0.0), ("edgeLength", 0.0), ("chordalError", 0.0)):
            getattr(self.panel, name).value = value
        for name, text in (("smoothing", "none"), ("keepVoxels", "Auto"), ("mode", "Balanced"), ("kind", MODULE.MODELS),
                           ("where", MODULE.EVERYWHERE), ("caps", MODULE.CAPS[0])):
            getattr(self.panel, name).currentText = text

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

    def test_the_angle_of_kept_edges_is_requested(self):
        self.panel.featureAngle.value = 45.0
        self.assertEqual(self.panel.request().feature_angle, 45.0)

    def test_shapes_are_requested(self):
        self.panel.minimumAngle.value, self.panel.edgeLength.value, self.panel.chordalError.value = 20.0, 3.0, 0.1
        found = self.panel.request()
        self.assertEqual((found.minimum_angle, found.edge_length, found.chordal_error), (20.0, 3.0, 0.1))

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
