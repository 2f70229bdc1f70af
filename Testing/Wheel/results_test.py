# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of arrays as meshes and files, and reports as tables."""

import ast
import pathlib
import pickle
import re
import tempfile
import unittest
from unittest import mock

import numpy as np
import pyvista as pv

import bonedecimate
import pyvista_test  # its specimens
from bonedecimate.report import number_text


class Results(unittest.TestCase):
    def test_become_the_mesh_that_the_accessor_returns(self):
        mesh = pyvista_test.bone()
        options = {"max_error": 0.5, "labels": np.arange(mesh.n_cells) % 2, "maps": True}
        numbers, small = bonedecimate.decimate(mesh, **options), mesh.bone.decimate(**options)
        made = numbers.to_pyvista()
        np.testing.assert_array_equal(made.points, small.points)
        np.testing.assert_array_equal(made.regular_faces, small.regular_faces)
        self.assertEqual(set(made.array_names) ^ set(small.array_names), set(mesh.point_data) & set(small.point_data))
        for name in set(made.array_names) & set(small.array_names):
            np.testing.assert_array_equal(made[name], small[name]) if not name.startswith("BoneDecimate") else None
        self.assertEqual(made.bone.report["proof.status"], "proved")
        made.points *= 1.01
        self.assertNotIn("proof.status", made.bone.report)

    def test_of_a_stopped_comparison_are_the_bounds_proved_until_then(self):
        mesh = pyvista_test.bone()
        original = np.asarray(mesh.points), mesh.regular_faces
        pair = original, bonedecimate.decimate(*original, max_error=0.5)
        whole = bonedecimate.certify(*pair, tolerance=1000.0)
        self.assertFalse(whole.stopped)
        for end in (0.0, 0.3, 0.6, 0.9):
            stopped = bonedecimate.certify(*pair, tolerance=1000.0, progress=lambda fraction, end=end: fraction < end)
            self.assertEqual((stopped.stopped, stopped.status), (True, "proved"))
            self.assertLessEqual(stopped.lower, whole.upper)
            self.assertGreaterEqual(stopped.upper, whole.lower)
            self.assertEqual(stopped.report["stopped"], "stopped: bounds proved so far")

    def test_wrong_keywords_are_told_what_was_meant(self):
        bone = pyvista_test.bone
        with self.assertRaisesRegex(TypeError, "decimate takes keywords: target_reduction=0.9"):
            bone().bone.decimate(0.9)
        for word in ("n_triangles", "target_count"):
            with self.assertRaisesRegex(TypeError, f"no option '{word}' here .did you mean 'target_triangles'..$"):
                bone().bone.decimate(**{word: 500})
        with self.assertRaisesRegex(TypeError, "tolerance_array names one of the mesh"):
            bone().bone.decimate(max_error=0.5, tolerances="nonsense")
        with self.assertRaisesRegex(ValueError, "max_error is one for all"):
            bone().bone.decimate(tolerances=0.2)

    def test_a_run_that_was_ended_is_told(self):
        with self.assertWarnsRegex(UserWarning, "ended the run: the mesh is decimated in part"):
            pyvista_test.bone().bone.decimate(max_error=0.5, progress_bar=lambda fraction: fraction < 0.3)

    def test_certificates_are_neither_true_nor_false(self):
        mesh = pyvista_test.bone()
        certificate = mesh.bone.certify(mesh)
        self.assertRegex(repr(certificate), "0 to .* mm, proved; no tolerance to compare with>")
        with self.assertRaisesRegex(TypeError, 'certificate.status == "proved"'):
            bool(certificate)

    def test_keep_the_label_map(self):
        found = bonedecimate.extract_surfaces(pyvista_test.LabelMaps.image())
        small = bonedecimate.decimate(found, target_reduction=0.5)
        np.testing.assert_array_equal(small.to_pyvista().cell_data["BoundaryLabels"], small.boundary_labels)
        again = small.to_pyvista().bone.check_voxels(pyvista_test.LabelMaps.image())
        self.assertEqual(again.changed, small.report["voxels.changed"])

    def test_are_saved_with_what_the_format_holds(self):
        result = bonedecimate.decimate(pyvista_test.bone(), max_error=0.5)
        with tempfile.TemporaryDirectory() as folder:
            for ending, has_report in (("vtp", True), ("vtk", True), ("stl", False), ("ply", False), ("obj", False)):
                path = pathlib.Path(folder) / f"small.{ending}"
                result.save(path)
                read = pv.read(path)
                self.assertEqual((read.n_cells, "proof.status" in read.bone.report), (len(result.triangles), has_report), ending)
            with self.assertRaisesRegex(OSError, "no format has that ending"):
                result.save(pathlib.Path(folder) / "small.xyz")
            with self.assertRaisesRegex(FileNotFoundError, "the folder does not exist"):
                result.save(pathlib.Path(folder) / "nothing" / "small.vtp")
            double = bonedecimate.decimate(result.points.astype(np.float64) + 1e-9, result.triangles)
            with self.assertRaisesRegex(ValueError, "single precision"):
                double.save(pathlib.Path(folder) / "small.stl")

    def test_reports_are_tables_and_know_what_was_meant(self):
        for report in (bonedecimate.decimate(pyvista_test.bone(), max_error=0.5).report, pyvista_test.bone().bone.decimate(max_error=0.5).bone.report):
            with self.assertRaisesRegex(KeyError, "no entry 'proof.uper'; did you mean 'proof.upper'"):
                report["proof.uper"]
            self.assertEqual(report.units["proof.upper"], "mm")
            (line,) = [line for line in str(report).splitlines() if line.startswith("proof.upper ")]
            self.assertEqual(line.split(), ["proof.upper", number_text(report["proof.upper"]), "mm"])
            options = [name for name in report if name.startswith("options.")]
            self.assertEqual(str(report).splitlines()[-1].split(), ["options.*", str(len(options)), "more"])
            self.assertEqual(len(str(report).splitlines()), len(report) - len(options) + 1)
            rows = re.findall("<tr>", report._repr_html_())
            self.assertEqual(len(rows), len(report))
            self.assertEqual(pickle.loads(pickle.dumps(report)).units, report.units)

    def test_plots_the_error_up_to_the_number_that_it_names(self):
        mesh = pyvista_test.bone()
        small = mesh.bone.decimate(max_error=0.5)
        with mock.patch.object(pv.PolyData, "plot", lambda self, **settings: settings):
            settings = mesh.bone.plot_error(small)
        bound = float(re.match(r"at most (.*) mm, proved", settings["text"])[1])
        self.assertEqual(settings["clim"], (-bound, bound))
        self.assertTrue(0 <= bound - mesh.bone.certify(small).upper < 1e-4)

    def test_accessors_have_types(self):
        stub = (pathlib.Path(bonedecimate.__file__).parent / "pyvista_accessor.pyi").read_text(encoding="utf-8")
        classes = [node for node in ast.parse(stub).body if isinstance(node, ast.ClassDef)]
        self.assertEqual([node.decorator_list for node in classes], [[]] * len(classes))  # a decorator would hide the type
        self.assertIs(type(pyvista_test.bone().bone), bonedecimate.BoneAccessor)


if __name__ == "__main__":
    unittest.main()
