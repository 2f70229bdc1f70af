# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays as vtkPolyData."""

import json

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

REPORT, DISTANCE, COLORS = "BoneDecimateReport", "Distance", "Colors"  # names of arrays
BOUND = "only of the surface whose triangles have output.checksum: "
CHANGED = "nothing is proved of this surface: it is not the one that was proved, or was changed afterwards"


def polydata_of(points, corners):
    """@param points (n, 3), mm. @param corners (m, 3), of triangles."""
    surface = vtk.vtkPolyData()
    positions = vtk.vtkPoints()
    positions.SetData(numpy_to_vtk(points, deep=True))
    cells = vtk.vtkCellArray()
    offsets = np.arange(0, 3 * len(corners) + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(corners.astype(np.int64).ravel(), deep=True))
    surface.SetPoints(positions)
    surface.SetPolys(cells)
    return surface


def set_distance(surface, distance):
    """mm, of each point to the surface before simplification."""
    array = numpy_to_vtk(distance, deep=True)
    array.SetName(DISTANCE)
    surface.GetPointData().AddArray(array)


def set_colors(surface, colors):
    """@param colors (m, 3), from 0 to 1, of triangles."""
    array = numpy_to_vtk(np.rint(255 * colors).astype(np.uint8), deep=True)
    array.SetName(COLORS)
    surface.GetCellData().AddArray(array)


def checksum_of(surface):
    """As the core computes it (Mesh/Checksum.h): of the triangles in any order, to the bit. Empty unless it is one of triangles."""
    polygons = surface.GetPolys()
    if not surface.GetPoints() or surface.GetNumberOfStrips() > 0 or polygons.IsHomogeneous() != 3:
        return ""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(np.float64) + 0.0
    triangles = points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    each = np.arange(len(triangles))
    least = np.zeros(len(triangles), dtype=np.int64)
    for corner in (1, 2):
        one, other = triangles[:, corner], triangles[each, least]
        differs = one != other
        axis = differs.argmax(axis=1)
        least[differs.any(axis=1) & (one[each, axis] < other[each, axis])] = corner
    rotated = triangles[each[:, None], (least[:, None] + np.arange(3)) % 3]
    sums = np.full(len(triangles), 14695981039346656037, dtype=np.uint64)
    for word in np.ascontiguousarray(rotated).reshape(-1, 9).view(np.uint64).T:
        sums = _mixed(sums + word)
    return f"triangles:{int(sums.sum(dtype=np.uint64)):016x}"


def _mixed(words):
    """SplitMix64."""
    words = words + np.uint64(0x9e3779b97f4a7c15)
    words = (words ^ (words >> np.uint64(30))) * np.uint64(0xbf58476d1ce4e5b9)
    words = (words ^ (words >> np.uint64(27))) * np.uint64(0x94d049bb133111eb)
    return words ^ (words >> np.uint64(31))


def set_report(surface, report):
    """@param report Nested dictionaries; what it proves holds for this surface as it is now."""
    if "proof" in report:
        proof = {name: value for name, value in report["proof"].items() if name != "sentence"}
        sentence = report["proof"].get("sentence", "")
        report = {**report, "output": {**report["output"], "checksum": checksum_of(surface)},
                  "proof": {"if_unchanged": proof, "sentence": BOUND + sentence}}
    text = vtk.vtkStringArray()
    text.SetName(REPORT)
    text.InsertNextValue(json.dumps(report))
    surface.GetFieldData().AddArray(text)


def report_of(surface):
    """The report of the run as nested dictionaries; empty if there is none. A proof belongs to one surface: of another one, or of
    one that was changed since, it is a sentence that says so."""
    array = surface.GetFieldData().GetAbstractArray(REPORT)
    report = json.loads(array.GetValue(0)) if array is not None and array.GetNumberOfValues() > 0 else {}
    proof = report.get("proof", {})
    if "if_unchanged" in proof:
        is_proved = report["output"]["checksum"] == checksum_of(surface)
        report["proof"] = ({**proof["if_unchanged"], "sentence": proof["sentence"].replace(BOUND, "", 1)} if is_proved
                           else {"sentence": CHANGED})
    return report
