# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces on several ranks: how they are cut, and the properties of the filter."""

import specimens
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkIntArray

OWNER = {
    "slabs": lambda number, count, ranks: number * ranks // count,
    "crumbs": lambda number, count, ranks: number // 7 % ranks,
    "lopsided": lambda number, count, ranks: 0,  # the other ranks have nothing
}


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
        "blocks": (ring, "blocks", {"TargetReduction": 0.8}),
    }


def labeled(surface):
    """With half of the triangles of one bone, half of another."""
    bone = vtkIntArray()
    bone.SetName("bone")
    for number in range(surface.GetNumberOfCells()):
        bone.InsertNextValue(number % 2)
    surface.GetCellData().AddArray(bone)
    return surface


def with_tolerances(surface):
    tolerances = vtkFloatArray()
    tolerances.SetName("allowed")
    for _ in range(surface.GetNumberOfPoints()):
        tolerances.InsertNextValue(0.1)
    surface.GetPointData().AddArray(tolerances)
    return surface


def rejected():
    """Properties that need the whole surface."""
    ring = specimens.torus
    return {name: (labeled(ring()), "slabs", properties) for name, properties in {
        "PruneSize": {"PruneSize": 1.0},
        "PruneArea": {"PruneArea": 1.0},
        "PruneVolume": {"PruneVolume": 1.0},
        "PruneTriangles": {"PruneTriangles": 4},
        "LabelArrayName": {"LabelArrayName": "bone"},
        "MergePoints": {"MergePoints": 0},
        "MakeMaps": {"MakeMaps": 1},
        "Smoothing": {"Smoothing": 0.1},
        "AutomaticSmoothing": {"AutomaticSmoothing": 1},
        "OutputPointsPrecision": {"OutputPointsPrecision": "Double"},
        "DiagnoseInput": {"DiagnoseInput": 1},
        "KeepVoxels": {"KeepVoxels": "On"},
        "preset-alone": {"ErrorPreset": "HalfVoxel"},
    }.items()}


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


def fewer(part):
    return entry("output.triangles", lambda faces: faces < 1000)(part)


def proved(most):
    return entry("proof.upper", lambda upper: upper is not None and upper <= most)


def allowed():
    """By the name of the option: surface, how it is cut, properties, and how each part shows that they counted."""
    error = {"MaximumError": 0.1}
    names = ("DistanceArrayName", "RunningErrorArrayName", "PointCountArrayName", "ErrorBoundArrayName")
    return {name: (with_tolerances(specimens.torus()), "slabs", properties, shows) for name, (properties, shows) in {
        "Mode": ({"Mode": "Fast", "TargetReduction": 0.5}, fewer),
        "TargetNumberOfTriangles": ({"TargetNumberOfTriangles": 600}, entry("output.triangles", lambda faces: faces <= 600)),
        "TargetReduction": ({"TargetReduction": 0.5}, fewer),
        "MaximumError": (error, proved(0.1)),
        "AllowLargeError": ({"MaximumError": 40.0, "AllowLargeError": 1}, proved(40.0)),
        "IntersectionGuard": ({**error, "IntersectionGuard": 0}, proved(0.1)),
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
        "ToleranceArrayName": ({"ToleranceArrayName": "allowed"}, proved(0.1)),
        "ProveResult": ({**error, "ProveResult": 0}, entry("proof.upper", lambda upper: upper is None)),
        "ErrorPreset": ({"ErrorPreset": "HalfVoxel", "VoxelSize": 0.2}, proved(0.1)),
        "VoxelSize": ({"ErrorPreset": "OneVoxel", "VoxelSize": 0.1}, proved(0.1)),
    }.items()}
