# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The code blocks of the README."""

import pathlib
import re

README = pathlib.Path(__file__).resolve().parents[2] / "README.md"


def blocks():
    """All code blocks in their order, as (section, language, text)."""
    found = []
    for section in re.split(r"^## ", README.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
        title = section.splitlines()[0]
        found += [(title, *block) for block in re.findall(r"^```(\w+)\n(.*?)^```$", section, re.DOTALL | re.MULTILINE)]
    return found


def block(section, language):
    """The code block of that language in that section; there must be exactly one."""
    (text,) = [text for title, name, text in blocks() if (title, name) == (section, language)]
    return text
