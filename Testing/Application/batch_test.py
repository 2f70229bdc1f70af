# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Many bones into one folder."""

import csv
import os
import re
import shutil
import signal
import subprocess
import time
from pathlib import Path

from application import (
    NO_MEMORY,
    NOT_WRITTEN,
    PROGRAM,
    REJECTED,
    TEMPORARY,
    UNMEASURED,
    USAGE,
    ApplicationTest,
    main,
    read,
    sphere,
    together,
    torus,
    write,
)


LEFT_OUT = 8


class Batch(ApplicationTest):
    def setUp(self):
        super().setUp()
        self.bones = self.path("bones")
        self.bones.mkdir()
        write(torus(), self.bones / "b.stl")
        write(sphere(), self.bones / "a.ply")

    def run_program(self, *words, **keywords):
        self.completed = super().run_program(*words, **keywords)
        return self.completed

    def run_batch(self, *words):
        return self.succeed(*words, *UNMEASURED)

    def rows(self):
        with open(self.path("out/summary.csv"), newline="", encoding="utf-8") as file:
            return {row["name"]: row for row in csv.DictReader(file)}

    def statuses(self):
        return {name: row["status"] for name, row in self.rows().items()}

    def kept(self):
        """Those that an earlier run had finished."""
        return set(re.findall(r"(?m)^(\S+) .* by an earlier run; --force does it again$", self.completed.stdout))

    def test_folder_of_bones(self):
        (self.bones / "notes.txt").write_text("no bone")
        (self.bones / ".hidden.stl").write_text("no bone")
        text = self.succeed("bones", "out", "--target-reduction", 0.5, "--jobs", 2).stdout
        self.assertEqual(
            sorted(p.name for p in self.path("out").iterdir()),
            ["a.json", "a.ply", "b.json", "b.stl", "summary.csv", "summary.html"],
        )
        self.assertEqual(list(self.rows()), ["a", "b", "notes.txt"])
        row = self.rows()["b"]
        self.assertEqual((row["output"], row["status"], row["exit_code"], row["message"]), (row["name"] + Path(row["input"]).suffix, "done", "0", ""))
        self.assertEqual((row["triangles_in"], row["triangles_out"]), ("1920", "960"))
        self.assertEqual((row["components_in"], row["components_out"]), ("1", "1"))
        report = self.report("out/b.json")
        self.assertEqual(float(row["max_output_to_input_mm"]), report["distance"]["output_to_input"]["max"])
        self.assertEqual(float(row["mean_input_to_output_mm"]), report["distance"]["input_to_output"]["mean"])
        self.assertRegex(text, r"(?m)^a +done")
        self.assertRegex(text, r"(?m)^b +done +1,920 +960")

    def test_every_file_of_a_folder_has_a_row_and_the_reason_why_nothing_was_done(self):
        (self.bones / "notes.txt").write_text("no bone")
        (self.bones / "README").write_text("no bone")
        (self.bones / "a").write_text("no bone")
        (self.bones / ".hidden.stl").write_text("no bone")
        (self.bones / "below.stl").symlink_to(self.folder, target_is_directory=True)
        text = self.run_batch("bones", "bones/out", "--target-triangles", 500).stdout
        shutil.move(self.bones / "out", self.path("out"))
        with open(self.path("out/summary.csv"), newline="", encoding="utf-8") as file:
            reasons = {row["input"]: (row["status"], row["exit_code"], row["message"]) for row in csv.DictReader(file)}
        self.assertEqual(reasons, {
            "README": ("skipped", "0", "not a surface or volume: no extension"),
            "a": ("skipped", "0", "not a surface or volume: no extension"),
            "a.ply": ("done", "0", ""),
            "b.stl": ("done", "0", ""),
            "below.stl": ("skipped", "0", "a link to a folder, which is not followed"),
            "notes.txt": ("skipped", "0", "not a surface or volume: .txt"),
        })
        self.assertRegex(text, r"(?m)^notes.txt +skipped .* not a surface or volume: .txt$")
        self.assertTrue(self.path("out/a.ply").exists())

    def test_folders_of_a_folder_are_searched_and_outputs_lie_as_inputs_do(self):
        for folder in ("left/scan.2", "right", "nothing"):
            (self.bones / folder).mkdir(parents=True)
        write(sphere(), self.bones / "left/scan.2/a.ply")
        write(torus(), self.bones / "right/a.ply")
        write(torus(), self.bones / "right/a.stl")
        (self.bones / "right/z.ply").write_bytes(b"ply\n")
        completed = self.run_program("bones", "bones/out", "--target-triangles", 400, *UNMEASURED)
        self.assertEqual((completed.returncode, completed.stderr), (REJECTED, ""))
        shutil.move(self.bones / "out", self.path("out"))
        outputs = [str(p.relative_to(self.path("out"))) for p in sorted(self.path("out").rglob("*.*")) if p.is_file()]
        surfaces = ["a.ply", "b.stl", "left/scan.2/a.ply", "right/a_ply.ply", "right/a_stl.stl"]
        self.assertEqual(outputs, sorted([*surfaces, *(name[:-3] + "json" for name in surfaces), "right/z.log", "summary.csv", "summary.html"]))
        self.assertEqual({row["input"]: row["status"] for row in self.rows().values()},
                         {"a.ply": "done", "b.stl": "done", "left/scan.2/a.ply": "done", "right/a.ply": "done", "right/a.stl": "done",
                          "right/z.ply": "failed"})
        lines = completed.stdout.splitlines()
        self.assertEqual(len(lines), 8)
        self.assertRegex(lines[-1], r"^6 files: 5 done, 1 failed; table: bones/out/summary.csv$")
        self.run_program("bones", "out", "--target-triangles", 400, *UNMEASURED)
        self.assertEqual(sorted(self.statuses().values()), 5 * ["done"] + ["failed"])
        self.assertEqual(len(self.kept()), 5)

    def test_pruned_components_count_among_those_before(self):
        write(together(torus(), sphere(8, center=60.0)), self.bones / "b.stl")
        self.run_batch("bones", "out", "--only", "b.stl", "--prune-size", 25, "--target-triangles", 500)
        row = self.rows()["b"]
        self.assertEqual((row["components_in"], row["components_out"], row["triangles_out"]), ("2", "1", "500"))
        self.assertEqual(int(row["triangles_in"]), torus().GetNumberOfPolys() + sphere(8).GetNumberOfPolys())

    def test_only_files_of_a_pattern(self):
        (self.bones / "below").mkdir()
        write(torus(), self.bones / "below/b_left.stl")
        self.run_batch("bones", "out", "--only", "*_LEFT.stl", "--target-triangles", 500)
        self.assertEqual(self.statuses(), {"below/b_left": "done"})
        self.run_batch("bones", "other", "--only", "below/*", "--target-triangles", 500)
        self.assertTrue(self.path("other/below/b_left.stl").exists())
        self.fail_with(REJECTED, "bones", "none", "--only", "*.seg.nrrd",
                       says="'bones' was rejected: no surface or volume in it has a name, or path below the folder, that matches --only '*.seg.nrrd'\n")
        (self.bones / "ct.nrrd").write_bytes(b"NRRD0004\n")
        self.fail_with(REJECTED, "bones", "none", "--only", "*.nrrd", says="matches --only '*.nrrd'; volumes need --iso HU or --segments\n")
        self.fail_with(USAGE, "bones/a.ply", "a.ply", "--only", "a*", says="--only")

    def test_requested_work_that_fails_ends_with_its_code(self):
        (self.bones / "gone.stl").symlink_to("nowhere.stl")
        completed = self.run_program("bones", "out", "--target-triangles", 500, *UNMEASURED)
        self.assertEqual((completed.returncode, completed.stderr), (REJECTED, ""))
        self.assertEqual(self.statuses(), {"a": "done", "b": "done", "gone": "failed"})
        (self.bones / "gone.stl").unlink()
        (self.bones / "ct.nrrd").write_bytes(b"NRRD0004\n")
        completed = self.run_program("bones", "out", "--target-triangles", 500, *UNMEASURED)
        self.assertEqual((completed.returncode, completed.stderr), (LEFT_OUT, ""))
        self.assertIn("--iso", self.rows()["ct.nrrd"]["message"])
        (self.bones / "notes.txt").write_text("no bone")
        completed = self.run_program("bones/a.ply", "bones/notes.txt", "named")
        self.assertEqual(completed.returncode, REJECTED)

    def test_table_has_the_proved_bound_and_the_status_of_the_proof(self):
        text = self.run_batch("bones", "out", "--max-error", 0.2).stdout
        for name in ("a", "b"):
            proof = self.report("out/%s.json" % name)["proof"]
            self.assertEqual(float(self.rows()[name]["proved_mm"]), proof["upper"])
            self.assertEqual(self.rows()[name]["proof_status"], "proved")
            printed = re.search(r"(?m)^%s .* (0\.\d{4}) +proved$" % name, text)
            self.assertTrue(proof["upper"] <= float(printed[1]) <= 0.2)

    def test_named_like_a_file_is_no_output_folder(self):
        for name in ("extra.ply", "new.stl/", "report.json", "page.html", "ct.mha", "below/x.VTP"):
            self.fail_with(USAGE, "bones/a.ply", "bones/b.stl", name, says="named like a file")
            self.fail_with(USAGE, "bones", name, says="named like a file")
        self.run_batch("bones", "left.v2", "--target-triangles", 500)
        self.path("kept.ply").mkdir()
        self.run_batch("bones", "kept.ply", "--target-triangles", 500)

    def test_a_number_is_no_output_folder_of_several_inputs(self):
        self.fail_with(USAGE, "bones/a.ply", "bones/b.stl", 0.5,
                       says="'0.5' is no folder; an option takes its value behind its name, for example --max-error 0.5")
        self.run_batch("bones", "0.5", "--target-triangles", 500)

    def test_misspelled_commands_are_no_inputs(self):
        for meant in ("certify", "diagnose", "Levels", "tolerance", "curve", "thesis"):
            word, meant = meant[:3] + meant[4:], meant.lower()  # a letter is missing
            for words in (("bones/a.ply", "bones/b.stl"), ("bones/a.ply", "new"), ("bones/a.ply", "b", "--json", "c.json"),
                          ("bones/a.ply",), ()):
                self.fail_with(USAGE, word, *words, says="'%s' is neither a command nor a file; did you mean %s?" % (word, meant))
            self.fail_with(USAGE, "--quiet", word, "bones/a.ply", "new", says="did you mean " + meant)
        self.fail_with(USAGE, "shrink", "bones/a.ply", "new", says="the commands are cap, certify, curve, decimate, demo, diagnose, help, levels, smooth, summary, thesis")

    def test_iso_without_a_volume_is_wrong_usage(self):
        self.fail_with(USAGE, "bones", "out", "--iso", 226, says="none of the inputs is one")
        self.fail_with(USAGE, "bones/a.ply", "bones/b.stl", "out", "--iso", 226, says="none of the inputs is one")

    def test_several_files_and_a_folder_that_is_there(self):
        self.path("out").mkdir()
        self.run_batch("bones/b.stl", "bones/a.ply", "out")
        self.assertEqual(list(self.rows()), ["b", "a"])
        shutil.rmtree(self.path("out"))
        self.path("out").mkdir()
        self.run_batch("bones/a.ply", "out")
        self.assertEqual(self.statuses(), {"a": "done"})

    def test_format_of_the_outputs(self):
        self.run_batch("bones", "out", "--format", "vtp", "--target-triangles", 500)
        for name in ("a", "b"):
            self.assertEqual(read(self.path("out") / (name + ".vtp")).GetNumberOfPolys(), 500)

    def test_failed_bone_does_not_stop_the_others(self):
        (self.bones / "aa.stl").write_bytes((self.bones / "b.stl").read_bytes()[:-10])
        (self.bones / "z.obj").write_text("")
        completed = self.run_program("bones", "out", *UNMEASURED)
        self.assertEqual((completed.returncode, completed.stderr), (REJECTED, ""))
        self.assertEqual(self.statuses(), {"a": "done", "aa": "failed", "b": "done", "z": "failed"})
        self.assertIn("announces", self.rows()["aa"]["message"])
        self.assertEqual(self.rows()["aa"]["exit_code"], "2")
        self.assertIn("0 bytes", completed.stdout)
        self.assertFalse(self.path("out/aa.stl").exists())

    def test_missing_file_among_several_is_a_failed_bone(self):
        completed = self.run_program("bones/a.ply", "bones/nothing.ply", "out")
        self.assertEqual(completed.returncode, REJECTED)
        self.assertEqual(self.statuses(), {"a": "done", "nothing": "failed"})

    def test_finished_bones_are_kept(self):
        self.run_batch("bones", "out")
        before = self.path("out/a.ply").stat().st_mtime_ns
        table = self.rows()
        self.run_batch("bones", "out", "--threads", 1)
        self.assertEqual(self.statuses(), {"a": "done", "b": "done"})
        self.assertEqual(self.kept(), {"a", "b"})
        self.assertEqual(self.path("out/a.ply").stat().st_mtime_ns, before)
        self.assertEqual(self.rows()["a"]["triangles_out"], table["a"]["triangles_out"])
        self.run_batch("bones", "out", "--force")
        self.assertEqual(self.kept(), set())

    def test_changed_bones_are_done_again(self):
        self.run_batch("bones", "out")
        os.utime(self.bones / "a.ply", (1, 1))
        self.run_batch("bones", "out")
        self.assertEqual(self.kept(), {"b"})
        self.path("out/b.stl").write_bytes(b"cut")
        self.run_batch("bones", "out")
        self.assertEqual(self.kept(), {"a"})
        self.path("out/b.json").write_text("no report")
        self.run_batch("bones", "out")
        self.assertEqual(self.kept(), {"a"})

    def test_results_of_other_options_are_not_lost(self):
        self.run_batch("bones", "out", "--max-error", 0.5)
        before = {file.name: file.read_bytes() for file in self.path("out").iterdir()}
        for words in (("bones", "out", *UNMEASURED), ("bones", "out", *UNMEASURED, "--explain")):
            self.fail_with(USAGE, *words, says="'out' has 2 results of other options, the first is 'a' (--max-error 0.5 --measure off")
        self.assertEqual({file.name: file.read_bytes() for file in self.path("out").iterdir()}, before)
        self.assertRegex(self.succeed("bones", "out", *UNMEASURED, "--max-error", "0.5", "--explain").stdout, r"(?m)^finished +'bones/a.ply' -> ")
        self.run_batch("bones", "out", "--max-error", "0.50")
        self.assertEqual(self.kept(), {"a", "b"})
        self.run_batch("bones", "out", "--force")
        self.assertEqual(self.kept(), set())
        self.assertEqual(self.rows()["a"]["bound_mm"], "")
        self.path("out/a.ply").unlink()  # nothing to lose
        self.fail_with(USAGE, "bones", "out", *UNMEASURED, "--max-error", 0.5, says="1 result of other options, the first is 'b' (")
        self.assertIn("another folder keeps them, --force does all chosen inputs again\n", self.completed.stderr)

    def test_the_table_keeps_results_of_other_inputs(self):
        (self.bones / "z.obj").write_text("")
        self.run_program("bones", "out", *UNMEASURED)
        before = self.rows()
        self.run_batch("bones", "out", "--only", "a*", "--force")
        after = self.rows()
        self.assertEqual(list(after), ["a", "b", "z"])
        self.assertEqual((after["b"], after["z"]["status"]), (before["b"], "failed"))

    def test_the_table_and_the_page_have_the_options(self):
        self.run_batch("bones", "out", "--max-error", 0.5)
        self.assertEqual({row["options"] for row in self.rows().values()}, {"max-error=0.5 measure=off"})
        self.assertIn("Options: max-error=0.5", self.path("out/summary.html").read_text(encoding="utf-8"))
        self.run_batch("bones", "out", "--target-reduction", 0.5, "--only", "a*", "--force")
        self.assertEqual(self.rows()["a"]["options"], "measure=off target-reduction=0.5")
        self.assertIn("The results are of different options", self.path("out/summary.html").read_text(encoding="utf-8"))

    def test_a_batch_without_a_target_says_so(self):
        self.assertIn("note: without --max-error and a target nine tenths", self.run_batch("bones", "out").stdout)
        for words in (("--max-error", 0.5), ("--target-reduction", 0.5), ("--target-triangles", 500)):
            self.assertNotIn("note: ", self.run_batch("bones", "out", "--force", *words).stdout)

    def test_failures_come_first_on_the_page(self):
        (self.bones / "z.obj").write_text("")
        self.run_program("bones", "out", *UNMEASURED)
        page = self.path("out/summary.html").read_text(encoding="utf-8")
        self.assertLess(page.index(">z<"), page.index(">a<"))
        self.assertIn('<a href="z.log">log</a>', page)

    def test_failed_bone_is_tried_again(self):
        (self.bones / "z.obj").write_text("")
        self.run_program("bones", "out", *UNMEASURED)
        write(torus(), self.bones / "z.obj")
        self.run_batch("bones", "out")
        self.assertEqual(self.statuses(), {"a": "done", "b": "done", "z": "done"})
        self.assertEqual(self.kept(), {"a", "b"})

    def test_equal_names_do_not_overwrite_each_other(self):
        other = self.path("other")
        other.mkdir()
        write(torus(), self.bones / "a.obj")
        write(sphere(), other / "A.ply")
        write(sphere(), other / "b.ply")
        self.run_batch("bones", "other", "out", "--target-triangles", 400)
        self.assertEqual(len(self.rows()), 5)
        outputs = {p.name.lower() for p in self.path("out").iterdir()}
        self.assertEqual(len(outputs), 12)
        self.assertLessEqual({"a_obj.obj", "bones_a_ply.ply", "other_a_ply.ply", "b_stl.stl", "b_ply.ply"}, outputs)

    def test_same_file_twice_is_two_bones(self):
        self.run_batch("bones/a.ply", "bones/a.ply", "out")
        self.assertEqual(len(self.rows()), 2)

    def test_input_folder_is_no_output_folder(self):
        before = self.names()
        self.fail_with(USAGE, "bones", "bones", says="input and output")
        self.fail_with(USAGE, "bones/a.ply", "bones/b.stl", "bones", says="not overwritten")
        self.fail_with(USAGE, "bones", "bones/a.ply", says="output folder")
        self.assertEqual(self.names(), before)

    def test_options_of_one_bone_are_wrong_usage(self):
        for flag in ("--also", "--report", "--page", "--heatmap", "--picture"):
            self.fail_with(USAGE, "bones", "out", flag, "x.vtp", says="one bone")
        self.fail_with(USAGE, "bones", "out", "--format", "xyz", says="--format")
        self.fail_with(USAGE, "bones", "out", "--jobs", "0", says="--jobs")

    def test_folder_without_bones_is_rejected(self):
        self.path("nothing").mkdir()
        self.fail_with(REJECTED, "nothing", "out", says="no surface")

    def test_output_folder_that_cannot_be_made(self):
        self.path("file").touch()
        self.fail_with(NOT_WRITTEN, "bones", "file/out", says="file/out")

    def test_table_quotes_what_needs_it(self):
        write(torus(), self.bones / 'left, "upper".stl')
        self.run_batch("bones", "out")
        self.assertIn('left, "upper"', self.rows())

    def test_quiet_says_nothing(self):
        self.assertEqual(self.run_batch("bones", "out", "--quiet").stdout, "")

    def test_failures_are_told_even_so(self):
        self.path("bones/c.obj").write_text("v 0 0 0\nf 1 2 3\n", encoding="utf-8")
        completed = self.run_program("bones", "out", "--quiet")
        self.assertEqual((completed.returncode, completed.stdout), (REJECTED, ""))
        self.assertRegex(completed.stderr, r"^c +failed .*\n$")

    def test_warnings_reach_the_table(self):
        text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3"
        (self.bones / "c.obj").write_text(text)
        completed = self.run_batch("bones", "out")
        self.assertRegex(completed.stdout, "(?m)^c +done .* warning: the last line")
        self.assertIn("may be cut off", self.rows()["c"]["message"])

    def test_process_that_dies_does_not_stop_the_others(self):
        write(torus(300, 300), self.bones / "aa.ply")
        process = subprocess.Popen([PROGRAM, "bones", "out", *UNMEASURED], cwd=self.folder, stdout=subprocess.PIPE, encoding="utf-8")
        child = self.wait_for_child("aa.ply")
        os.kill(child, signal.SIGKILL)
        output = process.communicate()[0]
        self.assertEqual(process.returncode, NO_MEMORY)
        self.assertEqual(self.statuses(), {"a": "done", "aa": "failed", "b": "done"})
        self.assertIn("died of signal 9", output)
        self.assertEqual([n for n in self.names() if TEMPORARY in n], [])

    def test_goes_on_where_the_ends_of_children_were_ignored(self):
        def ignore():
            signal.signal(signal.SIGCHLD, signal.SIG_IGN)

        self.succeed("bones", "out", *UNMEASURED, preexec_fn=ignore, timeout=60)
        self.assertEqual(self.statuses(), {"a": "done", "b": "done"})

    def wait_for_child(self, name):
        """The process that works on that bone, once it has reserved its output."""
        while True:
            for staged in self.path("out").glob(TEMPORARY + "*.ply"):
                process = int(staged.name.split("-")[1])
                with open("/proc/%d/cmdline" % process, encoding="utf-8") as file:
                    if name in file.read():
                        return process
            time.sleep(0.005)


if __name__ == "__main__":
    main()
