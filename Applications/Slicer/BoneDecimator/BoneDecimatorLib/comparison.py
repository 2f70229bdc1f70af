# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The proved distance of two models as lines of text."""

import math
from dataclasses import dataclass

import numpy as np

DECIMALS = 4
DIRECTIONS = {"reference_to_result": "reference to result", "result_to_reference": "result to reference",
              "boundary_reference_to_result": "open boundaries, reference to result",
              "boundary_result_to_reference": "open boundaries, result to reference"}
ONE_SIDED = {"reference_only": "only the reference has open boundaries", "result_only": "only the result has open boundaries"}


@dataclass
class Comparison:
    """What an engine has found."""

    report: dict  # nested, as Documentation/certificate.schema.json describes it
    distances: tuple[np.ndarray, np.ndarray] | None  # mm, of each point of both; None: the engine does not measure them


def bounds_text(bounds):
    """Rounded outwards, so that what is printed is proved, too."""
    scale = 10**DECIMALS
    if bounds["upper"] is None or bounds["lower"] is None:  # not finite
        return "not known"
    return f"{math.floor(bounds['lower'] * scale) / scale:.{DECIMALS}f} to {math.ceil(bounds['upper'] * scale) / scale:.{DECIMALS}f} mm"


def _line_of(words, found):
    line = f"{words}: {bounds_text(found)}"
    if found["triangle"] >= 0:
        line += f" at ({found['x']:.1f}, {found['y']:.1f}, {found['z']:.1f})"
    return line + (f", mean {found['mean']:.{DECIMALS}f} mm" if "mean" in found else "")


def comparison_lines(report, tolerance=None):
    """@param tolerance mm; None: there was none."""
    lines = [f"largest distance, proved: {bounds_text(report)}"]
    if tolerance is not None:
        lines.append(f"tolerance of {tolerance:g} mm: {report['status']}")
    one_sided = ONE_SIDED.get(report["boundaries"])
    shown = [key for key in DIRECTIONS if key in report and not (one_sided and key.startswith("boundary"))]
    left_out = [f"not compared: {entry['sentence']}" for entry in report.get("left_out", [])]
    return lines + [_line_of(DIRECTIONS[key], report[key]) for key in shown] + [one_sided] * bool(one_sided) + left_out
