# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark's short form, without network and without peers, comes to its end and writes its table."""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = pathlib.Path(os.environ["BENCHMARK_PROGRAMS"])


class ShortForm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.done = subprocess.run(
            [sys.executable, "-B", "-m", "bonebench", "--programs", PROGRAMS, "--work", cls.folder.name, "--short",
             "--samples", "20000"],
            cwd=HERE, capture_output=True, text=True, check=False)
        cls.results = pathlib.Path(cls.folder.name) / "results"

    def test_comes_to_its_end(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout + self.done.stderr)

    def test_every_mode_of_the_program_has_its_figures(self):
        modes = subprocess.run([PROGRAMS / "bonedecimate-run", "--modes"], capture_output=True, text=True,
                               check=True).stdout.split()
        figures = json.loads((self.results / "benchmark.json").read_text(encoding="utf-8"))
        (row,) = figures["rows"]
        for mode in modes:
            for through in ("core", "filter"):
                (entry,) = [e for e in row["entries"] if e["mode"] == mode and e["through"] == through]
                self.assertEqual(entry["failure"], "")
                self.assertLessEqual(abs(entry["triangles"] - row["requested"]), 1)
                self.assertGreater(entry["median_seconds"], 0)
                self.assertGreater(entry["peak_bytes"], 0)

    def test_filter_and_core_give_the_same_bytes(self):
        figures = json.loads((self.results / "benchmark.json").read_text(encoding="utf-8"))
        for mode in figures["modes"]:
            sums = {sum_ for e in figures["rows"][0]["entries"] if e["mode"] == mode for sum_ in e["checksums"]}
            self.assertEqual(len(sums), 1, mode)

    def test_data_files_have_a_line_for_every_mode(self):
        with (self.results / "benchmark-data" / "comparison.csv").open(newline="", encoding="utf-8") as stream:
            lines = list(csv.DictReader(stream))
        figures = json.loads((self.results / "benchmark.json").read_text(encoding="utf-8"))
        for mode in figures["modes"]:
            adapters = [line["adapter"] for line in lines if line["method"] == mode]
            self.assertEqual(sorted(adapters), ["core", "filter"], mode)

    def test_the_page_has_a_line_for_every_mode(self):
        page = (self.results / "benchmark.md").read_text(encoding="utf-8")
        figures = json.loads((self.results / "benchmark.json").read_text(encoding="utf-8"))
        for mode in figures["modes"]:
            self.assertIn(f"\n| **{mode}** | ", page)


if __name__ == "__main__":
    unittest.main()
