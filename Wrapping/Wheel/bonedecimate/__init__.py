# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Bone surfaces from CT made smaller, with the error in millimeters, proved.

>>> import bonedecimate
>>> small = bonedecimate.decimate(points, triangles, max_error=0.2)
>>> small.points, small.triangles, small.proved_error

Importing this needs numpy only. `bonedecimate.vtkBoneDecimate`, the same filter for VTK pipelines, imports the VTK that is
there; PyVista finds `mesh.bone` by itself. For type checkers, which take that for Any, ``BoneAccessor(mesh)`` is the same.
"""

from typing import TYPE_CHECKING

from ._core import PreparedSurface, StopReason, __version__
from .arrays import Certificate, Result, certify, decimate, smooth
from .label_maps import LabelSurfaces, extract_label, extract_surfaces
from .label_pieces import PieceChanges, change_pieces
from .levels import Levels, open_levels, record_levels
from .progress import Aborted
from .report import Report
from .segments import Segment, Segments, segments
from .voxel_check import LabelChanges, VoxelChanges, check_voxels
from .voxels import LabelMap, VoxelGrid

if TYPE_CHECKING:
    from .pyvista_accessor import BoneAccessor, BoneImageAccessor
    from .vtk_filter import vtkBoneDecimate

__all__ = ["Aborted", "Certificate", "LabelChanges", "LabelMap", "LabelSurfaces", "Levels", "PieceChanges", "PreparedSurface",
           "Report", "Result", "Segment", "Segments", "StopReason", "VoxelChanges", "VoxelGrid", "__version__", "certify", "change_pieces", "check_voxels", "decimate",
           "extract_label", "extract_surfaces", "open_levels", "record_levels", "segments", "smooth", "vtkBoneDecimate"]

# Names of the package that is built with VTK, and what does the same here.
_BUILT_WITH_VTK = {
    "error_curve": "the program's bonedecimate curve", "smallest_error": "the program's bonedecimate tolerance", "vtkBoneCap": "mesh.bone.cap",
    "vtkBoneDecimateLevels": "bonedecimate.record_levels", "vtkBoneDiagnostics": "bonedecimate.decimate(diagnose=True)",
    "vtkBoneErrorSearch": "the program's bonedecimate tolerance", "vtkBoneLabelPieces": "bonedecimate.change_pieces",
    "vtkBoneSmooth": "bonedecimate.smooth", "vtkBoneSurfaceDistance": "bonedecimate.certify", "vtkBoneSurfaces": "bonedecimate.extract_surfaces",
    "vtkBoneTolerance": None, "vtkBoneVoxelCheck": "bonedecimate.check_voxels"}


def __getattr__(name: str):
    """Imports VTK at the first use of the filter."""
    if name == "vtkBoneDecimate":
        from .vtk_filter import vtkBoneDecimate
        return vtkBoneDecimate
    if name in ("BoneAccessor", "BoneImageAccessor"):
        from . import pyvista_accessor
        return getattr(pyvista_accessor, name)
    if name in _BUILT_WITH_VTK:  # an AttributeError would lose its text in "from bonedecimate import ..."
        same = _BUILT_WITH_VTK[name]
        hint = f"; {same} does the same here" if same else ""
        raise ImportError(f"{name} is in the package bonedecimate that is built with VTK, and this is the wheel, in "
                          f"{__path__[0]}: install one of them in an environment{hint}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*__all__, "BoneAccessor", "BoneImageAccessor"])
