# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The report that travels with a mesh. What it proves, it proves of one surface: that whose triangles have its checksum."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from . import _core

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPolyData

REPORT = "BoneDecimateReport"


def checksum_of(data: vtkPolyData) -> str:
    from .polydata import surface_of  # imports VTK, which is there
    surface = surface_of(data)
    return _core.triangle_checksum(surface.points, surface.triangles)


def report_of(data: vtkPolyData) -> dict:
    """Objects within objects; empty if there is none. For another surface than the proved one, the proof is a sentence alone."""
    array = data.GetFieldData().GetAbstractArray(REPORT)
    report = json.loads(array.GetValue(0)) if array is not None and array.GetNumberOfValues() else {}
    proof = report.get("proof", {})
    if "if_unchanged" in proof:
        is_proved = report["output"]["checksum"] == checksum_of(data)
        sentence = proof["sentence"].split(": ", 1)[1] if is_proved else _core.changed_surface_sentence()
        report["proof"] = {**(proof["if_unchanged"] if is_proved else {}), "sentence": sentence}
    return report
