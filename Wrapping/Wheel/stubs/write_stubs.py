# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes _keywords.pyi and vtk_filter.pyi, what editors know of the options, from the table that the module was built with.

    write_stubs.py FOLDER        with the module and its options on the path
"""

import pathlib
import sys
import textwrap

from bonedecimate import _core
from bonedecimate.options import ROWS, WITHOUT_ARRAYS, words

FILTER = pathlib.Path(__file__).resolve().parent / "vtk_filter.pyi.in"
HEAD = "# Written at build time from the table of options.\n"


def document(row, indent):
    unit = f" {row.unit}" if row.unit else ""
    text = f'"""{row.sentence} Default: {row.default_text or "none"}{unit}."""'
    return textwrap.indent("\n".join(textwrap.wrap(text, 110 - len(indent))), indent) + "\n"


def type_of(row):
    return "Literal[" + ", ".join(f'"{choice}"' for choice in row.choices) + "]" if row.choices else row.kind


def keywords():
    text = HEAD + "from typing import Literal, TypedDict\n"
    for name, without in (("ArrayOptions", WITHOUT_ARRAYS), ("AllOptions", set())):
        text += f"\nclass {name}(TypedDict, total=False):\n"
        for key, row in ROWS.items():
            if key not in without:
                text += f"    {key}: {type_of(row)}\n" + document(row, "    ")
    return text


def filter_class():
    lines = []
    for row in ROWS.values():
        kind = "int" if row.choices else row.kind
        lines.append(f"    def Set{row.name}(self, value: {kind}) -> None:\n" + document(row, "        "))
        lines.append(f"    def Get{row.name}(self) -> {kind}: ...\n")
        if row.kind == "bool":
            lines.append(f"    def {row.name}On(self) -> None: ...\n    def {row.name}Off(self) -> None: ...\n")
    members = [member for kind in (_core.Mode, _core.ErrorPreset, _core.StopReason) for member in kind]
    constants = [f"    {words(member.name, '_').upper()}: int\n" for member in members]
    text = FILTER.read_text(encoding="utf-8").replace("    # CONSTANTS\n", "".join(constants))
    return HEAD + text.replace("    # PROPERTIES\n", "".join(lines))


def main(folder):
    for name, text in (("_keywords.pyi", keywords()), ("vtk_filter.pyi", filter_class())):
        (pathlib.Path(folder) / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
