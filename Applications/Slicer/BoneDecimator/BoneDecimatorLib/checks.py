# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of the user's values before a run. Needs the standard library only."""

import numbers

AUTOMATIC = "automatic"  # the smoothing that voxels and tolerance suggest
LARGEST = 1e30  # mm, as in the core's table of options
MOST_TRIANGLES = 2**31 - 1


class DecimationError(RuntimeError):
    """What is wrong, in a sentence for the user."""


def check_number(name, value, least, most, unit=""):
    """Raises DecimationError for what is no number, NaN, infinite or outside the range."""
    is_number = isinstance(value, numbers.Real) and not isinstance(value, bool)
    if not is_number or not least <= value <= most:  # NaN is in no range
        raise DecimationError(f"{name} takes a number from {least:g} to {most:g}{unit and ' ' + unit}, not {value!r}."
                              .replace("e+", "e"))


def check_whole(name, value, least, most, unit=""):
    """The same for whole numbers."""
    if not isinstance(value, numbers.Integral) or isinstance(value, bool) or not least <= value <= most:
        raise DecimationError(f"{name} takes a whole number from {least} to {most}{unit and ' ' + unit}, not {value!r}.")


def check_length(name, value):
    """mm, 0 or more."""
    check_number(name, value, 0, LARGEST, "mm")


def check_value(name, value, row):
    """The same for the value of an option, by its row in the table of options."""
    if row["kind"] in ("int", "double"):
        check = check_whole if row["kind"] == "int" else check_number
        check(name, value, row["minimum"], row["maximum"], row["unit"])
    elif row["kind"] == "choice" and value not in row["choices"]:
        raise DecimationError(f"{name} takes one of {', '.join(row['choices'])}, not {value!r}.")
    elif row["kind"] == "bool" and not isinstance(value, bool):
        raise DecimationError(f"{name} takes True or False, not {value!r}.")
    elif row["kind"] == "text" and not isinstance(value, str):
        raise DecimationError(f"{name} takes a text, not {value!r}.")


def check_ratio(name, value):
    """Above 0 and at most 1."""
    check_number(name, value, 0, 1)
    if value == 0:
        raise DecimationError(f"{name} takes a number above 0 and at most 1, not {value!r}.")
