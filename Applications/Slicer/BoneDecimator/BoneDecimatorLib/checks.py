# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of the user's values before a run. Needs the standard library only."""

import math
import numbers

MODES = ["Thesis", "Fast", "Balanced", "Accurate"]
KEEP_VOXELS = ["Off", "On", "Auto"]
AUTOMATIC = "automatic"  # the smoothing that voxels and tolerance suggest
LARGEST = 1e30  # mm, as in the program's table of options
MOST_TRIANGLES = 2**31 - 1


class DecimationError(RuntimeError):
    """What is wrong, in a sentence for the user."""


def check_number(name, value, least, most, unit=""):
    """Raises DecimationError for what is no number, NaN, infinite or outside the range."""
    is_number = isinstance(value, numbers.Real) and not isinstance(value, bool)
    if not is_number or math.isnan(value) or not least <= value <= most:
        raise DecimationError(f"{name} takes a number from {least:g} to {most:g}{unit and ' ' + unit}, not {value!r}."
                              .replace("e+", "e"))


def check_whole(name, value, least, most, unit=""):
    """The same for whole numbers."""
    if not isinstance(value, numbers.Integral) or isinstance(value, bool) or not least <= value <= most:
        raise DecimationError(f"{name} takes a whole number from {least} to {most}{unit and ' ' + unit}, not {value!r}.")


def check_length(name, value):
    """mm, 0 or more."""
    check_number(name, value, 0, LARGEST, "mm")


def check_mode(mode):
    if mode not in MODES:
        raise DecimationError(f"Mode takes one of {', '.join(MODES)}, not {mode!r}.")


def check_keep_voxels(choice):
    if choice not in KEEP_VOXELS:
        raise DecimationError(f"Keep voxels takes one of {', '.join(KEEP_VOXELS)}, not {choice!r}.")


def check_smoothing(smoothing):
    if smoothing != AUTOMATIC:
        check_length(f"The smoothing, if it is not {AUTOMATIC!r},", smoothing)


def check_ratio(name, value):
    """Above 0 and at most 1."""
    check_number(name, value, 0, 1)
    if value == 0:
        raise DecimationError(f"{name} takes a number above 0 and at most 1, not {value!r}.")
