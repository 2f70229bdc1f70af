# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The code blocks of the README."""

import pathlib

from code_blocks import blocks_of

README = pathlib.Path(__file__).resolve().parents[2] / "README.md"


def blocks():
    """All code blocks in their order, as (section, language, text)."""
    return blocks_of(README)


def block(section, language):
    """The code block of that language in that section; there must be exactly one."""
    (text,) = [text for title, name, text in blocks() if (title, name) == (section, language)]
    return text
