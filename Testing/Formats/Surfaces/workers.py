# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Processes that read many files each: started again where a reader crashes or hangs."""

import json
import pathlib
import subprocess
import tempfile
import time

FOLDER = pathlib.Path(__file__).resolve().parent
SECONDS = 20  # without a result; the machine may be busy
FAILED = {"error": "it crashes or hangs"}


class Worker:
    """Writes a line of JSON for each path of its standard input; the first line, a greeting, says that the reader is there."""

    def __init__(self, command, has_greeting=True):
        self.command, self.has_greeting = command, has_greeting

    def run(self, paths):
        """The results that came before it ended; None if it did not begin."""
        with tempfile.TemporaryFile("w+", encoding="utf-8") as questions, tempfile.TemporaryFile("w+", encoding="utf-8") as results:
            questions.writelines(f"{path}\n" for path in paths)
            questions.seek(0)
            process = subprocess.Popen(self.command, stdin=questions, stdout=results, stderr=subprocess.DEVNULL)
            size, since = 0, time.monotonic()
            while process.poll() is None:
                time.sleep(0.02)
                now = results.seek(0, 2)
                size, since = (now, time.monotonic()) if now != size else (size, since)
                if time.monotonic() - since > SECONDS:
                    process.kill()
            results.seek(0)
            lines = [line for line in results if line.endswith("\n")]
            if self.has_greeting and not lines:
                return None
            return lines[1:] if self.has_greeting else lines

    def read_all(self, paths):
        """An result for each; None if the reader is not there. A file is lost if a new process does not read it as its first."""
        results = []
        while len(results) < len(paths):
            found = self.run(paths[len(results) :])
            if found is None:
                return None
            results += [json.loads(line) for line in found]
            if not found:
                results.append(FAILED)
        return results


def worker_of(python, reader):
    return Worker([python, "-B", str(FOLDER / "read_with.py"), reader])
