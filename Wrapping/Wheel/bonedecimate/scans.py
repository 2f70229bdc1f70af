# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of SimpleITK and nibabel as arrays in LPS. Depends on neither: they are known by what they have."""

from __future__ import annotations

import sys
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

RAS_TO_LPS = np.diag([-1.0, -1.0, 1.0, 1.0])


class SimpleItkImage(Protocol):
    """What is used of SimpleITK.Image."""

    def GetSpacing(self) -> tuple[float, ...]: ...
    def GetOrigin(self) -> tuple[float, ...]: ...
    def GetDirection(self) -> tuple[float, ...]: ...
    def GetNumberOfComponentsPerPixel(self) -> int: ...


class NibabelImage(Protocol):
    """What is used of nibabel's images."""

    affine: NDArray
    dataobj: Any
    header: Any


class Scan(NamedTuple):
    """The arguments of LabelMap, mm, LPS."""

    labels: NDArray
    axes: str
    where: dict[str, Any]


def is_simpleitk(image: object) -> bool:
    return any(kind.__module__.split(".")[0] == "SimpleITK" for kind in type(image).__mro__)


def is_nibabel(image: object) -> bool:
    return hasattr(image, "affine") and hasattr(image, "dataobj")


def scan_of(image: SimpleItkImage | NibabelImage) -> Scan:
    """Raises ValueError for several values a voxel, and for other units than mm."""
    return _of_nibabel(image) if is_nibabel(image) else _of_simpleitk(image)


def _of_simpleitk(image: Any) -> Scan:
    if image.GetNumberOfComponentsPerPixel() != 1:
        raise ValueError(f"the image has {image.GetNumberOfComponentsPerPixel()} values a voxel; labels have one")
    where = {"spacing": image.GetSpacing(), "origin": image.GetOrigin(), "direction": image.GetDirection()}
    if len(image.GetSpacing()) != 3:
        raise ValueError(f"a label map has three dimensions, not {len(image.GetSpacing())}")
    return Scan(sys.modules["SimpleITK"].GetArrayViewFromImage(image), "zyx", where)


def _of_nibabel(image: Any) -> Scan:
    units = getattr(image.header, "get_xyzt_units", lambda: ("mm", ""))()[0]
    if units not in ("mm", "unknown"):
        raise ValueError(f"the unit of the image is {units}, not mm")
    if image.affine is None:
        raise ValueError("the image has no affine")
    return Scan(np.asanyarray(image.dataobj), "xyz", {"affine": RAS_TO_LPS @ image.affine})
