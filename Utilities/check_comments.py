#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Lists comments of C++ that break off early, or that begin with "Of" and so are no phrase of their own.

    Utilities/check_comments.py FILE ...

A line breaks off early if the next word would fit and no sentence or clause ends there. Code, lists and tables in comments,
which are indented, are left alone. Prints "file:line: why: text" and exits with 1 if there is one.
"""
import re
import sys

COLUMNS = 94
COMMENT = re.compile(r"^(\s*)(///(?!<)|//|\*(?!/)) ?(.*)$")
NOT_PROSE = re.compile(r"\s|[-*@\\|#`]|\d+[.)]? |$|SPDX|.*\S {2,}[^@ ]")
CLAUSE_ENDS = (".", ":", ";")


def breaks_early(line, following):
    here, there = COMMENT.match(line), COMMENT.match(following)
    if not here or not there or here.group(1, 2) != there.group(1, 2):
        return False
    text, rest = here.group(3), there.group(3)
    if NOT_PROSE.match(text) or NOT_PROSE.match(rest) or text.rstrip().endswith(CLAUSE_ENDS):
        return False
    return len(line) + 1 + len(rest.split()[0]) <= COLUMNS


def problems(lines):
    for number, (line, following) in enumerate(zip(lines, lines[1:] + [""]), 1):
        if breaks_early(line, following):
            yield number, "breaks off early", line
        if re.search(r"(///?<?|/\*\*?) Of\b", line):
            yield number, 'begins with "Of"', line


def main():
    failed = False
    for file in sys.argv[1:]:
        with open(file, encoding="utf-8") as source:
            for number, why, line in problems(source.read().splitlines()):
                print(f"{file}:{number}: {why}: {line.strip()}")
                failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
