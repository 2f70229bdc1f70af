# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Names that changed still work for one release, with one line on the standard error that has the current name."""

from application import DONE, REJECTED, ApplicationTest, main, together, torus, write


class DeprecatedNames(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(together(torus(), torus(center=60.0)), self.path("in.ply"))

    def warn(self, old, current, *words):
        """A success that names both."""
        completed = self.run_program(*words)
        self.assertEqual(completed.returncode, DONE, completed.stderr)
        self.assertEqual(completed.stderr, f"bonedecimate: {old} is deprecated and will be removed in the next release; use {current}\n")
        return completed

    def result(self, *words):
        self.succeed("in.ply", "out.ply", "--quiet", *words)
        return self.path("out.ply").read_bytes()

    def test_flags_of_a_decimation_have_the_same_result(self):
        for words, current in (
            (("--target-faces", 700), ("--target-triangles", 700)),
            (("--target-faces=700",), ("--target-triangles", 700)),
            (("--keep-clearance", "off", "--max-error", 0.2), ("--intersection-guard", "off", "--max-error", 0.2)),
            (("--examine", "on", "--target-reduction", 0.5), ("--diagnose", "on", "--target-reduction", 0.5)),
        ):
            with self.subTest(words):
                expected = self.result(*current)
                self.warn(words[0].split("=")[0], current[0], "in.ply", "old.ply", "--quiet", *words)
                self.assertEqual(self.path("old.ply").read_bytes(), expected)

    def test_keys_of_configuration_files(self):
        self.path("old.toml").write_text("target-faces = 700\n[profiles.p]\nmax-error = 0.2\n", encoding="ascii")
        for words, old, current, says in (
            ((), "--target-faces", ("--target-triangles", 700), {"target-triangles": "700"}),
            (("--profile", "p"), "--target-faces", ("--target-triangles", 700, "--max-error", 0.2),
             {"target-triangles": "700", "max-error": "0.2"}),
        ):
            expected = self.result(*current)
            completed = self.run_program("in.ply", "old.ply", "--quiet", "--config", "old.toml", "--report", "report.json", *words)
            self.assertEqual(completed.returncode, DONE, completed.stderr)
            self.assertIn(f"{old} is deprecated and will be removed in the next release; use {current[0]}\n", completed.stderr)
            self.assertEqual(self.report()["settings"]["options"], says)
            self.assertEqual(self.path("old.ply").read_bytes(), expected)

    def test_flag_of_the_certificate(self):
        self.warn("--no-borders", "--no-boundaries", "certify", "in.ply", "in.ply", "--no-borders")

    def test_command(self):
        completed = self.warn("check", "diagnose", "check", "in.ply", "--json", "found.json")
        self.assertIn("It can be decimated.", completed.stdout)
        report = self.report("found.json")
        self.assertEqual(report["findings"], report["diagnostics"])

    def test_flags_with_underscores(self):
        words = ("--returnparameterfile", "results.txt", "in.ply", "old.ply", "--target_faces", 700)
        self.warn("--target-faces", "--target-triangles", *words)

    def test_words_behind_two_dashes_are_files(self):
        self.fail_with(REJECTED, "--", "--target-faces", "out.ply", says="'--target-faces' was rejected: there is no such file")

    def test_keys_of_the_report(self):
        self.succeed("in.ply", "out.ply", "--max-error", 0.2, "--diagnose", "on", "--prune-size", 1, "--report", "report.json")
        report = self.report()
        for old, current in (
            (report["output"]["faces"], report["output"]["triangles"]),
            (report["input"]["faces_read"], report["input"]["triangles_read"]),
            (report["input"]["locked_points"], report["input"]["non_manifold_points"]),
            (report["input"]["frozen_points"], report["input"]["constrained_points"]),
            (report["proof"]["verdict"], report["proof"]["status"]),
            (report["proof"]["borders"], report["proof"]["boundaries"]),
            (report["refusals"]["border"], report["rejections"]["boundary"]),
            (report["findings"], report["diagnostics"]),
            (report["clearance"], report["fragment_gap"]),
            (report["options"]["KeepClearance"], report["options"]["IntersectionGuard"]),
            (report["options"]["ExamineInput"], report["options"]["DiagnoseInput"]),
        ):
            self.assertEqual(old, current)
        self.assertEqual(report["deprecated_keys"]["faces"], "triangles")

    def test_keys_of_a_certificate(self):
        self.succeed("certify", "in.ply", "in.ply", "--tolerance", 0.1, "--json", "c.json")
        report = self.report("c.json")
        self.assertEqual((report["verdict"], report["borders"]), (report["status"], report["boundaries"]))


if __name__ == "__main__":
    main()
