# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of a report as text."""

from __future__ import annotations

import math


def number_text(value: float) -> str:
    """The shortest decimals, six at least, that read back the same, as in JSON reports."""
    if not math.isfinite(value):
        return "NaN" if math.isnan(value) else "infinity" if value > 0 else "-infinity"
    return next(text for digits in range(6, 18) if float(text := f"{value:.{digits}g}") == value)
