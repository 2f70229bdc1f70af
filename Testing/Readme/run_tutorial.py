#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs every code block of a tutorial as printed and compares what it says: run_tutorial.py PAGE.md [--write]

--write puts what the blocks say now into the page. PROGRAMS is the folder of the programs. Pages with C++ are built against what BINARY_DIR,
the build of the project, installs, and without it against what the system has. Pages with JavaScript need PACKAGE, the package for npm.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

from code_blocks import Runner, blocks_of, said_lines


def environment_of(blocks, folder):
    """What the blocks find: programs, the installed project, the package for npm."""
    languages = {language for _, language, _ in blocks}
    found = {"PATH": os.pathsep.join([os.environ.get("PROGRAMS", ""), os.environ["PATH"]])}
    if "cmake" in languages:
        found["CMAKE_GENERATOR"] = "Ninja"
        if "BINARY_DIR" in os.environ:
            found["CMAKE_PREFIX_PATH"] = str(folder / "installed")
            subprocess.run(["cmake", "--install", os.environ["BINARY_DIR"], "--prefix", found["CMAKE_PREFIX_PATH"]], check=True,
                           stdout=subprocess.DEVNULL)
    if "js" in languages:
        (folder / "node_modules").mkdir()
        (folder / "node_modules" / "bonedecimate").symlink_to(pathlib.Path(os.environ["PACKAGE"]).resolve())
    return found


def rewrite(page, printed, output):
    """Puts the lines of the output that have the same words as the printed ones into the page."""
    lines = [said or line for line, said in zip(printed.splitlines(), said_lines(printed, output))]
    page.write_text(page.read_text(encoding="utf-8").replace(printed, "\n".join(lines) + "\n"), encoding="utf-8")


def run_page(page, writes, names=None):
    """The exit code: 1 if a line is not as printed. names are those that the blocks of Python find."""
    blocks, problems = blocks_of(page), []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        runner = Runner(folder, names, **environment_of(blocks, folder))
        for _, language, text in blocks:
            problems += runner.run(language, text)
            if writes and language == "text":
                rewrite(page, text, runner.output)
    for problem in problems:
        print(problem)
    print(f"{len(blocks)} blocks, {len(problems)} lines that are not as printed")
    return 1 if problems or not blocks else 0


if __name__ == "__main__":
    sys.exit(run_page(pathlib.Path(sys.argv[1]), "--write" in sys.argv))
