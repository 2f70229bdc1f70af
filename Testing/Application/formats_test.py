# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every format in and out."""

import shutil

from vtkmodules.vtkCommonCore import VTK_DOUBLE

from application import (
    SURFACES,
    UNMEASURED,
    ApplicationTest,
    array_names,
    as_doubles,
    main,
    read,
    torus,
    write,
)


class Formats(ApplicationTest):
    def test_reads_and_writes_every_pair_of_formats(self):
        for source in SURFACES:
            write(torus(), self.path("in." + source))
            for target in SURFACES:
                with self.subTest(source=source, target=target):
                    self.succeed("in." + source, "out." + target, "--target-triangles", 700, "--report", "report.json", *UNMEASURED)
                    self.assertEqual(self.report()["input"]["triangles"], torus().GetNumberOfPolys())
                    self.assertEqual(self.report()["input"]["points"], torus().GetNumberOfPoints())
                    result = read(self.path("out." + target))
                    self.assertEqual(result.GetNumberOfPolys(), self.report()["output"]["triangles"])
                    self.assertLessEqual(result.GetNumberOfPolys(), 700)

    def test_reads_the_text_form_of_every_format(self):
        for source in ("stl", "ply", "vtp", "vtk"):
            with self.subTest(source=source):
                write(torus(), self.path("in." + source), ascii_text=True)
                self.succeed("in." + source, "out.ply", "--target-triangles", 700, "--report", "report.json", *UNMEASURED)
                self.assertEqual(self.report()["input"]["triangles"], torus().GetNumberOfPolys())

    def test_gives_the_same_points_in_every_format(self):
        write(torus(), self.path("in.ply"))
        self.succeed("in.ply", "out.vtp", "--also", "out.obj", "--also", "out.ply", "--also", "out.vtk", *UNMEASURED)
        expected = read(self.path("out.vtp"))
        for target in ("obj", "ply", "vtk"):
            result = read(self.path("out." + target))
            self.assertEqual(result.GetNumberOfPoints(), expected.GetNumberOfPoints())
            for i in range(result.GetNumberOfPoints()):
                self.assertEqual(result.GetPoint(i), expected.GetPoint(i))

    def test_extension_in_capitals_is_the_same_format(self):
        write(torus(), self.path("in.STL"))
        self.succeed("in.STL", "out.PLY", "--target-triangles", 700, *UNMEASURED)
        self.assertEqual(read(self.path("out.PLY")).GetNumberOfPolys(), 700)

    def test_names_with_blanks_and_letters_beyond_ascii(self):
        name = "Sch\u00e4del links \u9aa8.stl"
        write(torus(), self.path("in.stl"))
        shutil.move(self.path("in.stl"), self.path(name))
        self.succeed(name, "Ergebnis \u00fc.vtp", "--report", "report.json", *UNMEASURED)
        self.assertEqual(self.report()["files"]["input"], name)
        self.assertTrue(self.path("Ergebnis \u00fc.vtp").exists())

    def test_names_that_begin_with_a_dash_or_look_like_a_list(self):
        write(torus(), self.path("-in.ply"))
        self.succeed("--target-triangles", 700, "--", "-in.ply", "out.ply")
        self.path("[bones]").mkdir()
        write(torus(), self.path("[bones]") / "a.ply")
        self.succeed("[bones]", "out", *UNMEASURED)
        self.assertTrue((self.path("out") / "a.ply").exists())

    def test_vtp_and_vtk_hold_the_arrays_and_the_report(self):
        write(torus(), self.path("in.ply"))
        self.succeed("in.ply", "out.vtp", "--also", "out.vtk")
        for name in ("out.vtp", "out.vtk"):
            result = read(self.path(name))
            self.assertLessEqual({"Distance", "RunningError", "InputPointCount"}, array_names(result.GetPointData()))
            self.assertIn("bonedecimate.output.triangles", array_names(result.GetFieldData()))

    def test_says_where_a_format_holds_no_arrays(self):
        write(torus(), self.path("in.ply"))
        for target in SURFACES:
            text = self.succeed("in.ply", "out." + target, *UNMEASURED).stdout
            self.assertEqual("cannot hold arrays" in text, target not in ("vtp", "vtk"), target)

    def test_says_that_doubles_are_rounded_only_where_they_are(self):
        write(as_doubles(torus()), self.path("double.vtp"))
        write(torus(), self.path("single.vtp"))
        for target in SURFACES:
            rounds = target == "stl"
            self.assertEqual("single precision" in self.succeed("double.vtp", "out." + target, *UNMEASURED).stdout, rounds)
            self.assertNotIn("single precision", self.succeed("single.vtp", "out." + target, *UNMEASURED).stdout)

    def test_doubles_keep_all_their_digits_where_the_format_does(self):
        write(as_doubles(torus(center=1.0 / 3.0)), self.path("in.vtp"))
        self.succeed("in.vtp", "out.vtp", "--also", "out.vtk", *UNMEASURED)
        expected = read(self.path("out.vtp"))
        self.assertEqual(expected.GetPoints().GetDataType(), VTK_DOUBLE)
        result = read(self.path("out.vtk"))
        for i in range(result.GetNumberOfPoints()):
            self.assertEqual(result.GetPoint(i), expected.GetPoint(i))

    def test_heat_map_is_the_input_with_its_distances(self):
        write(torus(), self.path("in.ply"))
        for name in ("heat.vtp", "heat.vtk"):
            self.succeed("in.ply", "out.ply", "--heatmap", name, "--report", "report.json")
            heat = read(self.path(name))
            self.assertEqual(heat.GetNumberOfPolys(), torus().GetNumberOfPolys())
            distances = heat.GetPointData().GetArray("DistanceToResult")
            largest = distances.GetRange()[1]
            expected = self.report()["distance"]["input_to_output"]["point_max"]
            self.assertAlmostEqual(largest, expected, 4)

    def test_says_nothing_of_groups_where_an_obj_file_has_none(self):
        write(torus(), self.path("in.obj"))
        self.assertNotIn("warning", self.succeed("in.obj", "out.vtp", *UNMEASURED).stdout)


if __name__ == "__main__":
    main()
