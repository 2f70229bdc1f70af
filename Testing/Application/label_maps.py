# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Label maps, and surfaces that other programs extract from them."""

import vtk
from vtk.util import numpy_support

SIZE = 14  # voxels along each axis
SPACING = (0.5, 0.75, 1.0)  # mm
ORIGIN = (-3.0, 10.0, 100.0)  # mm


def blocks(*labels):
    """A block of 6 x 6 x 6 voxels of the first label, and two voxels of the second on it."""
    image = vtk.vtkImageData()
    image.SetDimensions(SIZE, SIZE, SIZE)
    image.SetSpacing(SPACING)
    image.SetOrigin(ORIGIN)
    image.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 1)
    image.GetPointData().GetScalars().Fill(0)
    for z in range(4, 10):
        for y in range(4, 10):
            for x in range(4, 10):
                image.SetScalarComponentFromDouble(x, y, z, 0, labels[0])
    for z in range(10, 12 if len(labels) > 1 else 10):
        image.SetScalarComponentFromDouble(6, 6, z, 0, labels[1])
    return image


def ball():
    """Label 1 within 5 voxels of the middle."""
    image = blocks(1)
    for z in range(SIZE):
        for y in range(SIZE):
            for x in range(SIZE):
                inside = sum((i - 0.5 * (SIZE - 1)) ** 2 for i in (x, y, z)) < 25.0
                image.SetScalarComponentFromDouble(x, y, z, 0, 1 if inside else 0)
    return image


def surface_of(image, label):
    """By VTK's own marching cubes, in double precision."""
    contour = vtk.vtkDiscreteMarchingCubes()
    contour.SetInputData(image)
    contour.SetValue(0, label)
    contour.ComputeScalarsOff()
    contour.Update()
    surface = vtk.vtkPolyData()
    surface.SetPoints(contour.GetOutput().GetPoints())
    surface.SetPolys(contour.GetOutput().GetPolys())
    return surface


def smoothed(surface):
    """As segmentations are commonly smoothed, without a bound."""
    sinc = vtk.vtkWindowedSincPolyDataFilter()
    sinc.SetInputData(surface)
    sinc.SetPassBand(0.001)
    sinc.SetNumberOfIterations(40)
    sinc.Update()
    return sinc.GetOutput()


def bounded(surface, label):
    """With the array BoundaryLabels."""
    labels = vtk.vtkIntArray()
    labels.SetName("BoundaryLabels")
    labels.SetNumberOfComponents(2)
    for _ in range(surface.GetNumberOfPolys()):
        labels.InsertNextTuple2(label, 0)
    surface.GetCellData().AddArray(labels)
    return surface


def write_map(image, path):
    if path.suffix == ".nrrd":
        path.write_bytes(nrrd(image))
        return
    writer = vtk.vtkXMLImageDataWriter() if path.suffix == ".vti" else vtk.vtkMetaImageWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def nrrd(image):
    steps = " ".join("(" + ",".join(str(SPACING[i] if i == axis else 0) for i in range(3)) + ")" for axis in range(3))
    header = (f"NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIZE} {SIZE} {SIZE}\n"
              f"space directions: {steps}\nendian: little\nencoding: raw\n"
              f"space origin: ({','.join(map(str, ORIGIN))})\n\n")
    return header.encode() + numpy_support.vtk_to_numpy(image.GetPointData().GetScalars()).tobytes()
