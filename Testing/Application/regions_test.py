# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""--region and --tolerance-array: parts of a bone with a tolerance of their own."""

import vtk

from application import REJECTED, USAGE, ApplicationTest, main, torus, write


def points(surface):
    return [surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())]


def read(path):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def with_tolerance(surface, tolerance_of):
    array = vtk.vtkFloatArray()
    array.SetName("allowed")
    for point in points(surface):
        array.InsertNextValue(tolerance_of(point))
    surface.GetPointData().AddArray(array)
    return surface


class Regions(ApplicationTest):
    def setUp(self):
        super().setUp()
        self.bone = torus()
        write(self.bone, self.path("bone.vtp"))

    def decimate(self, *words):
        self.succeed("bone.vtp", "small.vtp", "--report", "report.json", "--quiet", *words)
        return read(self.path("small.vtp"))

    def test_of_zero_keeps_its_points_and_the_rest_does_not(self):
        small = self.decimate("--region", "box:0,99,-99,99,-99,99=0", "--target-reduction", 0.4)
        after = set(points(small))
        for point in points(self.bone):
            if point[0] >= 0:
                self.assertIn(point, after)
        self.assertLess(small.GetNumberOfPolys(), self.bone.GetNumberOfPolys())
        self.assertGreater(self.report()["input"]["constrained_points"], 400)
        self.assertEqual(self.report()["command_line"]["region"], "box:0,99,-99,99,-99,99=0")

    def test_may_be_many_of_which_the_smallest_counts_and_have_a_rest(self):
        self.decimate(
            "--region", "sphere:20,0,0,9=0.05", "--region", "box:0,99,-99,99,-99,99=0.3;rest=0.1", "--max-error", 0.2
        )
        expected = with_tolerance(
            torus(),
            lambda p: 0.05
            if (p[0] - 20) ** 2 + p[1] ** 2 + p[2] ** 2 <= 81
            else (0.2 if p[0] >= 0 else 0.1),
        )
        write(expected, self.path("expected.vtp"))
        self.succeed("certify", "expected.vtp", "small.vtp", "--tolerance-array", "allowed", "--quiet")

    def test_array_of_the_file_is_kept_and_lowered_by_regions(self):
        write(with_tolerance(torus(), lambda p: 0.4), self.path("bone.vtp"))
        few = self.decimate("--tolerance-array", "allowed").GetNumberOfPolys()
        self.succeed("certify", "bone.vtp", "small.vtp", "--tolerance-array", "allowed", "--quiet")
        more = self.decimate("--tolerance-array", "allowed", "--region", "box:0,99,-99,99,-99,99=0.01")
        self.assertLess(few, more.GetNumberOfPolys())

    def test_array_that_is_not_there_is_rejected(self):
        self.fail_with(REJECTED, "bone.vtp", "small.vtp", "--tolerance-array", "other", says="other")

    def test_that_make_no_sense_are_a_usage_error(self):
        for text in ("", "box", "box:1,2,3=0.1", "box:2,1,0,1,0,1=0.1", "ball:0,0,0,1=1", "sphere:0,0,0,1",
                     "sphere:0,0,0,1=", "sphere:0,0,0,-1=1", "sphere:0,0,x,1=1", "rest=much", "rest:1=1", "rest=-1",
                     "sphere:0,0,0,1=-0.1"):
            with self.subTest(text):
                self.fail_with(USAGE, "bone.vtp", "small.vtp", "--region", text)

    def test_that_hold_no_point_are_warned_of(self):
        self.decimate("--region", "box:0,99,-99,99,-99,99=0;sphere:999,0,0,5=0.1", "--region", "box:8,9,0,1,500,600=0",
                      "--max-error", 0.2)
        self.assertEqual(self.report()["warnings"], [
            "no point of the surface lies in sphere:999,0,0,5=0.1",
            "no point of the surface lies in box:8,9,0,1,500,600=0"])

    def test_thesis_takes_only_tolerances_of_zero(self):
        mode = ("--mode", "Thesis", "--target-triangles", 1500)
        self.decimate(*mode, "--region", "box:0,99,-99,99,-99,99=0")
        self.fail_with(REJECTED, "bone.vtp", "x.vtp", *mode, "--region", "rest=0.5", says="Thesis")


if __name__ == "__main__":
    main()
