# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Processes that read files: started again where a reader crashes or hangs."""

import json
import pathlib
import select
import subprocess

FOLDER = pathlib.Path(__file__).resolve().parent
SECONDS = 60  # for a file; the machine may be busy


class Worker:
    def __init__(self, command, has_greeting=True):
        self.command, self.has_greeting, self.process = command, has_greeting, None

    def start(self):
        """Whether it is there."""
        self.process = subprocess.Popen(
            self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, encoding="utf-8"
        )
        return not self.has_greeting or self.answer(2 * SECONDS) is not None

    def answer(self, seconds=SECONDS):
        ready, _, _ = select.select([self.process.stdout], [], [], seconds)
        line = self.process.stdout.readline() if ready else ""
        return json.loads(line) if line else None

    def read(self, path):
        if self.process is None:
            self.start()
        try:
            self.process.stdin.write(str(path) + "\n")
            self.process.stdin.flush()
            answer = self.answer()
        except BrokenPipeError:
            answer = None
        if answer is None:
            self.stop()
            return {"error": "it crashes or hangs"}
        return answer

    def stop(self):
        if self.process is not None:
            self.process.kill()
            self.process.communicate()
            self.process = None


def worker_of(python, reader):
    """None if that Python does not have the reader."""
    worker = Worker([python, "-B", str(FOLDER / "read_with.py"), reader])
    if worker.start():
        return worker
    worker.stop()
    return None
