# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""bonedecimate levels: record, list, take levels out; damaged logs."""

import re

from application import NOT_WRITTEN, REJECTED, USAGE, ApplicationTest, main, torus, write


class Levels(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.ply"))

    def record(self, *words):
        return self.succeed("levels", "in.ply", "--record", "in.levels", "--coarsest", 200, *words).stdout

    def test_levels_out_of_a_log_are_those_of_its_run(self):
        levels = ("--triangles", "1000,400,200", "--output", "run.ply", "--no-errors", "--quiet")
        self.assertEqual(self.record(*levels), "")
        self.succeed("levels", "in.ply", "--log", "in.levels", "--triangles", "1000,400,200", "--output", "log.ply")
        for triangles in (1000, 400, 200):
            of_run = self.path(f"run-{triangles}.ply").read_bytes()
            self.assertEqual(self.path(f"log-{triangles}.ply").read_bytes(), of_run)
            self.assertIn(b"element face %d\n" % triangles, of_run)

    def test_the_coarsest_level_is_the_result_of_a_decimation(self):
        self.record("--no-errors", "--mode", "fast", "--triangles", 200, "--output", "level.obj")
        self.succeed("in.ply", "direct.obj", "--mode", "fast", "--target-triangles", 200, "--quiet")

        def data(name):
            lines = self.path(name).read_text(encoding="ascii").splitlines()
            return [line for line in lines if line[:2] in ("v ", "f ")]

        self.assertEqual(data("level-200.obj"), data("direct.obj"))

    def test_measured_levels_are_listed_and_taken_by_their_distance(self):
        lines = self.record().splitlines()
        self.assertRegex(lines[0], r"^1,\d\d\d triangles, largest distance 0\.\d{4} mm, mean 0\.\d{4} mm$")
        self.assertTrue(lines[-1].startswith("200 triangles, largest distance "))
        listed = self.succeed("levels", "in.ply", "--log", "in.levels").stdout.splitlines()
        self.assertEqual((listed[:-1], listed[-1].split(":")[0]), (lines, "wrote nothing"))
        largest = float(lines[-1].split()[4]) + 1e-4
        words = ("--log", "in.levels", "--errors", largest, "--output", "near.stl")
        self.assertIn(f"wrote near-200.stl: --errors {largest}\n", self.succeed("levels", "in.ply", *words).stdout)

    def test_the_run_goes_on_to_the_least_number_that_is_requested(self):
        said = self.succeed("levels", "in.ply", "--no-errors", "--triangles", "1000,100", "--output", "level.ply").stdout
        self.assertIn("wrote level-1000.ply: --triangles 1000\nwrote level-100.ply: --triangles 100\n", said)
        self.assertNotIn("warning", said)

    def test_says_which_requests_a_file_is_for_and_that_nothing_was_written(self):
        said = self.succeed("levels", "in.ply", "--no-errors", "--triangles", "1000,1000,200", "--output", "level.ply").stdout
        self.assertIn("wrote level-1000.ply: --triangles 1000, --triangles 1000\nwrote level-200.ply", said)
        said = self.succeed("levels", "in.ply", "--no-errors").stdout
        self.assertTrue(said.endswith("wrote nothing: --triangles or --errors with --output writes levels, --record the log, --page a page\n"), said)

    def test_levels_go_onto_another_surface_of_the_same_triangles(self):
        self.record("--no-errors", "--quiet")
        write(torus(center=30.0), self.path("there.ply"))
        words = ("--log", "in.levels", "--triangles", 300, "--output", "on.ply", "--on")
        self.succeed("levels", "in.ply", *words, "there.ply")
        self.assertIn(b"element face 300\n", self.path("on-300.ply").read_bytes())
        write(torus(rings=41), self.path("other.ply"))
        self.path("on-300.ply").unlink()
        self.fail_with(REJECTED, "levels", "in.ply", *words, "other.ply", says="other triangles than the first")

    def test_the_page_of_a_log_has_the_levels_that_are_listed(self):
        lines = self.record().splitlines()
        self.succeed("levels", "in.ply", "--log", "in.levels", "--page", "levels.html", "--triangles", 200, "--output", "level.ply")
        self.assertEqual(self.names(), ["in.levels", "in.ply", "level-200.ply", "levels.html"])
        page = self.path("levels.html").read_text(encoding="utf-8")
        rows = re.findall(r'<th scope="row">([\d,]+)</th><td>([\d.]+)</td>', page)
        self.assertEqual([triangles for triangles, _ in rows], [line.split()[0] for line in lines])
        for line, (_, largest) in zip(lines, rows):
            self.assertAlmostEqual(float(largest), float(line.split()[4]), delta=6e-4)
        self.assertTrue("data:image/png;base64," in page)
        self.succeed("levels", "in.ply", "--coarsest", 200, "--no-errors", "--quiet", "--page", "levels.html")
        self.assertTrue("<td>not measured</td>" in self.path("levels.html").read_text(encoding="utf-8"))

    def test_a_page_that_cannot_be_written_is_rejected(self):
        self.fail_with(USAGE, "levels", "in.ply", "--page", "in.ply", says="is not overwritten")
        self.fail_with(USAGE, "levels", "in.ply", "--page", "a.html", "--record", "a.html", says="would be written twice")
        self.fail_with(USAGE, "levels", "in.ply", "--page", "a.html", "--on", "in.ply", says="--page compares levels with INPUT")
        self.fail_with(NOT_WRITTEN, "levels", "in.ply", "--page", "no/a.html", says="no/a.html")

    def test_damaged_logs_are_rejected(self):
        self.record("--no-errors", "--quiet")
        log = self.path("in.levels").read_bytes()
        damaged = {
            "cut": (log[:1000], "damaged"),
            "changed": (log[:500] + bytes([log[500] ^ 1]) + log[501:], "damaged"),
            "longer": (log + b"\0", "damaged"),
            "of another version": (log[:8] + b"\xff" + log[9:], "version"),
            "other": (b"ply\n" + log, "no log"),
            "empty": (b"", "empty"),
        }
        for name, (content, says) in damaged.items():
            self.path(name).write_bytes(content)
            self.fail_with(REJECTED, "levels", "in.ply", "--log", name, says=says)
        write(torus(rings=41), self.path("other.ply"))
        self.fail_with(REJECTED, "levels", "other.ply", "--log", "in.levels", says="another surface")
        self.fail_with(REJECTED, "levels", "in.ply", "--log", "nothing", says="no such file")
        self.fail_with(REJECTED, "levels", "in.ply", "--log", ".", says="folder")

    def test_rejects_what_makes_no_sense(self):
        self.fail_with(USAGE, "levels")
        self.fail_with(USAGE, "levels", "in.ply", "in.ply")
        self.fail_with(USAGE, "levels", "in.ply", "--triangles", 300, says="--output is needed")
        self.fail_with(USAGE, "levels", "in.ply", "--output", "out.ply", says="needs --triangles")
        unmeasured = ("--errors", 0.1, "--no-errors", "--output", "out.ply")
        self.fail_with(USAGE, "levels", "in.ply", *unmeasured, says="--no-errors")
        self.fail_with(USAGE, "levels", "in.ply", "--triangles", 300, "--output", "out.txt", says="extensions")
        self.fail_with(USAGE, "levels", "in.ply", "--log", "a", "--mode", "fast", says="takes its place")
        self.fail_with(USAGE, "levels", "in.ply", "--record", "in.ply", says="not overwritten")
        write(torus(), self.path("out-300.ply"))
        words = ("--triangles", 300, "--output", "out.ply", "--no-errors")
        self.fail_with(USAGE, "levels", "out-300.ply", *words, says="not overwritten")
        self.fail_with(NOT_WRITTEN, "levels", "in.ply", "--record", "nowhere/in.levels", "--no-errors")


if __name__ == "__main__":
    main()
