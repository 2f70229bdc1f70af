# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""bonedecimate tolerance and bonedecimate curve."""

import csv
import xml.etree.ElementTree as xml

from application import REJECTED, USAGE, ApplicationTest, main, torus, write

VIOLATED = 6


class ErrorCommands(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.ply"))

    def test_tolerance_finds_an_error_that_a_run_of_its_own_confirms(self):
        text = self.succeed(
            "tolerance", "in.ply", "--triangles", 500, "--precision", 0.1, "--mode", "fast", "--json", "t.json"
        ).stdout
        found = self.report("t.json")
        self.assertIn("smallest error  <= ", text)
        best = [run for run in found["runs"] if run["reached"] and run["proved_mm"] == found["smallest_error_mm"]][0]
        self.assertLessEqual(best["triangles"], 500)
        words = ["--max-error", best["max_error_mm"]] if best["max_error_mm"] else []
        self.succeed("in.ply", "out.ply", "--target-triangles", 500, "--mode", "fast", "--quiet", *words)
        bound = found["smallest_error_mm"] * (1 + 1e-3)
        self.succeed("certify", "in.ply", "out.ply", "--tolerance", bound, "--quiet")

    def test_tolerance_says_that_there_is_none(self):
        completed = self.run_program("tolerance", "in.ply", "--triangles", 2, "--json", "t.json")
        self.assertEqual(completed.returncode, VIOLATED)
        self.assertIn("no surface of so few triangles", completed.stdout)
        self.assertIsNone(self.report("t.json")["smallest_error_mm"])

    def test_the_search_warns_of_no_option_that_it_sets_itself(self):
        said = self.succeed("tolerance", "in.ply", "--triangles", 5000, "--mode", "fast", "--json", "t.json").stdout
        self.assertNotIn("warning", said)
        self.assertEqual(self.report("t.json")["warnings"], [])

    def test_curve_is_written_as_data_and_picture(self):
        files = ("--json", "c.json", "--csv", "c.csv", "--picture", "c.svg")
        self.succeed("curve", "in.ply", "--errors", "0.1,0.4,1.6", "--mode", "Fast", *files)
        runs = self.report("c.json")["runs"]
        self.assertEqual([run["max_error_mm"] for run in runs], [0.1, 0.4, 1.6])
        for run in runs:
            self.assertLessEqual(run["proved_mm"], run["max_error_mm"])
        self.assertGreater(runs[0]["triangles"], runs[2]["triangles"])
        with self.path("c.csv").open(encoding="ascii") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual([int(row["triangles"]) for row in rows], [run["triangles"] for run in runs])
        circles = xml.parse(self.path("c.svg")).findall("{http://www.w3.org/2000/svg}circle")
        self.assertEqual(len(circles), 3)

    def test_reject_what_makes_no_sense(self):
        self.fail_with(USAGE, "tolerance", "in.ply")
        self.fail_with(USAGE, "tolerance", "in.ply", "in.ply", "--triangles", 5, says="takes one INPUT")
        self.fail_with(USAGE, "curve", "in.ply", "--errors", "0.1,0")
        self.fail_with(USAGE, "curve", "in.ply", "--errors", "0.1", "--picture", "c.bmp", says="svg")
        self.fail_with(USAGE, "curve", "in.ply", "--errors", "0.1", "--json", "in.ply", says="not overwritten")
        self.fail_with(USAGE, "curve", "in.ply", "--errors", "0.1", "--json", "a", "--csv", "./a", says="written twice")
        self.fail_with(REJECTED, "tolerance", "nothing.ply", "--triangles", 5, says="no such file")


if __name__ == "__main__":
    main()
