# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvbatch on several ranks: each takes its part of each surface and writes what the filter makes of it.

    mpiexec -n N pvbatch --sym parallel_worker.py FOLDER CASE...     writes FOLDER/CASE-N-RANK.vtp
"""

import sys

from paraview import simple
from paraview.servermanager import vtkProcessModule
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import cases
import label_images
import specimens
import surfaces


def part_of(surface, belongs):
    """The triangles that belong here, with the points they use and no others, and their arrays."""
    chosen = vtkCellArray()
    part = specimens.polydata(surface.GetPoints(), chosen)
    part.GetPointData().ShallowCopy(surface.GetPointData())
    part.GetCellData().CopyAllocate(surface.GetCellData())
    for number, corners in enumerate(specimens.triangles_of(surface)):
        if belongs(number):
            part.GetCellData().CopyData(surface.GetCellData(), number, chosen.InsertNextCell(3, corners))
    clean = vtkCleanPolyData()
    clean.SetInputData(part)
    clean.PointMergingOff()
    clean.Update()
    return clean.GetOutput()


def blocks_of(surface, rank, ranks):
    """Two blocks on the first rank, one on the others: every rank must take part all the same."""
    parts = 2 * ranks
    cells = surface.GetNumberOfCells()
    blocks = vtkMultiBlockDataSet()
    for block in range(2):
        blocks.SetBlock(block, part_of(surface, lambda number: number * parts // cells == 2 * rank + block))
    return blocks


def damaged(part):
    """With a triangle that has a point that is not there."""
    corners = vtkIdList()
    for corner in (0, 1, 10**6):
        corners.InsertNextId(corner)
    part.GetPolys().ReplaceCellAtId(0, corners)
    return part


def surface_of(image, cut, rank, ranks):
    """A source of the surface of a segmentation, or of this rank's part of it."""
    extract = simple.BoneSurfaces(Input=image_source(image, cut, rank, ranks), LabelArray=["POINTS", label_images.ARRAY])
    if cut in ("pieces", "image", "images"):
        return extract
    algorithm = extract.GetClientSideObject()
    extract.UpdatePipeline()
    algorithm.UpdatePiece(0, 1, 0)
    whole = cases.with_tolerances(algorithm.GetOutput())
    owner = cases.OWNER["slabs" if cut == "grids" else cut]
    part = part_of(whole, lambda number: owner(number, whole.GetNumberOfCells(), ranks) == rank)
    part.GetFieldData().DeepCopy(whole.GetFieldData())
    if cut == "grids":
        part.GetFieldData().GetArray("VoxelGridOrigin").SetValue(0, rank)
    return surfaces.source(part)


def image_source(image, cut, rank, ranks):
    """The whole image on every rank, or a few of its slices: for the cut "image" ranks know the whole, for "images" they do not."""
    producer = simple.TrivialProducer()
    if cut in ("image", "images"):
        whole = image.GetExtent()
        part = vtkImageData()
        part.DeepCopy(image)
        last = whole[5]
        part.Crop((*whole[:4], rank * last // ranks, (rank + 1) * last // ranks))
        image = part
        producer.GetClientSideObject().SetWholeExtent(whole if cut == "image" else image.GetExtent())
    producer.GetClientSideObject().SetOutput(image)
    producer.UpdatePipeline()
    return producer


def main(folder, *names):
    surfaces.load()
    module = vtkProcessModule.GetProcessModule()
    rank, ranks = module.GetPartitionId(), module.GetNumberOfLocalPartitions()
    every = {**cases.cases(), **cases.label_cases(), **cases.rejected(), **cases.allowed()}
    for name in names:
        surface, cut, properties, *_ = every[name]
        if surface.IsA("vtkImageData"):
            data = surface_of(surface, cut, rank, ranks)
        elif cut == "blocks":
            data = surfaces.source(blocks_of(surface, rank, ranks))
        else:
            owner = cases.OWNER["slabs" if cut == "damaged" else cut]
            part = part_of(surface, lambda number: owner(number, surface.GetNumberOfCells(), ranks) == rank)
            data = surfaces.source(damaged(part) if cut == "damaged" and rank == ranks - 1 else part)
        decimate = simple.BoneDecimate(Input=data, **properties)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(f"{folder}/{name}-{ranks}-{rank}.vtp")
        writer.SetInputData(surfaces.output(decimate))
        writer.Write()


if __name__ == "__main__":
    main(*sys.argv[1:])
