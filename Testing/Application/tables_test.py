# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables that the program prints: what follows them in the documentation, and that runs do what they say."""

import pathlib
import re
import subprocess
import sys

from application import FORMATS, MODES, PROGRAM, PROVING_MODES, TABLES, UNMEASURED, ApplicationTest, main, torus, write

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Tables(ApplicationTest):
    def test_pages_are_what_the_tables_say(self):
        checked = subprocess.run([sys.executable, ROOT / "Utilities" / "write_pages.py", PROGRAM, "--check"],
                                 stderr=subprocess.PIPE, encoding="utf-8", check=False)
        self.assertEqual((checked.stderr, checked.returncode), ("", 0))

    def test_every_format_has_a_row_of_the_page(self):
        page = (ROOT / "Documentation" / "reference" / "files.md").read_text(encoding="utf-8")
        rows = [row.split("|")[1] for row in page.splitlines() if row.startswith("| `")]
        self.assertLessEqual(set(FORMATS), {name for row in rows for name in re.findall(r"`(\w+)`", row)})

    def flags_of(self, *command):
        return set(re.findall(r"(?m)^  (?:-h,)?(--[a-z-]+)", self.succeed(*command, "--help").stdout))

    def test_commands_on_pages_have_flags_that_the_program_has(self):
        commands = set(re.findall(r"bonedecimate ([a-z]+) ", self.succeed("--help").stdout))
        used = {}
        for page in [ROOT / "README.md", *(ROOT / "Documentation").glob("*/*.md")]:
            for line in re.findall(r"(?m)^(?: {4})?bonedecimate ([^#\n]+)", page.read_text(encoding="utf-8")):
                first = line.split()[0]
                used.setdefault((first,) if first in commands else (), set()).update(re.findall(r"(?<=\s)--[a-z-]+", line))
        self.assertGreater(len(used), 5)
        for command, flags in used.items():
            self.assertEqual(flags - self.flags_of(*command), set(), command)

    def test_every_flag_of_the_program_is_on_the_page_of_options(self):
        flags = self.flags_of()
        page = (ROOT / "Documentation" / "reference" / "options.md").read_text(encoding="utf-8")
        of_the_build = {"--help", "--version", "--options-markdown", "--profiles-markdown"}
        self.assertEqual(flags - of_the_build - set(re.findall(r"`(--[a-z-]+)", page)), set())

    def test_modes_are_those_of_the_option_and_prove_what_they_say(self):
        write(torus(), self.path("in.ply"))
        values = re.search(r"\| `--mode` \| (.*?) \|", self.succeed("--options-markdown").stdout)[1]
        self.assertEqual(values.split(", "), MODES)
        self.assertEqual([mode["name"] for mode in TABLES["modes"] if mode["is_default"]], ["Balanced"])
        for mode in MODES:
            self.succeed("in.ply", "out.ply", "--mode", mode, "--max-error", 0.5, "--report", "report.json", *UNMEASURED)
            self.assertEqual("proof" in self.report(), mode in PROVING_MODES, mode)

    def test_reasons_are_those_of_the_report_in_order(self):
        write(torus(), self.path("in.ply"))
        self.succeed("in.ply", "out.ply", "--report", "report.json", *UNMEASURED)
        words = [row["word"] for row in TABLES["rejections"]]
        self.assertEqual([word for word in self.report()["rejections"] if word in words], words)


if __name__ == "__main__":
    main()
