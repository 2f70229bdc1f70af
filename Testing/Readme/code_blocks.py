# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The code blocks of a page, and a runner for them."""

import contextlib
import io
import os
import re
import subprocess

NUMBER = re.compile(r"\d[\d,]*(?:\.\d+)?(?:e[-+]?\d+)?")
FILE_NAME = re.compile(r"(?://|#) (\S+)\n")


def blocks_of(page):
    """All code blocks of a Markdown page in their order, as (section, language, text)."""
    found = []
    for section in re.split(r"^## ", page.read_text(encoding="utf-8"), flags=re.MULTILINE):
        title = section.splitlines()[0]
        found += [(title, *block) for block in re.findall(r"^```(\w+)\n(.*?)^```$", section, re.DOTALL | re.MULTILINE)]
    return found


def block(page, section, language):
    """The code block of that language in that section; there must be exactly one."""
    (text,) = [text for title, name, text in blocks_of(page) if (title, name) == (section, language)]
    return text


def words_of(line):
    """A line without its numbers and the width of its spaces."""
    return " ".join(NUMBER.sub("0", line).split())


def numbers_of(line):
    return [float(number.replace(",", "")) for number in NUMBER.findall(line)]


def said_lines(printed, output):
    """For each printed line the line of the output with the same words, in their order; None where there is none."""
    rest = iter(output.splitlines())
    return [next((line for line in rest if words_of(line) == words_of(wanted)), None) for wanted in printed.splitlines()]


class Runner:
    """Runs the code blocks of a page in a folder, in their order, in one interpreter.

    sh and js are run, python is run with the names of the blocks before, and a language of FILES is written to the file that its
    first line names. A block of the language text lists lines that the block before prints, with the same numbers.
    """

    FILES = ("cpp", "cmake")
    INTERPRETERS = {"sh": (("sh", "-e"), "block.sh"), "js": (("node",), "block.mjs")}

    def __init__(self, folder, names=None, **environment):
        self.folder, self.names, self.output = folder, dict(names or {}), ""
        self.environment = {**os.environ, **environment}

    def run(self, language, text):
        """Lines of the language text that are not as printed, each with what is there instead; fails if the block does."""
        if language == "text":
            return self.differences(text)
        if language in self.FILES:
            (self.folder / FILE_NAME.match(text)[1]).write_text(text, encoding="utf-8")
        elif language in self.INTERPRETERS:
            interpreter, name = self.INTERPRETERS[language]
            (self.folder / name).write_text(text, encoding="utf-8")
            done = subprocess.run([*interpreter, name], cwd=self.folder, env=self.environment, check=False,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            (self.folder / name).unlink()
            assert done.returncode == 0, f"{text}\n{done.stdout}"
            self.output = done.stdout
        elif language == "python":
            said = io.StringIO()
            with contextlib.chdir(self.folder), contextlib.redirect_stdout(said):
                exec(compile(text, "block", "exec"), self.names)
            self.output = said.getvalue()
        else:
            raise AssertionError(f"no way to run {language}")
        return []

    def differences(self, text):
        found = []
        for printed, said in zip(text.splitlines(), said_lines(text, self.output)):
            if said is None:
                found.append(f"'{printed}' is not said; the output is\n{self.output}")
            elif numbers_of(printed) != numbers_of(said):
                found.append(f"'{printed}' is now '{said}'")
        return found
