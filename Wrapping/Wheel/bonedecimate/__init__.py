# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Bone surfaces from CT made smaller, with the error in millimeters, proved.

>>> import bonedecimate
>>> small = bonedecimate.decimate(points, triangles, max_error=0.2)
>>> small.points, small.triangles, small.proved_error

Importing this needs numpy only. `bonedecimate.vtkBoneDecimate`, the same filter for VTK pipelines, imports the VTK that is
there; PyVista finds `mesh.bone` by itself.
"""

from typing import TYPE_CHECKING

from ._core import StopReason, __version__
from .arrays import Aborted, Certificate, Result, certify, decimate, smooth
from .label_maps import LabelSurfaces, extract_label, extract_surfaces
from .levels import Levels, open_levels, record_levels

if TYPE_CHECKING:
    from .vtk_filter import vtkBoneDecimate

__all__ = ["Aborted", "Certificate", "LabelSurfaces", "Levels", "Result", "StopReason", "__version__", "certify", "decimate",
           "extract_label", "extract_surfaces", "open_levels", "record_levels", "smooth", "vtkBoneDecimate"]


def __getattr__(name: str):
    """Imports VTK at the first use of the filter."""
    if name == "vtkBoneDecimate":
        from .vtk_filter import vtkBoneDecimate
        return vtkBoneDecimate
    if name in ("vtkBoneDecimateLevels", "vtkBoneDiagnostics", "vtkBoneErrorSearch", "vtkBoneSmooth", "vtkBoneSurfaceDistance",
                "vtkBoneSurfaces", "vtkBoneTolerance", "vtkBoneVoxelCheck"):
        raise AttributeError(f"{name} is in the package bonedecimate that is built with VTK, not in the wheel")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)
