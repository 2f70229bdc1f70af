# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""`mesh.bone` of PyVista, the notebook, and the programs that the documentation prints."""

import importlib.metadata
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


def bone():
    return pv.Sphere(radius=40, theta_resolution=80, phi_resolution=80)


class Accessor(unittest.TestCase):
    def test_levels_are_those_of_one_run(self):
        levels = bone().bone.levels(target_faces=400)
        self.assertEqual(levels.at(triangles=400).n_cells, 400)
        finer = levels.at(error=float(levels.marks[0, 1]))
        self.assertEqual(finer.n_cells, int(levels.marks[0, 0]))
        self.assertLess(finer.bone.distance_to(bone())["SignedDistance"].max(), 2 * levels.marks[0, 1] + 1e-9)

    def test_is_found_without_an_import(self):
        program = """
import sys, pyvista
assert not any(name.startswith("bonedecimate") for name in sys.modules)
print(pyvista.Sphere().bone.decimate(target_faces=200).n_cells)
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
        with self.assertRaisesRegex(ValueError, "no point array 'nonsense'"):
            bone().bone.decimate(tolerance_array="nonsense")

    def test_what_is_left_out_is_a_warning(self):
        mesh = bone()
        mesh.lines = [2, 0, 1]
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(mesh.bone.decimate().n_lines, 1)
        mesh = pv.PolyData(mesh.points, np.concatenate([mesh.faces, [2, 0, 1]]))
        with self.assertWarnsRegex(UserWarning, "1 polygons could not be triangulated"):
            mesh.bone.decimate()

    def test_measures_distances(self):
        mesh = bone()
        small = mesh.bone.decimate(max_error=0.2)
        measured = mesh.bone.distance_to(small)
        self.assertLessEqual(np.abs(measured["SignedDistance"]).max(), 0.2)
        self.assertEqual(set(measured["Side"]) - {-1, 0, 1}, set())
        self.assertNotIn("SignedDistance", mesh.point_data)
        upper = measured.field_data["bonedecimate.certificate.upper"][0]
        self.assertLessEqual(np.abs(measured["SignedDistance"]).max(), upper)
        self.assertEqual(mesh.bone.certify(small, tolerance=0.2).verdict, "proved")

    def test_plots_the_error(self):
        mesh = bone()
        picture = mesh.bone.plot_error(mesh.bone.decimate(max_error=0.5), screenshot=True, return_img=True)
        self.assertGreater(np.asarray(picture).std(), 10)

    def test_draws_a_bar_when_asked(self):
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
        notebook = json.loads((SOURCE / "Documentation" / "bonedecimate.ipynb").read_text(encoding="utf-8"))
        cells = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
        names, said = self.run_blocks(cells)
        self.assertLessEqual(names["small"].bone.report["proof.upper"], 0.2)
        self.assertIn("proved", said)

    def test_printed_programs_run(self):
        page = (SOURCE / "Documentation" / "python.md").read_text(encoding="utf-8")
        names, said = self.run_blocks(re.findall(r"```python\n(.*?)```", page, re.DOTALL))
        self.assertIn("2000 triangles", said)
        self.assertLessEqual(names["small"].report["proof.upper"], 0.2)


class Package(unittest.TestCase):
    def test_is_typed_and_its_stubs_know_every_option(self):
        folder = pathlib.Path(bonedecimate.__file__).parent
        self.assertTrue((folder / "py.typed").exists())
        for stub in ("_core.pyi", "_keywords.pyi", "vtk_filter.pyi"):
            compile((folder / stub).read_text(encoding="utf-8"), stub, "exec")
        from bonedecimate.options import ROWS
        keywords, members = ((folder / name).read_text() for name in ("_keywords.pyi", "vtk_filter.pyi"))
        for key, row in ROWS.items():
            self.assertIn(f"    {key}: ", keywords)
            self.assertIn(f"def Set{row.name}(self, value: ", members)

    def test_version_is_that_of_the_project(self):
        self.assertEqual(bonedecimate.__version__, importlib.metadata.version("bonedecimate"))


if __name__ == "__main__":
    unittest.main()
