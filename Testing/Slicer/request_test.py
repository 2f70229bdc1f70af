# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripted module's logic rejects values outside their range before it runs anything, and runs previews when it should.

Needs VTK, but no Slicer. The table of options is that of the program in BONEDECIMATE_PROGRAM.
"""

import math
import os
import pathlib
import sys
import types
import unittest

import numpy as np
import vtk

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "Applications" / "Slicer" / "BoneDecimator"), str(ROOT / "Testing" / "Support")]
from BoneDecimatorLib.checks import DecimationError  # noqa: E402
from BoneDecimatorLib.engines import Canceled, ProgramEngine  # noqa: E402
from BoneDecimatorLib.logic import CAPS, SMOOTHINGS, BoneDecimatorLogic, presets, smoothing_of, statistics  # noqa: E402
from BoneDecimatorLib.option_table import CURATED, description, label, value_of  # noqa: E402
from BoneDecimatorLib.request import Request  # noqa: E402
from BoneDecimatorLib.preview import PAUSE, QUIET, Preview, part_of_label_map, part_of_surface  # noqa: E402
from BoneDecimatorLib.segmentation import LabelMap  # noqa: E402
from BoneDecimatorLib.surfaces import report_of  # noqa: E402
from option_rows import another_value, case_of  # noqa: E402

NO_NUMBERS = (math.nan, math.inf, -math.inf, "0.1", None, True)
PROGRAM = ProgramEngine(os.environ["BONEDECIMATE_PROGRAM"])
TABLE = PROGRAM.table


def with_effect(row):
    """A Request in which the option has an effect and another value than its default."""
    options = {TABLE.rows[name]["flag"]: value_of(TABLE.rows[name], text) for name, text in case_of(TABLE.rows, row).items()}
    return Request(mode=options.pop("mode", None), tolerance=options.pop("max-error", 0.0), triangles=100, extra=options)


class Engine:
    """Fails the test at any run."""

    has_levels, table = True, TABLE

    def decimate(self, *_arguments):
        raise AssertionError("it was run")

    record_levels = decimate


class Requests(unittest.TestCase):
    def rejects(self, says, **request):
        with self.subTest(**request):
            with self.assertRaisesRegex(DecimationError, says):
                Request(**request).options(TABLE)
            with self.assertRaisesRegex(DecimationError, says):
                BoneDecimatorLogic(None, Engine()).decimate(None, Request(**request))

    def test_outside_their_range_are_rejected_with_a_sentence(self):
        for value in (-1, -1e-300, 1.1e30, *NO_NUMBERS):
            self.rejects("^The tolerance takes a number from 0 to 1e30 mm, not ", tolerance=value, triangles=100)
            self.rejects("^The smoothing, if it is not 'automatic', takes a number from 0 to 1e30 mm, not ", smoothing=value)
            self.rejects("^The radius takes a number from 0 to 1e30 mm, not ", radius=value)
            self.rejects("^The feather takes a number from 0 to 1e30 mm, not ", feather=value)
        for value in (-1, 180.5, *filter(None, NO_NUMBERS)):
            self.rejects("^The angle of kept edges takes a number from 0 to 180 degrees, not ", feature_angle=value)
        for value in (-1, 0.5, 2**31, *NO_NUMBERS):
            self.rejects("^The number of triangles takes a whole number from 0 to 2147483647 triangles, not ", triangles=value)
        for name, field in (("Mode", "mode"), ("KeepVoxels", "keep_voxels")):
            choices = TABLE.rows[name]["choices"]
            for value in ("", choices[0].lower(), "Nonsense", True, 2):
                self.rejects(f"^{label(TABLE.rows[name])} takes one of {', '.join(choices)}, not ", **{field: value})

    def test_options_of_the_table_are_rejected_outside_their_range(self):
        for row in TABLE.panel_rows():
            words, unit = {"double": "a number from", "int": "a whole number from", "bool": "True or False",
                           "choice": "one of"}[row["kind"]], row["unit"] and f" {row['unit']}"
            beyond = (row["minimum"] - 1, row["maximum"] * 1.1) if row["kind"] in ("double", "int") else (2,)
            for value in (*beyond, math.nan, "0.1", None):
                self.rejects(f"^{label(row)} takes {words}.*{unit}, not ", extra={row["flag"]: value})
        self.rejects("^There is no option --nothing", extra={"nothing": 1})

    def test_options_of_the_table_that_have_no_effect_are_rejected(self):
        for row in filter(lambda row: row["conditions"], TABLE.panel_rows()):
            extra = {row["flag"]: value_of(row, another_value(row))}
            self.rejects(f"^{label(row)} has no effect; it needs [A-Z]", tolerance=0.0, mode="Thesis", triangles=100, extra=extra)
        self.rejects("^Chordal error has no effect; it needs Edge length", extra={"chordal-error": 0.1})

    def test_without_any_goal_are_rejected(self):
        self.rejects("^Give a tolerance, a number of triangles, an edge length or a smoothing", tolerance=0.0, triangles=0)
        self.rejects("^Give a tolerance, a number of triangles, an edge length or a smoothing", tolerance=0.0, keep_voxels="Off")
        self.rejects("^A brush needs a tolerance", tolerance=0.0, triangles=100, brush="Paint")

    def test_within_their_range_become_flags(self):
        wanted = Request(tolerance=0.25, triangles=100, mode="Fast").options(TABLE)
        self.assertEqual(wanted, {"mode": "Fast", "max-error": 0.25, "target-triangles": 100})
        self.assertEqual(Request(extra={"edge-length": 3.0}, tolerance=0.0).options(TABLE), {"edge-length": 3.0})

    def test_smoothing_and_voxels_become_flags(self):
        fast = {"mode": "Fast"}
        for request, wanted in (({"smoothing": 0.2}, {"smooth": 0.2, "target-reduction": 0.0}),
                                ({"smoothing": np.float64(0.2)}, {"smooth": 0.2, "target-reduction": 0.0}),
                                ({"smoothing": "automatic"}, {"auto-smooth": True, "target-reduction": 0.0}),
                                ({"smoothing": 0.2, "feature_angle": 45.0},
                                 {"smooth": 0.2, "feature-angle": 45.0, "target-reduction": 0.0}),
                                ({"feature_angle": 45.0, "triangles": 9}, {"target-triangles": 9}),
                                ({"smoothing": "automatic", "triangles": 9}, {"auto-smooth": True, "target-triangles": 9}),
                                ({"keep_voxels": "On"}, {"keep-voxels": "On"}),
                                ({"keep_voxels": "Off", "triangles": 9}, {"keep-voxels": "Off", "target-triangles": 9}),
                                ({"triangles": 9}, {"target-triangles": 9})):
            with self.subTest(**request):
                self.assertEqual(Request(tolerance=0.0, mode="Fast", **request).options(TABLE), {**fast, **wanted})

    def test_every_option_of_the_table_is_in_the_panel_or_cannot_be(self):
        of_panel = [row["name"] for row in TABLE.panel_rows()]
        self.assertLessEqual({"MinimumAngle", "IntersectionGuard", "OutputPointsPrecision"}, set(of_panel))
        self.assertLessEqual(set(CURATED), set(TABLE.rows))
        self.assertNotIn("Thesis", TABLE.modes)
        for name, row in TABLE.rows.items():
            needs_thesis = [["Mode", str(TABLE.rows["Mode"]["choices"].index("Thesis")), True]] in row["conditions"]
            left_out = name in CURATED or not row["flag"] or row["kind"] == "text" or needs_thesis
            self.assertEqual(of_panel.count(name), 0 if left_out else 1, name)

    def test_descriptions_have_default_range_and_unit(self):
        text = description(TABLE.rows["MinimumAngle"])
        self.assertTrue(text.endswith(" 0: off. Default: 0 degrees. Range: 0 to 40 degrees."), text)
        self.assertTrue(description(TABLE.rows["EdgeLength"]).endswith(" Range: 0 to 1e30 mm."))
        self.assertTrue(description(TABLE.rows["ProveResult"]).endswith(" Default: on."))

    def test_options_of_the_table_reach_the_program(self):
        source = vtk.vtkSphereSource()
        source.SetRadius(20.0)
        source.Update()
        for row in TABLE.panel_rows():
            with self.subTest(option=row["name"]):
                used = report_of(PROGRAM.decimate(source.GetOutput(), with_effect(row).options(TABLE)))["options"]
                wanted = case_of(TABLE.rows, row)
                self.assertEqual({name: used[name] for name in wanted}, wanted)

    def test_a_program_without_a_table_is_named(self):
        for program in ("/no/program", sys.executable):
            with self.assertRaisesRegex(DecimationError, f"^{program} prints no table of options; install its current version"):
                ProgramEngine(program).table

    def test_presets_of_smoothing_are_fractions_of_the_least_side_of_a_voxel(self):
        found = {each: smoothing_of(each, (0.8, 0.4, 1.0), own=0.3) for each in SMOOTHINGS}
        self.assertEqual(found, {"none": 0.0, "automatic": "automatic", "quarter of a voxel": 0.1, "half a voxel": 0.2,
                                 "one voxel": 0.4, "own distance": 0.3})

    def test_of_levels_are_rejected(self):
        logic = BoneDecimatorLogic(None, Engine())
        for value in (0, -0.1, 1.1, *NO_NUMBERS):
            with self.subTest(value=value), self.assertRaisesRegex(DecimationError, "^The ratio of triangles takes"):
                logic.record_levels(None, ratio=value)
        with self.assertRaisesRegex(DecimationError, "^Mode takes"):
            logic.record_levels(None, mode="Nonsense")
        for value in (0, -1, 0.5, *NO_NUMBERS):
            with self.subTest(value=value), self.assertRaisesRegex(DecimationError, "^The number of triangles takes"):
                logic.show_level(None, value, None)

    def test_of_presets_are_rejected(self):
        for value in (-1.0, *NO_NUMBERS):
            with self.subTest(value=value), self.assertRaisesRegex(DecimationError, "^The scan's spacing takes"):
                presets((0.5, 0.5, value))
        self.assertEqual(presets((0.5, 1.0))["one voxel"], 0.5)


class Caps(unittest.TestCase):
    @staticmethod
    def tube():
        ring = vtk.vtkCylinderSource()
        ring.SetResolution(24)
        ring.CappingOff()
        triangles = vtk.vtkTriangleFilter()
        triangles.SetInputConnection(ring.GetOutputPort())
        triangles.Update()
        return triangles.GetOutput()

    @staticmethod
    def node(surface):
        node = types.SimpleNamespace(surface=surface)
        node.IsA = lambda name: name == "vtkMRMLModelNode"
        node.GetPolyData = lambda: node.surface
        node.GetName = lambda: "bone"
        node.GetParentTransformNode = lambda: None
        node.SetAndObservePolyData = lambda closed: setattr(node, "surface", closed)
        return node

    def test_close_a_model_into_a_new_one(self):
        source, made = self.node(self.tube()), self.node(None)
        scene = types.SimpleNamespace(AddNewNodeByClass=lambda kind, name: made, RemoveNode=lambda node: None)
        logic = BoneDecimatorLogic(scene, PROGRAM)
        for loops in CAPS:
            node, lines = logic.cap(source, loops)
            self.assertIs(node, made)
            self.assertEqual(lines, ["44 triangles of caps; they are outside of every tolerance"])
            edges = vtk.vtkFeatureEdges()
            edges.FeatureEdgesOff()
            edges.ManifoldEdgesOff()
            edges.SetInputData(node.GetPolyData())
            edges.Update()
            self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)
        self.assertEqual(source.GetPolyData().GetNumberOfPolys() + 44, made.GetPolyData().GetNumberOfPolys())
        logic.undo()
        logic.undo()

    def test_of_an_unknown_kind_are_rejected(self):
        with self.assertRaisesRegex(DecimationError, "^Caps takes one of "):
            BoneDecimatorLogic(None, Engine()).cap(self.node(self.tube()), "some")


class Statistics(unittest.TestCase):
    def test_name_segments_and_round_what_is_proved_up(self):
        report = {"input": {"triangles": 5000, "components": 2}, "output": {"triangles": 800, "components": 2},
                  "proof": {"status": "proved", "upper": 0.20001, "sentence": "at most 0.200010 mm in both directions, but for 1 line"}, "distance": {"input_to_output": {"mean": 0.05}},
                  "smoothing": {"largest_displacement": 0.15, "rms_displacement": 0.1, "sharp_points": 7},
                  "voxels": {"guard": "off", "changed": 3, "of_1": {"voxels": 70, "lost": 2, "gained": 1},
                             "of_2": {"voxels": 80, "lost": 1, "gained": 0}, "of_0": {"voxels": 9, "lost": 0, "gained": 2}}}
        text = "\n".join(statistics(report, ["tibia", "fibula"]))
        for line in ("5,000 -> 800 triangles", "proved at most 0.200010 mm in both directions, but for 1 line",
                     "smoothing moved points by 0.1500 mm at most, 0.1000 mm RMS", "3 voxels changed (voxels not kept)",
                     "7 points on edges that were kept sharp",
                     "tibia: 2 voxels lost, 1 gained, of 70", "fibula: 1 voxels lost, 0 gained, of 80"):
            self.assertIn(line, text)
        self.assertNotIn("proved", "\n".join(statistics({**report, "proof": {"status": "undecided", "sentence": "<= 3 mm"}})))


class Previews(unittest.TestCase):
    """With a clock of the test's own."""

    def setUp(self):
        self.now, self.runs, self.told, self.during = 0.0, 0, [], None
        self.preview = Preview(self.run_once, self.told.append, self.listen, lambda: self.now)

    def run_once(self, progress):
        self.runs += 1
        if progress(0.5) is False:
            raise Canceled("Canceled.")

    def listen(self):
        during, self.during = self.during, None
        if during:
            during()

    def tick_after(self, seconds):
        self.now += seconds
        return self.preview.tick()

    def test_changes_in_short_order_are_one_run(self):
        self.preview.start()
        for _ in range(5):
            self.assertFalse(self.tick_after(0.9 * QUIET))
            self.preview.changed()
        self.assertTrue(self.tick_after(1.1 * QUIET))
        self.assertFalse(self.tick_after(10.0), "nothing has changed since")
        self.assertEqual(self.runs, 1)

    def test_a_change_during_a_run_cancels_it_and_runs_again(self):
        self.preview.start()
        self.during = self.preview.changed
        self.assertFalse(self.tick_after(1.1 * QUIET), "canceled")
        self.assertFalse(self.tick_after(0.5 * QUIET), "not quiet yet")
        self.assertTrue(self.tick_after(0.6 * QUIET))
        self.assertEqual(self.runs, 2)

    def test_a_tick_during_a_run_does_not_start_another(self):
        self.preview.start()
        self.during = lambda: self.assertFalse(self.tick_after(10.0))
        self.assertTrue(self.tick_after(1.1 * QUIET))
        self.assertEqual(self.runs, 1)

    def test_stopping_cancels_a_run_and_ignores_changes(self):
        self.preview.start()
        self.during = self.preview.stop
        self.assertFalse(self.tick_after(1.1 * QUIET))
        self.preview.changed()
        self.assertFalse(self.tick_after(10.0))
        self.assertEqual(self.runs, 1)

    def test_looks_for_changes_now_and_then(self):
        looks = []

        def run(progress):
            for step in range(100):
                self.now += 0.1 * PAUSE
                progress(0.01 * step)

        preview = Preview(run, self.told.append, lambda: looks.append(self.now), lambda: self.now)
        preview.start()
        self.now += 1.1 * QUIET
        self.assertTrue(preview.tick())
        self.assertTrue(5 <= len(looks) <= 11, looks)

    def test_problems_are_told_once(self):
        def fail(_progress):
            raise DecimationError("Choose a model.")

        preview = Preview(fail, self.told.append, clock=lambda: self.now)
        preview.start()
        self.now += 1.1 * QUIET
        preview.tick()
        preview.tick()
        self.assertEqual(self.told, ["Choose a model."])


class Parts(unittest.TestCase):
    """Of a ball of radius 30 voxels, of 0.5 x 0.5 x 1 mm, at an offset and turned."""

    def setUp(self):
        z, y, x = np.ogrid[-30:31, -30:31, -30:31]
        self.to_node = np.array([[0.0, -0.5, 0.0, 7.0], [0.5, 0.0, 0.0, -3.0], [0.0, 0.0, 1.0, 11.0], [0.0, 0.0, 0.0, 1.0]])
        self.ball = LabelMap((x * x + y * y + z * z <= 900).astype(np.uint16), ["ball"], self.to_node)

    def position_in_whole(self, part):
        """The index x, y, z of the part's first voxel in the ball's array."""
        shift = np.linalg.inv(self.to_node) @ part.to_node
        np.testing.assert_allclose(shift[:3, :3], np.eye(3), atol=1e-12)
        return np.rint(shift[:3, 3]).astype(int)

    def test_of_a_small_label_map_is_all_of_it(self):
        part, ratio = part_of_label_map(self.ball, 10**6)
        self.assertIs(part, self.ball)
        self.assertEqual(ratio, 1.0)

    def test_of_a_large_label_map_is_a_box_in_the_same_position(self):
        for center in (None, self.to_node[:3] @ (30.0, 30.0, 60.0, 1.0), self.to_node[:3] @ (0.0, 30.0, 30.0, 1.0)):
            part, ratio = part_of_label_map(self.ball, 4000, center)
            faces = sum(np.count_nonzero(np.diff(part.voxels.astype(int), axis=axis)) for axis in range(3))
            self.assertTrue(1000 < faces < 3000, faces)
            self.assertTrue(0.0 < ratio < 0.3, ratio)
            x, y, z = self.position_in_whole(part)
            nz, ny, nx = part.voxels.shape
            np.testing.assert_array_equal(part.voxels, self.ball.voxels[z:z + nz, y:y + ny, x:x + nx])
            if center is not None:
                local = np.linalg.inv(part.to_node) @ (*center, 1.0)
                self.assertTrue((local[:3] > -0.5).all() and (local[:3] < part.voxels.shape[::-1]).all())

    def test_of_a_surface_are_the_cells_about_a_point_with_their_arrays(self):
        source = vtk.vtkSphereSource()
        source.SetRadius(20.0)
        source.SetThetaResolution(60)
        source.SetPhiResolution(60)
        source.Update()
        part, ratio = part_of_surface(source.GetOutput(), 700, (20.0, 0.0, 0.0))
        self.assertEqual(part.GetNumberOfCells(), 700)
        self.assertAlmostEqual(ratio, 700 / source.GetOutput().GetNumberOfCells())
        self.assertGreater(part.GetBounds()[0], 0.0)
        self.assertTrue(part.GetPointData().HasArray("Normals"))
        self.assertIs(part_of_surface(source.GetOutput(), 10**6)[0], source.GetOutput())


if __name__ == "__main__":
    unittest.main()
