# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of single features, on a small phantom."""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import sharp_edges


def run_features(work, *words):
    return subprocess.run([sys.executable, "-B", "-m", "bonebench.features", "--programs", os.environ["BENCHMARK_PROGRAMS"], "--work", work, *words],
                          cwd=HERE, capture_output=True, text=True, check=False)


class ShortForm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.work = pathlib.Path(folder.name)
        cls.done = run_features(cls.work, "angles", "lengths", "normal-tolerance", "--bone", "specimen-4000", "--samples", "5000")

    def table(self, name):
        with (self.work / "features" / f"features-{name}.csv").open(newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def test_comes_to_its_end(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout + self.done.stderr)

    def test_a_larger_least_angle_leaves_more_triangles(self):
        for row in self.table("angles"):
            counts = [int(row[f"{degrees} degrees: triangles"]) for degrees in (0, 20, 30)]
            self.assertEqual(counts, sorted(counts))
            self.assertLess(int(row["below 20"]), counts[1] / 20)

    def test_the_rule_of_the_thesis_lowers_w_with_the_triangles(self):
        rows = self.table("normal-tolerance")
        self.assertEqual([row["remaining, %"] for row in rows], ["40", "30", "20", "10", "3"])
        chosen = [float(row["w"]) for row in rows]
        self.assertAlmostEqual(chosen[0], 0.89, delta=0.01)
        self.assertEqual(chosen, sorted(chosen, reverse=True))
        self.assertEqual(chosen[-1], 0)
        self.assertTrue(all(float(row[f"mean, mm {how}"]) > 0 for row in rows for how in ("0.95", "rule")))

    def test_lengths_keep_the_largest_error(self):
        rows = self.table("lengths")
        self.assertEqual([row["EdgeLength, mm"] for row in rows], ["3", "6", "2", "5"])
        for row in rows:
            self.assertLessEqual(float(row["mean, mm"]), float(row["RMS, mm"]))
            self.assertLessEqual(float(row["Hausdorff, mm"]), 0.5)
            self.assertTrue(row["commit"])

    def test_a_feature_angle_keeps_edges(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(os.environ["BENCHMARK_PROGRAMS"]) / "bonedecimate"
            row = sharp_edges.row_of("cube", sharp_edges.solids()["cube, 12 mm"], 1.0, program, pathlib.Path(folder))
        for figure in ("RMS, mm", "degrees"):
            values = [row[f"{method}: {figure}"] for method in ("edges kept", "smoothed", "not smoothed")]
            self.assertEqual(values, sorted(values))
        self.assertLess(row["edges kept: edge, mm"], row["smoothed: edge, mm"])

    def test_an_unknown_table_is_named(self):
        done = run_features(self.work, "angels")
        self.assertEqual(done.returncode, 2)
        self.assertIn("no table angels: there are angles, ", done.stderr)


if __name__ == "__main__":
    unittest.main()
