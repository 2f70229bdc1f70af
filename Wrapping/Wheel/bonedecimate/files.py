# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files in and out: by the user's VTK with all arrays, else by meshio, else binary STL by numpy alone."""

from __future__ import annotations

import contextlib
import importlib.util
import os
import pathlib

import numpy as np
from numpy.typing import NDArray

from . import exact

Surface = tuple[NDArray, NDArray]

# Of every ending that VTK knows: the module, the reader and the writer.
VTK_KINDS = {
    ".stl": ("vtkIOGeometry", "vtkSTLReader", "vtkSTLWriter"),
    ".obj": ("vtkIOGeometry", "vtkOBJReader", "vtkOBJWriter"),
    ".ply": ("vtkIOPLY", "vtkPLYReader", "vtkPLYWriter"),
    ".vtp": ("vtkIOXML", "vtkXMLPolyDataReader", "vtkXMLPolyDataWriter"),
    ".vtk": ("vtkIOLegacy", "vtkPolyDataReader", "vtkPolyDataWriter"),
}
SINGLE = (".stl", ".ply")  # what VTK's writers round to single precision
STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
STL_HEADER = 84  # bytes, of which the last four are the number of triangles


def has(module: str) -> bool:
    try:
        return importlib.util.find_spec(module) is not None
    except ModuleNotFoundError:  # not even the package that it is in
        return False


def endings() -> list[str]:
    """Of the files that VTK or meshio reads and writes, whichever is used; empty without both."""
    if has("vtkmodules.vtkIOGeometry"):
        return list(VTK_KINDS)
    if has("meshio"):
        import meshio
        return list(meshio.extension_to_filetypes)
    return []


@contextlib.contextmanager
def whole(path: pathlib.Path):
    """A temporary file beside the path, which replaces the path when it is complete."""
    made = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
    try:
        yield made
        os.replace(made, path)
    finally:
        made.unlink(missing_ok=True)


def read_vtk(path: pathlib.Path):
    """A vtkPolyData, in double precision if the file's coordinates need it. Raises OSError if there is none in the file."""
    surface = _read_vtk(path)
    coordinates = exact.coordinates(path)
    if coordinates is not None and not exact.are_single(coordinates):
        surface = _with_coordinates(surface, coordinates, path)
    return surface


def _with_coordinates(surface, coordinates: NDArray, path: pathlib.Path):
    """The surface with the coordinates that VTK's reader rounded. Raises OSError if they cannot be told apart."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    kind = path.suffix.lower()
    if kind == ".stl":
        surface = _read_vtk(path, merges=False)
    count = surface.GetNumberOfPoints()
    if kind == ".obj" and len(coordinates) != count:  # then every corner has a point, for texture or normals
        coordinates = coordinates[exact.obj_corners(path)]
    if len(coordinates) == count:
        read = vtk_to_numpy(surface.GetPoints().GetData()).astype(np.float64)
        if np.all(np.abs(read - coordinates) <= np.spacing(np.abs(coordinates).astype(np.float32))):
            surface.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(coordinates), deep=True))
            return surface
    raise OSError(f"{path} has coordinates in double precision, which VTK rounds; write it as .vtp")


def _read_vtk(path: pathlib.Path, merges: bool = True):
    reader = _vtk_class(path, 1)()
    if not merges:
        reader.MergingOff()
    problems = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda *_: problems.append(event))
    reader.SetFileName(str(_checked(path)))
    with _unlogged():
        reader.Update()
    if problems or reader.GetOutput().GetNumberOfPoints() == 0:
        raise OSError(f"{path} could not be read as {path.suffix}")
    return reader.GetOutput()


@contextlib.contextmanager
def _unlogged():
    """Without VTK's own words on the standard error, of parsers and executives, too."""
    from vtkmodules.vtkCommonCore import vtkLogger
    before = vtkLogger.GetCurrentVerbosityCutoff()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        yield
    finally:
        vtkLogger.SetStderrVerbosity(vtkLogger.ConvertToVerbosity(before))


def write_vtk(surface, path: pathlib.Path) -> None:
    writer = _vtk_class(path, 2)()
    writer.SetInputData(surface)
    if hasattr(writer, "SetFileTypeToBinary") and path.suffix.lower() in (".stl", ".ply", ".vtk"):
        writer.SetFileTypeToBinary()
    with whole(path) as made:
        writer.SetFileName(str(made))
        if writer.Write() != 1 or not made.exists():
            raise OSError(f"{path} could not be written")


def read(path: pathlib.Path) -> Surface:
    """Points and triangles, without VTK."""
    _checked(path)
    if has("meshio"):
        import meshio
        mesh = meshio.read(path)
        return np.asarray(mesh.points), mesh.get_cells_type("triangle")
    if path.suffix.lower() != ".stl":
        raise OSError(f"without VTK and meshio only binary STL can be read, not {path}")
    return _read_stl(path)


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


def _checked(path: pathlib.Path) -> pathlib.Path:
    """Raises OSError for what readers pass over in silence: a file that is not there, a binary STL that was cut."""
    if not path.is_file():
        raise FileNotFoundError(f"{path} is not there")
    if path.suffix.lower() == ".stl":
        with open(path, "rb") as file:
            is_text = file.read(5) == b"solid"
        if not is_text and path.stat().st_size != _stl_size(_stl_count(path)):
            raise OSError(f"{path} is no binary STL of {_stl_count(path)} triangles: it has {path.stat().st_size} bytes")
    return path


def _stl_count(path: pathlib.Path) -> int:
    count = np.fromfile(path, "<u4", 1, offset=STL_HEADER - 4) if path.stat().st_size >= STL_HEADER else []
    return int(count[0]) if len(count) else 0


def _stl_size(triangles: int) -> int:
    return STL_HEADER + triangles * STL_TRIANGLE.itemsize


def _vtk_class(path: pathlib.Path, which: int):
    kind = VTK_KINDS.get(path.suffix.lower())
    if kind is None:
        raise OSError(f"{path}: no format has that ending; there are {' '.join(VTK_KINDS)}")
    return getattr(importlib.import_module("vtkmodules." + kind[0]), kind[which])


def _read_stl(path: pathlib.Path) -> Surface:
    count = _stl_count(path)
    if path.stat().st_size != _stl_size(count):  # text, too
        raise OSError(f"{path} is no binary STL; others need VTK or meshio")
    corners = np.fromfile(path, STL_TRIANGLE, count, offset=STL_HEADER)["corners"].reshape(-1, 3)
    return corners, np.arange(len(corners)).reshape(-1, 3)


def _write_stl(surface: Surface, path: pathlib.Path) -> None:
    triangles = np.zeros(len(surface[1]), STL_TRIANGLE)
    triangles["corners"] = surface[0][surface[1]]
    sides = np.diff(triangles["corners"].astype(np.float64), axis=1)
    normals = np.cross(sides[:, 0], sides[:, 1])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    triangles["normal"] = normals / np.where(lengths > 0, lengths, 1)
    header = b"bonedecimate".ljust(80) + np.uint32(len(triangles)).astype("<u4").tobytes()
    path.write_bytes(header + triangles.tobytes())
