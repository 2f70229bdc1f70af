# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripted module's logic on segmentation nodes of a scene.

Needs the wheels slicer-core and bonedecimate; run.sh installs them and calls this.
"""

import os
import pathlib
import sys
import unittest

import numpy as np
import slicer_core
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

sys.path[:0] = [os.environ["SLICER_MODULE"], str(pathlib.Path(__file__).resolve().parents[1] / "Support")]
from BoneDecimatorLib.engines import Canceled, DecimationError, ProgramEngine, WheelEngine  # noqa: E402
from BoneDecimatorLib.logic import BoneDecimatorLogic, spacing_of, surface_of  # noqa: E402
from BoneDecimatorLib.option_table import SEGMENT_RUNS, value_of  # noqa: E402
from BoneDecimatorLib.request import Request  # noqa: E402
from BoneDecimatorLib.segmentation import CLOSED_SURFACE, label_maps_of  # noqa: E402
from BoneDecimatorLib.surfaces import report_of  # noqa: E402
from option_rows import case_of  # noqa: E402

SPACING = (0.5, 0.5, 0.625)
# The axes of a scan in RAS: turned about z, x and y to the right and to the front.
TO_RAS = np.array([[-0.4, 0.3, 0.0, 31.0], [-0.3, -0.4, 0.0, 12.0], [0.0, 0.0, 0.625, -7.0], [0.0, 0.0, 0.0, 1.0]])

PROGRAM = os.environ["BONEDECIMATE_PROGRAM"]

slicer_core.vtkSegmentationConverterFactoryInitialize()
for rule in (slicer_core.vtkBinaryLabelmapToClosedSurfaceConversionRule,
             slicer_core.vtkClosedSurfaceToBinaryLabelmapConversionRule):
    slicer_core.vtkSegmentationConverterFactory.GetInstance().RegisterConverterRule(rule())


def image_of(voxels, to_ras=TO_RAS, first=(0, 0, 0)):
    """@param first Index x, y, z of the first voxel."""
    image = slicer_core.vtkOrientedImageData()
    matrix = vtk.vtkMatrix4x4()
    for i in range(4):
        for j in range(4):
            matrix.SetElement(i, j, to_ras[i, j])
    image.SetImageToWorldMatrix(matrix)
    ends = np.array(first) + voxels.shape[::-1] - 1
    image.SetExtent(first[0], ends[0], first[1], ends[1], first[2], ends[2])
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(voxels, np.uint8).ravel(), deep=True))
    return image


def ball(radius=12.0, center=(16, 16, 16)):
    """Voxels (33, 33, 33); the center is x, y, z."""
    z, y, x = np.ogrid[:33, :33, :33]
    return (x - center[0])**2 + (y - center[1])**2 + (z - center[2])**2 <= radius**2


def scene_with(**segments):
    """Scene, segmentation node, IDs by name. A segment is its voxels, or an image."""
    scene = slicer_core.vtkMRMLScene()
    node = scene.AddNewNodeByClass("vtkMRMLSegmentationNode", "bones")
    node.CreateDefaultDisplayNodes()
    ids = {}
    for i, (name, voxels) in enumerate(segments.items()):
        image = image_of(voxels) if isinstance(voxels, np.ndarray) else voxels
        ids[name] = node.AddSegmentFromBinaryLabelmapRepresentation(image, name, [0.25 * i, 0.5, 0.75])
    return scene, node, ids


def halves():
    whole, x = ball(), np.arange(33)[None, None, :]
    return {"left": whole & (x < 14), "right": whole & (x >= 14)}


def points_of(surface):
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def triangles_of(surface):
    """Sets of corners, each as its rotation that starts with the smallest corner."""
    points = [tuple(point) for point in points_of(surface)]
    found = set()
    for corners in vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3):
        a, b, c = (points[corner] for corner in corners)
        found.add(min((a, b, c), (b, c, a), (c, a, b)))
    return found


def edges_without_partner(surface):
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.BoundaryEdgesOn()
    edges.NonManifoldEdgesOn()
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


def farthest(points, surface):
    """mm, of the points from the surface."""
    distance = vtk.vtkImplicitPolyDataDistance()
    distance.SetInput(surface)
    return max(abs(distance.EvaluateFunction(point)) for point in points)


def slicers_surface(node, segment, factor):
    """Slicer's own conversion."""
    node.GetSegmentation().SetConversionParameter("Smoothing factor", str(factor))
    node.RemoveClosedSurfaceRepresentation()
    node.CreateClosedSurfaceRepresentation()
    surface = vtk.vtkPolyData()
    node.GetClosedSurfaceRepresentation(segment, surface)
    return surface


class Segments(unittest.TestCase):
    def run_segments(self, request=Request(tolerance=0.2), segments=None, **voxels):
        scene, node, ids = scene_with(**(voxels or halves()))
        models, lines = BoneDecimatorLogic(scene, WheelEngine()).decimate_segments(node, request, segments)
        return {model.GetName(): model.GetPolyData() for model in models}, "\n".join(lines)

    def test_surfaces_lie_where_slicer_puts_them(self):
        _, node, ids = scene_with(ball=image_of(ball(), first=(5, -3, 8)))
        theirs = slicers_surface(node, ids["ball"], 0.0)
        ours, _ = self.run_segments(Request(tolerance=0.0, smoothing=1e-4), ball=image_of(ball(), first=(5, -3, 8)))
        self.assertEqual(ours["ball"].GetNumberOfPoints(), theirs.GetNumberOfPoints())
        self.assertLess(farthest(points_of(ours["ball"]), theirs), 2e-4)
        self.assertLess(farthest(points_of(theirs), ours["ball"]), 2e-4)

    def test_neighbors_have_their_wall_in_common_and_are_closed(self):
        for request in (Request(tolerance=0.2), Request(tolerance=0.25, smoothing=0.1)):
            found, lines = self.run_segments(request)
            left, right = (triangles_of(found[name]) for name in ("left", "right"))
            reversed_right = {min((a, c, b), (c, b, a), (b, a, c)) for a, b, c in right}
            self.assertGreater(len(left & reversed_right), 3)
            for surface in found.values():
                self.assertEqual(edges_without_partner(surface), 0)
            self.assertIn("proved", lines)
            self.assertLess(found["left"].GetNumberOfPolys() + found["right"].GetNumberOfPolys(), 2000)

    def test_models_have_names_colors_a_folder_and_the_transform(self):
        scene, node, ids = scene_with(**halves())
        transform = scene.AddNewNodeByClass("vtkMRMLLinearTransformNode")
        node.SetAndObserveTransformNodeID(transform.GetID())
        logic = BoneDecimatorLogic(scene, WheelEngine())
        models, _ = logic.decimate_segments(node, Request(tolerance=0.2))
        tree = scene.GetSubjectHierarchyNode()
        for model, name in zip(models, ("left", "right")):
            self.assertEqual(model.GetName(), name)
            self.assertEqual(model.GetDisplayNode().GetColor(), node.GetSegmentation().GetSegment(ids[name]).GetColor())
            self.assertEqual(model.GetTransformNodeID(), transform.GetID())
            folder = tree.GetItemParent(tree.GetItemByDataNode(model))
            self.assertEqual(tree.GetItemName(folder), "bones simplified")
            self.assertIsNotNone(model.GetPolyData().GetPointData().GetArray("Distance"))
            self.assertEqual(report_of(model.GetPolyData())["proof"]["status"], "proved")
        self.assertIsNone(logic.undo())
        self.assertEqual(scene.GetNumberOfNodesByClass("vtkMRMLModelNode"), 0)
        self.assertEqual(tree.GetItemByName("bones simplified"), tree.GetInvalidItemID())

    def test_surfaces_become_those_of_the_segmentation(self):
        scene, node, ids = scene_with(**halves())
        theirs = slicers_surface(node, ids["right"], 0.5).GetNumberOfPolys()
        logic = BoneDecimatorLogic(scene, WheelEngine())
        logic.decimate_segments(node, Request(tolerance=0.3), [ids["left"]], as_models=False)
        made = vtk.vtkPolyData()
        node.GetClosedSurfaceRepresentation(ids["left"], made)
        self.assertLess(made.GetNumberOfPolys(), 500)
        node.GetClosedSurfaceRepresentation(ids["right"], made)
        self.assertEqual(made.GetNumberOfPolys(), theirs, "the other one stays")
        logic.undo()
        node.GetClosedSurfaceRepresentation(ids["left"], made)
        self.assertGreater(made.GetNumberOfPolys(), 1000)

    def test_smoothing_moves_points_by_its_distance_at_most(self):
        reports = {}
        for distance in (0.05, 0.2):
            found, _ = self.run_segments(Request(tolerance=0.3, smoothing=distance, keep_voxels="Off"))
            reports[distance] = report_of(found["left"])["smoothing"]
            self.assertLessEqual(reports[distance]["largest_displacement"], distance)
        self.assertLess(reports[0.2]["angle_after"], reports[0.05]["angle_after"])
        self.assertLess(reports[0.05]["angle_after"], reports[0.05]["angle_before"])

    def test_voxels_are_kept_on_request_and_counted_by_segment(self):
        changed = {}
        for choice in ("On", "Off", "Auto"):
            found, lines = self.run_segments(Request(tolerance=0.5, keep_voxels=choice))
            voxels = report_of(found["left"])["voxels"]
            changed[choice] = voxels["changed"]
            self.assertEqual(voxels["of_1"]["voxels"], np.count_nonzero(halves()["left"]))
            self.assertIn(f"left: {voxels['of_1']['lost']:,} voxels lost, ", lines)
            self.assertIn(f"right: {voxels['of_2']['lost']:,} voxels lost, ", lines)
        self.assertEqual(changed["On"], 0)
        self.assertGreater(changed["Off"], 0)
        self.assertEqual(changed["Auto"], changed["Off"], "a voxel is more than half a voxel")
        found, lines = self.run_segments(Request(tolerance=0.0, keep_voxels="On", smoothing="automatic"))
        self.assertIn("0 voxels changed (voxels kept)", lines)
        self.assertLess(found["left"].GetNumberOfPolys(), 600)

    def test_options_of_the_table_reach_the_run_but_those_that_segments_do_not_have(self):
        table = WheelEngine().table
        for row in table.panel_rows():
            wanted = {"MaximumError": "0.2", **case_of(table.rows, row)}
            extra = {table.rows[name]["flag"]: value_of(table.rows[name], text) for name, text in wanted.items()}
            with self.subTest(option=row["name"]):
                if any(run in row["unsupported"] for run in SEGMENT_RUNS):
                    with self.assertRaisesRegex(DecimationError, row["flag"].replace("-", "_")):
                        self.run_segments(Request(extra=extra))
                else:
                    used = report_of(self.run_segments(Request(extra=extra))[0]["left"])["options"]
                    self.assertEqual({name: used[name] for name in wanted}, wanted)

    def test_visible_segments_are_taken_without_a_choice(self):
        _, node, ids = scene_with(**halves())
        node.GetDisplayNode().SetSegmentVisibility(ids["left"], False)
        for choice, names in ((None, ["right"]), ([ids["left"]], ["left"]), (list(ids.values()), ["left", "right"])):
            maps = label_maps_of(node, choice).maps
            self.assertEqual([segment.name for each in maps for segment in each.segments], names)
        node.GetDisplayNode().SetSegmentVisibility(ids["right"], False)
        with self.assertRaisesRegex(DecimationError, "none is visible"):
            label_maps_of(node)
        with self.assertRaisesRegex(DecimationError, "no segment 'skull'"):
            label_maps_of(node, ["skull"])

    def test_voxels_of_segments_are_those_of_the_node(self):
        """Whether segments have an array of their own or one together."""
        for collapse in (False, True):
            _, node, _ = scene_with(small=image_of(ball(5.0)[8:25, 8:25, 8:25], first=(8, 8, 8)), **halves())
            node.GetSegmentation().RemoveSegment(node.GetSegmentation().GetNthSegmentID(0))
            if collapse:
                node.GetSegmentation().CollapseBinaryLabelmaps(False)
                self.assertEqual(node.GetSegmentation().GetNumberOfLayers(), 1)
            label_map, = label_maps_of(node).maps
            inside = ball()
            expected = np.where(halves()["left"], 1, 2)[inside]
            np.testing.assert_array_equal(label_map.voxels[label_map.voxels > 0], expected)
            np.testing.assert_allclose(label_map.spacing, SPACING)
            first = np.array([np.flatnonzero(inside.any(axis=axes))[0] for axes in ((0, 1), (0, 2), (1, 2))])
            np.testing.assert_allclose(label_map.origin, TO_RAS[:3] @ np.append(first, 1.0))

    def test_segments_that_overlap_are_named_and_run_one_by_one(self):
        plate = np.zeros((33, 33, 33), bool)
        plate[10:20, 10:20, 2:8] = True
        common = np.count_nonzero(plate & halves()["left"])
        found, lines = self.run_segments(**halves(), plate=plate)
        self.assertIn(f"plate and left overlap in {common:,} voxels: they have no wall in common", lines)
        self.assertIn("left, right:", lines)
        self.assertEqual(set(found), {"left", "right", "plate"})
        for surface in found.values():
            self.assertEqual(edges_without_partner(surface), 0)
        _, lines = self.run_segments(**halves())
        self.assertNotIn("overlap", lines)

    def test_empty_segments_and_other_grids_are_said(self):
        empty = np.zeros((33, 33, 33), bool)
        found, lines = self.run_segments(left=halves()["left"], nothing=empty)
        self.assertEqual(list(found), ["left"])
        self.assertIn("nothing has no voxels.", lines)
        with self.assertRaisesRegex(DecimationError, "^The chosen segments have no voxels"):
            self.run_segments(nothing=empty)
        shifted, stretched = TO_RAS.copy(), TO_RAS.copy()
        shifted[:3, 3] += 0.1
        stretched[:3, 0] *= 1.01
        for to_ras in (shifted, stretched):
            with self.assertRaisesRegex(DecimationError, "^right has another voxel grid than left"):
                self.run_segments(left=halves()["left"], right=image_of(halves()["right"], to_ras))

    def test_a_region_of_interest_says_where(self):
        scene, node, _ = scene_with(ball=ball())
        kept = points_of(slicers_surface(node, node.GetSegmentation().GetNthSegmentID(0), 0.0))
        region = scene.AddNewNodeByClass("vtkMRMLMarkupsROINode")
        center = TO_RAS[:3] @ (16.0, 16.0, 16.0, 1.0)
        region.SetCenterWorld(*(center + (0.0, 0.0, 20.0)))
        region.SetSize(100.0, 100.0, 40.0)
        (model,), _ = BoneDecimatorLogic(scene, WheelEngine()).decimate_segments(
            node, Request(tolerance=0.3, brush=region, keeps_brush=True, feather=0.0))
        upper = {tuple(point) for point in np.round(kept[kept[:, 2] > center[2] + 1e-3], 3)}
        self.assertLessEqual(upper, {tuple(point) for point in np.round(points_of(model.GetPolyData()), 3)})
        self.assertLess(model.GetPolyData().GetNumberOfPoints(), 0.8 * len(kept))
        with self.assertRaisesRegex(DecimationError, "^Segments have no painted points"):
            BoneDecimatorLogic(scene, WheelEngine()).decimate_segments(node, Request(brush="Paint"))

    def test_canceling_changes_nothing(self):
        scene, node, _ = scene_with(**halves())
        logic = BoneDecimatorLogic(scene, WheelEngine())
        for last in (0.0, 0.3, 0.9):
            with self.assertRaises(Canceled):
                logic.decimate_segments(node, Request(tolerance=0.2), progress=lambda fraction: fraction < last)
        self.assertEqual(scene.GetNumberOfNodesByClass("vtkMRMLModelNode"), 0)
        self.assertFalse(logic.can_undo())

    def test_what_cannot_be_done_is_said(self):
        scene, node, _ = scene_with(**halves())
        with self.assertRaisesRegex(DecimationError, "need the Python package"):
            BoneDecimatorLogic(scene, ProgramEngine(PROGRAM)).decimate_segments(node, Request())
        logic = BoneDecimatorLogic(scene, WheelEngine())
        with self.assertRaisesRegex(DecimationError, "has voxels"):
            logic.decimate(node, Request())
        with self.assertRaisesRegex(DecimationError, "has voxels"):
            surface_of(node)

    def test_presets_are_those_of_its_own_voxels(self):
        scene, node, _ = scene_with(**halves())
        np.testing.assert_allclose(spacing_of(node), SPACING)
        with self.assertRaisesRegex(DecimationError, "^Choose the scan first"):
            spacing_of(scene.AddNewNodeByClass("vtkMRMLModelNode"))


class Previews(unittest.TestCase):
    def models(self, scene):
        nodes = [scene.GetNthNodeByClass(i, "vtkMRMLModelNode") for i in range(scene.GetNumberOfNodesByClass("vtkMRMLModelNode"))]
        return [node for node in nodes if node.GetName() == "Bone Decimator preview"]

    def test_is_one_temporary_model_in_the_colors_of_the_segments(self):
        scene, node, ids = scene_with(**halves())
        logic = BoneDecimatorLogic(scene, WheelEngine())
        counts = []
        for tolerance in (0.05, 0.3):
            lines = logic.preview(node, Request(tolerance=tolerance))
            shown, = self.models(scene)
            counts.append(shown.GetPolyData().GetNumberOfPolys())
        self.assertLess(counts[1], counts[0])
        self.assertEqual(lines[0], "Preview:")
        self.assertFalse(shown.GetSaveWithScene())
        colors = {tuple(color) for color in vtk_to_numpy(shown.GetPolyData().GetCellData().GetArray("Colors")).tolist()}
        segments = (node.GetSegmentation().GetSegment(each) for each in ids.values())
        self.assertEqual(colors, {tuple(round(255 * value) for value in segment.GetColor()) for segment in segments})
        logic.remove_preview()
        self.assertEqual(self.models(scene), [])
        self.assertFalse(logic.can_undo())

    def test_of_a_large_bone_is_the_whole_result_of_a_part(self):
        large = np.kron(ball(), np.ones((4, 4, 4), bool))
        scene, node, _ = scene_with(large=image_of(large))
        lines = BoneDecimatorLogic(scene, WheelEngine()).preview(node, Request(tolerance=0.5))
        self.assertRegex(lines[0], "^Preview of [0-9]+ % of the surface:$")
        shown, = self.models(scene)
        low, high = np.array(shown.GetPolyData().GetBounds()).reshape(3, 2).T
        whole = np.array(slicers_surface(node, node.GetSegmentation().GetNthSegmentID(0), 0.0).GetBounds()).reshape(3, 2).T
        self.assertTrue((low > whole[0] - 0.6).all() and (high < whole[1] + 0.6).all())
        self.assertLess(np.prod(high - low), 0.5 * np.prod(whole[1] - whole[0]))

    def test_works_with_every_goal_and_both_engines(self):
        scene, node, _ = scene_with(ball=ball())
        (model,), _ = BoneDecimatorLogic(scene, WheelEngine()).decimate_segments(node, Request(tolerance=0.1))
        for request in (Request(tolerance=0.0, triangles=200), Request(tolerance=0.0, triangles=200, mode="Thesis"),
                        Request(tolerance=0.0, smoothing=0.1), Request(tolerance=0.3, mode="Thesis", triangles=200),
                        Request(tolerance=0.3, mode="Fast", keep_voxels="Off")):
            for engine, source in ((WheelEngine(), node), (WheelEngine(), model), (ProgramEngine(PROGRAM), model)):
                with self.subTest(request=request, engine=type(engine).__name__):
                    said = BoneDecimatorLogic(scene, engine).preview(source, request)
                    lines = [line for line in said if not line.startswith("nothing is proved in Thesis mode")]
                    self.assertIn("triangles", lines[1])
                    if request.tolerance:
                        self.assertNotIn("proved", "".join(lines))

    def test_of_a_model_is_one_too_and_canceling_leaves_the_last(self):
        scene, node, _ = scene_with(ball=ball())
        logic = BoneDecimatorLogic(scene, WheelEngine())
        (model,), _ = logic.decimate_segments(node, Request(tolerance=0.0, smoothing=0.1))
        logic.preview(model, Request(tolerance=0.3))
        before = self.models(scene)[0].GetPolyData().GetNumberOfPolys()
        self.assertLess(before, model.GetPolyData().GetNumberOfPolys())
        with self.assertRaises(Canceled):
            logic.preview(node, Request(tolerance=0.1), progress=lambda fraction: False)
        self.assertEqual(self.models(scene)[0].GetPolyData().GetNumberOfPolys(), before)


if __name__ == "__main__":
    unittest.main(verbosity=2)
