# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkBoneDecimate for Python: ``from vtkbonedecimate import vtkBoneDecimate``."""

# The superclass must be known to Python before the wrapped class is loaded.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401

from .vtkFiltersBoneDecimate import (
    vtkBoneCheck, vtkBoneDecimate, vtkBoneDecimateLevels, vtkBoneErrorSearch, vtkBoneSurfaceDistance,
    vtkBoneTolerance)

__all__ = ["vtkBoneCheck", "vtkBoneDecimate", "vtkBoneDecimateLevels", "vtkBoneErrorSearch", "vtkBoneSurfaceDistance",
           "vtkBoneTolerance", "error_curve", "smallest_error"]


def smallest_error(surface, triangles, precision=0.02, mode=vtkBoneDecimate.BALANCED):
    """The smallest largest distance (mm) that can be proved for that many triangles, and the surface that has it.

    The distance is None if topology does not allow so few triangles.
    """
    search = vtkBoneErrorSearch()
    search.SetInputData(surface)
    search.SetMode(mode)
    search.SetTargetNumberOfTriangles(triangles)
    search.SetRelativePrecision(precision)
    search.Update()
    error = search.GetSmallestError()
    return (None if error != error else error), search.GetOutput()


def error_curve(surface, errors, mode=vtkBoneDecimate.BALANCED):
    """For each largest distance (mm): it, the number of triangles and the distance that is proved (mm)."""
    search = vtkBoneErrorSearch()
    search.SetInputData(surface)
    search.SetMode(mode)
    for error in errors:
        search.AddError(error)
    search.Update()
    trials = search.GetTrials()
    columns = [trials.GetColumnByName(name) for name in ("MaximumError", "Triangles", "ProvedError")]
    return [tuple(column.GetValue(row) for column in columns) for row in range(trials.GetNumberOfRows())]
