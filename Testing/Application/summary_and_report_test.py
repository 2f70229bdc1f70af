# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the program says on the terminal and in the JSON report."""

import os
import pty
import re
import subprocess

from application import DONE, PROGRAM, ApplicationTest, main, sphere, together, torus, write
from label_maps import ball, surface_of


class SummaryAndReport(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(together(torus(), sphere(center=100.0)), self.path("in.ply"))

    def test_report_has_its_documented_entries(self):
        self.succeed("in.ply", "out.vtp", "--target-triangles", 900, "--report", "report.json")
        report = self.report()
        self.assertEqual(report["input"]["components"], 2)
        self.assertEqual(report["output"]["components"], 2)
        self.assertEqual(report["input"]["triangles"], 1920 + 2 * 24 * 22)
        self.assertEqual(report["output"]["triangles"], 900)
        self.assertEqual(report["stop_reason"], "target_reached")
        for direction, names in (
            ("output_to_input", ("max", "second", "mean", "rms")),
            ("input_to_output", ("max", "mean", "rms")),
        ):
            for name in names:
                self.assertGreater(report["distance"][direction][name], 0.0)
        for name in ("read", "decimate", "measure", "write", "total"):
            self.assertGreaterEqual(report["seconds"][name], 0.0)
        parts = sum(report["seconds"][name] for name in ("read", "decimate", "measure", "write"))
        self.assertGreaterEqual(report["seconds"]["total"], parts)

    def test_whole_numbers_stay_whole_and_units_are_named(self):
        self.succeed("in.ply", "out.vtp", "--report", "report.json")
        report = self.report()
        self.assertIsInstance(report["output"]["triangles"], int)
        self.assertIsInstance(report["input"]["area"], float)
        self.assertEqual(report["units"]["distance.output_to_input.max"], "mm")

    def test_report_names_files_without_their_folders(self):
        self.path("patient").mkdir()
        write(torus(), self.path("patient") / "bone.ply")
        self.succeed(self.path("patient") / "bone.ply", self.path("out.vtp"), "--report", self.path("report.json"))
        self.assertEqual(self.report()["files"]["input"], "bone.ply")
        self.assertEqual(self.report()["files"]["output"], "out.vtp")
        self.assertNotIn("patient", self.path("report.json").read_text())
        self.assertNotIn(str(self.folder), self.path("report.json").read_text())

    def test_summary_tells_the_same_as_the_report(self):
        text = self.succeed("in.ply", "out.vtp", "--report", "report.json", "--target-triangles", 900).stdout
        report = self.report()
        self.assertRegex(text, r"triangles +2,976 -> 900\n")
        self.assertRegex(text, r"components +2 of 2 kept\n")
        size = float(re.search(r"size +([\d.]+) mm, the diagonal of the input\n", text)[1])
        self.assertAlmostEqual(size, report["input"]["diagonal"], delta=0.06)
        self.assertIn(report["stop_sentence"], text)
        for direction, words in (("output_to_input", "result to input"), ("input_to_output", "input to result")):
            shown = float(re.search(r"max ([\d.]+)", text.split(words)[1])[1])
            self.assertTrue(0 <= report["distance"][direction]["max"] - shown < 1e-4)  # rounded down
        self.assertRegex(text, r"written +out.vtp\n")
        self.assertRegex(text, r"written +report.json\n")
        self.assertLess(text.count("\n"), 13)

    def test_parts_of_a_smoothed_surface_have_area_volume_and_thickness(self):
        write(surface_of(ball(), 1), self.path("ball.ply"))
        text = self.succeed("ball.ply", "out.vtp", "--smooth", 0.3, "--target-reduction", 0.3,
                            "--report", "report.json", "--page", "page.html").stdout
        parts = self.report()["parts"]
        self.assertEqual((parts["kind"], parts["count"], len(parts["list"])), ("components", 1, 1))
        before, after = parts["list"][0]["input"], parts["list"][0]["output"]
        self.assertAlmostEqual(after["volume"] / before["volume"], 1, delta=0.1)
        self.assertLess(after["area"], before["area"])
        self.assertRegex(text, r"parts +1 components, before -> after")
        cells = [f"{before[name]:.{decimals}f} -> {after[name]:.{decimals}f}" for name, decimals in (
            ("area", 1), ("volume", 1), ("thickness_median", 3), ("thickness_percentile_5", 3))]
        page = self.path("page.html").read_text(encoding="utf-8")
        self.assertIn("Area, volume and thickness", page)
        for cell in cells:
            self.assertIn(cell, text)
            self.assertIn(cell.replace("->", "&rarr;"), page)

    def test_smoothing_without_a_largest_error_proves_nothing_because_none_was_requested(self):
        for mode in ("Fast", "Balanced"):
            said = self.succeed("in.ply", "out.vtp", "--mode", mode, "--smooth", 0.1).stdout
            self.assertIn("proved          nothing: no largest error was requested\n", said)

    def test_no_distances_where_none_are_measured(self):
        text = self.succeed("in.ply", "out.vtp", "--measure", "off", "--report", "report.json").stdout
        self.assertNotIn(" mm", text.replace(" mm, the diagonal", ""))
        self.assertNotIn("distance", self.report())

    def test_number_or_error_alone_switches_the_default_reduction_off(self):
        faces = 2976
        self.succeed("in.ply", "out.vtp", "--report", "report.json", "--target-triangles", 2000)
        self.assertEqual(self.report()["output"]["triangles"], 2000)
        self.succeed("in.ply", "out.vtp", "--report", "report.json", "--max-error", 1e-3)
        self.assertEqual(self.report()["stop_reason"], "error_reached")
        self.assertGreater(self.report()["output"]["triangles"], 0.5 * faces)
        self.succeed("in.ply", "out.vtp", "--report", "report.json", "--target-reduction", 0.5)
        self.assertAlmostEqual(self.report()["output"]["triangles"] / faces, 0.5, 2)

    def test_quiet_says_nothing(self):
        self.assertEqual(self.succeed("in.ply", "out.stl", "--quiet").stdout, "")

    def test_warnings_go_to_the_summary_and_the_report(self):
        points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 0 0\nv 6 0 0\nv 7 0 0\n"
        triangles = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 5 6 7\n"
        self.path("in.obj").write_text(points + triangles, encoding="ascii")
        text = self.succeed("in.obj", "out.vtp", "--report", "report.json").stdout
        self.assertRegex(text, r"(?m)^warning: .*without area")
        self.assertIn("without area", self.report()["warnings"][1])

    def test_progress_bar_on_a_terminal_only(self):
        write(torus(200, 200), self.path("large.ply"))
        done = self.succeed("large.ply", "out.vtp")
        self.assertNotRegex(done.stdout + done.stderr, "[\r#]")
        text = self.on_terminal("large.ply", "out.vtp")
        self.assertRegex(text, r"\rsimplifying \[#+ +\] +\d+ %")
        self.assertRegex(text, r"\rreading .*\rsimplifying .*\rwriting ")
        self.assertNotIn("#", self.on_terminal("large.ply", "out.vtp", "--quiet"))

    def test_progress_on_request_without_a_terminal(self):
        write(torus(100, 100), self.path("large.ply"))
        done = self.run_program("large.ply", "out.vtp", "--progress")
        self.assertEqual(done.returncode, DONE)
        percents = [int(one) for one in re.findall(r"(?m)^simplifying: (\d+) %", done.stderr)]
        self.assertEqual((percents[0], sorted(set(percents))), (0, percents))
        self.assertLessEqual(len(percents), 11)
        self.assertNotIn("simplifying", done.stdout)
        self.assertEqual(self.succeed("large.ply", "out.vtp", "--progress", "--quiet").stderr, "")

    def on_terminal(self, *words):
        ours, theirs = pty.openpty()
        process = subprocess.Popen([PROGRAM, *words], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        text = b""
        try:
            while chunk := os.read(ours, 65536):
                text += chunk
        except OSError:  # how a terminal says that the other side is gone
            pass
        os.close(ours)
        self.assertEqual(process.wait(), DONE)
        return text.decode()

    def test_version_and_help(self):
        self.assertRegex(self.succeed("--version").stdout, r"\Abonedecimate \d+\.\d+\.\d+ \((built from source|Debian package|archive)\)\n\Z")
        text = self.succeed("--help").stdout
        for flag in re.findall(r"`--([a-z-]+)`", self.succeed("--options-markdown").stdout):
            self.assertIn("--" + flag + " ", text)
        for words in ("Exit codes", "5  out of memory", "not a medical device", "thesis INPUT.obj"):
            self.assertIn(words, text)
        self.assertIn("numbFaces", self.succeed("thesis", "--help").stdout)


if __name__ == "__main__":
    main()
