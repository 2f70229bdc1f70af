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

    def test_labels_of_any_type_and_byte_order_are_those_of_the_mesh(self):
        mesh = pyvista_test.bone()
        labels = np.arange(mesh.n_cells) % 2
        for kind in ("?", ">i4", ">f8", "f2", "g", "u1"):
            result = bonedecimate.decimate(mesh, labels=labels.astype(kind), target_reduction=0.5)
            np.testing.assert_array_equal(np.asarray(result.to_pyvista().cell_data["Labels"], float), np.asarray(result.labels, float), kind)
        mesh.bone.decimate(labels=labels.astype("f2"), target_reduction=0.5)

    def test_a_stopped_comparison_has_no_mesh_of_distances(self):
        mesh = pyvista_test.bone()
        with self.assertRaisesRegex(bonedecimate.Aborted, "the comparison was stopped"):
            mesh.bone.distance_to(mesh, progress=lambda fraction: False)

    def test_a_profile_without_its_error_is_no_target(self):
        with self.assertRaisesRegex(ValueError, "max_error=0 sets no limit"):
            bonedecimate.decimate(pyvista_test.bone(), profile="planning", max_error=0)
        mesh = pyvista_test.bone()
        self.assertEqual(bonedecimate.smooth(mesh.points, mesh.regular_faces, 0.1, max_error=0).triangles.shape, mesh.regular_faces.shape)

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
            lines = str(report).splitlines()
            self.assertEqual(lines[0].split(maxsplit=1), ["proof.sentence", report["proof.sentence"]])
            (line,) = [line for line in lines if line.startswith("proof.upper ")]
            name, printed, unit = line.split()
            self.assertEqual((name, unit), ("proof.upper", "mm"))
            self.assertGreaterEqual(float(printed), report["proof.upper"])  # rounded up
            self.assertAlmostEqual(float(printed), report["proof.upper"], delta=1e-6)
            options = [name for name in report if name.startswith("options.")]
            self.assertEqual(lines[-1].split(), ["options.*", str(len(options)), "more"])
            filled = [name for name, value in report.items() if value != ""]
            self.assertLess(len(filled), len(report))
            self.assertEqual(len(lines), len([name for name in filled if name not in options]) + 1)
            rows = re.findall("<tr>", report._repr_html_())
            self.assertEqual(len(rows), len(filled))
            self.assertEqual(pickle.loads(pickle.dumps(report)).units, report.units)

    def test_of_meshes_without_a_report_or_its_proof_say_why(self):
        mesh = pyvista_test.bone()
        with self.assertRaisesRegex(KeyError, "this mesh has no report: no run made it"):
            mesh.bone.report["proof.upper"]
        small = mesh.bone.decimate(max_error=0.5)
        small.points *= 1.01
        with self.assertRaisesRegex(KeyError, "no entry 'proof.upper': nothing is proved of this surface: .* was changed afterwards"):
            small.bone.report["proof.upper"]

    def test_plots_the_error_up_to_the_number_that_it_names(self):
        mesh = pyvista_test.bone()
        small = mesh.bone.decimate(max_error=0.5)
        with mock.patch.object(pv.PolyData, "plot", lambda self, **settings: settings):
            settings = mesh.bone.plot_error(small)
        bound = float(re.search(r"at most\n(.*) mm,\nproved", settings["scalar_bar_args"]["title"])[1])
        self.assertEqual(settings["clim"], (-bound, bound))
        self.assertTrue(0 <= bound - mesh.bone.certify(small).upper < 1e-4)

    def test_plots_the_bar_of_colors_beside_the_surface(self):
        mesh = pv.Cylinder(radius=12, height=40, direction=(0, 0, 1), resolution=60).triangulate().clean()
        small = mesh.bone.decimate(max_error=0.5)
        for size in ((700, 500), (400, 300)):
            kept = {"window_size": size, "screenshot": True, "return_img": True, "show_axes": False}
            whole = mesh.bone.plot_error(small, **kept)[..., :3].astype(int)
            surface = mesh.bone.plot_error(small, **kept, show_scalar_bar=False)[..., :3].astype(int)
            is_surface, is_bar = (surface != surface[0, 0]).any(axis=2), (whole != surface).any(axis=2)
            self.assertGreater(is_bar.mean(), 0.01)
            self.assertFalse((is_surface & is_bar).any())

    def test_images_say_what_is_wrong_with_which_array(self):
        image = pyvista_test.LabelMaps.image()
        for name in ("decimate", "smooth", "certify"):
            with self.assertRaisesRegex(AttributeError, f"no bone.{name}: first make its surfaces, image.bone.surfaces...bone.{name}"):
                getattr(image.bone, name)
        with self.assertRaisesRegex(AttributeError, "no bone.nonsense$"):
            image.bone.nonsense
        image.point_data["HU"] = np.arange(image.n_points) / 2
        image.point_data["zeros"] = np.zeros(image.n_points, int)
        for scalars, keywords, words in (("HU", {}, "whole numbers; some have a fraction"), ("zeros", {}, "the label map has no label"),
                                         ("segments", {"labels": [9]}, "no voxel has label 9")):
            with self.assertRaisesRegex(ValueError, f"^array '{scalars}': .*{words}"):
                image.bone.surfaces(scalars, **keywords)

    def test_accessors_have_types(self):
        stub = (pathlib.Path(bonedecimate.__file__).parent / "pyvista_accessor.pyi").read_text(encoding="utf-8")
        classes = [node for node in ast.parse(stub).body if isinstance(node, ast.ClassDef)]
        self.assertEqual([node.decorator_list for node in classes], [[]] * len(classes))  # a decorator would hide the type
        self.assertIs(type(pyvista_test.bone().bone), bonedecimate.BoneAccessor)


if __name__ == "__main__":
    unittest.main()
