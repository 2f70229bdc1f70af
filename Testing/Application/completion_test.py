# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Completions as the shells themselves compute them, and the manual page as its own checkers read it."""

import os
import pty
import re
import select
import shutil
import subprocess
import time
import unittest

from application import MODES, PROVING_MODES, ApplicationTest, main

COMMANDS = {"decimate", "thesis", "smooth", "certify", "tolerance", "curve", "levels", "diagnose"}
FILES = ("bone.stl", "ct.nii.gz", "REPORT.JSON", "page.html", "notes.txt", "two words.ply")


def needs(tool):
    """In CI every tool of Utilities/packages.txt must be there."""
    return unittest.skipUnless(shutil.which(tool) or os.environ.get("CI"), f"{tool} is not installed")


class Terminal:
    """A shell that reads keys."""

    def __init__(self, words, folder, **variables):
        self.process, self.side = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.execvpe(words[0], words, {**os.environ, "TERM": "dumb", "COLUMNS": "200", "LINES": "60", **variables})

    def type(self, keys, until, seconds=60):
        """What the terminal shows, at the latest when it shows this."""
        os.write(self.side, keys.encode())
        shown, end = "", time.monotonic() + seconds
        while until not in shown and time.monotonic() < end and select.select([self.side], [], [], end - time.monotonic())[0]:
            shown = re.sub(".\b", "", shown + os.read(self.side, 65536).decode(errors="replace"))
        return shown

    def close(self):
        os.close(self.side)
        os.waitpid(self.process, 0)


class Completion(ApplicationTest):
    def setUp(self):
        super().setUp()
        for name in FILES:
            self.path(name).touch()
        self.path("scans").mkdir()

    def script(self, shell, name):
        self.path(name).write_text(self.succeed("--completion", shell).stdout, encoding="utf-8")
        return self.path(name)

    def flags(self, command):
        found = re.findall(r"(?m)^  (?:-h,)?(--[a-z-]+(?:,--[a-z-]+)*)", self.succeed(command, "--help").stdout)
        self.assertGreater(len(found), 3)
        return {flag for flags in found for flag in flags.split(",")}

    def check_all(self, complete):
        """complete: from words to the set of what the shell offers in place of the last one."""
        self.assertEqual(complete("bonedecimate", "le"), {"levels"})
        self.assertLessEqual(COMMANDS | {"bone.stl", "ct.nii.gz", "two words.ply", "scans"}, complete("bonedecimate", ""))
        self.assertEqual(complete("bonedecimate", "bone.stl", "") & set(FILES), {"bone.stl", "ct.nii.gz", "two words.ply"})
        self.assertEqual(complete("bonedecimate", "certify", "") & set(FILES), {"bone.stl", "two words.ply"})
        self.assertEqual(complete("bonedecimate", "bone.stl", "out.stl", "--mode", ""), set(MODES))
        self.assertEqual(complete("bonedecimate", "curve", "--mode", ""), set(PROVING_MODES))
        self.assertEqual(complete("bonedecimate", "bone.stl", "--max-error", ""), {"quartervoxel", "halfvoxel", "voxel"})
        self.assertEqual(complete("bonedecimate", "bone.stl", "--report", ""), {"REPORT.JSON", "scans"})
        self.assertEqual(complete("bonedecimate", "levels", "--page", "p"), {"page.html"})
        self.assertEqual(complete("bonedecimate", "certify", "--label-map", ""), {"ct.nii.gz", "scans"})
        self.assertEqual(complete("bonedecimate", "certify", "--gap", ""), set())
        self.assertEqual(complete("bonedecimate", "certify", "--first"), {"--first-proof"})
        self.assertEqual(complete("bonedecimate", "certify", "--coarse"), set())

    def test_fish_offers_what_the_commands_take(self):
        if not shutil.which("fish") and not os.environ.get("CI"):
            self.skipTest("fish is not installed")
        script = self.script("fish", "completion.fish")

        def complete(*words):
            line = " ".join(word.replace(" ", "\\ ") for word in words)
            done = subprocess.run(["fish", "--no-config", "-c", 'source $argv[1]; complete -C "$argv[2]"', script, line], cwd=self.folder,
                                  capture_output=True, text=True, check=True, env={**os.environ, "HOME": str(self.folder)})
            self.assertEqual(done.stderr, "")
            return {offer.split("\t")[0].rstrip("/") for offer in done.stdout.splitlines()}

        self.check_all(complete)
        for command in sorted(COMMANDS):
            self.assertEqual(complete("bonedecimate", command, "--"), self.flags(command))
        self.assertEqual({offer.partition("=")[2] for offer in complete("bonedecimate", "curve", "--mode=F")}, {"Fast"})

    def bash(self, *words):
        """By the function that bash calls, with the variables that it sets."""
        return self.bash_at(len(words) - 1, *words)

    def bash_at(self, index, *words):
        call = ('source completion.bash; shift; index=$1; shift; COMP_WORDS=("$@") COMP_CWORD=$index; '
                '_bonedecimate; printf "%s\\n" "${COMPREPLY[@]}"')
        done = subprocess.run(["bash", "--norc", "-c", call, "bash", "", str(index), *words], cwd=self.folder,
                              capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        return set(done.stdout.splitlines()) - {""}

    def test_bash_offers_what_the_commands_take(self):
        self.script("bash", "completion.bash")
        self.check_all(self.bash)
        for command in sorted(COMMANDS):
            self.assertEqual(self.bash("bonedecimate", command, "--"), self.flags(command))
        self.assertEqual(self.bash("bonedecimate", "curve", "--mode", "=", "F"), {"Fast"})
        self.assertEqual(self.bash("bonedecimate", "curve", "--mode", "="), set(PROVING_MODES))
        self.assertEqual(self.bash("bonedecimate", "certify", "--", "bone.stl", ""), {"bone.stl", "two words.ply", "scans"})

    def test_bash_completes_at_the_keyboard(self):
        self.script("bash", "completion.bash")
        terminal = Terminal(["bash", "--norc", "--noprofile", "-i"], self.folder, PS1="> ", HISTFILE="")
        self.addCleanup(terminal.close)
        terminal.type("source completion.bash; echo rea''dy\n", "ready")
        self.assertIn("certify --first-proof", terminal.type("bonedecimate cer\t--fir\t", "--first-proof"))
        self.assertIn(r"two\ words.ply", terminal.type("two\t", "words.ply"))

    @needs("zsh")
    def test_zsh_completes_at_the_keyboard(self):
        self.script("zsh", "_bonedecimate")
        terminal = Terminal(["zsh", "-f", "-i"], self.folder, PS1="> ", HOME=str(self.folder))
        self.addCleanup(terminal.close)
        terminal.type("setopt nobeep; fpath=($PWD $fpath); autoload -U compinit; compinit -u -D; echo rea''dy\n", "ready")
        self.assertIn("certify --first-proof", terminal.type("bonedecimate cer\t--fir\t", "--first-proof"))
        self.assertIn(r"two\ words.ply", terminal.type("two\t", "words.ply"))
        for line, offers, missing in (
            ("bonedecimate \t", ("levels", "bone.stl", "ct.nii.gz", "scans"), ("notes.txt",)),
            ("bonedecimate curve --mode \t", ("Accurate", "Balanced", "Fast"), ("Thesis",)),
            ("bonedecimate bone.stl --mode=\t", ("Accurate", "Thesis"), ()),
            ("bonedecimate certify --label-map \t", ("ct.nii.gz", "scans"), ("bone.stl", "notes.txt")),
            ("bonedecimate certify -- \t", ("bone.stl", "scans"), ("ct.nii.gz",)),
        ):
            shown = terminal.type(f"\x15{line}\t", offers[-1]) + terminal.type("\x15echo e''nd\n", "\nend")
            for word in offers:
                self.assertIn(word, shown, line)
            for word in missing:
                self.assertNotIn(word, shown, line)
        self.assertIn("REPORT.JSON", terminal.type("bonedecimate bone.stl --report R\t", "REPORT.JSON"))

    def test_every_choice_that_is_offered_is_taken(self):
        script = self.script("bash", "completion.bash").read_text(encoding="utf-8")
        count = 0
        for command in sorted(COMMANDS):
            for flag in sorted(self.flags(command) - {"--help", "--version", "--man", "--completion"}):
                for choice in self.bash("bonedecimate", command, flag, "") - {*FILES, "scans"}:
                    done = self.run_program(command, flag, choice)
                    self.assertNotIn(f"{flag} takes", done.stderr)
                    self.assertNotIn("unknown option", done.stderr)
                    count += 1
        self.assertGreater(count, 80)

    def test_other_shells_are_rejected(self):
        self.fail_with(1, "--completion", "tcsh", says="--completion")


class ManualPage(ApplicationTest):
    def setUp(self):
        super().setUp()
        self.text = self.succeed("--man").stdout
        self.path("bonedecimate.1").write_text(self.text, encoding="ascii")

    def lint(self, *words):
        done = subprocess.run(words, cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual((done.stdout, done.stderr), ("", ""))

    def test_has_every_option_of_every_command(self):
        plain = re.sub(r"\\f[A-Z]", "", self.text.replace(r"\-", "-"))
        for command in sorted(COMMANDS):
            self.assertIn("bonedecimate" if command == "decimate" else f".SS bonedecimate {command}\n", plain)
            for flag in re.findall(r"(?m)^  (?:-h,)?(--[a-z-]+)", self.succeed(command, "--help").stdout):
                self.assertRegex(plain, rf"(?m)^(-h, )?(--labels, )?{flag}( |$|,)")

    @needs("mandoc")
    def test_mandoc_warns_of_nothing(self):
        self.lint("mandoc", "-Tlint", "bonedecimate.1")

    @needs("groff")
    def test_groff_warns_of_nothing(self):
        self.lint("groff", "-ww", "-man", "-z", "bonedecimate.1")


if __name__ == "__main__":
    main()
