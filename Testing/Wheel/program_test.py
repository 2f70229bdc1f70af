# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""`python -m bonedecimate`: with VTK, with meshio, and with numpy alone."""

import contextlib
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import warnings
from unittest import mock

import numpy as np

from arrays_test import POINTS, TRIANGLES
from bonedecimate import __main__ as program
from bonedecimate import certify, files
from bonedecimate.options import ROWS

REAL_HAS = files.has


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        files._write_stl((POINTS, TRIANGLES), self.folder / "bone.stl")

    def run_program(self, *words, code=0, without=()):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), mock.patch.object(
                files, "has", lambda module: not module.startswith(tuple(without)) and REAL_HAS(module)):
            found = program.main([str(word) for word in words])
        self.assertEqual(found, code, err.getvalue())
        return out.getvalue(), err.getvalue()

    def engines(self):
        """What to do without, so that each of those that are there has its turn."""
        found = [("vtk", "meshio")]
        found += [("vtk",)] if REAL_HAS("meshio") else []
        return found + ([()] if REAL_HAS("vtkmodules") else [])

    def test_decimates_an_stl_with_whatever_is_there(self):
        for without in self.engines():
            with self.subTest(without=without):
                small, report = self.folder / "small.stl", self.folder / "report.json"
                out, _ = self.run_program(self.folder / "bone.stl", small, "--max-error", "0.2", "--report", report,
                                          without=without)
                told = json.loads(report.read_text())
                self.assertIn(f"{len(TRIANGLES)} -> {told['output']['triangles']} triangles", out)
                points, triangles = files._read_stl(small)
                self.assertEqual(len(triangles), told["output"]["triangles"])
                certificate = certify((POINTS, TRIANGLES), (points, triangles), boundaries=False)
                self.assertLess(certificate.upper, 0.2 + 1e-5)  # single precision in the file
                self.assertLess(len(triangles), len(TRIANGLES) / 3)

    @unittest.skipUnless(REAL_HAS("vtkmodules"), "no VTK here")
    def test_keeps_the_voxels_of_a_file_that_has_their_grid(self):
        from specimens import boxes
        files.write_vtk(boxes(), self.folder / "boxes.vtp")
        for choice, words in (("on", r"voxels: 0 of \d+ changed"), ("off", r"voxels: \d+ of \d+ changed")):
            out, _ = self.run_program(self.folder / "boxes.vtp", self.folder / "small.vtp", "--keep-voxels", choice)
            self.assertRegex(out, words)
        self.assertTrue(files.read_vtk(self.folder / "small.vtp").GetCellData().HasArray("BoundaryLabels"))
        _, err = self.run_program(self.folder / "bone.stl", self.folder / "small.stl", "--keep-voxels", "on", code=2)
        self.assertIn("no voxel grid", err)

    def test_warns_of_what_was_dealt_with(self):
        """A third triangle at an edge: its points stay."""
        triangles = np.vstack([TRIANGLES, [[*TRIANGLES[0][:2], len(POINTS)]]])
        files._write_stl((np.vstack([POINTS, [[0, 0, 30]]]), triangles), self.folder / "odd.stl")
        for without in self.engines():
            with self.subTest(without=without), warnings.catch_warnings():
                warnings.simplefilter("error")
                _, err = self.run_program(self.folder / "odd.stl", self.folder / "small.stl", without=without)
                self.assertRegex(err, "^bonedecimate-py: warning: [0-9]+ points stay where they are")

    def test_a_package_that_is_not_there_is_no_failure(self):
        self.assertFalse(files.has("no_such_package.module"))

    def test_the_input_is_not_overwritten(self):
        bone = self.folder / "bone.stl"
        before = bone.read_bytes()
        for words in ((bone, bone), (bone, self.folder / "out.stl", "--report", bone)):
            self.assertIn("not overwritten", self.run_program(*words, code=1)[1])
        self.assertEqual(bone.read_bytes(), before)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["bone.stl"])

    def test_formats_of_the_program_alone_are_rejected(self):
        bone = self.folder / "bone.stl"
        for without in self.engines()[1:]:  # without VTK and meshio there is STL alone
            for words in ((bone, self.folder / "out.glb"), (self.folder / "in.nothing", self.folder / "out.stl")):
                says = self.run_program(*words, code=1, without=without)[1]
                self.assertRegex(says, r"has none of the endings .*\.stl.*; the C\+\+ program bonedecimate has more\n$")

    def test_files_that_are_none_are_rejected(self):
        (self.folder / "cut.stl").write_bytes((self.folder / "bone.stl").read_bytes()[:1000])
        for without in self.engines():
            for name in ("cut.stl", "absent.stl"):
                with self.subTest(name, without=without):
                    self.run_program(self.folder / name, self.folder / "out.stl", code=2, without=without)
                    self.assertFalse((self.folder / "out.stl").exists())

    def test_says_what_it_needs_for_other_formats(self):
        _, err = self.run_program(self.folder / "bone.stl", self.folder / "out.ply", code=3, without=("vtk", "meshio"))
        self.assertIn("only binary STL can be written", err)
        _, err = self.run_program(self.folder / "bone.stl", self.folder / "out.stl", "--recompute-normals",
                                  code=2, without=("vtk",))
        self.assertIn("--recompute-normals is about arrays of a file", err)

    def test_wrong_words_are_usage(self):
        for words in (["--mode", "Slow"], ["--max-error", "-1"], ["--nonsense"]):
            self.run_program(self.folder / "bone.stl", self.folder / "out.stl", *words, code=1)
        self.run_program(code=1)

    def test_usage_errors_are_one_line_with_the_flag(self):
        bone, out = self.folder / "bone.stl", self.folder / "out.stl"
        for words, says in (
                ((bone, out, "--nonsense"), "unrecognized arguments: --nonsense; see bonedecimate-py --help"),
                ((bone,), "the following arguments are required: output; see bonedecimate-py --help"),
                ((bone, out, "--max-error", "-1"), "--max-error takes a number from 0 to 1e30 mm, not -1"),
                ((bone, out, "--mode", "Slow"), "--mode takes one of " + ", ".join(ROWS["mode"].choices) + ", not 'Slow'"),
                ((bone, out, "--max-error", "halfvoxel"),
                 "--max-error takes a number from 0 to 1e30 mm, not 'halfvoxel'; --preset HalfVoxel says that")):
            printed, err = self.run_program(*words, code=1)
            self.assertEqual((printed, err), ("", f"bonedecimate-py: {says}\n"))

    def test_warnings_have_the_flag(self):
        for without in self.engines():
            _, err = self.run_program(self.folder / "bone.stl", self.folder / "out.stl", "--voxel-size", "0.5", without=without)
            self.assertEqual(err, "bonedecimate-py: warning: --voxel-size has no effect; it needs --preset\n")

    def test_a_text_with_the_name_of_a_surface_gives_one_line(self):
        for name in ("text.stl", "text.ply", "text.vtp", "text.vtk", "text.obj"):
            (self.folder / name).write_text("solid advice\n" * 20)
            done = subprocess.run([sys.executable, "-m", "bonedecimate", self.folder / name, self.folder / "out.stl"],
                                  capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (2, ""), name)
            self.assertRegex(done.stderr, r"^bonedecimate-py: [^\n]+\n$", name)

    def test_has_every_flag_of_the_table(self):
        out, _ = self.run_program("--help")
        for row in ROWS.values():
            if row.flag:
                self.assertIn("--" + row.flag, out)

    @unittest.skipUnless(REAL_HAS("vtkmodules"), "no VTK here")
    def test_arrays_come_along_where_vtk_reads_and_writes(self):
        self.run_program(self.folder / "bone.stl", self.folder / "small.vtp", "--target-triangles", "800", "--maps")
        surface = files.read_vtk(self.folder / "small.vtp")
        self.assertEqual(surface.GetNumberOfPolys(), 800)
        for name in ("Distance", "InputPointCount", "OriginalPointIds"):
            self.assertIsNotNone(surface.GetPointData().GetArray(name), name)
        self.assertIsNotNone(surface.GetFieldData().GetAbstractArray("BoneDecimateReport"))

    @unittest.skipUnless(REAL_HAS("vtkmodules"), "no VTK here")
    def test_coordinates_in_double_precision_are_read_as_they_are(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        far = POINTS.astype(np.float64) + 1e7 + 1 / 3
        vertices = ["%r %r %r\n" % tuple(map(float, point)) for point in far]
        header = f"element vertex {len(far)}\nproperty double x\nproperty double y\nproperty double z\n" \
                 f"element face {len(TRIANGLES)}\nproperty list uchar int vertex_indices\nend_header\n"
        fives = np.zeros(len(TRIANGLES), np.dtype([("count", "u1"), ("corners", ">i4", 3)]))
        fives["count"], fives["corners"] = 3, TRIANGLES
        faces = "".join("f %d %d %d\n" % tuple(corners + 1) for corners in TRIANGLES)
        loops = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex " + vertices[i] for i in corners)
                        + "endloop\nendfacet\n" for corners in TRIANGLES)
        for name, data in (
            ("plain.obj", "".join("v " + vertex for vertex in vertices) + faces),
            ("texture.obj", "vt 0 0\n" + "".join("v " + vertex for vertex in vertices) + "".join(
                "f %d/1 %d/1 %d/1\n" % tuple(corners + 1) for corners in TRIANGLES)),
            ("text.ply", "ply\nformat ascii 1.0\n" + header + "".join(vertices)
             + "".join("3 %d %d %d\n" % tuple(corners) for corners in TRIANGLES)),
            ("text.stl", "solid\n" + loops + "endsolid\n"),
        ):
            with self.subTest(name=name):
                (self.folder / name).write_text(data)
                self.expect_corners(name, far, vtk_to_numpy)
        (self.folder / "big.ply").write_bytes(("ply\nformat binary_big_endian 1.0\n" + header).encode()
                                              + far.astype(">f8").tobytes() + fives.tobytes())
        self.expect_corners("big.ply", far, vtk_to_numpy)

    def expect_corners(self, name, far, vtk_to_numpy):
        surface = files.read_vtk(self.folder / name)
        points = vtk_to_numpy(surface.GetPoints().GetData())
        triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        np.testing.assert_array_equal(points[triangles[: len(TRIANGLES)]], far[TRIANGLES])

    def test_runs_as_a_module(self):
        done = subprocess.run([sys.executable, "-m", "bonedecimate", self.folder / "bone.stl", self.folder / "out.stl"],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(len(files._read_stl(self.folder / "out.stl")[1]), len(TRIANGLES) // 10)

    def test_stl_keeps_orientation(self):
        points, triangles = files._read_stl(self.folder / "bone.stl")
        np.testing.assert_array_equal(points[triangles], POINTS[TRIANGLES].astype(np.float32))


if __name__ == "__main__":
    unittest.main()
