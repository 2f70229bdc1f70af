# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""SIGINT, SIGTERM and SIGHUP end a run; nothing of it is left. What a killed run leaves, the next one removes."""

import fcntl
import json
import os
import pathlib
import pty
import re
import signal
import subprocess
import time

import vtk

from application import INTERRUPTED, PROGRAM, TEMPORARY, ApplicationTest, main, torus, write


def is_reserved(path):
    try:
        with open(path, "r+b") as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        return False
    except BlockingIOError:
        return True


class Interruption(ApplicationTest):
    def start(self, *words, **keywords):
        return subprocess.Popen(
            [PROGRAM, *words],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            encoding="utf-8",
            **keywords,
        )

    def temporaries(self):
        return sorted(path.name for path in self.folder.glob(TEMPORARY + "*"))

    def wait_for_work(self, folder):
        """Until the program has reserved its output, which it does before it reads."""
        while not any(folder.glob(TEMPORARY + "*.ply")):
            time.sleep(0.005)

    def test_signals_leave_nothing(self):
        write(torus(300, 300), self.path("in.ply"))
        for name in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            process = self.start("in.ply", "out.ply", "--also", "out.stl", "--report", "report.json")
            self.wait_for_work(self.folder)
            process.send_signal(name)
            output, errors = process.communicate()
            self.assertEqual((process.returncode, output, errors), (INTERRUPTED, "", "bonedecimate: interrupted\n"))
            self.assertEqual(self.names(), ["in.ply"])

    def test_hangup_is_ignored_where_it_was_ignored_before(self):
        """As under nohup."""
        write(torus(100, 100), self.path("in.ply"))
        process = self.start("in.ply", "out.ply", preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        self.wait_for_work(self.folder)
        process.send_signal(signal.SIGHUP)
        self.assertEqual(process.communicate()[1], "")
        self.assertEqual(process.returncode, 0)

    def test_next_run_removes_what_a_killed_one_left(self):
        write(torus(100, 100), self.path("in.ply"))
        write(torus(), self.path("small.ply"))
        process = self.start("in.ply", "out.ply", "--also", "out.stl", "--report", "report.json")
        self.wait_for_work(self.folder)
        process.kill()
        process.communicate()
        self.assertGreater(len(self.temporaries()), 0)
        self.path("other").mkdir()
        self.succeed("small.ply", "other/small.ply", "--quiet")
        self.assertGreater(len(self.temporaries()), 0, "only the folder that a run writes to is its business")
        self.succeed("diagnose", "small.ply", "--json", "found.json", "--quiet")
        self.assertEqual(self.temporaries(), [])
        self.assertFalse(self.path("out.ply").exists())

    def test_run_leaves_the_files_of_a_living_one_alone(self):
        write(torus(100, 100), self.path("in.ply"))
        write(torus(), self.path("small.ply"))
        process = self.start("in.ply", "out.ply", "--also", "out.stl", "--picture", "out.png")
        self.wait_for_work(self.folder)
        # Until then another run may remove it.
        while not all(is_reserved(path) for path in self.folder.glob(TEMPORARY + "*")):
            time.sleep(0.005)
        process.send_signal(signal.SIGSTOP)
        os.waitpid(process.pid, os.WUNTRACED)  # until it has stopped
        before = self.temporaries()
        self.succeed("small.ply", "other.ply", "--quiet")
        self.assertEqual(self.temporaries(), before)
        process.send_signal(signal.SIGCONT)
        self.assertEqual((process.communicate()[1], process.returncode), ("", 0))
        self.assertEqual(self.temporaries(), [])
        for name in ("out.ply", "out.stl", "out.png"):
            self.assertGreater(self.path(name).stat().st_size, 0)

    def test_files_of_another_system_and_of_other_programs_are_left_alone(self):
        write(torus(), self.path("small.ply"))
        boot = pathlib.Path("/proc/sys/kernel/random/boot_id").read_text(encoding="ascii").replace("-", "")[:12]
        names = [".bonedecimate-1-000000000000-0.ply", ".bonedecimate-1-0.ply", f".bonedecimate-{boot}.ply"]
        for name in names:
            self.path(name).write_text("of another")
        self.path(f".bonedecimate-1-{boot}-0.ply").mkdir()  # no file
        self.path(f".bonedecimate-1-{boot}-1.ply").symlink_to("small.ply")
        names += [f".bonedecimate-1-{boot}-0.ply", f".bonedecimate-1-{boot}-1.ply"]
        self.path(f".bonedecimate-1-{boot}-2.ply").write_text("of a process that is no more")
        self.succeed("small.ply", "out.ply", "--quiet")
        self.assertEqual(self.temporaries(), sorted(names))

    def test_interrupted_batch_stops_its_children(self):
        self.path("bones").mkdir()
        for i in range(3):
            write(torus(300, 300), self.path("bones") / ("bone%d.ply" % i))
        process = self.start("bones", "out", "--jobs", "2")
        while not self.path("out").exists():
            time.sleep(0.005)
        self.wait_for_work(self.path("out"))
        process.send_signal(signal.SIGTERM)
        output, errors = process.communicate()
        self.assertEqual((process.returncode, errors), (INTERRUPTED, "bonedecimate: interrupted\n"))
        self.assertEqual(sorted(p.name for p in self.path("out").iterdir()), ["summary.csv", "summary.html"])
        table = self.path("out/summary.csv").read_text()
        self.assertEqual(table.count(",interrupted,4,") + table.count(",not run,,"), 3)
        self.assertIn("interrupted", output)
        self.succeed("bones", "out", "--target-reduction", "0.01", "--measure", "off")
        self.assertEqual(len(list(self.path("out").glob("*.ply"))), 3)


def flat(cells):
    """The unit square in cells x cells squares, in single precision."""
    plane = vtk.vtkPlaneSource()
    plane.SetResolution(cells, cells)
    plane.Update()
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(plane.GetOutput())
    triangles.Update()
    return triangles.GetOutput()


class StoppedCertificate(ApplicationTest):
    """Flat surfaces in other triangles: to their smallest gap the bounds take minutes."""

    def setUp(self):
        super().setUp()
        for folder in ("before", "after"):
            self.path(folder).mkdir()
        for name in ("a", "b"):
            write(flat(28), self.path(f"before/{name}.ply"))
            write(flat(1), self.path(f"after/{name}.ply"))

    def start(self, *words):
        """The process, and its error output, a terminal."""
        terminal, end = pty.openpty()
        process = subprocess.Popen([PROGRAM, "certify", *words], cwd=self.folder, stdout=subprocess.PIPE, stderr=end, encoding="utf-8")
        os.close(end)
        self.addCleanup(os.close, terminal)
        return process, terminal

    def test_signals_leave_the_bounds_proved_so_far(self):
        for name in (signal.SIGINT, signal.SIGTERM):
            process, terminal = self.start(
                "before/a.ply", "after/a.ply", "--tolerance", "0.5", "--json", "c.json", "--page", "c.html")
            shown = ""
            while not re.search(r"\d\.\d{4} to \d\.\d{4} mm", shown):
                shown += os.read(terminal, 4096).decode()
            process.send_signal(name)
            output, _ = process.communicate(timeout=60)
            self.assertEqual(process.returncode, INTERRUPTED)
            self.assertIn("stopped: bounds proved so far\n", output)
            found = json.loads(self.path("c.json").read_text(encoding="utf-8"))
            self.assertEqual(found["stopped"], "stopped: bounds proved so far")
            self.assertEqual((found["problem"], found["lower"]), ("", 0.0))
            self.assertIn(found["status"], ("proved", "undecided"))
            self.assertEqual(found["status"] == "proved", found["upper"] <= 0.5 and found["boundary_reference_to_result"]["upper"] <= 0.5
                             and found["boundary_result_to_reference"]["upper"] <= 0.5)
            page = self.path("c.html").read_text(encoding="utf-8")
            self.assertIn("The comparison was stopped: bounds proved so far.", page)
            self.assertTrue(page.endswith("</html>\n"))
            self.assertEqual([name for name in self.names() if "/" not in name], ["after", "before", "c.html", "c.json"])

    def test_of_folders_the_other_pairs_are_listed(self):
        process, _ = self.start("before", "after", "--json", "c.json")
        time.sleep(1.0)
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, INTERRUPTED)
        rows = json.loads(self.path("c.json").read_text(encoding="utf-8"))
        self.assertEqual([(row["name"], row["exit_code"]) for row in rows], [("a", INTERRUPTED), ("b", INTERRUPTED)])
        self.assertEqual(rows[1]["problem"], "not compared: interrupted")
        self.assertIn("b: not compared: interrupted\n", output)


if __name__ == "__main__":
    main()
