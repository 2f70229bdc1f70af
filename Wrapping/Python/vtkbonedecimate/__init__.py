# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Deprecated name of the package ``bonedecimate``; it is removed with the next release."""

import sys
import warnings

import bonedecimate
from bonedecimate import *  # noqa: F401,F403
from bonedecimate import __all__  # noqa: F401

warnings.warn("the package vtkbonedecimate is deprecated; use bonedecimate", DeprecationWarning, stacklevel=2)
for _name in ("vtkFiltersBoneDecimate", "vtkFiltersBoneDecimateParallel"):
    if "bonedecimate." + _name in sys.modules:
        sys.modules[f"{__name__}.{_name}"] = sys.modules["bonedecimate." + _name]


def __getattr__(name):
    return getattr(bonedecimate, name)
