# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkBoneDecimate for Python: ``from bonedecimate import vtkBoneDecimate``.

Every option has both forms of VTK: ``decimate.SetMaximumError(0.1)`` and ``decimate.maximum_error = 0.1``; every getter without
arguments is a property, too: ``decimate.proved_error``. A value outside its range is a ValueError, an unknown attribute an
AttributeError.
"""

# The superclass must be known to Python before the wrapped class is loaded.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401

from . import vtkFiltersBoneDecimate as _wrapped
from ._checked import ErrorTexts, checked

vtkBoneCap = checked(_wrapped, "vtkBoneCap")
vtkBoneDiagnostics = checked(_wrapped, "vtkBoneDiagnostics")
vtkBoneDecimate = checked(_wrapped, "vtkBoneDecimate")
vtkBoneDecimateLevels = checked(_wrapped, "vtkBoneDecimateLevels")
vtkBoneErrorSearch = checked(_wrapped, "vtkBoneErrorSearch")
vtkBoneLabelPieces = checked(_wrapped, "vtkBoneLabelPieces")
vtkBoneSmooth = checked(_wrapped, "vtkBoneSmooth")
vtkBoneSurfaceDistance = checked(_wrapped, "vtkBoneSurfaceDistance")
vtkBoneSurfaces = checked(_wrapped, "vtkBoneSurfaces")
vtkBoneTolerance = checked(_wrapped, "vtkBoneTolerance")
vtkBoneVoxelCheck = checked(_wrapped, "vtkBoneVoxelCheck")

__all__ = ["vtkBoneCap", "vtkBoneDiagnostics", "vtkBoneDecimate", "vtkBoneDecimateLevels", "vtkBoneErrorSearch",
           "vtkBoneLabelPieces", "vtkBoneSmooth", "vtkBoneSurfaceDistance", "vtkBoneSurfaces", "vtkBoneTolerance", "vtkBoneVoxelCheck", "error_curve",
           "smallest_error"]


def _update(search):
    """Updates; what the filter says is wrong is a ValueError."""
    with ErrorTexts(search, search.GetExecutive()) as errors:
        search.Update()
    if errors.texts:
        raise ValueError(errors.texts[0])


def _search(surface, mode):
    """Of a surface and a mode, which is a number or a name."""
    search = vtkBoneErrorSearch()
    search.SetInputData(surface)
    if isinstance(mode, str):
        search.SetOptionFromText("Mode", mode)
    else:
        search.SetMode(mode)
    return search


def smallest_error(surface, triangles, precision=0.02, mode=vtkBoneDecimate.BALANCED):
    """The smallest largest distance (mm) that can be proved for that many triangles, and the surface that has it.

    The mode is vtkBoneDecimate.FAST, BALANCED or ACCURATE, or its name: "Fast". The distance is None if topology does not allow so few triangles. What cannot be searched raises ValueError.
    """
    search = _search(surface, mode)
    search.SetTargetNumberOfTriangles(triangles)
    search.SetRelativePrecision(precision)
    _update(search)
    error = search.GetSmallestError()
    return (None if error != error else error), search.GetOutput()


def error_curve(surface, errors, mode=vtkBoneDecimate.BALANCED):
    """For each largest distance (mm): it, the number of triangles and the distance that is proved (mm). The mode is as of smallest_error.

    A distance that cannot be kept, and one that does not suit the size of the surface, raise ValueError.
    """
    search = _search(surface, mode)
    for error in errors:
        search.AddError(error)
    _update(search)
    trials = search.GetTrials()
    columns = [trials.GetColumnByName(name) for name in ("MaximumError", "Triangles", "ProvedError")]
    return [tuple(column.GetValue(row) for column in columns) for row in range(trials.GetNumberOfRows())]


def __getattr__(name):
    """Names of the wheel."""
    if name in ("decimate", "smooth", "certify", "check_voxels", "extract_label", "extract_surfaces", "open_levels", "record_levels",
                "LabelMap"):  # an AttributeError would lose its text in "from bonedecimate import ..."
        raise ImportError(f"bonedecimate.{name} is in the wheel, and this is the package that is built with VTK, in {__path__[0]}: "
                          "install one of them in an environment")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
