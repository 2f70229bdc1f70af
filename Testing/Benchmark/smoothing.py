#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares smoothing methods for surfaces of label maps: the tables of Documentation/smoothing.md.

    smoothing.py [--ct Cranium.inv3] [--verify PROGRAM] [--save FOLDER] [--with-meshlib] [NAME ...]

A label map is made of a shape with a known surface (the truth): crops of the CT of Debian's package invesalius-examples at 226 HU, and
analytic shapes. Each method gets the label map or its surface. The table has the distance from the truth (RMS of samples in both
directions, mm), the mean angle between the normals (degrees), the voxels next to a boundary that change their label (by
vtkPolyDataToImageStencil, percent), intersecting pairs of triangles, and the time. NAME selects shapes.

Runs with every VTK that Python finds, and leaves out what it does not have: vtkSurfaceNets3D needs VTK 9.3, MeshLab the package
pymeshlab. MeshLib only takes part with --with-meshlib: its license is for non-commercial use.
"""
import argparse
import json
import subprocess
import tarfile
import tempfile
import time
from pathlib import Path

import numpy as np
from vtkmodules import vtkFiltersCore, vtkFiltersGeneral
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkImagingCore import vtkImageResample
from vtkmodules.vtkImagingStencil import vtkImageStencilToImage, vtkPolyDataToImageStencil

from vtkmodules.vtkIOPLY import vtkPLYWriter

from bonedecimate import vtkBoneSmooth, vtkBoneSurfaces

CRANIUM = Path("/usr/share/doc/invesalius-examples/examples/Cranium.inv3")
VERIFY = Path(__file__).resolve().parents[2] / "build/release/bin/bonedecimate-verify"
HU = 226
SAMPLES = 20000
# Ranges of voxels along x, y and z.
CROPS = {
    "first crop": ((60, 190), (20, 150), (5, 75)),
    "thin bone": ((70, 150), (110, 190), (10, 60)),
    "vault": ((150, 230), (60, 140), (50, 105)),
    "orbit": ((60, 130), (20, 90), (10, 50)),
    "skull base": ((90, 170), (70, 150), (0, 45)),
    "occiput": ((80, 180), (150, 222), (30, 90)),
}


class Case:
    """A label map (array along z, y, x), its spacing, and the true surface."""

    def __init__(self, labels, spacing, truth):
        self.labels = labels
        self.spacing = np.asarray(spacing, float)
        self.truth = truth

    def image(self):
        return image_of(self.labels.astype(np.uint8), self.spacing)


def image_of(values, spacing):
    image = vtkImageData()
    image.SetDimensions(*values.shape[::-1])
    image.SetSpacing(*spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=True))
    return image


def isosurface(image, value):
    contour = vtkFiltersCore.vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, value)
    contour.ComputeNormalsOff()
    contour.ComputeGradientsOff()
    contour.ComputeScalarsOff()
    clean = vtkFiltersCore.vtkCleanPolyData()
    clean.SetInputConnection(contour.GetOutputPort())
    clean.SetTolerance(0.0)
    clean.ConvertPolysToLinesOff()
    clean.Update()
    return clean.GetOutput()


def ct_cases(path):
    """The truth is the surface of the CT resampled to a third of its voxel size."""
    spacing = (0.9570312, 0.9570312, 1.5)
    with tarfile.open(path) as archive:
        matrix = next(member for member in archive if member.name.endswith("matrix.dat"))
        values = np.frombuffer(archive.extractfile(matrix).read(), dtype=np.int16).reshape(108, 256, 256)
    for name, ((x0, x1), (y0, y1), (z0, z1)) in CROPS.items():
        crop = values[z0:z1, y0:y1, x0:x1].astype(np.float32)
        finer = vtkImageResample()
        finer.SetInputData(image_of(crop, spacing))
        finer.SetInterpolationModeToCubic()
        for axis in range(3):
            finer.SetAxisMagnificationFactor(axis, 3.0)
        finer.Update()
        yield name, Case(crop >= HU, spacing, isosurface(finer.GetOutput(), HU))


def analytic_case(distance, size, spacing):
    """@param distance Signed distance of points (x, y, z) in mm, negative inside."""
    def sampled(step):
        counts = [int(np.ceil(size / s)) for s in step]
        z, y, x = np.meshgrid(*(np.arange(n) * s - 0.5 * size for n, s in zip(counts[::-1], step[::-1])), indexing="ij")
        return distance(x, y, z).astype(np.float32)
    truth = isosurface(image_of(sampled((0.25, 0.25, 0.25)), (0.25, 0.25, 0.25)), 0.0)
    return Case(sampled(spacing) < 0.0, spacing, truth)


def analytic_cases():
    def tilted(x, y, z):
        """Oblique to the grid."""
        return 0.8 * x + 0.36 * y + 0.48 * z, -0.6 * x + 0.48 * y + 0.64 * z, -0.8 * y + 0.6 * z

    def sphere(x, y, z):
        return np.sqrt(x * x + y * y + z * z) - 10.0

    def torus(x, y, z):
        x, y, z = tilted(x, y, z)
        return np.sqrt((np.sqrt(x * x + y * y) - 9.0)**2 + z * z) - 3.5

    def box(x, y, z, half):
        q = [np.abs(c) - h for c, h in zip(tilted(x, y, z), half)]
        return np.sqrt(sum(np.maximum(c, 0.0)**2 for c in q)) + np.minimum(np.maximum.reduce(q), 0.0)

    def capsule(x, y, z):
        x, y, z = tilted(x, y, z)
        return np.sqrt((x - np.clip(x, -6.0, 6.0))**2 + y * y + z * z) - 4.0

    half = (0.5, 0.5, 0.5)
    thick = (0.5, 0.5, 3.0)
    yield "sphere", analytic_case(sphere, 28.0, half)
    yield "torus", analytic_case(torus, 32.0, half)
    yield "capsule", analytic_case(capsule, 28.0, half)
    yield "cube", analytic_case(lambda x, y, z: box(x, y, z, (7.0, 7.0, 7.0)), 32.0, half)
    yield "plate of 1.5 mm", analytic_case(lambda x, y, z: box(x, y, z, (9.0, 9.0, 0.75)), 32.0, half)
    yield "sphere, thick slices", analytic_case(sphere, 28.0, thick)
    yield "torus, thick slices", analytic_case(torus, 32.0, thick)


def surface_of(case):
    surfaces = vtkBoneSurfaces()
    surfaces.SetInputData(case.image())
    surfaces.ClosedOff()
    surfaces.Update()
    return surfaces.GetOutput()


def ours(case):
    smooth = vtkBoneSmooth()
    smooth.SetInputData(surface_of(case))
    smooth.MeasureDistancesOff()
    smooth.ProveResultOff()
    smooth.Update()
    return smooth.GetOutput()


def windowed_sinc(case, factor):
    """With the parameters of 3D Slicer's closed surface conversion."""
    smooth = vtkFiltersCore.vtkWindowedSincPolyDataFilter()
    smooth.SetInputData(isosurface(case.image(), 0.5))
    smooth.SetNumberOfIterations(int(20 + 40 * factor))
    smooth.SetPassBand(10.0**(-4.0 * factor))
    smooth.BoundarySmoothingOff()
    smooth.FeatureEdgeSmoothingOff()
    smooth.NonManifoldSmoothingOn()
    smooth.NormalizeCoordinatesOn()
    smooth.Update()
    return smooth.GetOutput()


def constrained(case):
    smooth = vtkFiltersGeneral.vtkConstrainedSmoothingFilter()
    smooth.SetInputData(isosurface(case.image(), 0.5))
    smooth.SetConstraintStrategyToConstraintDistance()
    smooth.SetConstraintDistance(0.5 * case.spacing.min())
    smooth.SetNumberOfIterations(100)
    smooth.Update()
    return smooth.GetOutput()


def surface_nets(case):
    nets = vtkFiltersCore.vtkSurfaceNets3D()
    nets.SetInputData(case.image())
    nets.SetValue(0, 1)
    nets.SetOutputMeshTypeToTriangles()
    nets.Update()
    return nets.GetOutput()


def arrays_of(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    return points, vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(np.int64)


def surface_from(points, triangles):
    surface = vtkPolyData()
    vertices = vtkPoints()
    vertices.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    cells = vtkCellArray()
    offsets = np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, np.int64).ravel(), deep=True))
    surface.SetPoints(vertices)
    surface.SetPolys(cells)
    return surface


def meshlab(case, name, **parameters):
    import pymeshlab
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*arrays_of(isosurface(case.image(), 0.5))))
    getattr(meshes, name)(**parameters)
    return surface_from(meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix())


def meshlib(case):
    from meshlib import mrmeshnumpy, mrmeshpy
    points, triangles = arrays_of(isosurface(case.image(), 0.5))
    mesh = mrmeshnumpy.meshFromFacesVerts(triangles, points)
    relaxation = mrmeshpy.MeshRelaxParams()
    relaxation.iterations = 5
    mrmeshpy.relaxKeepVolume(mesh, relaxation)
    return surface_from(mrmeshnumpy.getNumpyVerts(mesh), mrmeshnumpy.getNumpyFaces(mesh.topology))


def methods(with_meshlib):
    yield "not smoothed", surface_of
    yield "vtkBoneSmooth", ours
    yield "windowed sinc, Slicer 0.2", lambda case: windowed_sinc(case, 0.2)
    yield "windowed sinc, Slicer 0.5", lambda case: windowed_sinc(case, 0.5)
    if hasattr(vtkFiltersGeneral, "vtkConstrainedSmoothingFilter"):
        yield "vtkConstrainedSmoothingFilter", constrained
    if hasattr(vtkFiltersCore, "vtkSurfaceNets3D"):
        yield "vtkSurfaceNets3D", surface_nets
    try:
        import pymeshlab  # noqa: F401
        yield "Taubin (MeshLab)", lambda case: meshlab(case, "apply_coord_taubin_smoothing", stepsmoothnum=10)
        yield "HC Laplacian (MeshLab)", lambda case: meshlab(case, "apply_coord_hc_laplacian_smoothing")
    except ImportError:
        pass
    if with_meshlib:
        yield "MeshLib, volume kept", meshlib


def normals_and_areas(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    return normals / np.maximum(lengths, 1e-30)[:, None], 0.5 * lengths


def samples_of(surface, seed):
    points, triangles = arrays_of(surface)
    normals, areas = normals_and_areas(points, triangles)
    random = np.random.default_rng(seed)
    chosen = random.choice(len(triangles), SAMPLES, p=areas / areas.sum())
    u = random.random((SAMPLES, 2))
    u[u.sum(1) > 1] = 1 - u[u.sum(1) > 1]
    a, b, c = (points[triangles[chosen, k]] for k in range(3))
    return a + u[:, :1] * (b - a) + u[:, 1:] * (c - a), normals[chosen]


def nearest(samples, surface):
    """Squared distances, and the nearest triangles."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    squared = np.empty(len(samples))
    cells = np.empty(len(samples), np.int64)
    at, cell, sub, distance = [0.0, 0.0, 0.0], reference(0), reference(0), reference(0.0)
    for i, point in enumerate(samples):
        locator.FindClosestPoint(point, at, cell, sub, distance)
        squared[i], cells[i] = distance, cell
    return squared, cells


def distance_and_angle(surface, truth):
    samples, normals = samples_of(surface, 1)
    there, cells = nearest(samples, truth)
    back, _ = nearest(samples_of(truth, 2)[0], surface)
    cosines = (normals * normals_and_areas(*arrays_of(truth))[0][cells]).sum(1)
    angles = np.degrees(np.arccos(np.clip(cosines, -1, 1)))
    return np.sqrt(np.concatenate([there, back]).mean()), min(angles.mean(), 180.0 - angles.mean())


def voxelized(case, surface):
    stencil = vtkPolyDataToImageStencil()
    stencil.SetInputData(surface)
    stencil.SetOutputSpacing(*case.spacing)
    stencil.SetOutputWholeExtent(0, case.labels.shape[2] - 1, 0, case.labels.shape[1] - 1, 0, case.labels.shape[0] - 1)
    to_image = vtkImageStencilToImage()
    to_image.SetInputConnection(stencil.GetOutputPort())
    to_image.SetInsideValue(1)
    to_image.SetOutputScalarTypeToUnsignedChar()
    to_image.Update()
    return vtk_to_numpy(to_image.GetOutput().GetPointData().GetScalars()).reshape(case.labels.shape) > 0


def changed_voxels(case, surface):
    """Percent of the voxels next to a boundary."""
    labels = case.labels.astype(bool)
    near = np.zeros_like(labels)
    for axis in range(3):
        differs = np.diff(labels, axis=axis)
        low = [slice(None)] * 3
        high = [slice(None)] * 3
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        near[tuple(low)] |= differs
        near[tuple(high)] |= differs
    return 100.0 * (voxelized(case, surface) != labels).sum() / near.sum()


def intersections(surface, verify):
    """Counted by CGAL in bonedecimate-verify; not a number without that program."""
    if not verify.exists():
        return float("nan")
    with tempfile.TemporaryDirectory() as folder:
        writer = vtkPLYWriter()
        writer.SetFileName(folder + "/surface.ply")
        writer.SetInputData(surface)
        writer.Write()
        shape = subprocess.run([verify, "--shape", folder + "/surface.ply"], capture_output=True, text=True, check=True)
    return json.loads(shape.stdout)["self_intersections"]


def padded(case):
    """So that the surfaces of all methods are closed."""
    return Case(np.pad(case.labels, 1), case.spacing, None)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--ct", type=Path, default=CRANIUM)
    parser.add_argument("--verify", type=Path, default=VERIFY, help="the program that counts intersecting pairs")
    parser.add_argument("--save", type=Path, help="write the surfaces here, as .vtp")
    parser.add_argument("--with-meshlib", action="store_true")
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    cases = list(analytic_cases()) + (list(ct_cases(arguments.ct)) if arguments.ct.exists() else [])
    print("| shape | method | triangles | RMS, mm | normals, degrees | voxels changed, % | intersecting pairs | s |")
    print("|---|---|---:|---:|---:|---:|---:|---:|")
    for name, case in cases:
        if arguments.names and name not in arguments.names:
            continue
        for label, method in methods(arguments.with_meshlib):
            start = time.perf_counter()
            surface = method(case)
            seconds = time.perf_counter() - start
            rms, angle = distance_and_angle(surface, case.truth)
            closed = padded(case)
            changed = changed_voxels(closed, method(closed))
            print(f"| {name} | {label} | {surface.GetNumberOfPolys():,} | {rms:.3f} | {angle:.1f} | {changed:.2f} | "
                  f"{intersections(surface, arguments.verify):.0f} | {seconds:.2f} |", flush=True)
            if arguments.save:
                save(surface, arguments.save / f"{name}, {label}.vtp")


def save(surface, path):
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
    path.parent.mkdir(parents=True, exist_ok=True)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(surface)
    writer.Write()


if __name__ == "__main__":
    main()
