# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""SIGINT and SIGTERM end a run; nothing of it is left."""

import signal
import subprocess
import time

from application import INTERRUPTED, PROGRAM, TEMPORARY, ApplicationTest, main, torus, write


class Interruption(ApplicationTest):
    def start(self, *words):
        return subprocess.Popen(
            [PROGRAM, *words],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            encoding="utf-8",
        )

    def wait_for_work(self, folder):
        """Until the program has reserved its output, which it does before it reads."""
        while not any(folder.glob(TEMPORARY + "*.ply")):
            time.sleep(0.005)

    def test_signals_leave_nothing(self):
        write(torus(600, 600), self.path("in.ply"))
        for name in (signal.SIGINT, signal.SIGTERM):
            process = self.start("in.ply", "out.ply", "--also", "out.stl", "--report", "report.json")
            self.wait_for_work(self.folder)
            process.send_signal(name)
            output, errors = process.communicate()
            self.assertEqual((process.returncode, output, errors), (INTERRUPTED, "", "bonedecimate: interrupted\n"))
            self.assertEqual(self.names(), ["in.ply"])

    def test_interrupted_batch_stops_its_children(self):
        self.path("bones").mkdir()
        for i in range(3):
            write(torus(600, 600), self.path("bones") / ("bone%d.ply" % i))
        process = self.start("bones", "out", "--jobs", "2")
        while not self.path("out").exists():
            time.sleep(0.005)
        self.wait_for_work(self.path("out"))
        process.send_signal(signal.SIGTERM)
        output, errors = process.communicate()
        self.assertEqual((process.returncode, errors), (INTERRUPTED, "bonedecimate: interrupted\n"))
        self.assertEqual(sorted(p.name for p in self.path("out").iterdir()), ["summary.csv"])
        table = self.path("out/summary.csv").read_text()
        self.assertEqual(table.count(",interrupted,4,") + table.count(",not run,,"), 3)
        self.assertIn("interrupted", output)
        self.succeed("bones", "out", "--target-reduction", "0.01", "--measure", "off")
        self.assertEqual(len(list(self.path("out").glob("*.ply"))), 3)


if __name__ == "__main__":
    main()
