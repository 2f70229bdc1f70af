# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""`python -m bonedecimate`, of a wheel with the program and of one without it."""

import importlib.metadata
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import bonedecimate

PACKAGE = pathlib.Path(bonedecimate.__file__).parent
HAS_PROGRAM = any(file.name in ("bonedecimate", "bonedecimate.exe") for file in importlib.metadata.files("bonedecimate"))


def run(*words, **variables):
    return subprocess.run([sys.executable, *words], capture_output=True, text=True, check=False, env={**os.environ, **variables})


class Program(unittest.TestCase):
    @unittest.skipIf(HAS_PROGRAM, "this wheel has the program")
    def test_a_wheel_without_the_program_says_where_it_is(self):
        done = run("-m", "bonedecimate", "--version")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, r"^bonedecimate: this wheel .* has no program; a portable wheel .* have it\n$")

    @unittest.skipUnless(HAS_PROGRAM, "this wheel has no program")
    def test_runs_the_program_of_the_wheel(self):
        done = run("-m", "bonedecimate", "--version")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, f"bonedecimate {bonedecimate.__version__} (Python wheel)\n", ""))

    @unittest.skipIf(os.name == "nt", "the program here is a script for a shell")
    def test_words_and_exit_code_are_those_of_the_program(self):
        """An installation as pip leaves it, with a script for the program."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            packages, scripts, records = root / "lib/packages", root / "bin", root / "lib/packages/bonedecimate-0.dist-info"
            for made in (scripts, records):
                made.mkdir(parents=True)
            (packages / "bonedecimate").symlink_to(PACKAGE)
            (scripts / "bonedecimate").write_text('#!/bin/sh\nprintf "%s|" "$@"\nexit 6\n')
            (scripts / "bonedecimate").chmod(0o755)
            (records / "METADATA").write_text("Metadata-Version: 2.1\nName: bonedecimate\nVersion: 0\n")
            (records / "RECORD").write_text("bonedecimate/__init__.py,,\n../../bin/bonedecimate,,\n")
            done = run("-m", "bonedecimate", "--quiet", "two words", "", PYTHONPATH=str(packages))
        self.assertEqual((done.returncode, done.stdout, done.stderr), (6, "--quiet|two words||", ""))


if __name__ == "__main__":
    unittest.main()
