# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program and makes the meshes that the tests give it."""

import json
import math
import os
import pathlib
import resource
import subprocess
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

PROGRAM = os.environ["BONEDECIMATE_PROGRAM"]
DONE, USAGE, REJECTED, NOT_WRITTEN, INTERRUPTED, NO_MEMORY = range(6)
TABLES = json.loads(subprocess.run([PROGRAM, "--tables"], stdout=subprocess.PIPE, check=True).stdout)  # of the program
MODES = [mode["name"] for mode in TABLES["modes"]]
PROVING_MODES = [mode["name"] for mode in TABLES["modes"] if mode["proves_error"]]
FORMATS = {row["extension"]: row for row in TABLES["formats"]}
VTK_CLASSES = {
    "obj": (vtkOBJReader, vtkOBJWriter),
    "stl": (vtkSTLReader, vtkSTLWriter),
    "ply": (vtkPLYReader, vtkPLYWriter),
    "vtp": (vtkXMLPolyDataReader, vtkXMLPolyDataWriter),
    "vtk": (vtkPolyDataReader, vtkPolyDataWriter),
}
SURFACES = tuple(VTK_CLASSES)  # formats that VTK reads and writes
OTHER_FORMATS = tuple(sorted(set(FORMATS) - set(SURFACES)))
TEMPORARY = ".bonedecimate-"
UNMEASURED = ("--measure", "off")  # most of the time of a small bone, for tests that do not look at distances


class ApplicationTest(unittest.TestCase):
    """A folder of its own for each test, and the program in it."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="bonedecimate-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def path(self, name):
        return self.folder / name

    def run_program(self, *words, **keywords):
        """Runs in the test's folder; the completed process has returncode, stdout and stderr."""
        return subprocess.run(
            [PROGRAM, *map(str, words)],
            cwd=self.folder,
            stdout=keywords.pop("stdout", subprocess.PIPE),
            stderr=subprocess.PIPE,
            encoding="utf-8",
            check=False,
            **keywords,
        )

    def succeed(self, *words, **keywords):
        """A success says nothing on the standard error."""
        completed = self.run_program(*words, **keywords)
        self.assertEqual((completed.returncode, completed.stderr), (DONE, ""), completed.stdout)
        return completed

    def fail_with(self, code, *words, says="", **keywords):
        """A failure is one line on the standard error and leaves no file behind."""
        before = self.names()
        completed = self.run_program(*words, **keywords)
        self.assertEqual(completed.returncode, code, completed.stderr + completed.stdout)
        self.assertRegex(completed.stderr, r"\Abonedecimate: [^\n]+\n\Z")
        self.assertIn(says, completed.stderr)
        self.assertEqual(self.names(), before)
        return completed

    def names(self):
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*"))

    def report(self, name="report.json"):
        return json.loads(self.path(name).read_text(encoding="utf-8"))


def torus(rings=40, sides=24, center=0.0):
    """A closed surface of 2 rings sides triangles; coordinates in mm."""
    ring, side = (index.ravel() for index in np.indices((rings, sides)))
    u, v = 2.0 * math.pi * ring / rings, 2.0 * math.pi * side / sides
    radius = 20.0 + 8.0 * np.cos(v)
    points = np.stack([radius * np.cos(u), radius * np.sin(u), 8.0 * np.sin(v)], -1)
    next_ring, next_side = (ring + 1) % rings, (side + 1) % sides
    a, b = ring * sides + side, next_ring * sides + side
    c, d = next_ring * sides + next_side, ring * sides + next_side
    corners = np.stack([a, b, c, a, c, d], -1).astype(np.int64)
    triangles = vtkCellArray()
    triangles.SetData(3, numpy_to_vtkIdTypeArray(corners.ravel(), deep=True))
    return surface_of(points.astype(np.float32) + [center, 0.0, 0.0], triangles, np.float32)


def sphere(resolution=24, center=0.0):
    """Points and triangles alone, single precision, moved along x."""
    source = vtkSphereSource()
    source.SetRadius(10.0)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.GenerateNormalsOff()
    source.Update()
    surface = source.GetOutput()
    return surface_of(positions_of(surface) + [center, 0.0, 0.0], surface.GetPolys(), np.float32)


def positions_of(surface):
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def surface_of(positions, triangles, kind=float):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(positions, kind), deep=True))
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    return surface


def as_doubles(surface):
    return surface_of(positions_of(surface) + 1e-9, surface.GetPolys())


def together(*surfaces):
    append = vtkAppendPolyData()
    for surface in surfaces:
        append.AddInputData(surface)
    append.Update()
    return append.GetOutput()


def write(surface, path, ascii_text=False):
    """By VTK's own writers; the extension decides."""
    extension = path.suffix[1:].lower()
    writer = VTK_CLASSES[extension][1]()
    writer.SetFileName(str(path))
    writer.SetInputData(surface)
    if extension == "vtp":
        (writer.SetDataModeToAscii if ascii_text else writer.SetDataModeToAppended)()
    elif extension != "obj":
        (writer.SetFileTypeToASCII if ascii_text else writer.SetFileTypeToBinary)()
    writer.Write()
    return path


def read(path):
    """By VTK's own readers; points of STL files are merged. What VTK does not read the program converts."""
    if path.suffix[1:] in OTHER_FORMATS:
        with tempfile.TemporaryDirectory(prefix="bonedecimate-test-") as folder:
            converted = pathlib.Path(folder) / "converted.vtp"
            unchanged = ("--mode", "fast", "--target-reduction", "0", "--merge-points", "off", "--measure", "off", "--quiet")
            subprocess.run([PROGRAM, path, converted, *unchanged], check=True)
            return read(converted)
    reader = VTK_CLASSES[path.suffix[1:].lower()][0]()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def array_names(data):
    return {data.GetArrayName(i) for i in range(data.GetNumberOfArrays())}


def limit(what, value):
    """For preexec_fn: a limit of the process alone."""
    return lambda: resource.setrlimit(what, (value, value))


def without_root_powers():
    """For preexec_fn: root obeys the permissions of files like everybody else."""
    if os.geteuid() == 0:
        import ctypes

        drop_from_bounding_set = 24
        for capability in (1, 2):  # CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH
            ctypes.CDLL(None).prctl(drop_from_bounding_set, capability, 0, 0, 0)


def main():
    unittest.main(verbosity=2)
