# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays that are numbers, and nothing that is made a number without notice."""

from __future__ import annotations

from operator import index

import numpy as np
from numpy.typing import ArrayLike, NDArray


def numeric_array(values: ArrayLike, name: str, kinds: str = "iuf") -> NDArray:
    """Never converts what is not a number: numpy takes text for numbers and drops imaginary parts and masks."""
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise TypeError(f"{name} have masked values; fill them or take them out")
    try:
        array = np.asarray(values)
    except ValueError as problem:  # rows of different lengths
        raise ValueError(f"{name} are not an array: {problem}") from None
    if array.dtype.kind not in kinds:
        raise TypeError(f"{name} are numbers, not {array.dtype}")
    return array


def numbers_of(name: str, values: ArrayLike, count: int) -> NDArray[np.float64]:
    """So many numbers, in a row or as rows of three."""
    numbers = numeric_array(values, name).astype(np.float64)
    if numbers.size != count or numbers.shape not in ((count,), (3, count // 3)):
        raise ValueError(f"{name} has {count} numbers, not {f'the shape {numbers.shape}' if numbers.ndim else 'one'}")
    return numbers.reshape(-1)


def label_value(name: str, value: int) -> int:
    """A whole number that is a label."""
    number = index(value)
    if not -2**63 <= number < 2**63:
        raise ValueError(f"{name} takes whole numbers from -2^63 to 2^63 - 1, not {number}")
    return number
