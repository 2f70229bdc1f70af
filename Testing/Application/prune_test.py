# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Small components left out on request, and what the doctor found, in summary, report and page."""

from application import REFUSED, ApplicationTest, main, read, sphere, together, torus, write


class Prune(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(together(torus(), sphere(8, centre=60.0)), self.path("in.ply"))

    def test_nothing_goes_without_being_asked_for(self):
        said = self.succeed("in.ply", "out.ply", "--report", "report.json", "--target-faces", 700).stdout
        self.assertNotIn("pruned", said)
        self.assertNotIn("pruned", self.report())
        self.assertEqual(self.report()["output"]["components"], 2)

    def test_what_went_is_listed(self):
        words = ("--prune-size", 25, "--report", "report.json", "--page", "page.html", "--max-error", 0.5)
        said = self.succeed("in.ply", "out.ply", *words).stdout
        self.assertRegex(said, r"pruned          1 components, \d+ triangles\n  \d+ triangles, ")
        pruned = self.report()["pruned"]
        self.assertEqual((pruned["components"], len(pruned["list"])), (1, 1))
        self.assertEqual(pruned["list"][0]["faces"], pruned["faces"])
        self.assertAlmostEqual(pruned["list"][0]["place"][0], 60.0, 1)
        self.assertLess(pruned["list"][0]["size"], 25)
        self.assertEqual(self.report()["units"]["pruned.list.0.size"], "mm")
        self.assertEqual(self.report()["proof"]["verdict"], "proved")
        self.assertIn("What was left out", self.path("page.html").read_text(encoding="utf-8"))
        self.assertLess(read(self.path("out.ply")).GetBounds()[1], 30.0)

    def test_what_is_just_large_enough_stays(self):
        faces = sphere(8).GetNumberOfPolys()
        self.succeed("in.ply", "out.ply", "--prune-triangles", faces, "--report", "report.json")
        self.assertEqual(self.report()["pruned"], {"components": 0, "faces": 0})
        self.assertEqual(self.report()["output"]["components"], 2)

    def test_nothing_left_is_refused(self):
        self.fail_with(REFUSED, "in.ply", "out.ply", "--prune-area", 1e6, says="each of the 2 components")

    def test_the_doctor_speaks_when_asked(self):
        words = ("--report", "report.json", "--page", "page.html", "--target-faces", 700)
        self.assertNotIn("found  ", self.succeed("in.ply", "out.ply", *words).stdout)
        self.assertNotIn("findings", self.report())
        said = self.succeed("in.ply", "out.ply", "--examine", "on", *words).stdout
        self.assertIn("found           2 connected parts", said)
        kinds = [finding["kind"] for finding in self.report()["findings"]]
        self.assertEqual(kinds, ["components"])
        self.assertIn("What was found in the input", self.path("page.html").read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
