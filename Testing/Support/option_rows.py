# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of options for tests that have a case for every option: those without a case of their own get one from the table.

The environment variable OPTION_TABLE names the file that the build wrote. Values are texts, as on the command line.
"""

import json
import os
import subprocess


def read_rows(text=None):
    """By the names of the options. text: the table; None: that of the file."""
    if text is None:
        with open(os.environ["OPTION_TABLE"], encoding="utf-8") as file:
            text = file.read()
    return {row["name"]: row for row in json.loads(text)["options"]}


def another_value(row):
    """In the range, and not the default."""
    default = row["default"]
    if row["kind"] == "bool":
        return "off" if default == "on" else "on"
    if row["kind"] == "text":
        return "another name"
    if row["kind"] == "choice":
        return next(choice for choice in row["choices"] if choice != default)
    if row["kind"] == "int":
        return str(int(default) + 2)
    return f"{row['maximum'] / 4 if row['maximum'] < 1e30 else float(default) + 0.25:g}"


def value_number(row, text):
    """The text as ParaView's XML has it: choices and switches as numbers."""
    if row["kind"] == "choice":
        return str(row["choices"].index(text))
    return str(int(text == "on")) if row["kind"] == "bool" else text


def needed_values(rows, row):
    """Values of other options with which the option has an effect."""
    values = {}
    for terms in row["conditions"]:
        def is_met(term):
            name, value, has_value = term
            held = value_number(rows[name], values.get(name, rows[name]["default"]))
            return (held == value) == has_value
        if not any(map(is_met, terms)):
            name, value, has_value = terms[0]
            other = rows[name]
            if not has_value:
                values[name] = another_value(other)
            else:
                values[name] = (other["choices"][int(value)] if other["kind"] == "choice" else
                                ("off", "on")[int(value)] if other["kind"] == "bool" else value)
    return values


def case_of(rows, row):
    """{option: value}: with it the option has an effect and another value than its default."""
    return {**needed_values(rows, row), row["name"]: another_value(row)}


def cases_of_flags(program):
    """Name, flag, words of the command line and value of each option with a flag, by the table of the program."""
    table = subprocess.run([program, "--options-json"], stdout=subprocess.PIPE, encoding="utf-8", check=True).stdout
    rows = read_rows(table)
    for name, row in rows.items():
        if row["flag"]:
            values = case_of(rows, row)
            words = tuple(word for other, value in values.items() for word in ("--" + rows[other]["flag"], value))
            yield name, "--" + row["flag"], words, values[name]
