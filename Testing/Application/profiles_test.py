# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Profiles and configuration files: what they set, what wins, what is rejected, and what the reports say."""

import pathlib
import re

from application import UNMEASURED, USAGE, ApplicationTest, main, sphere, together, torus, write

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILT_IN = ("planning", "print", "FEM", "web")


class Profiles(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.vtp"))

    def config(self, text, name="ours.toml"):
        self.path(name).write_text(text, encoding="utf-8")
        return name

    def run_report(self, *words):
        self.succeed("in.vtp", "out.vtp", *UNMEASURED, "--report", "report.json", *words)
        return self.report()

    def test_each_built_in_profile_sets_what_the_table_says(self):
        table = self.succeed("--profiles-markdown").stdout
        for name in BUILT_IN:
            section = table.split(f"### {name}\n")[1].split("\n### ")[0]
            rows = dict(re.findall(r"(?m)^\| `--([a-z-]+)` \| (\S+) \|", section))
            self.assertGreaterEqual(len(rows), 3)
            report = self.run_report("--profile", name, "--also", "out.obj")
            self.assertEqual(report["settings"], {"profile": name, "options": rows, "overridden": []})
            self.assertEqual({flag: report["command_line"][flag] for flag in rows}, rows)
            written = ["--" + flag + "=" + value for flag, value in rows.items()]
            self.succeed("in.vtp", "typed.obj", *UNMEASURED, *written)
            self.assertEqual(self.path("out.obj").read_bytes(), self.path("typed.obj").read_bytes())

    def test_the_page_has_the_table(self):
        page = (ROOT / "Documentation" / "reference" / "command-line.md").read_text(encoding="utf-8")
        self.assertIn(self.succeed("--profiles-markdown").stdout, page)

    def test_the_command_line_wins_also_in_other_words(self):
        report = self.run_report("--profile", "PRINT", "--mode", "fast", "--preset", "HalfVoxel", "--voxel-size", 0.6)
        self.assertEqual(report["settings"]["profile"], "print")
        self.assertEqual(report["settings"]["overridden"], ["mode", "max-error"])
        self.assertNotIn("max-error", report["command_line"])
        self.assertEqual(report["command_line"]["mode"], "Fast")
        self.assertEqual(report["proof"]["tolerance"], 0.3)

    def test_a_file_sets_options_and_the_profile_wins_over_the_rest_of_it(self):
        config = self.config("""# ours
            max-error = 0.4   # mm
            measure = false
            region = ["sphere:28,0,0,9=0",
                      "rest=0.2"]
            quiet = true
            [levels]
            errors = [0.1, 0.2]
            [profiles.hip]
            max-error = 0.3
            mode = "Fast"
            [profiles.hip.levels]
            coarsest = 300
            """)
        report = self.run_report("--config", config, "--profile=hip")
        self.assertEqual(report["settings"], {"profile": "hip", "file": "ours.toml", "overridden": ["measure"], "options": {
            "max-error": "0.3", "mode": "Fast", "region": "sphere:28,0,0,9=0;rest=0.2", "quiet": ""}})
        self.assertEqual(report["command_line"]["max-error"], "0.3")
        self.assertEqual(self.run_report("--config", config)["command_line"]["max-error"], "0.4")
        levels = ("levels", "in.vtp", "--output", "level.vtp", "--no-errors")
        self.assertIn("--errors needs the distances", self.run_program(*levels, "--config", config).stderr)
        self.succeed("levels", "in.vtp", "--output", "level.vtp", "--config", config, "--profile", "hip")
        self.assertTrue(any(re.match(r"level-\d+\.vtp", name) for name in self.names()))

    def test_a_profile_of_the_file_replaces_the_one_of_its_name(self):
        config = self.config('[profiles.web]\nmax-error = "0.7"\n')
        self.assertEqual(self.run_report("--config", config, "--profile", "web")["settings"]["options"], {"max-error": "0.7"})

    def test_the_summary_names_the_profile(self):
        said = self.succeed("in.vtp", "out.vtp", *UNMEASURED, "--profile", "web", "--mode", "Fast").stdout
        self.assertIn("profile 'web': --max-error 0.5 --pass-arrays off --precision Single --prune-size 2; the command line sets mode\n", said)
        self.assertEqual(self.succeed("in.vtp", "out.vtp", *UNMEASURED, "--profile", "web", "--quiet").stdout, "")

    def test_unknown_names_are_rejected_with_a_sentence(self):
        run = ("in.vtp", "out.vtp")
        self.fail_with(USAGE, *run, "--profile", "pront", says="'pront' is none of planning, print, FEM, web; did you mean print?")
        self.fail_with(USAGE, *run, "--config", "no.toml", says="'no.toml' could not be read")
        for text, says in (
            ("mode = Fast\n\nmax-error 0.4\n", "'ours.toml' has in line 3 'max-error 0.4', which is neither KEY = VALUE nor a [SECTION]"),
            ('{"max-error": 0.4}', "has in line 1 '{\"max-error\": 0.4}', which is neither KEY = VALUE"),
            ("{", "in line 1 '{', which"),
            ("quiet", "in line 1 'quiet', which"),
            ("[levels", "in line 1 '[levels', which"),
            ("max-eror = 1", "'ours.toml' has 'max-eror', which is no option of decimate that a file can set; did you mean max-error?"),
            ("[levels]\niso = 1", "'iso' of [levels], which is no option of levels"),
            ("[profiles]\nmode = 1", "options go into [profiles.NAME]"),
            ("[level]\ncoarsest = 1", "the section [level], which is neither a command nor profiles.NAME"),
            ("[profiles.a.level]\ncoarsest = 1", "the section [profiles.a.level]"),
            ('profile = "web"', "'profile'"),
            ("help = true", "'help'"),
            ("FILES = true", "'FILES'"),
            ("quiet = 2", "'quiet', which takes true or false"),
            ("mode = Fast\nthreads = 1\nmode = Thesis", "'ours.toml' has 'mode' twice"),
            ("max-error = wide", "--max-error takes a number from 0 to 1e30 mm, or quartervoxel, halfvoxel or voxel, not 'wide'; --max-error is from 'ours.toml'"),
            ("mode = Thesis\nmin-angle = 20", "--min-angle is from 'ours.toml'"),
        ):
            self.fail_with(USAGE, *run, "--config", self.config(text), says=says)

    def test_a_profile_that_does_not_fit_is_rejected(self):
        self.fail_with(USAGE, "certify", "in.vtp", "in.vtp", "--profile", "web", says="--profile web sets nothing for certify; it is for decimate and levels")
        self.fail_with(USAGE, "in.vtp", "out.vtp", "--profile", "FEM", "--mode", "Thesis", says="is from profile 'FEM'")

    def test_every_command_has_files_and_says_so(self):
        config = self.config("""
            [certify]
            tolerance = 0.5
            [curve]
            errors = [0.2, 0.3]
            [diagnose]
            threads = 1
            [tolerance]
            mode = "Fast"
            [smooth]
            smooth = 0.1
            """)
        self.succeed("certify", "in.vtp", "in.vtp", "--config", config, "--json", "c.json")
        self.assertEqual(self.report("c.json")["settings"]["options"], {"tolerance": "0.5"})
        self.succeed("curve", "in.vtp", "--config", config, "--json", "e.json")
        self.assertEqual(self.report("e.json")["settings"]["options"], {"errors": "0.2,0.3"})
        self.assertEqual(len(self.report("e.json")["runs"]), 2)
        self.succeed("diagnose", "in.vtp", "--config", config, "--json", "d.json")
        self.assertEqual(self.report("d.json")["settings"]["file"], "ours.toml")
        self.succeed("tolerance", "in.vtp", "--triangles", 900, "--config", config, "--json", "t.json")
        self.assertEqual(self.report("t.json")["mode"], "Fast")
        self.succeed("smooth", "in.vtp", "s.vtp", "--config", config, "--report", "s.json")
        self.assertEqual(self.report("s.json")["settings"]["options"], {"smooth": "0.1"})

    def test_a_batch_hands_them_to_its_processes(self):
        write(together(torus(), sphere(center=60.0)), self.path("two.vtp"))
        words = ("in.vtp", "two.vtp", "small/", *UNMEASURED)
        config = self.config("jobs = 2\n[profiles.hip]\nprune-size = 30\nmax-error = 0.3\n")
        self.succeed(*words, "--config", config, "--profile", "hip")
        for name in ("in", "two"):
            report = self.report(f"small/{name}.json")
            self.assertEqual(report["settings"]["profile"], "hip")
            self.assertEqual(report["command_line"]["prune-size"], "30")
        self.assertEqual(self.report("small/two.json")["output"]["components"], 1)
        typed = self.succeed(*words, "--prune-size", 30, "--max-error", 0.3).stdout
        self.assertEqual(typed.count("by an earlier run"), 2)


if __name__ == "__main__":
    main()
