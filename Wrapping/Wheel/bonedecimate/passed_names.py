# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Names under which arrays of the input go to the result, as PassedNames does it in C++.

An array with the name of one that the run adds is either that of an earlier run, which is dropped, or the user's, which gets
another name: "Distance.input". Arrays of runs have the unit as the name of their component.
"""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkCommonCore import vtkAbstractArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import _core
from .polydata import numbers

SEAMS = ["texture coordinates are left out: at seams of the texture, points have several of them, which simplified triangles "
         "cannot keep; MergePoints off keeps seams as open boundaries"]


def own_point_arrays(options: _core.Options) -> set[str]:
    return {options.get(name + "ArrayName") for name in ("Distance", "RunningError", "PointCount", "ErrorBound")}


def is_renamed(array, own: set[str]) -> bool:
    is_of_run = array.GetNumberOfComponents() == 1 and array.GetComponentName(0) in ("mm", "points")
    return array.GetName() in own and not is_of_run


def passed_name(array, own: set[str], data) -> str | None:
    """None if the array is dropped; an empty name for one without a name."""
    name = array.GetName() or ""
    if name in own and not is_renamed(array, own):
        return None
    while name in own or (name != (array.GetName() or "") and data.HasArray(name)):
        name += ".input"
    return name


def arrays_with_seams(data: vtkPolyData, options: _core.Options) -> set[str]:
    """Names of the texture coordinates if the texture has seams, where points of equal coordinates have several of them, or
    several materials have one each; empty where points are not merged."""
    if not options.get("MergePoints") or not data.GetNumberOfPoints():
        return set()
    arrays, materials = data.GetPointData(), data.GetFieldData().GetAbstractArray("MaterialNames")
    names = [materials.GetValue(i) for i in range(materials.GetNumberOfValues())] if isinstance(materials, vtkStringArray) else []
    textures = {}
    for array in (arrays.GetTCoords(), *(arrays.GetArray(name) for name in names)):
        if array is not None and array.GetName() is not None and array.GetNumberOfComponents() <= 3:
            textures[array.GetName()] = array
    is_left_out = len(textures) > 1 or any(_has_seam(data, array) for array in textures.values())
    return set(textures) if is_left_out else set()


def _has_seam(data: vtkPolyData, array) -> bool:
    positions, texture = numbers(data.GetPoints().GetData()), numbers(array)
    order = np.lexsort(positions.T)
    is_same = (positions[order[1:]] == positions[order[:-1]]).all(axis=1)
    return bool((is_same & (texture[order[1:]] != texture[order[:-1]]).any(axis=1)).any())


def array_warnings(data: vtkPolyData, options: _core.Options) -> list[str]:
    """A sentence for texture coordinates that are left out, and for each array that gets another name."""
    if not options.get("PassArrays"):
        return []
    return (SEAMS if arrays_with_seams(data, options) else []) + renamed_arrays(data, options)


def renamed_arrays(data: vtkPolyData, options: _core.Options) -> list[str]:
    own, arrays = own_point_arrays(options), data.GetPointData()
    found = [arrays.GetAbstractArray(i) for i in range(arrays.GetNumberOfArrays())]
    return [f"the input's point array '{array.GetName()}' is '{passed_name(array, own, arrays)}' in the result, "
            "whose own array has that name" for array in found if is_renamed(array, own)]


def keep_user_arrays(copy: vtkPolyData, options: _core.Options) -> None:
    """In the copy of an input."""
    own = {options.get(name + "ArrayName") for name in ("InputDistance", "InputErrorBound")}
    data = copy.GetPointData()
    for name in sorted(own):
        array = data.GetAbstractArray(name)
        if array is not None and is_renamed(array, own):
            kept = vtkAbstractArray.CreateArray(array.GetDataType())
            kept.DeepCopy(array)
            kept.SetName(passed_name(array, own, data))
            data.AddArray(kept)
