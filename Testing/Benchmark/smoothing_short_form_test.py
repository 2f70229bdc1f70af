# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark of smoothing, on small label maps and without network, comes to its end, and its figures are those that they must be."""

import csv
import io
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import unittest

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
OURS, NOT_SMOOTHED, SINC = "vtkBoneSmooth", "not smoothed", "windowed sinc 0.5"


def write_ct(path):
    """A ball of bone in place of the CT."""
    z, y, x = np.ogrid[:108, :256, :256]
    values = np.where((x - 128)**2 + (y - 128)**2 + (z - 54)**2 < 900, 1000, -1000).astype(np.int16)
    with tarfile.open(path, "w:gz", compresslevel=1) as archive:
        member = tarfile.TarInfo("matrix.dat")
        member.size = values.nbytes
        archive.addfile(member, io.BytesIO(values.tobytes()))


class ShortForm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.work = pathlib.Path(folder.name)
        write_ct(cls.work / "ct.inv3")
        cls.done = [cls.run_benchmark(*words) for words in (
            ("--compare", "gap of 1 mm", "ball of five labels"),
            ("--growth", "--threads", "--sizes", "5e3", "--thread-sizes", "5e3", "--thread-counts", "1", "3", "--", "CT, 5,000 triangles"))]

    @classmethod
    def run_benchmark(cls, *words):
        return subprocess.run(
            [sys.executable, "-B", "-m", "smoothingbench", "--programs", os.environ["BENCHMARK_PROGRAMS"],
             "--python", f"{os.environ['BENCHMARK_PACKAGES']}:{sys.executable}", "--work", cls.work, "--ct", cls.work / "ct.inv3",
             "--rounds", "1", "--samples", "1000", *words],
            cwd=HERE, capture_output=True, text=True, check=False)

    def rows(self, name):
        with (self.work / f"smoothing-{name}.csv").open(newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def row(self, shape, method):
        (row,) = [row for row in self.rows("compare") if (row["shape"], row["method"]) == (shape, method)]
        return row

    def test_comes_to_its_end(self):
        for done in self.done:
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_smoothing_is_nearer_to_the_truth_and_keeps_every_voxel(self):
        before, after = self.row("gap of 1 mm", NOT_SMOOTHED), self.row("gap of 1 mm", OURS)
        for column in ("rms_mm", "normal_degrees", "roughness_degrees"):
            self.assertLess(float(after[column]), 0.9 * float(before[column]), column)
        for row in (before, after):
            self.assertEqual(row["changed_voxels"], "0")
            self.assertGreater(int(row["boundary_voxels"]), 5000)
        self.assertLessEqual(float(after["displacement_mm"]), 0.25)
        self.assertGreater(float(after["least_thickness_mm"]), float(before["least_thickness_mm"]))

    def test_the_measure_finds_voxels_that_change(self):
        self.assertGreater(int(self.row("gap of 1 mm", SINC)["changed_voxels"]), 0)

    def test_several_labels_have_no_gaps_and_overlaps(self):
        row = self.row("ball of five labels", OURS)
        for column in ("changed_voxels", "gap_mm3", "overlap_mm3"):
            self.assertEqual(float(row[column]), 0.0, column)
        apart = self.row("ball of five labels", SINC)
        self.assertGreater(float(apart["gap_mm3"]), 1.0)
        self.assertGreater(float(apart["overlap_mm3"]), 1.0)

    def test_all_steps_give_the_same_bytes_for_any_number_of_threads(self):
        rows = self.rows("threads")
        for step in ("extract", "smooth", "proved", "keep voxels"):
            sums = [row["sha256"] for row in rows if row["step"] == step]
            self.assertEqual((len(sums), len(set(sums))), (2, 1), step)

    def test_growth_has_time_and_memory_of_each_step(self):
        rows = {row["step"]: row for row in self.rows("growth")}
        for step in ("extract", "smooth", "proved", "keep voxels", "vtkFlyingEdges3D", "windowed sinc"):
            self.assertGreater(float(rows[step]["cpu_seconds"]), 0.0, step)
        self.assertGreater(float(rows["smooth"]["peak_bytes"]), 0.0)

    def test_the_page_has_a_line_for_every_method(self):
        page = (self.work / "smoothing-benchmark.md").read_text(encoding="utf-8")
        for name in (f"**{OURS}**", NOT_SMOOTHED, SINC):
            self.assertIn(f"\n| {name} | ", page)
        self.assertNotIn("<!--", page)


if __name__ == "__main__":
    unittest.main()
