# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvbatch on several ranks: each takes its part of the triangles of a surface and writes what the filter makes of it.

    mpiexec -n N pvbatch --sym rank_parts.py PLUGIN SURFACE.ply MODE MM RESULT     writes RESULT-RANK.ply, and RESULT-RANK.json with its CPU seconds
"""

import json
import resource
import sys
from pathlib import Path

from paraview import simple
from paraview.servermanager import vtkProcessModule
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter


def part_of(surface, rank, ranks):
    """One of as many parts as there are ranks, of equally many triangles in the order of the file."""
    count = surface.GetNumberOfPolys()
    chosen = vtkCellArray()
    for cell in range(count * rank // ranks, count * (rank + 1) // ranks):
        chosen.InsertNextCell(surface.GetCell(cell))
    part = vtkPolyData()
    part.SetPoints(surface.GetPoints())
    part.SetPolys(chosen)
    clean = vtkCleanPolyData()
    clean.SetInputData(part)
    clean.PointMergingOff()
    clean.Update()
    return clean.GetOutput()


def main(plugin, surface, mode, error, result):
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    module = vtkProcessModule.GetProcessModule()
    rank = module.GetPartitionId()
    reader = vtkPLYReader()
    reader.SetFileName(surface)
    reader.Update()
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(part_of(reader.GetOutput(), rank, module.GetNumberOfLocalPartitions()))
    producer.UpdatePipeline()
    decimate = simple.BoneDecimate(Input=producer, Mode=mode, MaximumError=float(error), MeasureDistances=0, NumberOfThreads=1)
    before = resource.getrusage(resource.RUSAGE_SELF)
    decimate.UpdatePipeline()
    after = resource.getrusage(resource.RUSAGE_SELF)
    writer = vtkPLYWriter()
    writer.SetFileName(f"{result}-{rank}.ply")
    writer.SetInputData(decimate.GetClientSideObject().GetOutputDataObject(0))
    writer.Write()
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    Path(f"{result}-{rank}.json").write_text(json.dumps(seconds), encoding="ascii")


if __name__ == "__main__":
    main(*sys.argv[1:])
