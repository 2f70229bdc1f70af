# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of SimpleITK, nibabel and MONAI as arrays in LPS. Depends on neither: they are known by what they have."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

MILLIMETERS = {"unknown": 1.0, "mm": 1.0, "meter": 1000.0, "micron": 0.001}
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


class MetaTensor(Protocol):
    """What is used of MONAI's MetaTensor."""

    affine: Any
    meta: dict

    def detach(self) -> Any: ...


class Scan(NamedTuple):
    """The arguments of LabelMap, mm, LPS."""

    labels: NDArray
    axes: str
    where: dict[str, Any]


def is_simpleitk(image: object) -> bool:
    return any(kind.__module__.split(".")[0] == "SimpleITK" for kind in type(image).__mro__)


def is_nibabel(image: object) -> bool:
    return hasattr(image, "affine") and hasattr(image, "dataobj")


def is_metatensor(image: object) -> bool:
    return all(hasattr(image, name) for name in ("affine", "meta", "detach"))


def scan_of(image: SimpleItkImage | NibabelImage | MetaTensor) -> Scan:
    """Raises ValueError for several values a voxel."""
    return _of_metatensor(image) if is_metatensor(image) else _of_nibabel(image) if is_nibabel(image) else _of_simpleitk(image)


def _of_metatensor(image: Any) -> Scan:
    voxels = np.asarray(image.detach().cpu())
    if voxels.ndim == 4 and voxels.shape[0] == 1:
        voxels = voxels[0]
    if voxels.ndim != 3:
        raise ValueError(f"the tensor has the shape {tuple(voxels.shape)}; labels have one channel: (1, x, y, z), after AsDiscrete(argmax=True)")
    space = str(getattr(image.meta.get("space", "RAS"), "value", image.meta.get("space", "RAS"))).upper()
    if space not in ("RAS", "LPS"):
        raise ValueError(f"meta['space'] is {space!r}, which is neither RAS nor LPS")
    affine = np.asarray(image.affine.detach().cpu(), dtype=np.float64)
    return Scan(voxels, "xyz", {"affine": RAS_TO_LPS @ affine if space == "RAS" else affine})


def _of_simpleitk(image: Any) -> Scan:
    if image.GetNumberOfComponentsPerPixel() != 1:
        raise ValueError(f"the image has {image.GetNumberOfComponentsPerPixel()} values a voxel; labels have one")
    where = {"spacing": image.GetSpacing(), "origin": image.GetOrigin(), "direction": image.GetDirection()}
    if len(image.GetSpacing()) != 3:
        raise ValueError(f"a label map has three dimensions, not {len(image.GetSpacing())}")
    # A copy: a view is of memory that ends with the image.
    return Scan(sys.modules["SimpleITK"].GetArrayFromImage(image), "zyx", where)


def _of_nibabel(image: Any) -> Scan:
    if image.affine is None:
        raise ValueError("the image has no affine")
    unit = getattr(image.header, "get_xyzt_units", lambda: ("mm", ""))()[0]
    if unit not in MILLIMETERS:
        raise ValueError(f"the unit of the image is {unit}, which is none of length")
    if MILLIMETERS[unit] != 1:
        warnings.warn(f"its unit is the {unit} by its header; lengths are converted to millimeters", stacklevel=6)
    scale = np.diag([MILLIMETERS[unit]] * 3 + [1.0])
    voxels = np.asanyarray(image.dataobj)
    while voxels.ndim > 3 and voxels.shape[-1] == 1:
        voxels = voxels[..., 0]
    return Scan(voxels, "xyz", {"affine": RAS_TO_LPS @ scale @ _position(image)})


def _position(image: Any) -> NDArray[np.float64]:
    """From voxels to the image's unit, RAS, by the rule of ITK and the program: the qform, unless only the sform is of the scanner."""
    header = image.header
    if not (hasattr(header, "get_qform") and hasattr(header, "get_sform")):
        return image.affine
    if not np.allclose(image.affine, header.get_best_affine()):
        return image.affine  # which was set after the header
    (qform, q_code), (sform, s_code) = header.get_qform(coded=True), header.get_sform(coded=True)
    if not q_code and not s_code:
        warnings.warn("its header does not say how the patient lies (sform_code and qform_code are 0): x is taken to run to the left and "
                      "y to the back, as ITK does; nibabel and FSL let y run to the front, so the surface may be mirrored", stacklevel=7)
        spacing = header.get_zooms()[:3]
        return np.diag([-spacing[0], -spacing[1], spacing[2], 1.0])
    if s_code == 1 or not q_code:
        return sform
    distance = _largest_distance(qform, sform, image.shape[:3]) if s_code else 0.0
    if distance > 0.1 * min(header.get_zooms()[:3]):
        millimeters = distance * MILLIMETERS[header.get_xyzt_units()[0]]
        warnings.warn(f"its sform and qform are up to {millimeters:g} mm apart; positions are those of its qform, as of ITK; "
                      "nibabel's affine is the sform", stacklevel=7)
    return qform


def _largest_distance(one: NDArray, other: NDArray, shape: Sequence[int]) -> float:
    """Of the coordinates of a voxel."""
    corners = np.array([[x, y, z, 1] for x in (0, shape[0] - 1) for y in (0, shape[1] - 1) for z in (0, shape[2] - 1)])
    return float(np.abs(corners @ (one - other).T).max())
