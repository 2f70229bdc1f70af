#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Times the strokes of a brush by vtkBoneDecimate: the table of Documentation/results/measurements.md.

    strokes.py SURFACE [--strokes 10] [--radius 12.5] [--error 0.2] [--mode Fast] [--threads 2] [--repeats 3] [--json]

Each stroke adds a ball to what may be simplified, around a random point; balls do not overlap. After them comes the undo of the last
one: the tolerances before it. Processor seconds are those of the update alone, medians of so many repetitions with a new filter each. The last row has
the tolerances of the last stroke in a filter that runs the whole surface.
"""
import argparse
import json
import statistics
import time
from pathlib import Path

import numpy as np
from bonedecimate import vtkBoneDecimate
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

READERS = {".ply": vtkPLYReader, ".stl": vtkSTLReader, ".vtp": vtkXMLPolyDataReader}
TOLERANCE = "Tolerance"


def read(path):
    reader = READERS[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    surface = vtkPolyData()
    surface.SetPoints(reader.GetOutput().GetPoints())
    surface.SetPolys(reader.GetOutput().GetPolys())
    return surface


def centers_on(points, count, apart):
    """Random points of the surface, so far apart, mm, that their regions are separate."""
    chosen = []
    for point in points[np.random.default_rng(1).permutation(len(points))]:
        if len(chosen) < count and all(np.linalg.norm(point - other) > apart for other in chosen):
            chosen.append(point)
    return chosen


def tolerances_of(points, centers, options):
    """One list for each stroke, and that of the undo."""
    inside = np.zeros(len(points), bool)
    maps = []
    for center in centers:
        inside = inside | (np.linalg.norm(points - center, axis=1) <= options.radius)
        maps.append(np.where(inside, options.error, 0.0))
    return maps + [maps[-2 if len(maps) > 1 else -1]]


def filter_of(options):
    decimate = vtkBoneDecimate()
    getattr(decimate, f"SetModeTo{options.mode}")()
    decimate.SetMaximumError(options.error)
    decimate.SetNumberOfThreads(options.threads)
    decimate.SetMeasureDistances(False)
    decimate.SetToleranceArrayName(TOLERANCE)
    decimate.AddObserver("WarningEvent", lambda *_: None)
    return decimate


def update(decimate, surface, tolerances):
    """Processor seconds."""
    stroke = vtkPolyData()
    stroke.ShallowCopy(surface)
    array = numpy_to_vtk(tolerances, deep=True)
    array.SetName(TOLERANCE)
    stroke.GetPointData().AddArray(array)
    decimate.SetInputDataObject(0, stroke)
    begin = time.process_time()
    decimate.Update()
    return time.process_time() - begin


def row_of(name, seconds, decimate):
    """Figures of an update, and of its run."""
    value = decimate.GetReportValue
    return {"update": name, "CPU s": round(seconds, 3), "triangles of all parts": int(value("regions.triangles") or 0),
            "run": int(value("regions.count")) - int(value("regions.kept")), "regions": int(value("regions.count")),
            "triangles of the result": decimate.GetNumberOfOutputTriangles(), "status": decimate.GetProofStatusAsString(),
            "memory kept, MB": round(decimate.GetPreparedMemory() / 1e6, 1)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surface", type=Path)
    parser.add_argument("--strokes", type=int, default=10)
    parser.add_argument("--radius", type=float, default=12.5, help="mm")
    parser.add_argument("--error", type=float, default=0.2, help="mm")
    parser.add_argument("--mode", default="Fast")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--json", action="store_true", help="in the last line, for features.sh")
    options = parser.parse_args()

    surface = read(options.surface)
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    maps = tolerances_of(points, centers_on(points, options.strokes, 2 * options.radius + 10 * options.error), options)
    times = [[] for _ in maps]
    rows = []
    for repeat in range(options.repeats):
        decimate = filter_of(options)
        for stroke, tolerances in enumerate(maps):
            times[stroke].append(update(decimate, surface, tolerances))
            if repeat == options.repeats - 1:
                name = "undo" if stroke == len(maps) - 1 else f"stroke {stroke + 1}"
                rows.append(row_of(name, statistics.median(times[stroke]), decimate))
    decimate = filter_of(options)
    decimate.DiagnoseInputOn()
    rows.append(row_of("last stroke, the whole surface", update(decimate, surface, maps[-2]), decimate))
    for row in rows:
        print(", ".join(f"{column} {value}" for column, value in row.items()))
    if options.json:
        print(json.dumps(rows))


if __name__ == "__main__":
    main()
