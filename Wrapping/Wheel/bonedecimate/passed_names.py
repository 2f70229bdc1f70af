# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Names under which arrays of the input go to the result, as PassedNames does it in C++.

An array with the name of one that the run adds is either that of an earlier run, which is dropped, or the user's, which gets
another name: "Distance.input". Arrays of runs have the unit as the name of their component.
"""

from __future__ import annotations

from vtkmodules.vtkCommonCore import vtkAbstractArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import _core


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
