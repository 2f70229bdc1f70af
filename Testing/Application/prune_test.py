# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Small components left out on request, and the diagnostics, in summary, report and page."""

import re

from application import REJECTED, ApplicationTest, main, read, sphere, together, torus, write


class Prune(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(together(torus(), sphere(8, center=60.0)), self.path("in.ply"))

    def test_nothing_is_removed_by_default(self):
        said = self.succeed("in.ply", "out.ply", "--report", "report.json", "--target-triangles", 700).stdout
        self.assertNotIn("pruned", said)
        self.assertNotIn("pruned", self.report())
        self.assertEqual(self.report()["output"]["components"], 2)

    def test_what_went_is_listed(self):
        words = ("--prune-size", 25, "--report", "report.json", "--page", "page.html", "--max-error", 0.5)
        said = self.succeed("in.ply", "out.ply", *words).stdout
        whole = self.report()["input"]["triangles"] + self.report()["pruned"]["triangles"]
        self.assertIn(f"triangles       {whole:,} -> ", said)
        self.assertIn("components      1 of 2 kept, 1 pruned on request\n", said)
        self.assertRegex(said, r"pruned          1 components, \d+ triangles\n  \d+ triangles, ")
        pruned = self.report()["pruned"]
        self.assertEqual((pruned["components"], len(pruned["list"])), (1, 1))
        self.assertEqual(pruned["list"][0]["triangles"], pruned["triangles"])
        self.assertAlmostEqual(pruned["list"][0]["center"][0], 60.0, 1)
        self.assertLess(pruned["list"][0]["size"], 25)
        self.assertEqual(self.report()["units"]["pruned.list.0.size"], "mm")
        self.assertEqual(self.report()["proof"]["status"], "proved")
        page = self.path("page.html").read_text(encoding="utf-8")
        self.assertIn("Components left out", page)
        self.assertIn("<div class=\"lost\"><strong>1 of 2</strong>components (separate pieces) kept, 1 pruned on request</div>", page)
        self.assertRegex(page, "<a href=\"#proved\">Exceptions</a>: 1 pruned component")
        self.assertIn("<section id=\"proved\">", page)
        self.assertLess(read(self.path("out.ply")).GetBounds()[1], 30.0)

    def test_the_page_concerns_what_is_left(self):
        words = ("--prune-size", 25, "--report", "report.json", "--page", "page.html", "--heatmap", "heat.vtp", "--max-error", 0.5)
        self.succeed("in.ply", "out.ply", *words)
        page = self.path("page.html").read_text(encoding="utf-8")
        left = self.report()["input"]["triangles"]
        self.assertEqual(left, torus().GetNumberOfPolys())
        self.assertIn(f" % of {left + self.report()['pruned']['triangles']:,}</div>", page)
        if "viewer-scene" in page:
            self.assertIn(f'"caption":"Before: {left:,} triangles"', page)
        farthest = float(re.search(r"the farthest at ([\d.]+) mm", page).group(1))
        self.assertLessEqual(farthest, self.report()["distance"]["input_to_output"]["max"] + 5e-4)
        points = read(self.path("heat.vtp")).GetPointData()
        far = [points.GetArray("DistanceToResult").GetValue(i) > 1.0 for i in range(points.GetNumberOfTuples())]
        gone = [points.GetArray("ResultPointIds").GetValue(i) < 0 for i in range(points.GetNumberOfTuples())]
        self.assertEqual(far, gone)
        self.assertTrue(any(gone))

    def test_what_is_just_large_enough_stays(self):
        faces = sphere(8).GetNumberOfPolys()
        self.succeed("in.ply", "out.ply", "--prune-triangles", faces, "--report", "report.json")
        self.assertEqual((self.report()["pruned"]["components"], self.report()["pruned"]["triangles"]), (0, 0))
        self.assertEqual(self.report()["output"]["components"], 2)

    def test_nothing_left_is_rejected(self):
        self.fail_with(REJECTED, "in.ply", "out.ply", "--prune-area", 1e6, says="each of the 2 components")

    def test_diagnostics_are_shown_on_request(self):
        words = ("--report", "report.json", "--page", "page.html", "--target-triangles", 700)
        self.assertNotIn("found  ", self.succeed("in.ply", "out.ply", *words).stdout)
        self.assertNotIn("diagnostics", self.report())
        said = self.succeed("in.ply", "out.ply", "--diagnose", "on", *words).stdout
        self.assertIn("found           2 connected parts", said)
        kinds = [one["kind"] for one in self.report()["diagnostics"]]
        self.assertEqual(kinds, ["components"])
        self.assertIn("Diagnostics of the input", self.path("page.html").read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
