# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that both filters make, the C++ one and that of the wheel, and what there is to compare of their outputs."""

import hashlib
import itertools
import math
import re

import numpy as np
from vtkmodules.vtkCommonCore import (VTK_STRING, vtkBitArray, vtkDataArray, vtkDoubleArray, vtkFloatArray,
                                      vtkIdTypeArray, vtkIntArray, vtkLogger, vtkPoints, vtkShortArray,
                                      vtkStringArray)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

# VTK builds arrays of normals, and its versions differ.
DEPENDS_ON_VTK = {"RecomputedNormals"}


def sin(angle):
    """The same bits with every mathematical library."""
    return round(math.sin(angle), 9)


def cos(angle):
    return round(math.cos(angle), 9)


def torus(around=40, across=20, single=False, shift=0.0, bumps=0.0):
    """A closed surface, mm."""
    points = vtkPoints()
    points.SetDataTypeToFloat() if single else points.SetDataTypeToDouble()
    triangles = vtkCellArray()
    for i in range(around):
        for j in range(across):
            u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
            thick = 3 + bumps * sin(7 * u) * sin(5 * v)
            out = 10 + thick * cos(v)
            points.InsertNextPoint(shift + out * cos(u), out * sin(u), thick * sin(v))
            a, b = i * across + j, (i + 1) % around * across + j
            c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
            for corners in ((a, b, c), (a, c, d)):
                triangles.InsertNextCell(3, corners)
    return polydata(points, triangles)


def polydata(points, triangles):
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    return surface


def triangles_of(surface):
    return [tuple(surface.GetCell(i).GetPointId(k) for k in range(3)) for i in range(surface.GetNumberOfCells())]


def patch(single=True):
    """A wavy patch with an open boundary and a hole."""
    points = vtkPoints()
    points.SetDataTypeToFloat() if single else points.SetDataTypeToDouble()
    triangles = vtkCellArray()
    side = 24
    for i in range(side):
        for j in range(side):
            points.InsertNextPoint(0.5 * i, 0.5 * j, sin(0.4 * i) * cos(0.3 * j))
            if i + 1 < side and j + 1 < side and not (8 < i < 12 and 8 < j < 12):
                a = i * side + j
                triangles.InsertNextCell(3, (a, a + side, a + side + 1))
                triangles.InsertNextCell(3, (a, a + side + 1, a + 1))
    return polydata(points, triangles)


def add(data, kind, name, count, value, components=1):
    array = kind()
    array.SetName(name)
    array.SetNumberOfComponents(components)
    array.SetNumberOfTuples(count)
    for i in range(count * components):
        array.SetValue(i, value(i))
    data.AddArray(array)
    return array


def with_arrays(surface):
    """Arrays of many types on points and cells, some of them active."""
    points, cells = surface.GetNumberOfPoints(), surface.GetNumberOfCells()
    data = surface.GetPointData()
    add(data, vtkDoubleArray, "Density", points, lambda i: math.nan if i % 50 == 7 else 1 / (i + 1)).SetComponentName(0, "HU")
    add(data, vtkShortArray, "Label", points, lambda i: i % 5)
    add(data, vtkFloatArray, "Vector", points, lambda i: sin(i), 3)
    add(data, vtkFloatArray, "Normal", points, lambda i: cos(i // 60 + i % 3), 3)
    add(data, vtkIdTypeArray, "Id", points, lambda i: 10 * i)
    add(data, vtkBitArray, "Bit", points, lambda i: i % 3 == 0)
    add(data, vtkStringArray, "Text", points, lambda i: f"point {i}")
    add(data, vtkDoubleArray, "Distance", points, lambda i: 1e9)  # of no run: it gets another name
    add(data, vtkDoubleArray, "GlobalDouble", points, lambda i: i + 0.5)
    data.SetActiveScalars("Label")
    data.SetActiveNormals("Normal")
    data.SetActiveVectors("Vector")
    data.SetPedigreeIds(data.GetArray("Id"))
    data.SetGlobalIds(data.GetArray("GlobalDouble"))
    add(surface.GetCellData(), vtkIntArray, "Part", cells, lambda i: i // 7, 2)
    add(surface.GetCellData(), vtkStringArray, "Name", cells, lambda i: f"cell {i}")
    surface.GetCellData().SetActiveScalars("Part")
    add(surface.GetFieldData(), vtkStringArray, "Patient", 1, lambda i: "phantom")
    return surface


def with_lines(surface, wrong=False):
    """Vertices and lines, some at points of their own."""
    last = surface.GetNumberOfPoints()
    for i in range(4):
        surface.GetPoints().InsertNextPoint(100 + i / 3, 0.1 * i, 0)
    verts, lines = vtkCellArray(), vtkCellArray()
    verts.InsertNextCell(1, [last + 2])
    verts.InsertNextCell(2, [5, last])
    if wrong:
        verts.InsertNextCell(1, [last + 99])
    lines.InsertNextCell(4, [last + 3, last, 7, last + 1])
    surface.SetVerts(verts)
    surface.SetLines(lines)
    return surface


def polygons():
    """A box of quads with a pentagon and a strip beside it, a polygon of two points, cell data."""
    points, polys, strips = vtkPoints(), vtkCellArray(), vtkCellArray()
    for i in range(14):
        for j in range(14):
            points.InsertNextPoint(i, j, 0.05 * i * j)
            if i and j and (i, j) != (3, 3):
                a = (i - 1) * 14 + j - 1
                polys.InsertNextCell(4, [a, a + 14, a + 15, a + 1])
    polys.InsertNextCell(2, [0, 1])
    polys.InsertNextCell(4, [28, 43, 42, 29])  # it crosses itself
    base = points.GetNumberOfPoints()
    for x, y in ((20, 0), (22, 0), (23, 2), (21, 3), (19, 2), (30, 0), (30, 1), (31, 0), (31, 1), (32, 0), (32, 1)):
        points.InsertNextPoint(x, y, 0)
    polys.InsertNextCell(5, range(base, base + 5))
    strips.InsertNextCell(6, range(base + 5, base + 11))
    surface = polydata(points, polys)
    surface.SetStrips(strips)
    with_lines(surface)
    return with_arrays(surface)


def textured():
    """Two patches that meet at points of equal coordinates, with other texture coordinates on each."""
    points, triangles = vtkPoints(), vtkCellArray()
    for side in range(2):
        first = points.GetNumberOfPoints()
        for i in range(9):
            for j in range(9):
                points.InsertNextPoint(8 * side + i, j, 0.1 * i * (8 - i))
                if i and j:
                    a = first + 9 * (i - 1) + j - 1
                    triangles.InsertNextCell(3, [a, a + 9, a + 10])
                    triangles.InsertNextCell(3, [a, a + 10, a + 1])
    surface = polydata(points, triangles)
    data = surface.GetPointData()
    add(data, vtkFloatArray, "Texture", points.GetNumberOfPoints(), lambda i: (i % 81) / 81, 2)
    data.SetActiveTCoords("Texture")
    return surface


def boxes(has_lines=False):
    """Labels 3 and 5 side by side, as the faces of their voxels with one wall, and the arrays of a label map."""
    def label(x, y, z):
        return 0 if not (0 <= x < 8 and 0 <= y < 4 and 0 <= z < 4) else 3 if x < 4 else 5

    points, triangles, ids, pairs = vtkPoints(), vtkCellArray(), {}, []
    for voxel, axis in itertools.product(itertools.product(range(-1, 9), range(-1, 5), range(-1, 5)), range(3)):
        below, above = label(*voxel), label(*(voxel[k] + (k == axis) for k in range(3)))
        if below == above:
            continue
        square = []
        for u, v in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
            shift = {axis: 0.5, (axis + 1) % 3: u, (axis + 2) % 3: v}
            corner = tuple(voxel[k] + shift[k] for k in range(3))
            if corner not in ids:
                ids[corner] = points.InsertNextPoint(corner)
            square.append(ids[corner])
        is_upward = above == 0 or 0 < below < above
        a, b, c, d = square if is_upward else reversed(square)
        for corners in ((a, b, c), (a, c, d)):
            triangles.InsertNextCell(3, corners)
            pairs += (below, above) if is_upward else (above, below)
    surface = polydata(points, triangles)
    return with_label_map(with_lines(surface), [0, 0] * 3 + pairs) if has_lines else with_label_map(surface, pairs)


def with_label_map(surface, pairs, labels=(3, 5, 0)):
    fields = surface.GetFieldData()
    add(surface.GetCellData(), vtkIntArray, "BoundaryLabels", len(pairs) // 2, lambda i: pairs[i], 2)
    add(surface.GetPointData(), vtkIntArray, "GridPoint", surface.GetNumberOfPoints(), lambda i: 1, 3)
    add(fields, vtkIntArray, "LabelValues", len(labels), lambda i: labels[i])
    add(fields, vtkDoubleArray, "VoxelGridOrigin", 1, lambda i: 0.0, 3)
    add(fields, vtkDoubleArray, "VoxelGridSpacing", 1, lambda i: 1.0, 3)
    add(fields, vtkDoubleArray, "VoxelGridDirection", 1, lambda i: float(i % 4 == 0), 9)
    add(fields, vtkIntArray, "VoxelGridDimensions", 1, lambda i: 8, 3)
    return surface


def tolerant(surface, value, kind=vtkDoubleArray):
    add(surface.GetPointData(), kind, "Tolerance", surface.GetNumberOfPoints(), value)
    return surface


def spoilt(surface, position):
    surface.GetPoints().SetPoint(17, position)
    return surface


def wrong_index():
    surface = torus(8, 6)
    surface.GetPolys().InsertNextCell(3, [0, 1, 4711])
    return surface


def cases():
    """By name: input and properties."""
    half = {"TargetReduction": 0.5}
    return {
        "Default": (torus(), {}),
        "Single": (torus(single=True, bumps=0.3), {"MaximumError": 0.2}),
        "SingleToDouble": (torus(single=True), {**half, "OutputPointsPrecision": 1}),
        "DoubleToSingle": (with_lines(torus()), {**half, "OutputPointsPrecision": 0}),
        "Arrays": (with_arrays(torus(single=True)), {**half, "MakeMaps": True, "MeasureInputDistances": True}),
        "ArraysOfAPatch": (with_arrays(with_lines(patch())), {"MaximumError": 0.1, "MeasureInputDistances": True}),
        "NoArrays": (with_arrays(patch(False)), {**half, "PassArrays": False, "DistanceArrayName": "Mine"}),
        "NothingMeasured": (torus(), {**half, "MeasureDistances": False}),
        "Polygons": (polygons(), {**half, "MakeMaps": True}),
        "RecomputedNormals": (with_arrays(patch()), {**half, "RecomputeNormals": True}),
        "Thesis": (torus(single=True), {"Mode": 0, "TargetNumberOfTriangles": 300, "NormalTolerance": 0.9}),
        "ThesisWithConstrainedParts": (tolerant(torus(), lambda i: 0 if i < 200 else -1, vtkShortArray),
                                       {"Mode": 0, **half, "ToleranceArrayName": "Tolerance"}),
        "Fast": (torus(120, 60, bumps=0.4), {"Mode": 1, "TargetNumberOfTriangles": 2000}),
        "FastOnOneThread": (torus(120, 60, bumps=0.4), {"Mode": 1, "TargetNumberOfTriangles": 2000, "NumberOfThreads": 1}),
        "Accurate": (torus(60, 40, bumps=0.4), {"Mode": 3, "TargetReduction": 0.8}),
        "Tolerances": (tolerant(patch(), lambda i: 0.02 * (i % 9), vtkFloatArray), {"ToleranceArrayName": "Tolerance"}),
        "Preset": (patch(False), {"ErrorPreset": 2, "VoxelSize": 0.5, "IntersectionGuard": False}),
        "Reference": (torus(bumps=0.3), {"MaximumError": 0.2, "ReferenceData": torus(bumps=0.31)}),
        "ReferenceTooFar": (torus(bumps=0.3), {"MaximumError": 0.001, "ReferenceData": torus()}),
        "ClosedTunnel": (with_arrays(torus()), {**half, "TunnelSize": 14.5, "MakeMaps": True, "MeasureInputDistances": True}),
        "LabelMap": (boxes(has_lines=True), {"KeepVoxels": 1}),
        "LabelMapOfOtherPoints": (with_lines(boxes()), {}),
        "LabelMapWithoutArrays": (boxes(), {**half, "PassArrays": False, "Smoothing": 0.2}),
        "LabelMapOff": (boxes(), {**half, "KeepVoxels": 0, "MakeMaps": True}),
        "LabelMapOfAnotherLabel": (with_label_map(torus(), [3, 4] * 1600), {}),
        "KeepVoxelsWithoutGrid": (torus(), {"KeepVoxels": 1}),
        "TextureSeam": (textured(), half),
        "TextureSeamThatStays": (textured(), {**half, "MergePoints": False}),
        "Empty": (vtkPolyData(), {}),
        "PointsAlone": (polydata(torus(6, 5).GetPoints(), vtkCellArray()), {}),
        "NotANumber": (spoilt(torus(), (math.nan, 0, 0)), {}),
        "WrongIndex": (wrong_index(), {}),
        "WrongLines": (with_lines(torus(), wrong=True), half),
        "EdgeLengths": (tolerant(torus(), lambda i: 1.0 + i % 9, vtkFloatArray),
                        {"MaximumError": 0.2, "EdgeLength": 6.0, "EdgeLengthArrayName": "Tolerance", "ChordalError": 0.3}),
        "NoSuchEdgeLengths": (torus(), {"EdgeLength": 6.0, "EdgeLengthArrayName": "Nonsense"}),
        "NoSuchTolerances": (torus(), {"ToleranceArrayName": "Nonsense"}),
        "BadTolerances": (tolerant(torus(), lambda i: math.inf), {"ToleranceArrayName": "Tolerance"}),
    }


class Ear:
    """What a filter says by events, without where it says it."""

    def __init__(self, speaker):
        self.texts = []

        def listen(_caller, event, text):
            words = text.strip().split("): ", 1)[-1]
            self.texts.append(f"{event}: {words}")

        listen.CallDataType = VTK_STRING
        for event in ("ErrorEvent", "WarningEvent"):
            speaker.AddObserver(event, listen)


def digest(array):
    if isinstance(array, vtkDataArray) and not isinstance(array, vtkBitArray):
        values = np.asarray(memoryview(array)).tobytes() if array.GetNumberOfValues() else b""
        return hashlib.sha256(values).hexdigest()
    values = [str(array.GetValue(i)) for i in range(array.GetNumberOfValues())]
    if array.GetName() == "BoneDecimateReport":  # the times differ from run to run
        values = [re.sub(r'"seconds": \{[^}]*\}', "", value) for value in values]
    return hashlib.sha256("\n".join(values).encode()).hexdigest()


def described(data):
    """Every array with its type, names, role and a digest of its values."""
    found = []
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        name = array.GetName()
        if "seconds." in name:
            continue
        role = data.IsArrayAnAttribute(i) if hasattr(data, "IsArrayAnAttribute") else -1
        found.append([name, array.GetDataType(), array.GetNumberOfComponents(), array.GetComponentName(0),
                      array.GetNumberOfTuples(), role, digest(array)])
    return found


def portrait(surface):
    """Of a vtkPolyData: everything, as what JSON can hold."""
    found = {"point data": described(surface.GetPointData()), "cell data": described(surface.GetCellData()),
             "field data": described(surface.GetFieldData())}
    for kind in ("Verts", "Lines", "Polys", "Strips"):
        cells = getattr(surface, "Get" + kind)()
        ids = [cells.GetOffsetsArray(), cells.GetConnectivityArray()] if cells and cells.GetNumberOfCells() else []
        found[kind] = [cells.GetNumberOfCells() if cells else 0] + [[a.GetDataTypeSize(), digest(a)] for a in ids]
    if surface.GetNumberOfPoints():
        points = surface.GetPoints().GetData()
        found["points"] = [points.GetDataType(), surface.GetNumberOfPoints(), digest(points)]
    return found


def run(kind, surface, properties):
    """What a filter of that kind makes of it."""
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # executives say once more what the filter said
    decimate = kind()
    ear = Ear(decimate)
    decimate.SetInputDataObject(surface)
    for name, value in properties.items():
        getattr(decimate, "Set" + name)(value)
    decimate.Update()
    names = [decimate.GetReportEntryName(i) for i in range(decimate.GetNumberOfReportEntries())]
    entries = [[name, decimate.GetReportText(name), decimate.GetReportEntryUnit(name)]
               for name in names if not name.startswith("seconds.")]
    return {"input": portrait(surface), "output 0": portrait(decimate.GetOutputDataObject(0)),
            "output 1": portrait(decimate.GetOutputDataObject(1)), "said": ear.texts, "report": entries,
            "stop": [decimate.GetStopReason(), decimate.GetStopReasonAsString()]}
