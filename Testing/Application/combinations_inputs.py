# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the combined features are tried on: a torus of two halves, one of which is to move little, and beside it a crumb whose
triangles share no points; the same in meters; a scan of two balls."""

import math

import vtk

from application import torus, write

METERS = 1e-3  # per mm


def scaled(surface, factor):
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for i in range(surface.GetNumberOfPoints()):
        points.InsertNextPoint([factor * x for x in surface.GetPoint(i)])
    result = vtk.vtkPolyData()
    result.ShallowCopy(surface)
    result.SetPoints(points)
    return result


def crumb():
    source = vtk.vtkPlatonicSolidSource()
    source.SetSolidTypeToOctahedron()
    source.Update()
    solid = source.GetOutput()
    points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
    for cell in range(solid.GetNumberOfCells()):
        corners = solid.GetCell(cell).GetPointIds()
        cells.InsertNextCell(3, [
            points.InsertNextPoint([x + (60.0 if axis == 0 else 0.0) for axis, x in enumerate(solid.GetPoint(corners.GetId(k)))])
            for k in range(3)])
    surface = vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells)
    return surface


def bone():
    append = vtk.vtkAppendPolyData()
    append.AddInputData(torus(28, 14))
    append.AddInputData(crumb())
    append.Update()
    surface = append.GetOutput()
    tolerance, size, label = vtk.vtkFloatArray(), vtk.vtkFloatArray(), vtk.vtkIntArray()
    tolerance.SetName("allowed")
    size.SetName("size")
    label.SetName("Bone")
    for i in range(surface.GetNumberOfPoints()):
        tolerance.InsertNextValue(0.0 if surface.GetPoint(i)[0] < -20.0 else -1.0)
        size.InsertNextValue(8.0 if surface.GetPoint(i)[0] < 0.0 else 10.0)
    for cell in range(surface.GetNumberOfCells()):
        y = sum(surface.GetCell(cell).GetPoints().GetPoint(k)[1] for k in range(3))
        label.InsertNextValue(1 if y < 0 else 2)
    surface.GetPointData().AddArray(tolerance)
    surface.GetPointData().AddArray(size)
    surface.GetCellData().AddArray(label)
    return surface


def volume():
    """A ball of 8 mm in air, and a smaller one beside it."""
    size = 28
    image = vtk.vtkImageData()
    image.SetDimensions(size + 12, size, size)
    image.AllocateScalars(vtk.VTK_SHORT, 1)
    for z in range(size):
        for y in range(size):
            for x in range(size + 12):
                to_large = math.dist((x, y, z), (13.5, 13.5, 13.5))
                to_small = math.dist((x, y, z), (33.0, 13.5, 13.5))
                depth = max(8.0 - to_large, 2.0 - to_small)
                image.SetScalarComponentFromDouble(x, y, z, 0, max(-1000.0, min(1000.0, depth * 400.0)))
    return image


def label_map(surface):
    """Label 1 inside of the surface; no voxel center lies on it."""
    bounds = surface.GetBounds()
    stencil = vtk.vtkPolyDataToImageStencil()
    stencil.SetInputData(surface)
    stencil.SetOutputOrigin([bounds[2 * axis] - 1.37 for axis in range(3)])
    stencil.SetOutputSpacing(1.0, 1.0, 1.0)
    stencil.SetOutputWholeExtent([round(bounds[i] - bounds[i - 1]) + 3 if i % 2 else 0 for i in range(6)])
    stencil.SetTolerance(0.0)
    image = vtk.vtkImageStencilToImage()
    image.SetInputConnection(stencil.GetOutputPort())
    image.SetInsideValue(1)
    image.SetOutsideValue(0)
    image.SetOutputScalarTypeToUnsignedChar()
    image.Update()
    return image.GetOutput()


def contour_of(path, value):
    reader = vtk.vtkMetaImageReader()
    reader.SetFileName(str(path))
    contour = vtk.vtkFlyingEdges3D()
    contour.SetInputConnection(reader.GetOutputPort())
    contour.SetValue(0, value)
    contour.Update()
    return contour.GetOutput()


def isosurface(path):
    return contour_of(path, 226)


def label_surface(path):
    """Of label 1."""
    return contour_of(path, 0.5)


def write_inputs(folder):
    surface = bone()
    meters = scaled(surface, METERS)
    for name, written in (("bone", surface), ("bone_m", meters)):
        for extension in ("vtp", "obj"):
            write(written, folder / f"{name}.{extension}")
    write(surface, folder / "first.vtp")
    write(meters, folder / "first_m.vtp")
    for name in ("bones", "meters", "volumes", "maps"):
        (folder / name).mkdir()
    write(surface, folder / "bones" / "bone.vtp")
    write(meters, folder / "meters" / "bone.vtp")
    for image, target in ((volume(), "bone.mha"), (volume(), "volumes/bone.mha"), (label_map(surface), "bone_map.mha"),
                          (label_map(surface), "maps/bone.mha")):
        writer = vtk.vtkMetaImageWriter()
        writer.SetFileName(str(folder / target))
        writer.SetInputData(image)
        writer.Write()
