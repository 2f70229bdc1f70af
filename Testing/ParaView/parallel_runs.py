# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs of parallel_worker.py on several ranks, and what there is to measure of their joined results.

As a program it makes the runs of all cases on the number of ranks that it is given, which the tests read: ParaView takes longer to
start than a case.
"""

import json
import os
import pathlib
import subprocess
import sys

from bonedecimate import vtkBoneSurfaceDistance
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData, vtkFeatureEdges
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import cases
import option_rows

FOLDER = pathlib.Path(os.environ["FOLDER"]) / "parallel"
WORKER = pathlib.Path(__file__).with_name("parallel_worker.py")
RANKS = (1, 2, 4)


def report_of(surface):
    return json.loads(surface.GetFieldData().GetAbstractArray("BoneDecimateReport").GetValue(0))


def run(ranks, folder, names):
    folder.mkdir(parents=True, exist_ok=True)
    environment = {**os.environ, "OMPI_MCA_mpi_yield_when_idle": "1", "LD_LIBRARY_PATH": os.environ["PARAVIEW_LIBRARIES"],
                   "PYTHONPATH": os.pathsep.join([os.environ["WHEEL_TESTS"], os.path.dirname(option_rows.__file__), str(WORKER.parent)])}
    subprocess.run([os.environ["MPIEXEC"], "-n", str(ranks), os.environ["PVBATCH"], "--sym", str(WORKER), str(folder), *names],
                   env=environment, check=True, timeout=800)


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def parts(name, ranks, folder=FOLDER):
    return [read(folder / f"{name}-{ranks}-{rank}.vtp") for rank in range(ranks)]


def joined(surfaces):
    """One surface, equal points merged."""
    append = vtkAppendPolyData()
    for surface in surfaces:
        append.AddInputData(surface)
    clean = vtkCleanPolyData()
    clean.SetInputConnection(append.GetOutputPort())
    clean.SetTolerance(0.0)
    clean.Update()
    return clean.GetOutput()


def bad_edges(surface, boundary):
    """How many edges are open, or of more than two triangles."""
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.SetBoundaryEdges(boundary)
    edges.SetNonManifoldEdges(not boundary)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


def intersecting_pairs(surface):
    """Counted by CGAL; none without the program that does it."""
    if not os.environ.get("VERIFY_PROGRAM"):
        return None
    path = FOLDER / "counted.ply"
    writer = vtkPLYWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(surface)
    writer.Write()
    found = subprocess.run([os.environ["VERIFY_PROGRAM"], "--shape", str(path)], stdout=subprocess.PIPE, encoding="utf-8", check=True)
    return json.loads(found.stdout)["self_intersections"]


def comparison(before, after):
    compare = vtkBoneSurfaceDistance()
    compare.SetInputData(0, before)
    compare.SetInputData(1, after)
    compare.SetMeasureMeans(False)
    return compare


def distance(before, after):
    """mm, proved: no point of either is farther from the other, open boundaries curve to curve."""
    compare = comparison(before, after)
    compare.SetRelativeGap(1e-3)
    compare.Update()
    return compare.GetUpperBound()


def is_proved(before, after, tolerance):
    """Whether the certificate says so, both ways and of open boundaries."""
    compare = comparison(before, after)
    compare.SetTolerance(tolerance)
    compare.Update()
    return compare.GetStatusAsString() == "proved"


if __name__ == "__main__":
    number = int(sys.argv[1])
    more = {**cases.rejected(), **cases.allowed()} if number == 2 else {}
    run(number, FOLDER, [*cases.cases(), *cases.label_cases(), *more])
