# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces on several ranks: how they are cut, and the properties of the filter."""

import json
import math

import label_images
import option_rows
import specimens
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray

ROWS = option_rows.read_rows()
ERROR = 0.5  # mm, of segmentations
TOLERANCE = 0.1  # mm

OWNER = {
    "slabs": lambda number, count, ranks: number * ranks // count,
    "crumbs": lambda number, count, ranks: number // 7 % ranks,
    "lopsided": lambda number, count, ranks: 0,  # the other ranks have nothing
    "tail": lambda number, count, ranks: min(ranks - 1, 1 + number * max(1, ranks - 1) // count),  # the first has nothing
}


def shells():
    """Two closed surfaces without common points, one in the other, 0.05 to 0.85 mm apart."""
    outer = specimens.torus(60, 24)
    inner = specimens.torus(60, 24)
    for i in range(inner.GetNumberOfPoints()):
        x, y, z = inner.GetPoint(i)
        around = math.hypot(x, y)
        smaller = 1 - (0.45 - 0.4 * x / around) / 3
        out = 10 + (around - 10) * smaller
        inner.GetPoints().SetPoint(i, out * x / around, out * y / around, z * smaller)
    return joined([outer, inner])


def with_spikes(surface):
    """With triangles without area all over it that stick out by 5 mm: no run knows them."""
    points, triangles = surface.GetPoints(), surface.GetPolys()
    for i in range(0, points.GetNumberOfPoints(), 50):
        x, y, z = points.GetPoint(i)
        first = points.InsertNextPoint(x, y, z + 2.5)
        points.InsertNextPoint(x, y, z + 5)
        triangles.InsertNextCell(3, (i, first, first + 1))
    return surface


def joined(surfaces):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    triangles = vtkCellArray()
    for surface in surfaces:
        first = points.GetNumberOfPoints()
        for i in range(surface.GetNumberOfPoints()):
            points.InsertNextPoint(surface.GetPoint(i))
        for corners in specimens.triangles_of(surface):
            triangles.InsertNextCell(3, [corner + first for corner in corners])
    return specimens.polydata(points, triangles)


def with_crumbs(surface):
    """The surface, one nearly as large, and two small ones. Slabs of four ranks cut one of these, and slabs of two the surface."""
    return joined([specimens.torus(60, 20, shift=40.0), small_torus(80.0), surface, small_torus(120.0)])


def small_torus(shift):
    """Of a tenth of the size."""
    small = specimens.torus(40, 20)
    for i in range(small.GetNumberOfPoints()):
        x, y, z = small.GetPoint(i)
        small.GetPoints().SetPoint(i, shift + 0.1 * x, 0.1 * y, 0.1 * z)
    return small


def cases():
    """By name: surface, how it is cut, properties."""
    ring = specimens.torus(120, 40, bumps=0.4)
    patch = specimens.patch(single=True)
    return {
        "reduction": (ring, "slabs", {"TargetReduction": 0.8}),
        "error": (ring, "slabs", {"MaximumError": 0.1}),
        "fast": (ring, "slabs", {"TargetNumberOfTriangles": 1500, "Mode": "Fast"}),
        "crumbs": (ring, "crumbs", {"TargetReduction": 0.5}),
        "lopsided": (specimens.torus(), "lopsided", {"TargetReduction": 0.5}),
        "open": (patch, "slabs", {"MaximumError": 0.1}),
        "shells": (shells(), "slabs", {"MaximumError": 0.1}),
        "scattered": (ring, "crumbs", {"MaximumError": 0.1, "Mode": "Fast"}),
        "blocks": (ring, "blocks", {"TargetReduction": 0.8}),
        "labels": (labeled(specimens.torus(120, 40, bumps=0.4), 4000), "slabs", {"MaximumError": 0.1, "LabelArrayName": "bone"}),
        "point-labels": (with_sectors(specimens.torus(120, 40, bumps=0.4)), "slabs",
                         {"MaximumError": 0.1, "LabelArrayName": "sector", "Mode": "Fast"}),
        "spikes": (with_spikes(specimens.torus(120, 40, bumps=0.4)), "slabs", {"MaximumError": 0.1, "Mode": "Fast"}),
        "pruned": (with_crumbs(ring), "slabs", {"MaximumError": 0.1, "Mode": "Fast", "PruneVolume": 1000.0, "MeasureInputDistances": 1}),
    }


def label_cases():
    """By name: segmentation, how its surface is cut, properties. "pieces": as Bone Surfaces hands it to the ranks."""
    smoothed = {"AutomaticSmoothing": 1}
    return {name: (label_images.image(), cut, properties) for name, cut, properties in (
        ("label-smoothed", "pieces", {**smoothed, "TargetReduction": 0.0}),
        ("label-image", "image", {**smoothed, "TargetReduction": 0.0}),
        ("label-images", "images", {**smoothed, "TargetReduction": 0.0}),
        ("label-error", "pieces", {**smoothed, "MaximumError": ERROR, "KeepVoxels": "On"}),
        ("label-crumbs", "crumbs", {**smoothed, "MaximumError": ERROR, "KeepVoxels": "On"}),
        ("label-free", "slabs", {**smoothed, "MaximumError": ERROR, "KeepVoxels": "Off"}),
        ("label-kept", "slabs", {"KeepVoxels": "On"}),
        ("label-preset", "tail", {**smoothed, "ErrorPreset": "HalfVoxel"}),
        ("label-tolerance", "slabs", {**smoothed, "ToleranceArrayName": "allowed", "MaximumError": ERROR}),
        ("label-thesis", "lopsided", {**smoothed, "Mode": "Thesis", "TargetReduction": 0.6}),
        ("label-millimeters", "slabs", {"Smoothing": 0.3, "MaximumError": 0.3, "Mode": "Fast"}),
    )}


def labeled(surface, length=1):
    """With half of the triangles of one bone, half of another: so many of each after the other."""
    bone = vtkIntArray()
    bone.SetName("bone")
    for number in range(surface.GetNumberOfCells()):
        bone.InsertNextValue(number // length % 2)
    surface.GetCellData().AddArray(bone)
    return surface


def with_sectors(surface):
    """Labels of points."""
    sector = vtkIntArray()
    sector.SetName("sector")
    for i in range(surface.GetNumberOfPoints()):
        x, y, z = surface.GetPoint(i)
        sector.InsertNextValue(3 if x + 0.5 * y + z > 0 else 8)
    surface.GetPointData().AddArray(sector)
    return surface


def with_tolerances(surface):
    tolerances = vtkFloatArray()
    tolerances.SetName("allowed")
    for _ in range(surface.GetNumberOfPoints()):
        tolerances.InsertNextValue(TOLERANCE)
    surface.GetPointData().AddArray(tolerances)
    return surface


def cases_of_the_table():
    """By the name of the option: properties with which it has an effect."""
    def value(name, text):
        kind = ROWS[name]["kind"]
        return text if kind in ("choice", "text") else int(text == "on") if kind == "bool" else float(text) if kind == "double" else int(text)
    return {name: {other: value(other, text) for other, text in option_rows.case_of(ROWS, row).items()} for name, row in ROWS.items()}


def rejected():
    """Properties that need the whole surface, and parts that are not one."""
    ring = specimens.torus
    return {name: (labeled(ring()), "slabs", properties) for name, properties in {
        "prune-all": {"PruneSize": 1000.0},
        "labels-alone": {"LabelArrayName": "bone", "PassArrays": 0},
        "labels-missing": {"LabelArrayName": "nothing"},
        **{name: case for name, case in cases_of_the_table().items() if "Ranks" in ROWS[name]["unsupported"]},
        "EdgeLengthArrayName": {"EdgeLength": 2.0, "EdgeLengthArrayName": "allowed"},
        "no-grid": {"KeepVoxels": "On"},
        "preset-alone": {"ErrorPreset": "HalfVoxel"},
    }.items()} | {
        "grids-differ": (label_images.image(), "grids", {"TargetReduction": 0.5}),
        "ids-out-of-range": (ring(), "damaged", {"TargetReduction": 0.5}),
    }


def has(*arrays):
    """Point arrays that every rank's result has."""
    return lambda part: all(part.GetPointData().HasArray(array) for array in arrays)


def lacks(*arrays):
    return lambda part: not any(part.GetPointData().HasArray(array) for array in arrays)


def entry(name, test):
    """Of the report, which is that of the whole surface."""
    def holds(part):
        array = part.GetFieldData().GetArray("bonedecimate." + name)
        return test(array.GetValue(0) if array else None)
    return holds


def reported(group, name, test):
    """Of the whole report, which is longer than the arrays of the field data."""
    def holds(part):
        report = json.loads(part.GetFieldData().GetAbstractArray("BoneDecimateReport").GetValue(0))
        return test(report[group][name])
    return holds


def fewer(part):
    return entry("output.triangles", lambda faces: faces < 1000)(part)


def proved(most):
    return entry("proof.if_unchanged.upper", lambda upper: upper is not None and upper <= most)


def allowed():
    """By the name of the option: surface, how it is cut, properties, and how each part shows that they counted. Options without
    a case below get one of the table, of which the report must tell."""
    return {name: (with_tolerances(specimens.torus()), "slabs", properties, reported("options", name, lambda text: text != ROWS[name]["default"]))
            for name, properties in cases_of_the_table().items() if "Ranks" not in ROWS[name]["unsupported"]} | allowed_with_effects()


def allowed_with_effects():
    """Those that show more than that the report tells of them."""
    error = {"MaximumError": 0.1}
    names = ("DistanceArrayName", "RunningErrorArrayName", "PointCountArrayName", "ErrorBoundArrayName")
    return {name: (with_tolerances(specimens.torus()), "slabs", properties, shows) for name, (properties, shows) in {
        "Mode": ({"Mode": "Fast", "TargetReduction": 0.5}, fewer),
        "TargetNumberOfTriangles": ({"TargetNumberOfTriangles": 600}, entry("output.triangles", lambda faces: faces <= 600)),
        "TargetReduction": ({"TargetReduction": 0.5}, fewer),
        "MaximumError": (error, proved(0.1)),
        "AllowLargeError": ({"MaximumError": 40.0, "AllowLargeError": 1}, proved(40.0)),
        "IntersectionGuard": ({**error, "IntersectionGuard": 0}, proved(0.1)),
        "ProveEachEdit": ({**error, "ProveEachEdit": 1}, reported("draft", "status", lambda status: status == "each_edit_is_proved")),
        "RefinementEffort": ({**error, "Mode": "Accurate", "RefinementEffort": 0.0}, reported("forced_collapses", "tried", lambda count: count == 0)),
        "MinimumAngle": ({**error, "MinimumAngle": 20.0}, proved(0.1)),
        "EdgeLength": ({"EdgeLength": 2.0}, entry("output.triangles", lambda faces: faces > 300)),  # a tenth would be 160
        "NormalTolerance": ({"Mode": "Thesis", "NormalTolerance": 0.5, "TargetReduction": 0.5}, fewer),
        "AutomaticNormalTolerance": ({"Mode": "Thesis", "AutomaticNormalTolerance": 1, "TargetReduction": 0.5}, fewer),
        "MeasureDistances": ({"MeasureDistances": 0}, lacks("Distance (mm)")),
        "MeasureInputDistances": ({"MeasureInputDistances": 1}, has("Distance (mm)")),
        "NumberOfThreads": ({"NumberOfThreads": 2, "TargetReduction": 0.5}, fewer),
        "PassArrays": ({"PassArrays": 0}, lacks("allowed")),
        "RecomputeNormals": ({"RecomputeNormals": 1}, has("Normals")),
        **{name: ({**error, name: "other name"}, has("other name")) for name in names},
        "InputDistanceArrayName": ({"MeasureInputDistances": 1, "InputDistanceArrayName": "other name"}, has("Distance (mm)")),
        "InputErrorBoundArrayName": ({**error, "InputErrorBoundArrayName": "other name"}, proved(0.1)),
        **{name: ({name: limit, "TargetReduction": 0.5}, reported("pruned", "components", lambda count: count == 0)) for name, limit in (
            ("PruneSize", 1.0), ("PruneArea", 1.0), ("PruneVolume", 1.0), ("PruneTriangles", 4))},
        "ToleranceArrayName": ({"ToleranceArrayName": "allowed"}, proved(0.1)),
        "ProveResult": ({**error, "ProveResult": 0}, entry("proof.if_unchanged.upper", lambda upper: upper is None)),
        "ErrorPreset": ({"ErrorPreset": "HalfVoxel", "VoxelSize": 0.2}, proved(0.1)),
        "VoxelSize": ({"ErrorPreset": "OneVoxel", "VoxelSize": 0.1}, proved(0.1)),
        "Smoothing": ({"Smoothing": 0.05, "TargetReduction": 0.0},
                      reported("smoothing", "largest_displacement", lambda most: 0.01 < most <= 0.05)),
    }.items()} | {name: (label_images.image(), "pieces", properties, shows) for name, (properties, shows) in {
        "AutomaticSmoothing": ({"AutomaticSmoothing": 1, "TargetReduction": 0.0},
                               reported("smoothing", "surface", lambda surface: surface == "label_map")),
        "KeepVoxels": ({"KeepVoxels": "On", "TargetReduction": 0.5}, reported("voxels", "guard", lambda guard: guard == "on")),
    }.items()} | {"LabelArrayName": (labeled(specimens.torus()), "slabs", {**error, "LabelArrayName": "bone"},
                                     lambda part: part.GetCellData().HasArray("bone") and proved(0.1)(part))
    } | {"FeatureAngle": (label_images.image(label_images.block_at), "pieces",
                                   {"AutomaticSmoothing": 1, "FeatureAngle": 45, "TargetReduction": 0.0},
                                   reported("smoothing", "sharp_points", lambda count: count > 0))}
