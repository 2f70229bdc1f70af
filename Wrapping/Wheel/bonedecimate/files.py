# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of results: by the user's VTK with all arrays, else by meshio, else binary STL by numpy alone."""

from __future__ import annotations

import contextlib
import importlib
import importlib.util
import os
import pathlib

import numpy as np
from numpy.typing import NDArray

Surface = tuple[NDArray, NDArray]

# For each ending that VTK writes, the module and the writer.
VTK_WRITERS = {
    ".stl": ("vtkIOGeometry", "vtkSTLWriter"),
    ".obj": ("vtkIOGeometry", "vtkOBJWriter"),
    ".ply": ("vtkIOPLY", "vtkPLYWriter"),
    ".vtp": ("vtkIOXML", "vtkXMLPolyDataWriter"),
    ".vtk": ("vtkIOLegacy", "vtkPolyDataWriter"),
}
SINGLE = (".stl", ".ply")  # what VTK's writers round to single precision
STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def has(module: str) -> bool:
    try:
        return importlib.util.find_spec(module) is not None
    except ModuleNotFoundError:  # not even the package that it is in
        return False


@contextlib.contextmanager
def whole(path: pathlib.Path):
    """A temporary file beside the path, which replaces the path when it is complete."""
    if not path.parent.is_dir():
        raise FileNotFoundError(f"{path}: the folder does not exist")
    made = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
    try:
        yield made
        os.replace(made, path)
    finally:
        made.unlink(missing_ok=True)


def write_vtk(surface, path: pathlib.Path) -> None:
    writer = _vtk_writer(path)
    writer.SetInputData(surface)
    if hasattr(writer, "SetFileTypeToBinary") and path.suffix.lower() in (".stl", ".ply", ".vtk"):
        writer.SetFileTypeToBinary()
    with whole(path) as made:
        writer.SetFileName(str(made))
        if writer.Write() != 1 or not made.exists():
            raise OSError(f"{path} could not be written")


def _vtk_writer(path: pathlib.Path):
    kind = VTK_WRITERS.get(path.suffix.lower())
    if kind is None:
        raise OSError(f"{path}: no format has that ending; there are {' '.join(VTK_WRITERS)}")
    return getattr(importlib.import_module("vtkmodules." + kind[0]), kind[1])()


def write(surface: Surface, path: pathlib.Path) -> None:
    if has("meshio"):
        import meshio
        options = {"binary": True} if path.suffix.lower() == ".stl" else {}
        with whole(path) as made:
            meshio.Mesh(surface[0], [("triangle", surface[1])]).write(made, **options)
    elif path.suffix.lower() == ".stl":
        with whole(path) as made:
            _write_stl(surface, made)
    else:
        raise OSError(f"without VTK and meshio only binary STL can be written, not {path}")


def _write_stl(surface: Surface, path: pathlib.Path) -> None:
    triangles = np.zeros(len(surface[1]), STL_TRIANGLE)
    triangles["corners"] = surface[0][surface[1]]
    sides = np.diff(triangles["corners"].astype(np.float64), axis=1)
    normals = np.cross(sides[:, 0], sides[:, 1])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    triangles["normal"] = normals / np.where(lengths > 0, lengths, 1)
    header = b"bonedecimate".ljust(80) + np.uint32(len(triangles)).astype("<u4").tobytes()
    path.write_bytes(header + triangles.tobytes())
