#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Times the strokes of a brush by vtkBoneDecimate: the table of Documentation/results/measurements.md.

    strokes.py SURFACE [--strokes 10] [--radius 12.5] [--error 0.2] [--mode Fast] [--threads 2] [--repeats 3] [--whole]

Each stroke adds a ball to what may be simplified, around a random point; balls do not overlap. The last line of strokes is the undo of the last
one: the tolerances before it. Times are those of the update alone, medians of so many repetitions with a new filter each, wall and
processor seconds; the load of the machine is printed, too. With --whole the same tolerances run with a filter that runs the whole
surface, which gives the number of triangles to compare with.
"""
import argparse
import os
import resource
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
    """Wall and processor seconds."""
    stroke = vtkPolyData()
    stroke.ShallowCopy(surface)
    array = numpy_to_vtk(tolerances, deep=True)
    array.SetName(TOLERANCE)
    stroke.GetPointData().AddArray(array)
    decimate.SetInputDataObject(0, stroke)
    begin, processor_begin = time.perf_counter(), time.process_time()
    decimate.Update()
    return time.perf_counter() - begin, time.process_time() - processor_begin


def figures(decimate):
    value = decimate.GetReportValue
    return (f"{decimate.GetNumberOfOutputTriangles():>9,} {int(value('regions.triangles') or 0):>9,} {int(value('regions.count')):>7} "
            f"{int(value('regions.kept')):>5} {decimate.GetProofStatusAsString():>9} {decimate.GetProvedError():>9.4f} "
            f"{decimate.GetPreparedMemory() / 1e6:>8.1f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surface", type=Path)
    parser.add_argument("--strokes", type=int, default=10)
    parser.add_argument("--radius", type=float, default=12.5, help="mm")
    parser.add_argument("--error", type=float, default=0.2, help="mm")
    parser.add_argument("--mode", default="Fast")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--whole", action="store_true")
    options = parser.parse_args()

    surface = read(options.surface)
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    maps = tolerances_of(points, centers_on(points, options.strokes, 2 * options.radius + 10 * options.error), options)
    print(f"{options.surface.name}: {surface.GetNumberOfPolys():,} triangles, {options.mode}, {options.error} mm, brush of radius "
          f"{options.radius} mm, {options.threads} threads, load {os.getloadavg()[0]:.1f}")
    print("stroke  wall s   cpu s triangles   of run regions  kept    status upper mm  kept MB")
    times = [[] for _ in maps]
    for repeat in range(options.repeats):
        decimate = filter_of(options)
        for stroke, tolerances in enumerate(maps):
            times[stroke].append(update(decimate, surface, tolerances))
            if repeat == options.repeats - 1:
                wall, processor = (statistics.median(each) for each in zip(*times[stroke]))
                name = "undo" if stroke == len(maps) - 1 else str(stroke + 1)
                print(f"{name:>6} {wall:>7.3f} {processor:>7.3f} {figures(decimate)}")
    print(f"peak memory {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3:.0f} MB, load {os.getloadavg()[0]:.1f}")
    if options.whole:
        decimate = filter_of(options)
        decimate.DiagnoseInputOn()
        wall, processor = update(decimate, surface, maps[-2])
        print(f"whole run of the last stroke: {wall:.1f} s wall, {processor:.1f} s processor, "
              f"{decimate.GetNumberOfOutputTriangles():,} triangles, {decimate.GetProofStatusAsString()}")


if __name__ == "__main__":
    main()
