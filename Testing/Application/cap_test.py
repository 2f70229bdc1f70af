# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""bonedecimate cap INPUT OUTPUT: open boundaries closed, counted and measured; bad calls leave nothing behind."""

import json
import math

from application import SURFACES, USAGE, ApplicationTest, main, torus, write
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCylinderSource


def tube():
    """An open cylinder of 24 sides, radius 10 mm, along y."""
    source, triangles, clean = vtkCylinderSource(), vtkTriangleFilter(), vtkCleanPolyData()
    source.SetRadius(10.0)
    source.SetHeight(30.0)
    source.SetResolution(24)
    source.CappingOff()
    triangles.SetInputConnection(source.GetOutputPort())
    clean.SetInputConnection(triangles.GetOutputPort())
    clean.Update()
    surface = clean.GetOutput()
    surface.GetPointData().Initialize()
    return surface


AREA = 2 * 12 * 100 * math.sin(math.pi / 12)  # of both ends, mm2


class Cap(ApplicationTest):
    def cap(self, *words):
        self.succeed("cap", *words, "--json", "cap.json", "--quiet")
        return json.loads(self.path("cap.json").read_text(encoding="utf-8"))

    def test_ends_of_a_scan_are_closed_in_every_format(self):
        write(tube(), self.path("in.ply"))
        for extension in SURFACES:
            found = self.cap("in.ply", "out." + extension)
            self.assertEqual((found["caps"], found["closed_loops"], found["open_loops"]), (2, 2, 0))
            self.assertAlmostEqual(found["cap_area_mm2"], AREA, 3)
            self.assertNotIn("open", self.succeed("diagnose", "out." + extension).stdout)

    def test_a_result_is_capped_after_its_run_and_the_input_before(self):
        write(tube(), self.path("in.ply"))
        self.succeed("in.ply", "small.ply", "--max-error", 0.5)
        self.assertEqual(self.cap("small.ply", "closed.ply")["open_loops"], 0)
        self.cap("in.ply", "closed_in.ply")
        self.succeed("closed_in.ply", "small.ply", "--max-error", 0.5)
        self.succeed("certify", "closed_in.ply", "small.ply", "--tolerance", 0.5)

    def test_the_sentence_says_that_caps_are_outside_of_the_bound(self):
        write(tube(), self.path("in.ply"))
        self.assertIn("outside of every error bound", self.succeed("cap", "in.ply", "out.ply").stdout)

    def test_boundaries_that_are_left_open_name_the_option_that_closes_them(self):
        surface = tube()
        points = surface.GetPoints()
        for i in range(points.GetNumberOfPoints()):  # both ends curved
            x, y, z = points.GetPoint(i)
            points.SetPoint(i, x, y + 0.02 * x * x * (1 if y > 0 else -1), z)
        write(surface, self.path("in.ply"))
        said = self.succeed("cap", "in.ply", "out.ply", "--json", "c.json").stdout
        says = "2 boundaries are at no plane where the surface ends and were left open; --loops all closes others, too"
        self.assertIn(f"written   out.ply\nwarning: {says}\n", said)
        self.assertEqual(self.report("c.json")["warnings"], [says])
        said = self.succeed("cap", "in.ply", "out.ply", "--loops", "all").stdout
        self.assertIn("2 closed, 0 left open\nwritten   out.ply\n", said)
        self.assertNotIn("warning", said)
        self.assertIn("Default planes.", self.succeed("cap", "--help").stdout)

    def test_units_change_nothing_but_the_numbers_of_the_file(self):
        write(tube(), self.path("in.ply"))
        found = self.cap("in.ply", "out.ply", "--unit", "cm")
        self.assertAlmostEqual(found["cap_area_mm2"], 100 * AREA, 1)

    def test_bad_calls_leave_nothing_behind(self):
        write(torus(), self.path("in.ply"))
        for words, says in ((("in.ply",), "INPUT and OUTPUT"), (("in.ply", "in.ply"), "not overwritten"),
                            (("in.ply", "out.stl", "--json", "./out.stl"), "written twice"), (("in.ply", "out.xyz"), "extensions"),
                            (("in.ply", "out.ply", "--loops", "some"), "--loops"), (("in.ply", "out.ply", "--plane-tolerance", -1), "--plane-tolerance"),
                            (("in.ply", "out.glb"), "out.glb")):
            self.fail_with(USAGE, "cap", *words, says=says)
        self.assertEqual(self.names(), ["in.ply"])


if __name__ == "__main__":
    main()
