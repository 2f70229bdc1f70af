# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The core's table of options as an engine prints it: a new option gets its widget, its checks and its flag from its row.

Needs the standard library only.
"""

import json
import re

from . import checks
from .checks import DecimationError

# Options that have a widget of their own, or that one replaces: presets are values of the tolerance.
CURATED = ("Mode", "TargetNumberOfTriangles", "TargetReduction", "MaximumError", "ErrorPreset", "VoxelSize", "Smoothing",
           "AutomaticSmoothing", "FeatureAngle", "KeepVoxels")
SEGMENT_RUNS = ("Arrays", "LabelMapSurface")  # the core's kinds of run that extracted segments have


def label(row):
    """MinimumAngle -> Minimum angle."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", row["name"]).capitalize()


def description(row):
    """Meaning, default, range and unit."""
    unit = row["unit"] and " " + row["unit"]
    text = f"{row['sentence']} Default: {row['default']}{unit}."
    if row["kind"] in ("int", "double"):
        text += f" Range: {row['minimum']:g} to {row['maximum']:.10g}{unit}.".replace("e+", "e")
    return text


def value_of(row, text):
    """The value that a text of the table, such as the default, means."""
    return {"bool": lambda: text == "on", "int": lambda: int(text), "double": lambda: float(text)}.get(row["kind"], lambda: text)()


class OptionTable:
    """Options are dictionaries of flags of the program, without dashes, and values: {"max-error": 0.2}."""

    def __init__(self, text):
        """@param text The JSON that `bonedecimate --options-json` prints."""
        self.rows = {row["name"]: row for row in json.loads(text)["options"]}
        self.by_flag = {row["flag"]: row for row in self.rows.values() if row["flag"]}

    @property
    def modes(self):
        """Those whose results can be proved."""
        prove = self.rows["ProveResult"]
        return [mode for mode in self.rows["Mode"]["choices"] if self.has_effect(prove, {"mode": mode, "max-error": 1.0})]

    def panel_rows(self):
        """Options for which the panel makes a widget: not the names of arrays, and not what has no effect in its modes."""
        return [row for row in self.by_flag.values() if row["name"] not in CURATED and row["kind"] != "text"
                and any(self._is_for(row, mode) for mode in self.modes)]

    def _is_for(self, row, mode):
        about_modes = [terms for terms in row["conditions"] if {name for name, _, _ in terms} == {"Mode"}]
        return all(self._is_met(terms, {"mode": mode}) for terms in about_modes)

    def _is_met(self, terms, options):
        return any((self._text(name, options) == value) == has_value for name, value, has_value in terms)

    def _text(self, name, options):
        """The value of an option as conditions have it: choices and switches are numbers."""
        row = self.rows[name]
        value = options.get(row["flag"], value_of(row, row["default"]))
        value = row["choices"].index(value) if row["choices"] else value
        return value if isinstance(value, str) else f"{value:g}"

    def has_effect(self, row, options):
        return all(self._is_met(terms, options) for terms in row["conditions"])

    def changed(self, options):
        """Without those that have their defaults."""
        rows = self.by_flag
        return {flag: value for flag, value in options.items() if value != value_of(rows[flag], rows[flag]["default"])}

    def check(self, options, names):
        """Raises DecimationError for the first flag that is none or whose value is wrong.  @param names Of options, by flag."""
        for flag, value in options.items():
            if flag not in self.by_flag:
                raise DecimationError(f"There is no option --{flag}.")
            checks.check_value(names.get(flag) or label(self.by_flag[flag]), value, self.by_flag[flag])

    def check_effects(self, flags, options):
        """Raises DecimationError for the first flag that does nothing beside the other options."""
        for row in map(self.by_flag.get, flags):
            for terms in row["conditions"]:
                if not self._is_met(terms, options):
                    needed = " or ".join(map(self._needed, terms))
                    raise DecimationError(f"{label(row)} has no effect; it needs {needed}.")

    def _needed(self, term):
        name, value, has_value = term
        row = self.rows[name]
        word = row["choices"][int(value)] if row["choices"] else ("off", "on")[int(value)] if row["kind"] == "bool" else value
        return f"{label(row)} {word}" if has_value else label(row)
