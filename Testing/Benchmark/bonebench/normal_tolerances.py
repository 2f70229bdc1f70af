# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The tolerance w of mode Thesis: its default and what the rule of AutomaticNormalTolerance chooses."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any, Iterator

if TYPE_CHECKING:
    from .features import Lab

Row = dict[str, Any]
PERCENT = (40, 30, 20, 10, 3)


def normal_tolerance(lab: Lab) -> Iterator[Row]:
    """Each bone at each number of triangles; from a half of them on both are the same."""
    for bone, percent in itertools.product(lab.bones(), PERCENT):
        count = 2 * round(percent * bone.triangles / 200)
        row: Row = {"bone": bone.name, "remaining, %": percent, "w": None}
        for words, how in (((), "0.95"), (("--auto-normal-tolerance", "on"), "rule")):
            done = lab.run(bone.file, "--mode", "Thesis", "--target-triangles", count, *words, "--measure", "off")
            row["w"] = done.report["normal_tolerance"]
            row.update({f"{column} {how}": value for column, value in lab.distances(bone.file).items()})
        yield row
