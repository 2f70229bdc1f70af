#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the parts of the documentation that follow the tables of the program.

    write_pages.py PROGRAM            write them
    write_pages.py PROGRAM --check    fail if a page is not what would be written
"""

import json
import pathlib
import re
import subprocess
import sys

DOCUMENTATION = pathlib.Path(__file__).resolve().parents[1] / "Documentation"
TABLE = r"(?m)^{head}\n(?:\|.*\n)+"


def replaced(page, pattern, text):
    """The page with what the pattern matches replaced; it is there once."""
    matches = list(re.finditer(pattern, page))
    if len(matches) != 1:
        raise ValueError(f"found {len(matches)} times: {pattern}")
    return page[:matches[0].start()] + text + page[matches[0].end():]


def with_table(page, table):
    """The page with the table that has the same first line."""
    return replaced(page, TABLE.format(head=re.escape(table.splitlines()[0])), table)


def with_profiles(page, text):
    """The sections of the profiles, from the first heading to the last row below it."""
    first = re.escape(text.splitlines()[0])
    return replaced(page, rf"(?ms)^{first}\n(?:(?!^## ).)*^\|[^\n]*\n", text)


def table_of_modes(modes):
    head = "| mode | use | order of the collapses | position of the new vertex | refinement |\n|---|---|---|---|---|\n"
    keys = ("use", "order", "position", "refinement")
    return head + "".join(f"| `{mode['name']}` | " + " | ".join(mode[key] for key in keys) + " |\n" for mode in modes)


def with_rejections(page, reasons):
    """The schema with the reasons."""
    block = re.search(r'(?s)    "rejections": \{\n.*?\n    \},\n', page)[0]
    properties = [f'        "{row["word"]}": {{"description": {json.dumps(row["sentence"])}, "$ref": "#/$defs/count"}}' for row in reasons]
    required = [f'        "{row["word"]}"' for row in reasons]
    written = re.sub(r'(?s)(      "properties": \{\n).*?(\n      \},\n)', lambda part: part[1] + ",\n".join(properties) + part[2], block)
    written = re.sub(r'(?s)(      "required": \[\n).*?(\n      \])', lambda part: part[1] + ",\n".join(required) + part[2], written)
    return page.replace(block, written)


def pages(program):
    """Each page and what it is to be."""
    def printed(flag):
        return subprocess.run([program, flag], stdout=subprocess.PIPE, encoding="utf-8", check=True).stdout

    tables = json.loads(printed("--tables"))
    for name, write, part in (("reference/options.md", with_table, printed("--options-markdown")),
                              ("reference/command-line.md", with_profiles, printed("--profiles-markdown")),
                              ("explanation/modes.md", with_table, table_of_modes(tables["modes"])),
                              ("report.schema.json", with_rejections, tables["rejections"])):
        path = DOCUMENTATION / name
        before = path.read_text(encoding="utf-8")
        yield path, before, write(before, part)


def main(program, *words):
    differing = [(path, after) for path, before, after in pages(program) if before != after]
    for path, after in differing:
        if "--check" in words:
            print(f"{path} is not what Utilities/write_pages.py writes", file=sys.stderr)
        else:
            path.write_text(after, encoding="utf-8")
            print(f"wrote {path}")
    return 1 if differing and "--check" in words else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
