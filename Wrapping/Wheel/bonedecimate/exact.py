# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Coordinates of OBJ, PLY and text STL files without the rounding to single precision of VTK's readers."""

from __future__ import annotations

import pathlib

import numpy as np
from numpy.typing import NDArray

PLY_TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
    "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}
BYTE_ORDERS = {"binary_little_endian": "<", "binary_big_endian": ">"}


def coordinates(path: pathlib.Path) -> NDArray | None:
    """The vertices of an OBJ or PLY file, the corners of a text STL, (n, 3); None for other files."""
    reader = {".obj": _of_obj, ".ply": _of_ply, ".stl": _of_stl}.get(path.suffix.lower())
    return None if reader is None else reader(path)


def obj_corners(path: pathlib.Path) -> NDArray:
    """The vertex of every corner of every face of an OBJ file, from 0."""
    found, vertices = [], 0
    with open(path, "rb") as file:
        for line in file:
            words = line.split()
            if words and words[0] == b"v":
                vertices += 1
            elif words and words[0] == b"f":
                indices = [int(word.split(b"/")[0]) for word in words[1:]]
                found += [index - 1 if index > 0 else vertices + index for index in indices]
    return np.array(found, np.int64)


def are_single(numbers: NDArray) -> bool:
    """Whether single precision holds all of them."""
    with np.errstate(over="ignore"):
        return bool(np.all(numbers == numbers.astype(np.float32)))


def _numbers(rows: list[list[bytes]]) -> NDArray:
    return np.array(rows).astype(np.float64).reshape(-1, 3)


def _of_obj(path: pathlib.Path) -> NDArray:
    with open(path, "rb") as file:
        return _numbers([words[1:4] for words in map(bytes.split, file) if words and words[0] == b"v"])


def _of_stl(path: pathlib.Path) -> NDArray | None:
    with open(path, "rb") as file:
        rows = [words[1:4] for words in map(bytes.split, file) if words and words[0].lower() == b"vertex"]
    return _numbers(rows) if rows and all(len(row) == 3 for row in rows) else None


def _of_ply(path: pathlib.Path) -> NDArray | None:
    """None where the vertices are not the first element or have lists."""
    with open(path, "rb") as file:
        form, elements = "", []
        for line in file:
            words = line.decode("latin-1").split()
            if words[:1] == ["format"]:
                form = words[1]
            elif words[:1] == ["element"]:
                elements.append((words[1], int(words[2]), []))
            elif words[:1] == ["property"]:
                elements[-1][2].append((words[-1], words[1]))
            elif words[:1] == ["end_header"]:
                break
        name, count, properties = elements[0] if elements else ("", 0, [])
        names = [name for name, _ in properties]
        if name != "vertex" or any(kind not in PLY_TYPES for _, kind in properties) or not {"x", "y", "z"} <= set(names):
            return None
        columns = [names.index(axis) for axis in "xyz"]
        if form == "ascii":
            rows = (line.split() for line in file)
            rows = [words for words, _ in zip((words for words in rows if words), range(count))]
            return _numbers([[words[column] for column in columns] for words in rows])
        kind = np.dtype([(str(i), BYTE_ORDERS[form] + PLY_TYPES[kind]) for i, (_, kind) in enumerate(properties)])
        vertices = np.frombuffer(file.read(count * kind.itemsize), kind)
        return np.column_stack([vertices[str(column)].astype(np.float64) for column in columns])
