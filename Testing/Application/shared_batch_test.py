# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Several batches with one output folder: each input is done once, and the summary is that of all."""

import csv
import os
import resource
import signal
import subprocess
import time

from application import INTERRUPTED, NOT_WRITTEN, NO_MEMORY, PROGRAM, REJECTED, UNMEASURED, USAGE, ApplicationTest, limit, main, sphere, torus, write

BONES = 24
REDUCED = ("--target-reduction", "0.5", *UNMEASURED)


class SharedBatch(ApplicationTest):
    def setUp(self):
        super().setUp()
        for number in range(BONES):
            folder = self.path(f"studies/{number % 5}")
            folder.mkdir(parents=True, exist_ok=True)
            write(torus(), folder / f"{number:02}.stl")

    def start(self, *words):
        return subprocess.Popen([PROGRAM, "studies", "out", *REDUCED, *words], cwd=self.path("."),
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def end(self, batches):
        """What each printed, after its exit code was checked."""
        said = [batch.communicate(timeout=120) for batch in batches]
        self.assertEqual([(batch.returncode, errors) for batch, (_, errors) in zip(batches, said)], [(0, "")] * len(batches))
        return [text for text, _ in said]

    def reports(self):
        """Those that are there; nothing removes them again."""
        paths = (self.path(f"out/{number % 5}/{number:02}.json") for number in range(BONES))
        return [path for path in paths if path.exists()]

    def rows(self):
        with open(self.path("out/summary.csv"), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def claim(self, name, age):
        """As of a batch that was last seen that many seconds ago."""
        folder = self.path("out/.bonedecimate") / (name + ".claim")
        folder.mkdir(parents=True)
        seen = time.time() - age
        os.utime(folder, (seen, seen))

    def test_there_is_one_summary_and_nothing_else_is_left(self):
        self.end([self.start() for _ in range(4)])
        self.assertEqual(len(self.rows()), BONES)
        self.assertEqual({row["triangles_out"] for row in self.rows()}, {"960"})
        self.assertEqual(sorted(entry.name for entry in self.path("out").iterdir()), ["0", "1", "2", "3", "4", "summary.csv", "summary.html"])

    def test_inputs_of_another_batch_are_left_to_it(self):
        """Runs of inputs are counted by the times at which their reports were written: nothing is written twice."""
        batches = [self.start("--jobs", "2") for _ in range(3)]
        seen = {}
        while any(batch.poll() is None for batch in batches):
            for report in self.reports():
                seen.setdefault(report, set()).add(report.stat().st_ino)
        self.end(batches)
        self.assertEqual(len(seen), BONES)
        self.assertEqual({len(files) for files in seen.values()}, {1})

    def test_results_below_the_inputs_are_no_inputs(self):
        self.succeed("studies", "studies/reduced", *REDUCED)
        said = self.succeed("studies", "out", *REDUCED).stdout
        self.assertIn("reduced", said)
        skipped = [(row["name"], row["status"]) for row in self.rows() if row["status"] != "done"]
        self.assertEqual((len(self.rows()), skipped), (BONES + 1, [("reduced", "skipped")]))
        self.succeed("studies/reduced", "again", *REDUCED)  # named itself

    def test_a_full_disk_fails_each_input_and_does_not_end_the_batch(self):
        completed = self.run_program("studies", "out", *REDUCED, preexec_fn=limit(resource.RLIMIT_FSIZE, 40000))  # below a surface, above the table
        self.assertEqual(completed.returncode, NOT_WRITTEN)
        self.assertEqual([row["status"] for row in self.rows()], ["failed"] * BONES)
        self.assertTrue(all("File too large" in row["message"] for row in self.rows()))
        self.succeed("studies", "out", *REDUCED)
        self.assertEqual({row["status"] for row in self.rows()}, {"done"})

    def test_what_a_killed_batch_had_is_done_by_another(self):
        self.claim("0/00", 3600)
        self.end([self.start()])
        self.assertEqual({row["status"] for row in self.rows()}, {"done"})

    def test_a_batch_waits_for_what_is_at_work_in_another(self):
        self.claim("0/00", 0)
        batch = self.start()
        deadline = time.time() + 60
        while len(self.reports()) < BONES - 1 and time.time() < deadline:
            time.sleep(0.1)
        time.sleep(1.5)
        self.assertIsNone(batch.poll())
        self.assertFalse(self.path("out/0/00.json").exists())
        self.path("out/.bonedecimate/0/00.claim").rmdir()
        self.end([batch])
        self.assertTrue(self.path("out/0/00.json").exists())

    def test_names_may_be_as_long_as_those_of_files(self):
        folder = self.path("studies") / "/".join(["f" * 100] * 4)
        folder.mkdir(parents=True)
        write(sphere(), folder / "long.stl")
        self.end([self.start()])
        self.assertEqual({row["status"] for row in self.rows()}, {"done"})

    def test_an_interrupted_batch_leaves_its_inputs_to_the_others(self):
        first, second = self.start(), self.start()
        time.sleep(0.5)
        first.send_signal(signal.SIGTERM)
        first.communicate(timeout=60)
        self.assertIn(first.returncode, (0, INTERRUPTED))
        self.end([second])
        self.assertEqual({row["triangles_out"] for row in self.rows()}, {"960"})

    def test_an_empty_folder_stays_while_another_batch_may_write_into_it(self):
        self.path("maps/0").mkdir(parents=True)
        header = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 4 4\nspacings: 1 1 1\nencoding: raw\n\n"
        self.path("maps/0/empty.nrrd").write_bytes(header.encode() + bytes(64))
        words = ("maps", "out", "--segments", "all", *UNMEASURED)
        other = self.path("out/.bonedecimate/1.batch")
        other.mkdir(parents=True)
        self.succeed(*words)
        self.assertTrue(self.path("out/0").is_dir())
        self.path("out/0").rmdir()
        other.rmdir()
        self.succeed(*words)
        self.assertFalse(self.path("out/0").exists())

    def test_what_failed_is_not_tried_by_each(self):
        self.path("studies/0/00.stl").write_bytes(b"no surface")
        batches = [self.start(), self.start()]
        said = [batch.communicate(timeout=120) for batch in batches]
        self.assertEqual([batch.returncode for batch in batches], [REJECTED] * 2)
        for text, _ in said:
            (line,) = [line for line in text.splitlines() if line.startswith("0/00 ")]
            self.assertIn("failed", line)
            self.assertIn("was rejected", line)
        self.assertFalse(self.path("out/.bonedecimate").exists())

    def test_a_folder_in_use_takes_no_batch_with_other_options(self):
        other = self.path("out/.bonedecimate/1.batch")
        other.mkdir(parents=True)
        (other / "options").write_text("--max-error 0.3", encoding="utf-8")
        self.fail_with(USAGE, "studies", "out", *REDUCED, says="'out' is in use by a batch with other options (--max-error 0.3), or was until a minute ago")
        self.assertFalse(self.path("out/summary.csv").exists())
        (other / "options").write_text("--measure off --target-reduction 0.5", encoding="utf-8")
        self.end([self.start("--jobs", "2")])
        (other / "options").write_text("--max-error 0.3", encoding="utf-8")
        os.utime(other, (time.time() - 120,) * 2)
        self.end([self.start()])

    def test_shards_know_what_the_others_made(self):
        self.path("studies/0/00.stl").write_bytes(b"no surface")
        self.assertEqual(self.run_program("studies", "out", *REDUCED, "--shard", "1/2").returncode, REJECTED)
        self.succeed("studies", "out", *REDUCED, "--shard", "2/2")
        (failed,) = [row for row in self.rows() if row["status"] == "failed"]
        self.assertEqual((failed["name"], failed["exit_code"]), ("0/00", str(REJECTED)))
        self.assertEqual(len([row for row in self.rows() if row["triangles_out"] == "960"]), BONES - 1)

    def test_a_surface_that_is_gone_or_another_is_failed_in_the_summary(self):
        self.end([self.start("--jobs", "2")])
        self.path("out/0/00.stl").unlink()
        with open(self.path("out/1/01.stl"), "r+b") as surface:
            surface.truncate(1000)
        self.path("out/2/02.json").write_text('{"a":')
        self.path("out/settings.json").write_text("{}")  # no report
        completed = self.run_program("summary", "out")
        self.assertEqual(completed.returncode, REJECTED)
        messages = {row["name"]: row["message"] for row in self.rows() if row["status"] == "failed"}
        self.assertEqual(messages, {"0/00": "the surface '00.stl' is missing", "1/01": "the surface '01.stl' changed after the report",
                                    "2/02": "the report '02.json' cannot be read"})
        self.assertIn(f"{BONES} files: {BONES - 3} done, 3 failed; ", completed.stdout)

    def test_shards_divide_the_inputs_and_summary_has_all_of_them(self):
        self.end([self.start("--shard", f"{number}/3") for number in (1, 2)])
        self.assertEqual(len(self.reports()), 2 * BONES // 3)
        self.assertEqual([row["message"] for row in self.rows() if row["status"] == "not run"], BONES // 3 * ["of another shard"])
        self.end([self.start("--shard", "3/3")])
        self.assertEqual({(row["status"], row["triangles_out"]) for row in self.rows()}, {("done", "960")})
        self.path("out/summary.csv").unlink()
        said = self.succeed("summary", "out").stdout
        self.assertEqual(len(self.rows()), BONES)
        self.assertEqual({(row["status"], row["triangles_out"]) for row in self.rows()}, {("done", "960")})
        self.assertIn(f"{BONES} files: {BONES} done", said)
        for wrong in ("0/3", "4/3", "3", "1/", "a/b", "-1/2"):
            self.fail_with(USAGE, "studies", "out", *REDUCED, f"--shard={wrong}", says="--shard takes two numbers I/N")
        self.path("empty").mkdir()
        self.fail_with(REJECTED, "summary", "empty", says="no report is in 'empty'")

    def test_an_input_that_takes_too_long_is_stopped(self):
        self.path("slow").mkdir()
        write(torus(500, 400), self.path("slow/a.stl"))
        write(sphere(), self.path("slow/b.stl"))
        self.assertEqual(self.run_program("slow", "out", "--mode", "Accurate", "--max-error", 0.01, "--time-limit", 4).returncode, INTERRUPTED)
        rows = {row["name"]: row for row in self.rows()}
        self.assertEqual((rows["a"]["status"], rows["b"]["status"]), ("failed", "done"))
        self.assertIn("took longer than the 4 s of --time-limit", rows["a"]["message"])

    def test_an_input_that_needs_too_much_memory_is_stopped(self):
        self.path("large").mkdir()
        write(torus(900, 800), self.path("large/a.stl"))  # 1.4 million triangles: more than 256 MiB
        write(sphere(), self.path("large/b.stl"))
        words = ("large", "out", "--mode", "Accurate", "--max-error", 0.01, "--memory-limit", "256M")
        self.assertEqual(self.run_program(*words).returncode, NO_MEMORY)
        rows = {row["name"]: row for row in self.rows()}
        self.assertEqual((rows["a"]["status"], rows["a"]["exit_code"], rows["b"]["status"]), ("failed", str(NO_MEMORY), "done"))
        self.assertIn("needed more than the 256 MiB of --memory-limit", rows["a"]["message"])
        self.assertFalse(self.path("out/a.stl").exists())
        self.path("out/notes.log").write_text("of something else\n")
        self.path("out/long.log").write_bytes(bytes(3_000_000))  # as of recorded edits
        self.assertEqual(self.run_program("summary", "out").returncode, NO_MEMORY)
        self.assertEqual({row["name"]: row for row in self.rows()}, rows)

    def test_a_failed_input_leaves_all_that_it_said(self):
        self.path("mixed").mkdir()
        self.path("mixed/bad.obj").write_text("v 0 0 0\nf 1 2 3\n")
        write(sphere(), self.path("mixed/good.stl"))
        alone = self.run_program("mixed/bad.obj", "alone.obj", *REDUCED)
        self.assertEqual(self.run_program("mixed", "out", *REDUCED).returncode, REJECTED)
        self.assertEqual(self.path("out/bad.log").read_text(), f"{alone.stderr}bad.obj: exit code {REJECTED}\n")
        self.assertFalse(self.path("out/good.log").exists())
        rows = self.rows()
        self.assertEqual(self.run_program("summary", "out").returncode, REJECTED)
        self.assertEqual(self.rows(), rows)  # the failed one, too
        write(sphere(), self.path("mixed/bad.obj"))
        self.succeed("mixed", "out", *REDUCED)
        self.assertFalse(self.path("out/bad.log").exists())


if __name__ == "__main__":
    main()
