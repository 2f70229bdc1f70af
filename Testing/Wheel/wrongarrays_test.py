# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays, meshes and numbers that are none, wherever the wheel takes some: each is rejected by a sentence, none is converted."""

import math
import unittest
from importlib.util import find_spec

import numpy as np

from arrays_test import POINTS, TRIANGLES, ball
from bonedecimate import LabelMap, VoxelGrid, certify, decimate, open_levels, record_levels

HAS_PYVISTA = find_spec("pyvista") is not None
SURFACE = POINTS, TRIANGLES
GRID = VoxelGrid((60, 60, 60), origin=(-30, -30, -30))
LABELS, TOLERANCES = np.zeros(len(TRIANGLES), int), np.full(len(POINTS), 0.2)
NO_NUMBERS = {"complex": lambda array: array.astype(complex), "text": lambda array: array.astype(str),
              "bytes": lambda array: array.astype(bytes), "objects": lambda array: array.astype(object),
              "truths": lambda array: array.astype(bool), "dates": lambda array: np.zeros(array.shape, "datetime64[s]"),
              "masked": lambda array: np.ma.masked_array(array, mask=np.arange(array.size).reshape(array.shape) == 2)}
NO_SURFACES = (None, 3, "bone.stl", POINTS, TRIANGLES, (POINTS,), (POINTS, TRIANGLES, LABELS), {"points": POINTS}, [])


class Arrays(unittest.TestCase):
    def rejects(self, error, words, function, *arguments, **keywords):
        with self.assertRaisesRegex(error, words):
            function(*arguments, **keywords)

    def test_of_what_is_no_number_are_type_errors(self):
        for name, wrong in NO_NUMBERS.items():
            with self.subTest(name):
                words = "masked" if name == "masked" else "numbers, not"
                for function in (decimate, record_levels, lambda *surface: certify(surface, SURFACE)):
                    self.rejects(TypeError, words, function, wrong(POINTS), TRIANGLES)
                    self.rejects(TypeError, words, function, POINTS, wrong(TRIANGLES))
                self.rejects(TypeError, words, decimate, *SURFACE, tolerances=wrong(TOLERANCES))
                self.rejects(TypeError, words, certify, SURFACE, SURFACE, tolerances=wrong(TOLERANCES))
                self.rejects(TypeError, words, decimate, *SURFACE, max_error=0.2, reference=(wrong(POINTS), TRIANGLES))
                pairs = np.stack([LABELS + 1, LABELS], axis=1)
                self.rejects(TypeError, words, decimate, *SURFACE, boundary_labels=wrong(pairs), label_map=GRID)
                self.rejects(TypeError, words, VoxelGrid, wrong(np.full(3, 60)))
                self.rejects(TypeError, words, VoxelGrid, (60, 60, 60), direction=wrong(np.eye(3)))
                if name != "truths":
                    self.rejects(TypeError, words, decimate, *SURFACE, labels=wrong(LABELS))
                    self.rejects(TypeError, words, LabelMap, wrong(np.zeros((3, 3, 3))))

    def test_of_a_wrong_shape_are_value_errors(self):
        for points in (POINTS[:, :2], POINTS.ravel(), POINTS[None], [[0, 0, 0], [1, 0]], np.array(1.0), []):
            self.rejects(ValueError, "points are", decimate, points, TRIANGLES)
        quads = np.hstack([np.full((len(TRIANGLES), 1), 3), TRIANGLES])  # as PyVista has faces
        for triangles in (TRIANGLES[:, :2], TRIANGLES.ravel(), quads, [[0, 1, 2], [1, 2]], []):
            self.rejects(ValueError, "triangles are", decimate, POINTS, triangles)
        for tolerances in (TOLERANCES[:-1], TOLERANCES[:, None], 0.2, [[1], [1, 2]]):
            self.rejects(ValueError, "tolerances are", decimate, *SURFACE, tolerances=tolerances)
            self.rejects(ValueError, "tolerances are", certify, SURFACE, SURFACE, tolerances=tolerances)
        for labels in (LABELS[:-1], LABELS[:, None], 1, np.zeros(len(POINTS), int)):
            self.rejects(ValueError, "labels are", decimate, *SURFACE, labels=labels)

    def test_with_values_out_of_range_are_value_errors_that_name_the_first(self):
        for value in (math.nan, math.inf, -math.inf):
            wrong = TOLERANCES.copy()
            wrong[[7, 9]] = value
            for keywords in ({}, {"max_error": 0.1}):
                self.rejects(ValueError, "2 tolerances are NaN or infinite, the first is that of point 7", decimate, *SURFACE,
                            tolerances=wrong, **keywords)
            self.rejects(ValueError, "the first is that of point 7", certify, SURFACE, SURFACE, tolerances=wrong)
            self.rejects(ValueError, "labels are whole numbers", decimate, *SURFACE, labels=LABELS + value)
            broken = POINTS.copy()
            broken[3, 1] = value
            self.rejects(ValueError, "the first is point 3", decimate, broken, TRIANGLES)
            self.rejects(ValueError, "not finite", certify, SURFACE, (broken, TRIANGLES))
        self.rejects(ValueError, "labels are whole numbers", decimate, *SURFACE, labels=LABELS + 0.5)
        for index in (-1, len(POINTS), 2**31, 2**40, -2**63):
            far = TRIANGLES.astype(np.int64)
            far[5, 1] = index
            self.rejects(ValueError, "out of range, the first is triangle 5", decimate, POINTS, far)
            self.rejects(ValueError, "missing|out of range", certify, (POINTS, far), SURFACE)
        self.rejects(ValueError, "missing|out of range", decimate, POINTS, TRIANGLES.astype(np.uint64) + np.uint64(2**63))

    def test_of_any_layout_are_taken_as_they_are(self):
        wanted = decimate(POINTS, TRIANGLES, tolerances=TOLERANCES, labels=LABELS)
        points, triangles = np.repeat(POINTS, 2, axis=0)[::2], np.asfortranarray(TRIANGLES)[:, ::1]
        sparse = [np.repeat(array, 3)[::3] for array in (TOLERANCES, LABELS)]
        for array in (points, triangles, *sparse):
            array.flags.writeable = False
        kinds = ((points, triangles, *sparse), (points.astype(">f8"), triangles.astype(">i4"), *sparse),
                 (points.astype(np.longdouble), triangles.astype(np.uint16), *(each.tolist() for each in sparse)))
        for points, triangles, tolerances, labels in kinds:
            result = decimate(points, triangles, tolerances=tolerances, labels=labels)
            np.testing.assert_array_equal(result.points, wanted.points)
            np.testing.assert_array_equal(result.triangles, wanted.triangles)
        self.assertEqual(decimate(POINTS.astype(">f4"), TRIANGLES).points.dtype, np.float32)


class Surfaces(unittest.TestCase):
    def test_are_pairs_or_what_decimate_returned(self):
        result = decimate(*SURFACE, max_error=0.2)
        for reference in (SURFACE, list(SURFACE), decimate(*SURFACE, target_reduction=0.0)):
            self.assertEqual(certify(reference, result, tolerance=0.2).status, "proved")

    def test_that_are_none_are_type_errors_that_say_what_is_taken(self):
        for wrong in NO_SURFACES:
            calls = [lambda: certify(wrong, SURFACE), lambda: certify(SURFACE, wrong)]
            if wrong is not None:  # no reference
                calls.append(lambda: decimate(*SURFACE, max_error=0.2, reference=wrong))
            for call in calls:
                with self.assertRaisesRegex(TypeError, r"(reference|result) is a mesh .*, a pair \(points, triangles\)"):
                    call()
        with self.assertRaisesRegex(TypeError, r"reference is .* not an array of shape \(1742, 3\)"):
            certify(POINTS, TRIANGLES)

    @unittest.skipUnless(HAS_PYVISTA, "no PyVista here")
    def test_are_meshes_too(self):
        import pyvista as pv
        mesh = pv.PolyData.from_regular_faces(POINTS, TRIANGLES)
        small = mesh.bone.decimate(max_error=0.2)
        wanted = certify(SURFACE, (small.points, small.regular_faces)).report
        for reference, result in ((mesh, small), (SURFACE, small), (mesh, (small.points, small.regular_faces)),
                                  (mesh, decimate(*SURFACE, max_error=0.2))):
            found = [certify(reference, result).report]
            if reference is mesh:
                found += [mesh.bone.certify(result).report, mesh.bone.distance_to(result).field_data]
            for report in found[:-1]:
                self.assertEqual((report["lower"], report["upper"]), (wanted["lower"], wanted["upper"]))
        levels = record_levels(*SURFACE, target_triangles=300)
        self.assertEqual(len(levels.at(triangles=500, on=mesh)[1]), len(levels.at(triangles=500)[1]))
        for wrong in (mesh.cast_to_unstructured_grid(), pv.MultiBlock([mesh]), *NO_SURFACES):
            for call in (mesh.bone.certify, mesh.bone.distance_to, mesh.bone.plot_error):
                with self.assertRaisesRegex(TypeError, "is a mesh .*, a pair"):
                    call(wrong)
            if wrong is not None:
                with self.assertRaisesRegex(TypeError, "on is a mesh .*, a pair"):
                    levels.at(triangles=500, on=wrong)

    @unittest.skipUnless(HAS_PYVISTA, "no PyVista here")
    def test_of_quads_are_cut_into_triangles_and_of_lines_rejected(self):
        import pyvista as pv
        quads = pv.Plane(i_resolution=20, j_resolution=20, i_size=20, j_size=20)
        self.assertIn(quads.bone.decimate(target_triangles=200).n_cells, (199, 200))
        self.assertLess(certify(quads, quads.triangulate()).upper, 1e-9)
        for empty, words in ((pv.Line(), "no triangle"), (pv.PolyData(), "the input is empty"),
                             (pv.PolyData(POINTS), "no triangle")):
            for call in (empty.bone.decimate, empty.bone.levels, lambda: empty.bone.certify(quads),
                         lambda: quads.bone.certify(empty)):
                with self.assertRaisesRegex(ValueError, f"{words}|has no triangle"):
                    call()


class Numbers(unittest.TestCase):
    def test_of_certificates_are_honored_or_rejected(self):
        never = [math.nan, math.inf, -math.inf, -1, -1e-300, 2**1100, np.float64("nan")]
        kinds = {"tolerance": [*never, 1e31], "relative_gap": [*never, 0, 1.5], "mean_precision": [*never, 0, 1e-5, 1.5],
                 "threads": [*never, 1025, 2**31, 1.5]}
        for name, values in kinds.items():
            for value in values:
                with self.assertRaisesRegex(ValueError, "^(NumberOfThreads|[a-z_]+) takes a .*number from .*, not "):
                    certify(SURFACE, SURFACE, **{name: value})
            for value in ("0.5", 1j, [0.5], True, b"1", np.array([0.5, 1])):
                with self.assertRaisesRegex(TypeError, f"^{name} takes a "):
                    certify(SURFACE, SURFACE, **{name: value})
        for name in ("tight_bounds", "boundaries", "means"):
            for value in ("no", 2, None, 0.5, math.nan, []):
                with self.assertRaisesRegex(TypeError, f"^{name} takes True or False"):
                    certify(SURFACE, SURFACE, **{name: value})

    def test_of_levels_are_honored_or_rejected(self):
        levels = record_levels(*ball(20, 10), target_triangles=50)
        for value in (math.nan, math.inf, -1, -1e-300, 1e31, 2**1100):
            with self.assertRaisesRegex(ValueError, "^error takes a number from 0 to 1e30 mm, not "):
                levels.at(error=value)
        for value in (math.nan, math.inf, -1, 1.5, 2**31, 2**70):
            with self.assertRaisesRegex(ValueError, "^triangles takes a whole number from 0 to 2147483647 triangles, not "):
                levels.at(triangles=value)
        for value in ("0.5", 1j, [100], True, np.array([100, 200])):
            for name in ("error", "triangles"):
                with self.assertRaisesRegex(TypeError, f"^{name} takes a "):
                    levels.at(**{name: value})
        self.assertEqual(len(levels.at(triangles=np.int64(60))[1]), len(levels.at(triangles=60.0)[1]))
        with self.assertRaisesRegex(TypeError, "did you mean|unexpected keyword"):
            levels.at(triangle=60)

    def test_of_logs_are_honored_or_rejected(self):
        for log in (5, "text", None, [1, 2], np.zeros(4, np.uint8)):
            with self.assertRaisesRegex(TypeError, "log is bytes"):
                open_levels(*SURFACE, log)
        log = record_levels(*SURFACE, target_triangles=300).log
        for threads in (-1, 1025, math.nan):
            with self.assertRaisesRegex(ValueError, "^threads takes"):
                open_levels(*SURFACE, log, threads=threads)
        self.assertEqual(open_levels(*SURFACE, bytearray(log)).log, log)

    @unittest.skipUnless(HAS_PYVISTA, "no PyVista here")
    def test_of_plots_and_switches_of_pyvista_are_honored_or_rejected(self):
        import pyvista as pv
        mesh = pv.Sphere(radius=40)
        for value in (math.nan, math.inf, -1, 0):
            with self.assertRaisesRegex(ValueError, "^largest takes a number from 1e-09 to 1e30 mm"):
                mesh.bone.plot_error(mesh, largest=value)
        for value in ("yes", 2, None):
            with self.assertRaisesRegex(TypeError, "with_input takes True or False"):
                mesh.bone.decimate(with_input=value)
        with self.assertRaisesRegex(TypeError, "progress"):
            mesh.bone.decimate(progress_bar="yes")


if __name__ == "__main__":
    unittest.main()
