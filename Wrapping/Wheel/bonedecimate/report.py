# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A report by name; deprecated names of entries warn."""

from __future__ import annotations

import math
from collections.abc import Mapping

from .options import deprecated

# Words of names before they were renamed, as in the JSON report of the program; removed with the next release.
RENAMED = {
    "faces": "triangles", "faces_read": "triangles_read", "locked_points": "non_manifold_points",
    "first_locked_point": "first_non_manifold_point", "frozen_points": "constrained_points", "verdict": "status",
    "borders": "boundaries", "border_output_to_input": "boundary_output_to_input",
    "border_input_to_output": "boundary_input_to_output", "border_reference_to_result": "boundary_reference_to_result",
    "border_result_to_reference": "boundary_result_to_reference", "refusals": "rejections", "findings": "diagnostics",
    "place": "center", "clearance": "fragment_gap", "KeepClearance": "IntersectionGuard", "ExamineInput": "DiagnoseInput"}
RENAMED_REJECTIONS = {"border": "boundary", "too_far": "error_bound", "frozen": "constrained", "crossing": "intersection"}


def number_text(value: float) -> str:
    """The shortest decimals, six at least, that read back the same, as in JSON reports."""
    if not math.isfinite(value):
        return "NaN" if math.isnan(value) else "infinity" if value > 0 else "-infinity"
    return next(text for digits in range(6, 18) if float(text := f"{value:.{digits}g}") == value)


def current_name(name: str) -> str:
    """The name of an entry by its deprecated name; itself if it is none."""
    words = [RENAMED.get(word, word) for word in name.split(".")]
    if words[0] == "rejections":
        words[1:] = [RENAMED_REJECTIONS.get(word, word) for word in words[1:]]
    return ".".join(words)


class Report(dict):
    """Values by name ("output.triangles"). A deprecated name warns and gives the value of the current one."""

    def __init__(self, values: Mapping[str, int | float | str]) -> None:
        super().__init__(values)

    def __missing__(self, name: str) -> int | float | str:
        current = current_name(name) if isinstance(name, str) else name
        if current not in self:
            raise KeyError(name)
        deprecated(name, current, 3)
        return self[current]

    def get(self, name: str, default=None):
        current = name if name in self or not isinstance(name, str) else current_name(name)
        if current != name and current in self:
            deprecated(name, current, 3)
        return super().get(current, default)
