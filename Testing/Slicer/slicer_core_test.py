# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Slicer's own machinery runs the program as a module, and the scripted module's logic runs on nodes of a scene.

Needs the wheels slicer-core and bonedecimate; run.sh installs them and calls this.
"""

import ctypes
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import slicer_core
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

PROGRAM = os.environ["BONEDECIMATE_PROGRAM"]
sys.path.insert(0, os.environ["SLICER_MODULE"])
from BoneDecimatorLib import logic as module  # noqa: E402
from BoneDecimatorLib.engines import Canceled, DecimationError, ProgramEngine, WheelEngine  # noqa: E402
from BoneDecimatorLib.logic import BoneDecimatorLogic, surface_of  # noqa: E402
from BoneDecimatorLib.request import Request  # noqa: E402
from BoneDecimatorLib.surfaces import report_of  # noqa: E402


def ball(radius=20.0):
    source = vtk.vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(60)
    source.SetPhiResolution(60)
    source.Update()
    return source.GetOutput()


def positions(surface):
    return {tuple(point) for point in vtk_to_numpy(surface.GetPoints().GetData())}


def scene_with_ball():
    scene = slicer_core.vtkMRMLScene()
    node = scene.AddNewNodeByClass("vtkMRMLModelNode", "bone")
    node.SetAndObservePolyData(ball())
    return scene, node


class CommandLineModule(unittest.TestCase):
    """vtkSlicerCLIModuleLogic on a scene's model."""

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.description = subprocess.run([PROGRAM, "--xml"], capture_output=True, text=True, check=True).stdout
        shim = ctypes.CDLL(os.environ["REGISTER_MODULE"])
        cls.register = lambda xml, program: shim.RegisterModule(xml.encode(), program.encode())
        cls.problem = cls.register(cls.description, PROGRAM)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def run_module(self, **parameters):
        scene, model = scene_with_ball()
        scene.RegisterNodeClass(slicer_core.vtkMRMLCommandLineModuleNode())
        node = scene.AddNewNodeByClass("vtkMRMLCommandLineModuleNode")
        node.SetModuleDescription("Bone Decimation")
        target = scene.AddNewNodeByClass("vtkMRMLModelNode", "small")
        node.SetParameterAsNode("inputModel", model)
        node.SetParameterAsNode("outputModel", target)
        for name, value in parameters.items():
            node.SetParameterAsString(name, str(value))
        application = slicer_core.vtkSlicerApplicationLogic()
        application.SetTemporaryPath(self.scratch.name)
        application.SetMRMLScene(scene)
        logic = slicer_core.vtkSlicerCLIModuleLogic()
        logic.SetMRMLApplicationLogic(application)
        logic.SetMRMLScene(scene)
        logic.DeleteTemporaryFilesOff()
        logic.ApplyAndWait(node, False)
        return scene, node, target

    def test_description_is_read_by_slicers_parser(self):
        self.assertEqual(self.problem, 0)
        self.assertNotEqual(type(self).register("<executable><nope>", PROGRAM), 0)

    def test_a_model_is_simplified_and_read_back_with_its_arrays(self):
        scene, node, target = self.run_module(MaximumError=0.1)
        self.assertEqual((node.GetStatusString(), node.GetErrorText()), ("Completed", ""))
        written = max(pathlib.Path(self.scratch.name).glob("*.vtp"), key=lambda path: path.stat().st_mtime)
        storage = scene.AddNewNodeByClass("vtkMRMLModelStorageNode")
        storage.SetFileName(str(written))
        self.assertEqual(storage.ReadData(target), 1)
        surface = target.GetPolyData()
        self.assertLess(surface.GetNumberOfPolys(), ball().GetNumberOfPolys())
        # Slicer's thread, which reads the results back, does not run: they are read here, by Slicer's own reader.
        node.ReadParameterFile(str(next(pathlib.Path(self.scratch.name).glob("*.params"))))
        self.assertEqual(int(node.GetParameterAsString("outputTriangles")), surface.GetNumberOfPolys())
        self.assertEqual(node.GetParameterAsString("proofStatus"), "proved")
        self.assertLessEqual(float(node.GetParameterAsString("provedError")), 0.1)
        self.assertIsNotNone(surface.GetPointData().GetArray("Distance"))
        bounds = np.array(surface.GetBounds())
        self.assertLess(np.abs(bounds - np.array(ball().GetBounds())).max(), 0.2, "no axis is turned round")
        print(f"\n  {node.GetStatusString()}: {surface.GetNumberOfPolys()} triangles, "
              f"proved {node.GetParameterAsString('provedError')} mm")

    def test_a_failure_is_shown_as_one(self):
        _, node, _ = self.run_module(MaximumError=0, TargetReduction=1, TargetNumberOfTriangles=0, Mode="Nonsense")
        self.assertIn("errors", node.GetStatusString())
        self.assertIn("--mode takes one of", node.GetErrorText())


class Logic(unittest.TestCase):
    """Both engines, on nodes."""

    def engines(self):
        return WheelEngine(), ProgramEngine(PROGRAM)

    def test_engines_give_the_same_points_and_triangles(self):
        found = []
        for engine in self.engines():
            scene, node = scene_with_ball()
            target, lines = BoneDecimatorLogic(scene, engine).decimate(node, Request(tolerance=0.1))
            self.assertIn("proved", " ".join(lines))
            surface = target.GetPolyData()
            found.append((positions(surface), vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).tolist()))
        self.assertEqual(*found)
        print("\n  " + "; ".join(lines))

    def test_a_brush_of_points_leaves_everything_else_bit_for_bit(self):
        for engine in self.engines():
            scene, node = scene_with_ball()
            brush = scene.AddNewNodeByClass("vtkMRMLMarkupsFiducialNode")
            brush.AddControlPoint(vtk.vtkVector3d(20.0, 0.0, 0.0))
            target, _ = BoneDecimatorLogic(scene, engine).decimate(
                node, Request(tolerance=0.2, brush=brush, radius=12.0, feather=3.0))
            kept = {position for position in positions(ball()) if np.linalg.norm(np.array(position) - (20, 0, 0)) > 15.1}
            self.assertLessEqual(kept, positions(target.GetPolyData()))
            self.assertLess(target.GetPolyData().GetNumberOfPoints(), ball().GetNumberOfPoints())

    def test_further_strokes_run_only_what_is_new_and_leave_earlier_results(self):
        scene, node = scene_with_ball()
        brush = scene.AddNewNodeByClass("vtkMRMLMarkupsFiducialNode")
        logic, request = BoneDecimatorLogic(scene, WheelEngine()), Request(tolerance=0.05, brush=brush, radius=4.0, feather=0.0)
        counts, targets = [], []
        for x in (20.0, -20.0):
            brush.AddControlPoint(vtk.vtkVector3d(x, 0.0, 0.0))
            target, _ = logic.decimate(node, request)
            counts.append([report_of(target.GetPolyData())["regions"][name] for name in ("kept", "count")])
            targets.append((target, positions(target.GetPolyData())))
        self.assertEqual(counts, [[0, 1], [1, 2]])
        self.assertEqual(positions(targets[0][0].GetPolyData()), targets[0][1])
        logic.undo()
        brush.RemoveNthControlPoint(1)
        again, _ = logic.decimate(node, request)
        self.assertEqual(positions(again.GetPolyData()), targets[0][1])
        self.assertEqual(report_of(again.GetPolyData())["regions"]["kept"], 1)
        logic.release_memory()
        self.assertEqual(report_of(logic.decimate(node, request)[0].GetPolyData())["regions"]["kept"], 0)

    def test_what_a_region_of_interest_keeps_stays_also_under_a_transform(self):
        scene, node = scene_with_ball()
        shift = vtk.vtkMatrix4x4()
        shift.SetElement(0, 3, 100.0)
        transform = scene.AddNewNodeByClass("vtkMRMLLinearTransformNode")
        transform.SetMatrixTransformToParent(shift)
        node.SetAndObserveTransformNodeID(transform.GetID())
        region = scene.AddNewNodeByClass("vtkMRMLMarkupsROINode")
        region.SetCenterWorld(120.0, 0.0, 0.0)
        region.SetSize(20.0, 100.0, 100.0)
        target, _ = BoneDecimatorLogic(scene, WheelEngine()).decimate(
            node, Request(tolerance=0.2, brush=region, keeps_brush=True, feather=0.0))
        kept = {position for position in positions(ball()) if position[0] > 10.0}
        self.assertLessEqual(kept, positions(target.GetPolyData()))
        self.assertLess(target.GetPolyData().GetNumberOfPoints(), ball().GetNumberOfPoints())
        self.assertEqual(target.GetTransformNodeID(), node.GetTransformNodeID())

    def test_paint_is_a_brush(self):
        scene, node = scene_with_ball()
        points = vtk_to_numpy(node.GetPolyData().GetPoints().GetData())
        painted = numpy_to_vtk((points[:, 2] > 5.0).astype(np.uint8), deep=True)
        painted.SetName("SelectedPoints")
        node.GetPolyData().GetPointData().AddArray(painted)
        target, _ = BoneDecimatorLogic(scene, WheelEngine()).decimate(
            node, Request(tolerance=0.2, brush="SelectedPoints", feather=0.0))
        self.assertLessEqual({p for p in positions(ball()) if p[2] < 5.0}, positions(target.GetPolyData()))

    def test_a_segment_is_a_source(self):
        scene = slicer_core.vtkMRMLScene()
        node = scene.AddNewNodeByClass("vtkMRMLSegmentationNode", "bones")
        node.SetSourceRepresentationToClosedSurface()
        name = node.AddSegmentFromClosedSurfaceRepresentation(ball(), "tibia", [0.9, 0.8, 0.6])
        self.assertEqual(surface_of(node, name).GetNumberOfPolys(), ball().GetNumberOfPolys())
        target, _ = BoneDecimatorLogic(scene, WheelEngine()).decimate(node, Request(tolerance=0.0, triangles=500))
        self.assertEqual(target.GetPolyData().GetNumberOfPolys(), 500)

    def test_undo_goes_back_step_by_step(self):
        scene, node = scene_with_ball()
        logic = BoneDecimatorLogic(scene, WheelEngine())
        logic.decimate(node, Request(tolerance=0.0, triangles=2000), target=node)
        logic.decimate(node, Request(tolerance=0.0, triangles=500), target=node)
        self.assertEqual(logic.undo().GetPolyData().GetNumberOfPolys(), 2000)
        self.assertEqual(logic.undo().GetPolyData().GetNumberOfPolys(), ball().GetNumberOfPolys())
        self.assertFalse(logic.can_undo())
        made, _ = logic.decimate(node, Request(tolerance=0.0, triangles=500))
        self.assertIsNone(logic.undo())
        self.assertIsNone(scene.GetNodeByID(made.GetID() or ""))

    def test_levels_are_a_slider(self):
        scene, node = scene_with_ball()
        logic = BoneDecimatorLogic(scene, WheelEngine())
        levels = logic.record_levels(node, ratio=0.1)
        for triangles in (4000, 1000):
            logic.show_level(levels, triangles, node)
            self.assertEqual(node.GetPolyData().GetNumberOfPolys(), triangles)
        with self.assertRaises(DecimationError):
            BoneDecimatorLogic(scene, ProgramEngine(PROGRAM)).record_levels(node)

    def test_canceling_changes_nothing(self):
        for engine in self.engines():
            scene, node = scene_with_ball()
            logic = BoneDecimatorLogic(scene, engine)
            with self.assertRaises(Canceled):
                logic.decimate(node, Request(tolerance=0.1), target=node, progress=lambda fraction: fraction < 0.3)
            self.assertEqual(positions(node.GetPolyData()), positions(ball()))
            self.assertFalse(logic.can_undo())

    def test_what_makes_no_sense_is_said(self):
        scene, node = scene_with_ball()
        logic = BoneDecimatorLogic(scene, WheelEngine())
        empty = scene.AddNewNodeByClass("vtkMRMLModelNode", "empty")
        brush = scene.AddNewNodeByClass("vtkMRMLMarkupsFiducialNode")
        for source, request in ((None, Request()), (empty, Request()), (node, Request(tolerance=0.0)),
                                (node, Request(brush=brush)), (node, Request(brush="nothing"))):
            with self.assertRaises(DecimationError):
                logic.decimate(source, request)

    def test_presets_are_fractions_of_the_least_side_of_a_voxel(self):
        self.assertEqual(module.presets((0.5, 0.5, 0.625))["half a voxel"], 0.25)


if __name__ == "__main__":
    unittest.main(verbosity=2)
