# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The subcommands: which there are, and what a command line without one is."""

import json
import re
import shlex
import signal
import subprocess

from application import DONE, FORMATS, PROGRAM, PROVING_MODES, REJECTED, USAGE, ApplicationTest, main, torus, write

COMMANDS = ("thesis", "smooth", "certify", "tolerance", "curve", "levels", "diagnose", "cap", "summary", "demo", "help")


class Commands(ApplicationTest):
    def test_decimate_is_the_default(self):
        write(torus(), self.path("in.ply"))
        self.succeed("in.ply", "a.ply", "--target-triangles", 700)
        self.succeed("decimate", "in.ply", "b.ply", "--target-triangles", 700)
        self.assertEqual(self.path("a.ply").read_bytes(), self.path("b.ply").read_bytes())
        self.assertEqual(self.succeed("--help").stdout, self.succeed("decimate", "--help").stdout)

    def test_help_has_every_command_and_each_has_its_own(self):
        usage = self.succeed("--help").stdout.split("\n\n")[0]
        self.assertEqual(tuple(re.findall(r"bonedecimate ([a-z]+) ", usage)), COMMANDS)
        for command in COMMANDS:
            text = self.succeed(command, "--help").stdout
            self.assertIn(f"Usage: bonedecimate {command} ", text)
            self.assertIn("Exit codes:", text)
            entries = re.findall(r"(?m)^  (--[a-z,-]+) ", text)
            self.assertEqual(sorted(set(entries)), sorted(entries))  # each once
            says = "help has no topic, command or option 'what'" if command == "help" else f"see bonedecimate {command} -h"
            self.fail_with(USAGE, command, "--what", says=says)

    def test_short_help_fits_one_screen_and_names_every_option(self):
        short = self.succeed("-h").stdout
        self.assertLessEqual(short.count("\n"), 40)
        self.assertLessEqual(max(len(line) for line in short.splitlines()), 100)
        self.assertEqual(self.succeed("help").stdout, short)
        flags = re.compile(r"--[a-z-]+")
        whole = re.findall(r"(?m)^  (?:-h,)?(--[a-z-]+)", self.succeed("--help").stdout)
        by_topic = short.split("Options by topic:\n")[1].split("\n\n")[0]
        self.assertEqual(flags.findall(by_topic), whole)  # each once, in the same order
        self.assertGreater(len(whole), 60)
        for command in COMMANDS:
            self.assertRegex(short, rf"\b{command}\b")

    def test_help_explains_topics_commands_and_options(self):
        whole = self.succeed("--help").stdout
        topics = re.findall(r"(?m)^  ([a-z-]+) ", self.succeed("-h").stdout.split("Options by topic:\n")[1].split("\n\n")[0])
        self.assertGreater(len(topics), 8)
        for topic in topics:
            with self.subTest(topic):
                title, entries = self.succeed("help", topic).stdout.split(":\n", 1)
                if entries.startswith("  --"):
                    self.assertIn(f"\n{title}:\n" + entries.split("\n\n")[0], whole)
        self.assertIn("a quarter more triangles", self.succeed("help", "modes").stdout)
        codes = self.succeed("help", "exit-codes").stdout
        for says in ("2  the input was rejected", "4  interrupted, or beyond --time-limit; nothing of that input was", "5  out of memory, or beyond --memory-limit; "):
            self.assertIn("\n  " + says, codes)
        self.assertIn("ends with 8 if none\nfailed", self.succeed("help", "batches").stdout)
        for command in COMMANDS:
            self.assertEqual(self.succeed("help", command).stdout, self.succeed(command, "--help").stdout)
        self.assertRegex(self.succeed("help", "max-error").stdout, r"^  --max-error MM\|")
        self.assertEqual(self.succeed("help", "--max-error").stdout, self.succeed("help", "max-error").stdout)
        self.assertEqual(self.succeed("help", "exit").stdout, self.succeed("help", "exit-codes").stdout)
        for word, says in (("pruning", "--prune-size MM"), ("specks", "Cleaning"), ("planning", "--profile PROFILE"), ("error", "--max-error")):
            self.assertIn(says, self.succeed("help", word).stdout)
        self.fail_with(USAGE, "help", "max-eror", says="did you mean max-error?")
        self.fail_with(USAGE, "help", "zzz", says="bonedecimate help lists them")

    def test_options_that_another_command_has_are_told(self):
        self.fail_with(USAGE, "a.stl", "b.stl", "--tolerance", 1, says="did you mean --max-error?")
        self.fail_with(USAGE, "certify", "a.stl", "b.stl", "--max-error", 1, says="did you mean --tolerance?")

    def test_a_closed_pipe_is_quiet(self):
        for words in ("--help", "-h", "help batches", "--man", "--tables", "--completion zsh"):
            with self.subTest(words):
                done = subprocess.run(["bash", "-c", f"{shlex.quote(PROGRAM)} {words} | head -n 1 > /dev/null; echo ${{PIPESTATUS[0]}}"],
                                      capture_output=True, text=True, check=False)
                self.assertEqual(done.stderr, "")
                self.assertIn(int(done.stdout), (DONE, 128 + signal.SIGPIPE))

    def test_a_dash_is_the_standard_output(self):
        write(torus(), self.path("in.ply"))
        words = ("in.ply", "out.ply", "--target-triangles", 700)
        for name in ("-", "/dev/stdout"):
            done = self.run_program(*words, "--report", name)
            self.assertEqual(done.returncode, DONE)
            self.assertEqual(json.loads(done.stdout)["output"]["triangles"], 700)
            self.assertRegex(done.stderr, r"(?m)^triangles +[\d,]+ -> 700$")
            self.assertTrue(json.loads(self.run_program("diagnose", "in.ply", f"--json={name}").stdout)["usable"])
        self.assertTrue(self.succeed(*words, "--page", "-", "--quiet").stdout.startswith("<!DOCTYPE html>"))
        self.assertEqual(self.names(), ["in.ply", "out.ply"])
        self.fail_with(USAGE, "in.ply", "-", says="the output '-' needs one of the extensions")
        self.fail_with(USAGE, *words, "--also", "-", says="--also '-' needs one of the extensions")
        self.fail_with(USAGE, *words, "--picture", "-", says="--picture '-' needs the extension png")
        self.fail_with(USAGE, *words, "--page", "-", "--report", "-", says="'-' would be written twice")

    def test_smooth_keeps_all_triangles_within_its_bound(self):
        write(torus(), self.path("in.ply"))
        self.succeed("smooth", "in.ply", "out.ply", "--smooth", 0.1, "--report", "report.json")
        report = json.loads(self.path("report.json").read_text(encoding="utf-8"))
        self.assertEqual(report["output"]["triangles"], report["input"]["triangles"])
        self.assertLessEqual(report["proof"]["upper"], 0.1)
        self.assertGreater(report["smoothing"]["largest_displacement"], 0)
        self.assertEqual(report["stop_sentence"], "No triangle was to be removed.")
        self.assertIn("was not smoothed", self.succeed("smooth", "in.ply", "same.ply").stdout)
        self.succeed("in.ply", "a.ply", "--smooth", "auto", "--target-triangles", 700)
        self.succeed("smooth", "in.ply", "kept.ply", "--smooth", 0.1, "--feature-angle", 10, "--report", "report.json")
        self.assertIn("sharp_points", json.loads(self.path("report.json").read_text(encoding="utf-8"))["smoothing"])
        self.fail_with(USAGE, "in.ply", "b.ply", "--smooth", "automatic", says="--smooth takes a number")
        self.fail_with(USAGE, "smooth", "in.ply", "b.ply", "--target-triangles", 700, says="unknown option --target-triangles")

    def test_names_of_commands_behind_the_first_word_are_files(self):
        write(torus(), self.path("in.ply"))
        self.path("curve").mkdir()
        self.succeed("in.ply", "curve", "--target-triangles", 700)
        self.assertIn("curve/in.ply", self.names())
        self.succeed("diagnose", "in.ply", "--json", "levels")
        self.assertIn("levels", self.names())

    def test_help_and_slicer_have_the_formats_of_the_table(self):
        listed = re.search(r"by extension: (.*)\.\n", self.succeed("--help").stdout)[1].split(", ")
        self.assertEqual(listed, list(FORMATS))
        first = re.search(r'fileExtensions="(.*?)"', self.succeed("--xml").stdout)[1]
        self.assertEqual(first, ",".join("." + extension for extension, row in FORMATS.items() if not row["names_unit"]))

    def test_unknown_options_name_those_that_may_be_meant(self):
        files = ("in.ply", "out.ply")
        for words, says in (
            ((*files, "--max-eror", 0.5), "unknown option --max-eror; did you mean --max-error?"),
            ((*files, "--max-eror=0.5"), "unknown option --max-eror; did you mean --max-error?"),
            ((*files, "-max-error", 0.5), "unknown option -max-error; did you mean --max-error?"),
            ((*files, "--triangles", 700), "unknown option --triangles; did you mean --target-triangles or --prune-triangles?"),
            ((*files, "--reduction", 0.5), "unknown option --reduction; did you mean --target-reduction?"),
            ((*files, "--max-error-mm", 0.5), "unknown option --max-error-mm; did you mean --max-error?"),
            ((*files, "--target", 0.5), "did you mean --target-triangles or --target-reduction?"),
            (("levels", "in.ply", "--eror", 0.5), "unknown option --eror; did you mean --errors?"),
            ((), "an OUTPUT are needed; see bonedecimate -h, or try bonedecimate demo"),
            ((*files, "--zzz"), "unknown option --zzz; see bonedecimate -h"),
        ):
            with self.subTest(words):
                self.fail_with(USAGE, *words, says=says)

    def test_options_are_rejected_in_sentences(self):
        files = ("in.ply", "out.ply")
        for words, says in (
            ((*files, "--mode", "Fast", "--mode", "Thesis"), "bonedecimate: --mode is given more than once\n"),
            (("--completion", "tcsh"), "--completion takes one of bash, zsh, fish, not 'tcsh'"),
            (("curve", "in.ply", "--errors", 1, "--allow-large-error", "yes"), "--allow-large-error takes on or off, not 'yes'"),
            (("curve", "in.ply", "--errors", 1, "--mode", "Thesis"), f"--mode takes one of {', '.join(PROVING_MODES)}, not 'Thesis'"),
            (("cap", *files, "--loops", "some"), "--loops takes planes or all, not 'some'"),
            (("--max-error",), "--max-error takes a value: MM"),
            ((*files, "--quiet=maybe"), "bonedecimate: --quiet takes no value\n"),
        ):
            with self.subTest(words):
                self.fail_with(USAGE, *words, says=says)

    def test_words_with_a_dash_that_are_no_options(self):
        self.fail_with(REJECTED, "--", "-nothing.ply", "out.ply", says="no such file")
        self.fail_with(USAGE, "thesis", "nothing.obj", "-5", "0.95", "0", says="numbFaces takes a")

    def test_texts_name_flags_and_no_properties(self):
        rows = re.findall(r"(?m)^\| `(\w+)` \|.*`--([a-z-]+)`", self.succeed("--options-markdown").stdout)
        self.assertGreater(len(rows), 30)
        names = re.compile(r"(?<![\w-])(%s)(?!\w)" % "|".join(name for name, _ in rows if name not in ("Mode", "Smoothing")))
        for words in (("--man",), *((command, "--help") for command in ("decimate", *COMMANDS))):
            with self.subTest(words):
                self.assertEqual(names.findall(self.succeed(*words).stdout), [])
        write(torus(), self.path("in.ply"))
        both = ("in.ply", "out.ply", "--auto-smooth", "on", "--smooth", 0.2)
        self.fail_with(USAGE, *both, says="--auto-smooth has no effect; it needs --smooth 0\n")
        said = self.succeed("smooth", "in.ply", "out.ply", "--measure", "off").stdout
        self.assertIn("of one label of a segmentation (--smooth smooths it anyway)\n", said)

    def test_texts_end_with_success(self):
        for flag, says in (("--version", "bonedecimate "), ("--options-markdown", "| `Mode` |"), ("--help", "Usage:")):
            completed = self.run_program(flag)
            self.assertEqual((completed.returncode, completed.stderr), (DONE, ""))
            self.assertIn(says, completed.stdout)


if __name__ == "__main__":
    main()
