# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""numpy in, numpy out: what decimate() of the wheel guarantees. Needs no VTK."""

import json
import os
import subprocess
import sys
import threading
import time
import math
import unittest
import warnings

import numpy as np

import bonedecimate
from bonedecimate import StopReason, certify, decimate
from bonedecimate import options as table


def ball(around=60, up=30, radius=10.0):
    """A closed surface: points, mm, and triangles."""
    u, v = np.meshgrid(np.arange(around) * 2 * np.pi / around, np.arange(1, up) * np.pi / up, indexing="ij")
    ring = np.stack([np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)], axis=-1).reshape(-1, 3)
    points = radius * np.vstack([ring, [[0, 0, 1], [0, 0, -1]]])
    triangles = []
    for i in range(around):
        j = (i + 1) % around
        a, b = i * (up - 1), j * (up - 1)
        triangles += [(len(ring), a, b), (a + up - 2, len(ring) + 1, b + up - 2)]
        for k in range(up - 2):
            triangles += [(a + k, a + k + 1, b + k), (b + k, a + k + 1, b + k + 1)]
    return points, np.array(triangles)


POINTS, TRIANGLES = ball()


def farthest(points, others, triangles, parts):
    """By brute force: the largest distance of the points to samples of triangles whose edges are cut into so many parts."""
    weights = np.array([(i, j, parts - i - j) for i in range(parts + 1) for j in range(parts + 1 - i)]) / parts
    samples = np.einsum("wk,tkc->twc", weights, others[triangles]).reshape(-1, 3)
    return max(np.sqrt(((samples - point) ** 2).sum(axis=1).min()) for point in points)


class Smoothing(unittest.TestCase):
    def test_keeps_all_triangles_and_its_distance(self):
        noise = np.random.default_rng(3).uniform(-0.1, 0.1, POINTS.shape)
        result = bonedecimate.smooth(POINTS + noise, TRIANGLES, 0.1)
        self.assertEqual(len(result.triangles), len(TRIANGLES))
        self.assertLessEqual(result.proved_error, 0.1)
        self.assertEqual(result.proof_status, "proved")
        self.assertLess(result.report["smoothing.angle_after"], result.report["smoothing.angle_before"])

    def test_leaves_alone_what_is_no_segmentation_and_says_so(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            result = bonedecimate.smooth(POINTS, TRIANGLES)
        self.assertTrue(any("was not smoothed" in str(one.message) for one in told))
        self.assertEqual(result.report["smoothing.bound"], 0)

    def test_takes_nothing_that_removes_triangles(self):
        for option in ({"target_reduction": 0.5}, {"mode": "Fast"}, {"smooth": 0.1}, {"prune_size": 1.0}):
            with self.assertRaises(TypeError):
                bonedecimate.smooth(POINTS, TRIANGLES, 0.1, **option)
        for distance in (-1.0, math.nan, math.inf):
            with self.assertRaises(ValueError):
                bonedecimate.smooth(POINTS, TRIANGLES, distance)


class Levels(unittest.TestCase):
    OPTIONS = {"mode": "Fast", "threads": 1}  # where a level is what a run of its own gives

    def test_are_what_runs_to_their_numbers_give(self):
        levels = bonedecimate.record_levels(POINTS, TRIANGLES, target_triangles=300, **self.OPTIONS)
        self.assertEqual(len(levels.result.triangles), 300)
        for triangles in (3000, 1000, 300):
            points, corners = levels.at(triangles=triangles)
            run = decimate(POINTS, TRIANGLES, target_triangles=triangles, **self.OPTIONS)
            np.testing.assert_array_equal(points, run.points)
            np.testing.assert_array_equal(corners, run.triangles)

    def test_marks_are_measured_and_taken_by_their_distance(self):
        levels = bonedecimate.record_levels(POINTS.astype(np.float32), TRIANGLES, target_triangles=300)
        self.assertTrue((np.diff(levels.marks[:, 0]) < 0).all())
        middle = levels.marks[len(levels.marks) // 2]
        points, corners = levels.at(error=middle[1])
        self.assertEqual((len(corners), points.dtype), (middle[0], np.float32))
        with self.assertWarnsRegex(UserWarning, "no mark is within 0 mm of the input; this is the whole input"):
            self.assertEqual(len(levels.at(error=0.0)[1]), len(TRIANGLES))
        with self.assertWarnsRegex(UserWarning, "the coarsest level has 300 triangles, more than 299"):
            self.assertEqual(len(levels.at(triangles=299)[1]), 300)
        bare = bonedecimate.record_levels(POINTS, TRIANGLES, measure=False)
        self.assertTrue(np.isnan(bare.marks[:, 1:]).all())
        with self.assertRaisesRegex(ValueError, "recorded without distances"):
            bare.at(error=0.1)

    def test_open_again_from_their_log_and_go_onto_another_bone(self):
        levels = bonedecimate.record_levels(POINTS, TRIANGLES, target_triangles=300)
        again = bonedecimate.open_levels(POINTS, TRIANGLES, levels.log)
        for one, other in zip(levels.at(triangles=800), again.at(triangles=800)):
            np.testing.assert_array_equal(one, other)
        points, corners = again.at(triangles=800, on=(2 * POINTS, TRIANGLES))
        np.testing.assert_array_equal(corners, levels.at(triangles=800)[1])
        np.testing.assert_allclose(points, 2 * levels.at(triangles=800)[0], atol=1e-6)

    def test_levels_of_a_log_have_the_precision_of_its_run(self):
        points = POINTS.astype(np.float32)
        for precision, kind in (("Double", np.float64), ("Single", np.float32)):
            levels = bonedecimate.record_levels(points, TRIANGLES, target_triangles=300, precision=precision)
            again = bonedecimate.open_levels(points, TRIANGLES, levels.log)
            for one in (levels, again):
                self.assertEqual(one.at(triangles=300)[0].dtype, kind)
            np.testing.assert_array_equal(again.at(triangles=300)[0], levels.at(triangles=300)[0])

    def test_of_what_makes_no_sense_there_are_none(self):
        levels = bonedecimate.record_levels(POINTS, TRIANGLES, target_triangles=300)
        for wrong in ({}, {"triangles": 3, "error": 0.1}, {"triangles": 300, "on": (POINTS, TRIANGLES[::-1])}):
            with self.assertRaises(ValueError):
                levels.at(**wrong)
        for log in (b"", b"no log at all", levels.log[:-1]):
            with self.assertRaises(ValueError):
                bonedecimate.open_levels(POINTS, TRIANGLES, log)
        with self.assertRaisesRegex(ValueError, "surface"):
            bonedecimate.open_levels(POINTS + 1.0, TRIANGLES, levels.log)


class Decimate(unittest.TestCase):
    def test_result_has_its_main_figures(self):
        result = decimate(POINTS, TRIANGLES, max_error=0.2)
        self.assertEqual(result.proved_error, result.report["proof.upper"])
        self.assertLessEqual(result.measured_error, result.proved_error)
        self.assertEqual(result.proof_status, "proved")
        self.assertEqual(result.rejected_edits, sum(value for name, value in result.report.items() if name.startswith("rejections.")))
        self.assertEqual(json.loads(result.report_as_json)["output"]["triangles"], len(result.triangles))
        plain = decimate(POINTS, TRIANGLES, target_reduction=0.5, measure=False)
        self.assertTrue(math.isnan(plain.proved_error) and math.isnan(plain.measured_error))
        self.assertEqual(plain.proof_status, "no_proof")

    def test_keeps_what_is_left_of_the_error_against_a_reference(self):
        first = decimate(POINTS, TRIANGLES, max_error=0.1)
        second = decimate(*first, max_error=0.2, reference=(POINTS, TRIANGLES))
        self.assertLess(len(second.triangles), len(first.triangles))
        self.assertEqual(second.report["proof.status"], "proved")
        self.assertLess(second.report["reference.to_input.upper"], 0.102)  # bounds tight enough to leave an error budget
        self.assertEqual(certify((POINTS, TRIANGLES), second, tolerance=0.2).status, "proved")
        with self.assertRaisesRegex(ValueError, "reference"):
            decimate(*first, target_reduction=0.5, reference=(POINTS, TRIANGLES))

    def test_keeps_the_largest_error_and_proves_it(self):
        result = decimate(POINTS, TRIANGLES, max_error=0.2)
        self.assertLess(len(result.triangles), len(TRIANGLES) / 3)
        self.assertEqual(result.report["proof.status"], "proved")
        self.assertLessEqual(result.report["proof.upper"], 0.2)
        self.assertLess(farthest(POINTS[::97], result.points, result.triangles, 36), 0.21)
        self.assertLess(farthest(result.points[::16], POINTS, TRIANGLES, 12), 0.21)
        self.assertEqual(result.units["proof.upper"], "mm")

    def test_has_shapes_and_types_as_documented(self):
        result = decimate(POINTS, TRIANGLES, max_error=0.2, maps=True, measure_input_distances=True)
        n, m = len(result.points), len(result.triangles)
        of_points = {"distance": np.float64, "running_error": np.float64, "point_count": np.int32,
                     "error_bound": np.float64, "nearest_point": np.int32, "nearest_triangle": np.int32}
        for name, kind in of_points.items():
            self.assertEqual((getattr(result, name).shape, getattr(result, name).dtype), ((n,), kind), name)
        self.assertEqual((result.points.shape, result.triangles.shape), ((n, 3), (m, 3)))
        self.assertEqual((result.barycentric.shape, result.triangle_at_centroid.shape), ((n, 3), (m,)))
        for name in ("input_distance", "input_error_bound", "output_point"):
            self.assertEqual(getattr(result, name).shape, (len(POINTS),), name)
        self.assertEqual(result.stop_reason, StopReason.ErrorReached)
        np.testing.assert_array_equal(np.bincount(result.output_point), result.point_count)

    def test_result_unpacks_and_outlives_what_made_it(self):
        points, triangles = decimate(POINTS, TRIANGLES, target_triangles=500)
        self.assertEqual((len(triangles), triangles.max()), (500, len(points) - 1))

    def test_does_not_change_its_input(self):
        points, triangles = POINTS.copy(), TRIANGLES.copy()
        decimate(points, triangles)
        np.testing.assert_array_equal(points, POINTS)
        np.testing.assert_array_equal(triangles, TRIANGLES)

    def test_takes_any_layout_and_type_of_integer(self):
        wanted = decimate(POINTS, TRIANGLES).points
        for kind in (np.int32, np.uint16, np.int64, np.uint64):
            odd = np.asfortranarray(TRIANGLES.astype(kind))
            np.testing.assert_array_equal(decimate(np.asfortranarray(POINTS), odd).points, wanted)
        np.testing.assert_array_equal(decimate(POINTS.tolist(), TRIANGLES.tolist()).points, wanted)

    def test_single_precision_gives_single_precision(self):
        for precision, given, wanted in (("Default", "f4", "f4"), ("Double", "f4", "f8"), ("Single", "f8", "f4")):
            points = decimate(POINTS.astype(given), TRIANGLES, precision=precision).points
            self.assertEqual(points.dtype, np.dtype(wanted))

    def test_the_number_of_threads_does_not_matter(self):
        one, two = (decimate(POINTS, TRIANGLES, max_error=0.1, threads=count) for count in (1, 2))
        np.testing.assert_array_equal(one.points, two.points)
        np.testing.assert_array_equal(one.triangles, two.triangles)

    def test_tolerances_constrain_points(self):
        tolerances = np.where(POINTS[:, 2] > 0, 0.0, -1.0)
        result = decimate(POINTS, TRIANGLES, tolerances=tolerances, target_reduction=0.4)
        kept = {tuple(point) for point in result.points}
        self.assertTrue(all(tuple(point) in kept for point in POINTS[POINTS[:, 2] > 0]))

    def test_labels_keep_their_lines_and_every_triangle_has_one(self):
        labels = np.where(POINTS[TRIANGLES].mean(axis=1)[:, 2] > 1e-6, 7, -3).astype(np.int16)
        result = decimate(POINTS, TRIANGLES, labels=labels, target_reduction=0.8)
        self.assertEqual((result.labels.shape, result.labels.dtype), ((len(result.triangles),), np.int16))
        self.assertEqual(result.report["labels.count"], 2)
        heights = result.points[result.triangles][:, :, 2]
        line = np.abs(POINTS[np.unique(TRIANGLES[labels == 7]), 2]).min()
        self.assertTrue((heights[result.labels == 7] >= -line - 0.5).all())
        self.assertTrue((heights[result.labels == -3] <= line + 0.5).all())
        plain = decimate(POINTS, TRIANGLES, labels=labels.astype(float), target_reduction=0.8)
        np.testing.assert_array_equal(plain.points, result.points)
        self.assertEqual(decimate(POINTS, TRIANGLES, target_reduction=0.8).labels.size, 0)

    def test_report_is_what_json_takes(self):
        result = decimate(POINTS.astype(np.float32), TRIANGLES, max_error=0.2, diagnose=True, prune_triangles=1)
        certificate = certify((POINTS, TRIANGLES), result)
        levels = bonedecimate.record_levels(POINTS, TRIANGLES, target_triangles=300)
        for report in (result.report, result.units, certificate.report, certificate.units, levels.result.report):
            self.assertEqual(json.loads(json.dumps(report)), report)
            self.assertLessEqual({type(value) for value in report.values()}, {int, float, str})

    def test_every_option_of_the_table_is_a_keyword(self):
        defaults = {key: row.default_text if row.choices else row.default
                    for key, row in table.ROWS.items() if key not in table.unsupported("Arrays")}
        del defaults["target_reduction"]  # setting it is not the same as leaving it
        result, plain = decimate(POINTS, TRIANGLES, **defaults), decimate(POINTS, TRIANGLES)
        np.testing.assert_array_equal(result.points, plain.points)
        self.assertEqual(result.report["options.MaximumError"], "0")


class Rejections(unittest.TestCase):
    def test_wrong_shapes_are_value_errors(self):
        for points, triangles in ((POINTS[:, :2], TRIANGLES), (POINTS, TRIANGLES.ravel()), (POINTS.ravel(), TRIANGLES)):
            with self.assertRaisesRegex(ValueError, "of shape"):
                decimate(points, triangles)
        with self.assertRaisesRegex(ValueError, "one for each"):
            decimate(POINTS, TRIANGLES, tolerances=[0.1])

    def test_indices_that_are_no_integers_are_type_errors(self):
        with self.assertRaisesRegex(TypeError, "integers"):
            decimate(POINTS, TRIANGLES.astype(float))

    def test_surfaces_that_are_none_are_value_errors(self):
        far, broken = TRIANGLES.copy(), POINTS.copy()
        far[5, 1] = 2**40
        broken[3, 1] = np.nan
        with self.assertRaisesRegex(ValueError, "out of range, the first is triangle 5"):
            decimate(POINTS, far)
        with self.assertRaisesRegex(ValueError, "NaN or infinite coordinates, the first is point 3"):
            decimate(broken, TRIANGLES)
        with self.assertRaisesRegex(ValueError, "no triangle"):
            decimate(POINTS, np.empty((0, 3), int))

    def test_nothing_is_no_surface_either(self):
        nothing = np.empty((0, 3)), np.empty((0, 3), int)
        for function in (decimate, bonedecimate.record_levels):
            with self.assertRaisesRegex(ValueError, "the input is empty: no points and no triangles"):
                function(*nothing)
        with self.assertRaisesRegex(ValueError, "no triangle"):
            certify(nothing, nothing)

    def test_unknown_options_are_type_errors_that_name_those_there_are(self):
        for name, rest in (("error", "did you mean 'max_error'"), ("zzz", "there are: mode, target_triangles"), ("n_faces", "did you mean 'target_triangles'"),
                           ("distance_array_name", ": it is about the arrays"), ("pass_arrays", ": it is about the arrays"), ("tolerance_array", ": it is about the arrays")):
            with self.assertRaisesRegex(TypeError, f"no option '{name}' here.*{rest}"):
                decimate(POINTS, TRIANGLES, **{name: 1})

    def test_values_out_of_range_are_value_errors(self):
        for key, value in (("max_error", -1), ("target_reduction", 1.5), ("mode", "Slow"), ("threads", 1.5),
                           ("max_error", float("nan"))):
            with self.assertRaisesRegex(ValueError, "takes"):
                decimate(POINTS, TRIANGLES, **{key: value})

    def test_values_of_the_wrong_kind_are_type_errors(self):
        for key, value in (("max_error", "0.2"), ("mode", 3)):
            with self.assertRaises(TypeError):
                decimate(POINTS, TRIANGLES, **{key: value})


class Running(unittest.TestCase):
    def test_what_was_dealt_with_is_a_warning(self):
        triangles = np.vstack([TRIANGLES, [[5, 5, 6]]])
        with self.assertWarnsRegex(UserWarning, "1 triangle without area was left out") as heard:
            result = decimate(POINTS, triangles)
        self.assertEqual((result.warnings, heard.filename), ([str(heard.warning)], __file__))
        with self.assertWarnsRegex(UserWarning, "1 triangle without area") as heard:
            bonedecimate.record_levels(POINTS, triangles)
        self.assertEqual(heard.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(decimate(POINTS, TRIANGLES).warnings, [])

    def test_surfaces_that_cannot_be_simplified_say_why_and_what_helps(self):
        soup = POINTS[TRIANGLES].reshape(-1, 3) + np.random.default_rng(1).uniform(-1e-5, 1e-5, (3 * len(TRIANGLES), 3))
        cases = {"the surface is double-sided": (POINTS, np.vstack([TRIANGLES, TRIANGLES[:, ::-1]])), "is inside out": (POINTS, TRIANGLES[:, ::-1]),
                 " joins such points, and its movement is part": (soup, np.arange(len(soup)).reshape(-1, 3))}
        for sentence, (points, triangles) in cases.items():
            for run in (decimate, bonedecimate.record_levels):
                with self.assertWarnsRegex(UserWarning, sentence):
                    run(points, triangles)

    def test_progress_rises_to_one(self):
        heard = []
        decimate(POINTS, TRIANGLES, progress=heard.append)
        self.assertEqual((heard, heard[-1]), (sorted(heard), 1.0))
        self.assertGreater(len(heard), 20)

    def test_false_ends_the_run_with_a_valid_surface(self):
        result = decimate(POINTS, TRIANGLES, max_error=0.2, progress=lambda fraction: fraction < 0.3)
        self.assertEqual(result.stop_reason, StopReason.Aborted)
        self.assertLess(result.triangles.max(), len(result.points))

    def test_what_the_progress_function_raises_comes_out(self):
        with self.assertRaises(ZeroDivisionError):
            decimate(POINTS, TRIANGLES, progress=lambda fraction: 1 / 0)
        with self.assertRaises(TypeError):
            decimate(POINTS, TRIANGLES, progress=7)

    def test_other_threads_run_meanwhile(self):
        points, triangles = ball(300, 150)
        turns, end = [], threading.Event()

        def count():
            while not end.wait(0.001):
                turns.append(time.perf_counter())
        thread = threading.Thread(target=count)
        thread.start()
        start = time.perf_counter()
        decimate(points, triangles, threads=1)
        stop = time.perf_counter()
        end.set()
        thread.join()
        during = [turn for turn in turns if start < turn < stop]
        self.assertLess(np.diff([start, *during, stop]).max(), 0.5 * (stop - start))

    def test_ctrl_c_ends_the_run(self):
        """In a process of its own, which hears the signal in the middle of a run that would go on."""
        program = """
import signal
import arrays_test, bonedecimate
signal.signal(signal.SIGINT, signal.default_int_handler)
points, triangles = arrays_test.ball(300, 150)
heard = []
def listen(fraction):
    heard.append(fraction)
    if len(heard) == 5:
        signal.raise_signal(signal.SIGINT)
try:
    bonedecimate.decimate(points, triangles, max_error=0.01, mode="Accurate", progress=listen)
except KeyboardInterrupt:
    print("interrupted after", len(heard))
"""
        here = os.path.dirname(os.path.abspath(__file__))
        done = subprocess.run([sys.executable, "-B", "-c", program], cwd=here, capture_output=True, text=True, timeout=60)
        self.assertRegex(done.stdout, r"^interrupted after [56]$", done.stderr)

    def test_importing_needs_no_vtk(self):
        program = "import sys, bonedecimate; print([name for name in sys.modules if 'vtk' in name.lower()])"
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "[]\n")


if __name__ == "__main__":
    unittest.main()
