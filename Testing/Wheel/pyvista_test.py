# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""`mesh.bone` of PyVista, the notebook, and the programs that the documentation prints."""

import ast
import importlib.metadata
import inspect
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import warnings
from contextlib import redirect_stderr, redirect_stdout

import numpy as np
import pyvista as pv

import bonedecimate

SOURCE = pathlib.Path(os.environ["SOURCE_DIR"])
pv.OFF_SCREEN = True


def bone(resolution=80):
    return pv.Sphere(radius=40, theta_resolution=resolution, phi_resolution=resolution)


class Accessor(unittest.TestCase):
    def test_levels_are_those_of_one_run(self):
        levels = bone().bone.levels(target_triangles=400)
        self.assertEqual(levels.at(triangles=400).n_cells, 400)
        finer = levels.at(error=float(levels.marks[0, 1]))
        self.assertEqual(finer.n_cells, int(levels.marks[0, 0]))
        self.assertLess(finer.bone.distance_to(bone())["SignedDistance"].max(), 2 * levels.marks[0, 1] + 1e-9)

    def test_is_found_without_an_import(self):
        program = """
import sys, pyvista
assert not any(name.startswith("bonedecimate") for name in sys.modules)
print(pyvista.Sphere().bone.decimate(target_triangles=200).n_cells)
"""
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "200\n")

    def test_decimates_and_carries_arrays_over(self):
        mesh = bone()
        mesh["density"] = mesh.points[:, 2]
        small = mesh.bone.decimate(max_error=0.2)
        self.assertIsInstance(small, pv.PolyData)
        self.assertLess(small.n_cells, mesh.n_cells / 3)
        self.assertLessEqual(small.bone.report["proof.upper"], 0.2)
        self.assertEqual(small.bone.report["stop_reason"], "error_reached")
        np.testing.assert_allclose(small["density"], small.points[:, 2], atol=0.3)
        self.assertEqual(mesh.bone.report, {})

    def test_raises_what_a_python_user_expects(self):
        with self.assertRaises(TypeError):
            bone().bone.decimate(error=0.2)
        with self.assertRaises(ValueError):
            bone().bone.decimate(max_error=-1)
        broken = bone()
        broken.points[3] = np.nan
        with self.assertRaisesRegex(ValueError, "the first is point 3"):
            broken.bone.decimate()
        with self.assertRaisesRegex(ValueError, "no point array 'nonsense' of one component .there are: "):
            bone().bone.decimate(tolerance_array="nonsense")

    def test_report_is_what_json_takes(self):
        mesh = bone()
        small = mesh.bone.decimate(max_error=0.2, diagnose=True)
        report = small.bone.report
        self.assertEqual(json.loads(json.dumps(report)), report)
        self.assertEqual({type(value) for value in report.values()}, {int, float, str})
        numbers = bonedecimate.decimate(mesh.points, mesh.regular_faces, max_error=0.2, diagnose=True).report
        self.assertEqual({name: value for name, value in report.items() if "seconds." not in name and "options." not in name},
                         {name: value for name, value in numbers.items() if "seconds." not in name and "options." not in name})

    def test_takes_tolerances_labels_and_a_reference_as_numpy_does(self):
        mesh = bone(40)
        points, triangles = mesh.points, mesh.regular_faces
        tolerances = np.where(points[:, 2] > 0, 0.0, 0.3)
        labels = (mesh.cell_centers().points[:, 0] > 0).astype(int)
        first = mesh.bone.decimate(max_error=0.1)
        given = {"tolerances": {"tolerances": tolerances}, "labels": {"labels": labels, "target_reduction": 0.7}}
        for name, keywords in given.items():
            small, wanted = mesh.bone.decimate(**keywords), bonedecimate.decimate(points, triangles, **keywords)
            np.testing.assert_array_equal(small.points, wanted.points, name)
            np.testing.assert_array_equal(small.regular_faces, wanted.triangles, name)
            if name == "labels":
                np.testing.assert_array_equal(small["Labels"], wanted.labels)
        self.assertEqual(mesh.array_names, bone(40).array_names)
        for reference in (mesh, (points, triangles)):
            again = first.bone.decimate(max_error=0.3, reference=reference)
            self.assertLessEqual(again.bone.report["proof.upper"], 0.3)
            self.assertEqual(again.bone.report["reference.triangles"], mesh.n_cells)
            numbers = bonedecimate.decimate(first.points, first.regular_faces, max_error=0.3, reference=reference)
            np.testing.assert_array_equal(again.points, numbers.points)
        mesh["Tolerance"] = tolerances
        mesh.cell_data["Part"] = labels
        np.testing.assert_array_equal(mesh.bone.decimate(tolerance_array="Tolerance").points,
                                      mesh.bone.decimate(tolerances=tolerances).points)
        np.testing.assert_array_equal(mesh.bone.decimate(labels="Part", target_reduction=0.7)["Part"],
                                      mesh.bone.decimate(labels=labels, target_reduction=0.7)["Labels"])
        with self.assertRaisesRegex(ValueError, "not both"):
            mesh.bone.decimate(tolerances=tolerances, tolerance_array="Tolerance")

    def test_takes_edge_lengths_as_an_array_or_by_name(self):
        mesh = bone(40)
        middle, width = mesh.center[0], mesh.length
        sizes = np.where(mesh.points[:, 0] < middle, 0.02, 0.06) * width
        options = {"max_error": 0.01 * width, "edge_length": 0.06 * width, "mode": "Fast"}
        fine = mesh.bone.decimate(edge_lengths=sizes, **options)
        left = (fine.points[:, 0] < middle).sum()
        self.assertGreater(left, 1.5 * (fine.n_points - left))
        self.assertLessEqual(fine.bone.report["proof.upper"], 0.01 * width)
        mesh["Size"] = sizes
        np.testing.assert_array_equal(mesh.bone.decimate(edge_length_array="Size", **options).points, fine.points)
        numbers = bonedecimate.decimate(mesh.points, mesh.regular_faces, edge_lengths=sizes, **options)
        np.testing.assert_array_equal(numbers.points, fine.points)
        with self.assertRaisesRegex(ValueError, "not both"):
            mesh.bone.decimate(edge_lengths=sizes, edge_length_array="Size", **options)
        with self.assertRaisesRegex(ValueError, "edge_lengths need edge_length"):
            mesh.bone.decimate(edge_lengths=sizes, max_error=0.2)
        with self.assertRaisesRegex(ValueError, "edge length"):
            bonedecimate.decimate(mesh.points, mesh.regular_faces, edge_lengths=0.0 * sizes, **options)
        curved = mesh.bone.decimate(chordal_error=0.001 * width, **options)
        self.assertLess(curved.bone.report["edges.least_requested"], options["edge_length"])
    def test_caps_boundaries_at_planes(self):
        tube = pv.Cylinder(radius=10.0, height=30.0, resolution=24, capping=False).triangulate().clean()
        tube.cell_data["Part"] = np.arange(tube.n_cells)
        tube.point_data["Number"] = np.arange(tube.n_points)
        closed = tube.bone.cap()
        self.assertEqual((tube.n_open_edges, closed.n_open_edges), (48, 0))
        self.assertTrue(closed.is_manifold)
        np.testing.assert_array_equal(closed.points, tube.points)
        np.testing.assert_array_equal(closed.regular_faces[:tube.n_cells], tube.regular_faces)
        np.testing.assert_array_equal(closed["Number"], tube["Number"])
        is_cap = closed["BoneCap"] == 1
        np.testing.assert_array_equal(np.flatnonzero(is_cap), np.arange(tube.n_cells, tube.n_cells + 2 * 22))
        self.assertTrue(np.isin(closed["Part"][is_cap], tube["Part"]).all())
        self.assertAlmostEqual(closed.volume, 30.0 * 12.0 * 100.0 * np.sin(np.pi / 12.0), delta=0.1)
        self.assertLessEqual(closed.bone.decimate(max_error=0.2).bone.report["proof.upper"], 0.2)
        np.testing.assert_array_equal(closed.bone.cap()["BoneCap"], np.zeros(closed.n_cells))

    def test_leaves_other_boundaries_open_unless_all_are_requested(self):
        dome = pv.Sphere(radius=10.0).clip("x", origin=(4.0, 0.0, 0.0), invert=True).triangulate().clean()
        bent = dome.copy()
        bent.points[:, 0] += 0.05 * bent.points[:, 1] ** 2
        with self.assertWarnsRegex(Warning, "1 boundaries stay open"):
            self.assertEqual(bent.bone.cap().n_cells, bent.n_cells)
        self.assertEqual(bent.bone.cap("all").n_open_edges, 0)
        for wrong in ({"loops": "none"}, {"plane_tolerance": -1.0}):
            with self.assertRaises(ValueError):
                bent.bone.cap(**wrong)

    def test_returns_the_input_with_its_distances_on_request(self):
        mesh = bone(40)
        small, measured = mesh.bone.decimate(max_error=0.2, measure_input_distances=True, maps=True, with_input=True)
        self.assertEqual(measured.n_points, mesh.n_points)
        self.assertLessEqual(measured["DistanceToResult"].max(), 0.2)
        self.assertLess(measured["ResultPointIds"].max(), small.n_points)
        self.assertNotIn("DistanceToResult", mesh.array_names)
        with self.assertRaisesRegex(ValueError, "with_input=True"):
            mesh.bone.decimate(measure_input_distances=True)

    def test_levels_open_again_and_go_onto_another_bone(self):
        levels = bone(40).bone.levels(target_triangles=400)
        again = bone(40).bone.open_levels(levels.log)
        np.testing.assert_array_equal(again.at(triangles=800).points, levels.at(triangles=800).points)
        other = bone(40)
        other.points *= 2
        np.testing.assert_allclose(again.at(triangles=800, on=other).points, 2 * again.at(triangles=800).points, atol=1e-4)

    def test_what_is_left_out_is_a_warning(self):
        mesh = bone(40)
        mesh.lines = [2, 0, 1]
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(mesh.bone.decimate().n_lines, 1)
        mesh = pv.PolyData(mesh.points, np.concatenate([mesh.faces, [2, 0, 1]]))
        other = bone(40)
        for run in (mesh.bone.decimate, mesh.bone.levels, lambda: mesh.bone.certify(other), lambda: other.bone.certify(mesh),
                    lambda: other.bone.decimate(max_error=1, reference=mesh)):
            with self.assertWarnsRegex(UserWarning, "1 polygon of fewer than three different corners was left out") as heard:
                run()
            self.assertIn(heard.filename, (__file__, inspect.getfile(type(mesh.bone))))

    def test_measures_distances(self):
        mesh = bone()
        small = mesh.bone.decimate(max_error=0.2)
        measured = mesh.bone.distance_to(small)
        self.assertLessEqual(np.abs(measured["SignedDistance"]).max(), 0.2)
        self.assertEqual(set(measured["Side"]) - {-1, 0, 1}, set())
        self.assertNotIn("SignedDistance", mesh.point_data)
        upper = measured.field_data["bonedecimate.certificate.upper"][0]
        self.assertLessEqual(np.abs(measured["SignedDistance"]).max(), upper)
        self.assertEqual(mesh.bone.certify(small, tolerance=0.2).status, "proved")

    def test_plots_the_error(self):
        mesh = bone()
        picture = mesh.bone.plot_error(mesh.bone.decimate(max_error=0.5), screenshot=True, return_img=True)
        self.assertGreater(np.asarray(picture).std(), 10)

    def test_draws_a_bar_on_request(self):
        said = io.StringIO()
        with redirect_stderr(said):
            bone().bone.decimate(progress_bar=True)
        self.assertIn("100%", said.getvalue())


class Documentation(unittest.TestCase):
    def run_blocks(self, blocks):
        """In one go, as a reader does, in a folder of their own."""
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder, redirect_stdout(io.StringIO()) as said:
            os.chdir(folder)
            try:
                names = {}
                for block in blocks:
                    exec(compile(block, "block", "exec"), names)
            finally:
                os.chdir(here)
        return names, said.getvalue()

    def test_notebook_runs(self):
        notebook = json.loads((SOURCE / "Documentation" / "tutorials" / "bonedecimate.ipynb").read_text(encoding="utf-8"))
        cells = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
        names, said = self.run_blocks(cells)
        self.assertLessEqual(names["small"].bone.report["proof.upper"], 0.2)
        self.assertIn("proved", said)

    def test_printed_programs_run(self):
        page = (SOURCE / "Documentation" / "how-to" / "python.md").read_text(encoding="utf-8")
        names, said = self.run_blocks(re.findall(r"```python\n(.*?)```", page, re.DOTALL))
        self.assertIn("2000 triangles", said)
        self.assertLessEqual(names["small"].report["proof.upper"], 0.2)


class LabelMaps(unittest.TestCase):
    @staticmethod
    def image():
        """Labels 2 and 7: the halves of a ball, turned, with an extent that does not begin at 0."""
        z, y, x = np.indices((12, 12, 12))
        labels = np.where((x - 5.5) ** 2 + (y - 5.5) ** 2 + (z - 5.5) ** 2 < 20, np.where(x < 6, 2, 7), 0)
        image = pv.ImageData(spacing=(0.5, 0.5, 1.0), origin=(10, 20, 30))
        image.extent = (3, 14, 0, 11, -2, 9)
        image.direction_matrix = np.array([[0, 1, 0], [1, 0, 0], [0, 0, 1]])
        image.point_data["segments"] = labels.astype(np.uint8).ravel()
        return image

    def test_become_a_mesh_with_common_walls(self):
        mesh = self.image().bone.surfaces()
        self.assertEqual({tuple(pair) for pair in mesh.cell_data["BoundaryLabels"].tolist()}, {(2, 0), (7, 0), (2, 7)})
        self.assertEqual(mesh.field_data["LabelValues"].tolist(), [2, 7, 0])
        # With both halves in one label, their common wall is gone, and the mesh is where the image has it.
        image = self.image()
        image.point_data["bone"] = (image.point_data["segments"] > 0).astype(np.uint8)
        whole = image.bone.surfaces("bone")
        voxels = image.points[image.point_data["bone"] > 0]
        self.assertTrue(whole.is_manifold)
        self.assertGreater(whole.volume, 0)
        half = image.direction_matrix @ np.array(image.spacing) / 2
        np.testing.assert_allclose(whole.points.min(axis=0), voxels.min(axis=0) - half)
        np.testing.assert_allclose(whole.points.max(axis=0), voxels.max(axis=0) + half)

    def test_are_decimated_with_their_walls(self):
        mesh = self.image().bone.surfaces(threads=1)
        small = mesh.bone.decimate(target_reduction=0.4, labels="BoundaryLabels")
        self.assertEqual({tuple(pair) for pair in small.cell_data["BoundaryLabels"].tolist()}, {(2, 0), (7, 0), (2, 7)})
        for label in (2, 7):
            points, triangles = bonedecimate.extract_label(
                small.points, small.regular_faces, small.cell_data["BoundaryLabels"], label)
            self.assertTrue(pv.PolyData.from_regular_faces(points, triangles).is_manifold)

    def test_lose_islands_on_request(self):
        image = self.image()
        image.point_data["segments"][0] = 7
        cleaned, changes = image.bone.change_pieces(island_volume=0.3, cavity_volume=1)
        np.testing.assert_array_equal(cleaned.point_data["segments"], self.image().point_data["segments"])
        self.assertEqual((image.point_data["segments"][0], changes[7].islands, changes[2].islands), (7, 1, 0))
        self.assertEqual((cleaned.extent, cleaned.origin), (image.extent, image.origin))

    def test_are_kept_voxel_by_voxel(self):
        image, mesh = self.image(), self.image().bone.surfaces()
        small = mesh.bone.decimate(target_reduction=0.9)
        self.assertEqual((small.bone.report["voxels.guard"], small.bone.report["voxels.changed"]), ("on", 0))
        numbers = bonedecimate.decimate(bonedecimate.extract_surfaces(image), target_reduction=0.9)
        for other in (numbers, bonedecimate.decimate(mesh, target_reduction=0.9)):
            np.testing.assert_array_equal(small.points, other.points)
            np.testing.assert_array_equal(small.cell_data["BoundaryLabels"], other.boundary_labels)
        self.assertNotIn("GridPoint", small.point_data)
        smoothed = mesh.bone.smooth()
        self.assertEqual((smoothed.bone.report["smoothing.in_voxels"], smoothed.bone.report["voxels.changed"]), (1, 0))
        again = smoothed.bone.decimate(keep_voxels="On")
        self.assertEqual([each.bone.check_voxels(image).changed for each in (mesh, small, smoothed, again)], [0, 0, 0, 0])
        coarse = mesh.bone.decimate(target_reduction=0.9, keep_voxels="Off")
        changes = coarse.bone.check_voxels(image)
        self.assertGreater(changes.changed, 0)
        self.assertEqual(changes.changed, coarse.bone.report["voxels.changed"])
        self.assertEqual(mesh.bone.certify(coarse, label_map=image).voxels.of_label, changes.of_label)
        with self.assertRaisesRegex(ValueError, "levels do not keep voxels"):
            mesh.bone.levels()

    def test_are_kept_by_meshes_of_other_filters(self):
        image = pv.ImageData(dimensions=(12, 12, 12), spacing=(0.5, 0.5, 1.0), origin=(10, 20, 30))
        image.point_data["bone"] = (self.image().point_data["segments"] > 0).astype(np.uint8)
        image.set_active_scalars("bone")
        mesh = image.contour([0.5], scalars="bone")
        self.assertEqual(mesh.bone.check_voxels(image).changed, 0)
        small = mesh.bone.decimate(label_map=image, target_reduction=0.9)
        self.assertEqual((small.bone.report["voxels.guard"], small.bone.check_voxels(image).changed), ("on", 0))
        self.assertNotIn("VoxelGridOrigin", mesh.field_data)
        with self.assertWarnsRegex(UserWarning, "differ in"):
            mesh.translate((1, 0, 0)).bone.decimate(label_map=image)
        with self.assertRaisesRegex(ValueError, "need a voxel grid"):
            mesh.bone.decimate(boundary_labels=np.tile([1, 0], (mesh.n_cells, 1)))
        pairs = np.tile([4, 0], (mesh.n_cells, 1))
        small = mesh.bone.decimate(boundary_labels=pairs, label_map=bonedecimate.extract_surfaces(image).grid)
        self.assertEqual(set(map(tuple, small.cell_data["BoundaryLabels"].tolist())), {(4, 0)})

    def test_without_a_grid_give_it_by_the_image(self):
        mesh = self.image().bone.surfaces()
        small = mesh.bone.decimate(target_reduction=0.9)
        for name in list(mesh.field_data):
            mesh.field_data.remove(name)
        mesh.point_data.remove("GridPoint")
        self.assertEqual(mesh.bone.check_voxels(self.image()).of_label, small.bone.check_voxels(self.image()).of_label)
        again = mesh.bone.decimate(label_map=self.image(), target_reduction=0.9)
        np.testing.assert_array_equal(again.points, small.points)
        numbers = bonedecimate.decimate(mesh, label_map=self.image(), target_reduction=0.9)
        np.testing.assert_array_equal(numbers.boundary_labels, small.cell_data["BoundaryLabels"])
        self.assertNotIn("voxels.changed", mesh.bone.decimate().bone.report)
        self.assertIsNone(bonedecimate.decimate(mesh).grid)

    def test_with_wrong_arrays_are_value_errors(self):
        for data, name, values, words in (
                ("field_data", "VoxelGridSpacing", [[1.0, 0, 1]], "not positive"),
                ("field_data", "VoxelGridOrigin", [[1.0, np.nan, 1]], "not finite"),
                ("field_data", "VoxelGridDirection", [[1.0] * 9], "unit vectors"),
                ("field_data", "VoxelGridDimensions", [[1, 2]], "number of components"),
                ("field_data", "LabelValues", [7, 2, 0], "ascending order"),
                ("field_data", "LabelValues", [2, 0], "not one of LabelValues")):
            mesh = self.image().bone.surfaces()
            getattr(mesh, data)[name] = values
            for run in (mesh.bone.decimate, mesh.bone.smooth, lambda: mesh.bone.check_voxels(self.image())):
                with self.subTest(name), self.assertRaisesRegex(ValueError, words):
                    run()
        mesh = self.image().bone.surfaces()
        mesh.cell_data["BoundaryLabels"] = mesh.cell_data["BoundaryLabels"][:, 0].copy()
        with self.assertRaisesRegex(ValueError, "BoundaryLabels does not have the number of components"):
            mesh.bone.decimate()

    def test_need_an_array(self):
        of_cells = pv.ImageData(dimensions=(3, 3, 3))
        of_cells.cell_data["labels"] = np.ones(8, np.uint8)
        for image, name, problem in ((self.image(), "other", "no point array 'other' .there are: 'segments'."), (pv.ImageData(dimensions=(3, 3, 3)), None, "has no labels"),
                                     (of_cells, None, "these are cell data: 'labels'"), (of_cells, "labels", "these are cell data: 'labels'")):
            with self.assertRaisesRegex(ValueError, problem):
                image.bone.surfaces(name)


class Package(unittest.TestCase):
    def test_is_typed_and_its_stubs_know_every_option(self):
        from bonedecimate import levels
        from bonedecimate.options import ROWS
        folder = pathlib.Path(bonedecimate.__file__).parent
        self.assertTrue((folder / "py.typed").exists())
        stubs = {path.stem: path.read_text(encoding="utf-8") for path in folder.glob("*.pyi")}
        self.assertEqual(set(stubs), {"_core", "_keywords", "arrays", "label_maps", "levels", "pyvista_accessor", "vtk_filter"})
        for name, text in stubs.items():
            compile(text, name + ".pyi", "exec")
        for key, row in ROWS.items():
            if key != "labels":  # a parameter of its own
                self.assertIn(f"    {key}: ", stubs["_keywords"])
            self.assertIn(f"def Set{row.name}(self, value: ", stubs["vtk_filter"])
        for name, owner in (("arrays", bonedecimate), ("levels", levels.Levels), ("levels", levels),
                            ("pyvista_accessor", type(bone().bone))):
            owned = ast.parse(stubs[name])
            for node in ast.walk(owned):
                if isinstance(node, ast.FunctionDef) and not node.name.startswith("_") and inspect.isfunction(
                        getattr(owner, node.name, None)):
                    with self.subTest(f"{name}.{node.name}"):
                        written = [each.arg for each in node.args.args + node.args.kwonlyargs]
                        written += [node.args.kwarg.arg] if node.args.kwarg else []
                        self.assertEqual(written, list(inspect.signature(getattr(owner, node.name)).parameters))

    def test_version_is_that_of_the_project(self):
        self.assertEqual(bonedecimate.__version__, importlib.metadata.version("bonedecimate"))


if __name__ == "__main__":
    unittest.main()
