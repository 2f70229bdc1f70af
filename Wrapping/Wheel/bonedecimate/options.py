# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The core's table of options as Python's keywords: `max_error` is `--max-error` and `MaximumError`."""

from __future__ import annotations

import re
from collections.abc import Mapping

from . import _core

# Of every option by keyword: its row.
ROWS: dict[str, _core.OptionInfo] = {}


def words(name: str, joint: str) -> str:
    """CamelCase as words: MeasureInputDistances, "_" -> measure_input_distances."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", joint, name).lower()


def keyword(row: _core.OptionInfo) -> str:
    """As the flag of the command line, or as the name where there is no flag."""
    return row.flag.replace("-", "_") or words(row.name, "_")


for _row in _core.option_table():
    ROWS[keyword(_row)] = _row

# What numpy arrays have no use for: names of arrays of a data set, and what becomes of the others of its arrays.
WITHOUT_ARRAYS = {key for key, row in ROWS.items() if row.name.endswith("ArrayName")} | {
    keyword(row) for row in ROWS.values() if row.name in ("PassArrays", "RecomputeNormals")
}


def _text(value: object) -> str:
    value = value.item() if hasattr(value, "item") else value
    if isinstance(value, bool):
        return "on" if value else "off"
    return value if isinstance(value, str) else repr(value)


def read(keywords: Mapping[str, object], without: set[str] = frozenset()) -> _core.Options:
    """Options with those values.

    Raises TypeError for a keyword that is none, ValueError for a value that is out of range.
    """
    options = _core.Options()
    for key, value in keywords.items():
        if key not in ROWS or key in without:
            there_are = ", ".join(name for name in ROWS if name not in without)
            raise TypeError(f"there is no option '{key}' here; there are: {there_are}")
        if isinstance(value, str) != (ROWS[key].kind == "str" or bool(ROWS[key].choices)):
            raise TypeError(f"{key} takes {_wanted(ROWS[key])}, not {value!r}")
        options.read(ROWS[key].name, _text(value))
    return options


def _wanted(row: _core.OptionInfo) -> str:
    return "one of " + ", ".join(map(repr, row.choices)) if row.choices else f"a value of type {row.kind}"
