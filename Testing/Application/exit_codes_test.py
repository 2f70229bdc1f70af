# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each exit code, by what leads to it."""

import os
import resource

from application import (
    DONE,
    NO_MEMORY,
    NOT_WRITTEN,
    REJECTED,
    USAGE,
    ApplicationTest,
    limit,
    main,
    torus,
    without_root_powers,
    write,
)


class ExitCodes(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.ply"))

    def test_wrong_values_name_flag_value_and_range(self):
        for flag, value, says in (
            ("--max-error", "-1", "a number from 0 to 1e30 mm, or quartervoxel, halfvoxel or voxel, not '-1'"),
            ("--max-error", "nan", "a number"),
            ("--max-error", "", "''"),
            ("--max-error", "1mm", "'1mm'"),
            ("--target-triangles", "1.5", "whole number"),
            ("--target-triangles", "2147483648", "0 to 2147483647"),
            ("--target-reduction", "1.1", "0 to 1"),
            ("--normal-tolerance", "2", "0 to 1"),
            ("--threads", "1025", "0 to 1024"),
            ("--mode", "Best", "Thesis"),
            ("--measure", "maybe", "on or off"),
            ("--iso", "bone", "--iso"),
        ):
            with self.subTest(flag=flag, value=value):
                completed = self.fail_with(USAGE, "in.ply", "out.vtp", flag, value, says=says)
                self.assertIn(flag, completed.stderr)

    def test_wrong_command_lines_are_wrong_usage(self):
        for words, says in (
            ((), "INPUT"),
            (("in.ply",), "OUTPUT"),
            (("in.ply", ""), "empty"),
            (("in.ply", "out.xyz"), "extensions"),
            (("in.ply", "out.vtp", "--what"), "--what"),
            (("in.ply", "out.vtp", "--threads"), "--threads takes a value: N"),
            (("in.ply", "out.vtp", "--report", "--threads", "1"), "--report takes a value: JSON"),
            (("in.ply", "out.vtp", "--max-error", "1", "--max-error", "2"), "--max-error"),
            (("in.ply", "out.vtp", "--also", "b"), "--also"),
            (("in.ply", "out.vtp", "--heatmap", "heat.stl"), "--heatmap"),
            (("in.ply", "out.vtp", "--picture", "picture.jpg"), "--picture"),
            (("in.ply", "out.vtp", "--report", "r.txt"), "--report 'r.txt' needs the extension json"),
            (("in.ply", "out.vtp", "--page", "p.pdf"), "--page 'p.pdf' needs the extension html"),
            (("levels", "in.ply", "--page", "p.pdf"), "--page 'p.pdf' needs the extension html"),
            (("certify", "in.ply", "in.ply", "--page", "p.pdf"), "--page 'p.pdf' needs the extension html"),
            (("cap", "in.ply"), "there is 1 file\n"),
            (("diagnose",), "there are 0 files\n"),
            (("thesis", "in.ply"), "there is 1 word\n"),
            (("in.ply", "out.vtp", "--jobs", "2"), "--jobs"),
            (("in.ply", "out.vtp", "--force"), "--force"),
            (("in.ply", "out.vtp", "--format", "stl"), "--format"),
            (("in.ply", "out.vtp", "--iso", "226"), "--iso"),
        ):
            with self.subTest(words=words):
                self.fail_with(USAGE, *words, says=says)

    def test_never_overwrites_its_input_or_writes_a_file_twice(self):
        os.link(self.path("in.ply"), self.path("same.ply"))
        before = self.path("in.ply").read_bytes()
        for words in (
            ("in.ply", "in.ply"),
            ("in.ply", "./in.ply"),
            ("in.ply", "same.ply"),
            ("in.ply", "out.vtp", "--also", "in.ply"),
            ("in.ply", "out.vtp", "--also", "out.vtp"),
            ("in.ply", "out.vtp", "--report", "in.ply"),
            ("in.ply", "out.vtp", "--report", "x", "--page", "x"),
        ):
            with self.subTest(words=words):
                self.fail_with(USAGE, *words)
        self.assertEqual(self.path("in.ply").read_bytes(), before)

    def test_inputs_that_are_no_files_are_rejected(self):
        self.path("folder.ply").mkdir()
        self.path("empty.ply").touch()
        os.mkfifo(self.path("pipe.ply"))
        self.path("bone.xyz").write_text("1 2 3\n")
        for name, says in (
            ("nothing.ply", "no such file"),
            ("empty.ply", "0 bytes"),
            ("pipe.ply", "regular"),
            ("bone.xyz", "extension"),
        ):
            with self.subTest(name=name):
                self.fail_with(REJECTED, name, "out.vtp", says=says)
        self.fail_with(REJECTED, "thesis", "folder.ply", 100, 0.95, 0, says="folder")

    def test_an_input_that_is_not_there_comes_before_the_name_of_the_output(self):
        self.fail_with(REJECTED, "missing/", "o4", says="'missing/' was rejected: there is no such folder")
        self.fail_with(REJECTED, "missing.ply", "o4", says="'missing.ply' was rejected: there is no such file")

    def test_unreadable_input_is_rejected(self):
        self.path("in.ply").chmod(0)
        self.fail_with(REJECTED, "in.ply", "out.vtp", says="ermission", preexec_fn=without_root_powers)

    def test_folder_that_takes_no_files(self):
        self.fail_with(NOT_WRITTEN, "in.ply", "nowhere/out.vtp", says="No such")
        page = self.fail_with(NOT_WRITTEN, "in.ply", "out.vtp", "--page", "nowhere/p.html", says="'nowhere/p.html'")
        self.assertNotIn("png", page.stderr)
        self.path("read-only").mkdir()
        self.path("read-only").chmod(0o555)
        self.fail_with(
            NOT_WRITTEN, "in.ply", "read-only/out.vtp", says="ermission", preexec_fn=without_root_powers
        )

    def test_devices_and_folders_are_not_overwritten(self):
        for name in ("/dev/full", "/dev/null", str(self.folder)):
            self.fail_with(NOT_WRITTEN, "in.ply", "out.vtp", "--report", name)
        self.assertTrue(os.path.exists("/dev/null") and not os.path.isfile("/dev/null"))

    def test_standard_output_that_cannot_be_written(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            completed = self.run_program("--options-markdown", stdout=full)
        self.assertEqual(completed.returncode, NOT_WRITTEN)
        self.assertIn("standard output", completed.stderr)

    def test_too_little_memory(self):
        write(torus(600, 600), self.path("large.ply"))
        enough = self.least_memory_for("in.ply")
        self.fail_with(
            NO_MEMORY, "large.ply", "out.vtp", "--threads", 1, says="memory", preexec_fn=limit(resource.RLIMIT_AS, enough)
        )

    def least_memory_for(self, name):
        """Bytes of address space, to a tenth, with which the small bone can be done."""
        size = 64 << 20
        words = (name, "small.vtp", "--threads", 1, "--quiet")
        while self.run_program(*words, preexec_fn=limit(resource.RLIMIT_AS, size)).returncode != DONE:
            size += size // 10
        self.path("small.vtp").unlink()
        return size


if __name__ == "__main__":
    main()
