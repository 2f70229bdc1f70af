# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The audit without network: a mode, CGAL, and a program that crashes or returns a tetrahedron, on a phantom."""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = pathlib.Path(os.environ["BENCHMARK_PROGRAMS"])
CRASHES = "OpenMesh ModHausdorff"
FAKE = """#!/bin/sh
case "$*" in
  *HD:1.0*) cat > "$(printf '%s\\n' "$@" | tail -n 1)" ;;
  *) kill -SEGV $$ ;;
esac << END
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 4
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
0 0 1.5
3 0 2 1
3 0 1 3
3 1 2 3
3 0 3 2
END
"""


class ShortForm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        fake = cls.folder / "OpenMesh-commandlineDecimater"
        fake.write_text(FAKE, encoding="ascii")
        fake.chmod(0o755)
        cls.done = cls.run_audit()
        cls.lines = cls.read()

    @classmethod
    def run_audit(cls):
        names = f"Fast,{CRASHES},CGAL Lindstrom-Turk"
        return subprocess.run(
            [sys.executable, "-B", "-m", "bonebench.audit", "--programs", PROGRAMS, "--work", cls.folder, "--bone", "small-leg",
             "--only", names, "--samples", "5000", "--certificates"],
            cwd=HERE, capture_output=True, text=True, check=False, env={**os.environ, "PATH": f"{cls.folder}:{os.environ['PATH']}"})

    @classmethod
    def read(cls, name="audit.csv"):
        with (cls.folder / "audit" / name).open(newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def of(self, name):
        return [line for line in self.lines if line["program"] == name]

    def test_comes_to_its_end(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout + self.done.stderr)

    def test_fast_keeps_every_tolerance(self):
        self.assertEqual([line["tolerance_mm"] for line in self.of("Fast")], ["0.1", "0.5", "1"])
        for line in self.of("Fast"):
            self.assertLessEqual(float(line["true_mm"]), float(line["tolerance_mm"]))
            self.assertEqual(line["self_intersecting_pairs"], "0")

    def test_the_independent_distance_is_within_the_proved_one(self):
        for line in self.lines:
            if line["true_mm"]:
                self.assertLessEqual(float(line["sampled_mm"]), (1 + 1e-8) * float(line["true_mm"]))  # nine digits are printed
                self.assertLessEqual(float(line["lower_mm"]), float(line["true_mm"]))

    def test_a_program_without_a_tolerance_gets_the_number_of_fast(self):
        for fast, peer in zip(self.of("Fast"), self.of("CGAL Lindstrom-Turk"), strict=True):
            self.assertEqual(peer["requested_triangles"], fast["triangles"])

    def test_a_crash_is_a_line_with_its_command(self):
        crashed = self.of(CRASHES)[:2]
        self.assertEqual([line["failure"] for line in crashed], 2 * ["ended by SIGSEGV"])
        page = (self.folder / "audit" / "audit.md").read_text(encoding="utf-8")
        for line in crashed:
            self.assertIn(f"-M HD:{line['tolerance_mm']}", line["command"])
            self.assertIn(f"`{line['command']}`", page)
        self.assertIn(f"\n| {CRASHES} | 3 | 2 | 0 | ", page)

    def test_the_page_has_the_nearest_of_the_others(self):
        page = (self.folder / "audit" / "audit.md").read_text(encoding="utf-8")
        table = page.split("## How near does another program come?")[1].split("##")[0]
        for line in self.of("CGAL Lindstrom-Turk")[:2]:  # the third time the tetrahedron takes part, too
            ratio = int(line["triangles"]) / int(line["fast_triangles"])
            found = next(row for row in table.splitlines() if row.startswith(f"| small-leg | {line['tolerance_mm']} mm | {line['program']} |"))
            self.assertAlmostEqual(float(found.split("|")[-4]), ratio, delta=0.01 * ratio)

    def test_a_result_far_away_is_measured(self):
        found = self.of(CRASHES)[2]
        self.assertEqual((found["failure"], found["triangles"], found["components"]), ("", "4", "1"))
        self.assertGreater(float(found["true_mm"]), 10.0)

    def test_the_certificate_agrees_with_other_programs_that_bound_the_distance(self):
        bounds = {}
        for line in self.read("certificates.csv"):
            if line["upper_mm"]:
                bounds.setdefault((line["first"], line["second"]), {})[line["program"]] = float(line["lower_mm"]), float(line["upper_mm"])
        self.assertEqual(len(bounds), 4)  # three results of Fast with the input, two with each other
        for pair, found in bounds.items():
            self.assertLessEqual({"bonedecimate certify", "CGAL bounded error"}, found.keys())
            self.assertLessEqual(max(lower for lower, _ in found.values()), min(upper for _, upper in found.values()), pair)

    def test_lines_that_are_there_are_not_measured_again(self):
        before = (self.folder / "audit" / "audit.csv").read_bytes()
        self.assertEqual(self.run_audit().returncode, 0)
        self.assertEqual((self.folder / "audit" / "audit.csv").read_bytes(), before)


if __name__ == "__main__":
    unittest.main()
