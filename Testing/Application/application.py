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

import vtk

PROGRAM = os.environ["BONEDECIMATE_PROGRAM"]
DONE, USAGE, REJECTED, NOT_WRITTEN, INTERRUPTED, NO_MEMORY = range(6)
SURFACES = ("obj", "stl", "ply", "vtp", "vtk")
TEMPORARY = ".bonedecimate-"


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
    points = vtk.vtkPoints()
    triangles = vtk.vtkCellArray()
    for i in range(rings):
        for j in range(sides):
            u, v = 2.0 * math.pi * i / rings, 2.0 * math.pi * j / sides
            radius = 20.0 + 8.0 * math.cos(v)
            points.InsertNextPoint(radius * math.cos(u), radius * math.sin(u), 8.0 * math.sin(v))
            a, b = i * sides + j, (i + 1) % rings * sides + j
            c, d = (i + 1) % rings * sides + (j + 1) % sides, i * sides + (j + 1) % sides
            for corners in ((a, b, c), (a, c, d)):
                triangles.InsertNextCell(3, corners)
    surface = vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    return plain(surface, center)


def sphere(resolution=24, center=0.0):
    source = vtk.vtkSphereSource()
    source.SetRadius(10.0)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.GenerateNormalsOff()
    source.Update()
    return plain(source.GetOutput(), center)


def plain(surface, center):
    """Points and triangles alone, single precision, moved along x."""
    points = vtk.vtkPoints()
    for i in range(surface.GetNumberOfPoints()):
        x, y, z = surface.GetPoint(i)
        points.InsertNextPoint(x + center, y, z)
    moved = vtk.vtkPolyData()
    moved.SetPoints(points)
    moved.SetPolys(surface.GetPolys())
    return moved


def as_doubles(surface):
    doubles = vtk.vtkPoints()
    doubles.SetDataTypeToDouble()
    for i in range(surface.GetNumberOfPoints()):
        doubles.InsertNextPoint([x + 1e-9 for x in surface.GetPoint(i)])
    result = vtk.vtkPolyData()
    result.SetPoints(doubles)
    result.SetPolys(surface.GetPolys())
    return result


def together(*surfaces):
    append = vtk.vtkAppendPolyData()
    for surface in surfaces:
        append.AddInputData(surface)
    append.Update()
    return append.GetOutput()


def write(surface, path, ascii_text=False):
    """By VTK's own writers; the extension decides."""
    writers = {
        "obj": vtk.vtkOBJWriter,
        "stl": vtk.vtkSTLWriter,
        "ply": vtk.vtkPLYWriter,
        "vtp": vtk.vtkXMLPolyDataWriter,
        "vtk": vtk.vtkPolyDataWriter,
    }
    extension = path.suffix[1:].lower()
    writer = writers[extension]()
    writer.SetFileName(str(path))
    writer.SetInputData(surface)
    if extension == "vtp":
        (writer.SetDataModeToAscii if ascii_text else writer.SetDataModeToAppended)()
    elif extension != "obj":
        (writer.SetFileTypeToASCII if ascii_text else writer.SetFileTypeToBinary)()
    writer.Write()
    return path


def read(path):
    """By VTK's own readers; points of STL files are merged."""
    readers = {
        "obj": vtk.vtkOBJReader,
        "stl": vtk.vtkSTLReader,
        "ply": vtk.vtkPLYReader,
        "vtp": vtk.vtkXMLPolyDataReader,
        "vtk": vtk.vtkPolyDataReader,
    }
    reader = readers[path.suffix[1:].lower()]()
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
