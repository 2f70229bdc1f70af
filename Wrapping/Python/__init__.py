# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkBoneDecimate for Python: ``from vtkbonedecimate import vtkBoneDecimate``."""

# The superclass must be known to Python before the wrapped class is loaded.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401

from .vtkFiltersBoneDecimate import vtkBoneCheck, vtkBoneDecimate, vtkBoneSurfaceDistance

__all__ = ["vtkBoneCheck", "vtkBoneDecimate", "vtkBoneSurfaceDistance"]
