#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of a segmentation node by the panel's logic and by Slicer's own conversion: the table of Documentation/slicer.md.

    closed_surfaces.py [--verify PROGRAM] [--save FOLDER] [NAME ...]

The segmentations are parts of the CT of Debian's package invesalius-examples at 226 HU, as one segment and cut into four.
NAME selects some of them. Needs the wheels slicer-core and bonedecimate; run.sh installs them.
"""
import argparse
import json
import os
import subprocess
import sys
import tarfile
import tempfile
import time
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

sys.path.insert(0, os.environ["SLICER_MODULE"])
from BoneDecimatorLib.engines import WheelEngine  # noqa: E402
from BoneDecimatorLib.logic import BoneDecimatorLogic, Request  # noqa: E402
from segmentation_test import image_of, scene_with, slicers_surface  # noqa: E402

CRANIUM = Path("/usr/share/doc/invesalius-examples/examples/Cranium.inv3")
HU = 226
SPACING = np.array((0.9570312, 0.9570312, 1.5))
TO_RAS = np.diag((-SPACING[0], -SPACING[1], SPACING[2], 1.0))  # as of a scan in LPS
CROPS = {"vault": ((150, 230), (60, 140), (50, 105)), "thin bone": ((70, 150), (110, 190), (10, 60))}  # voxels x, y, z
SAMPLES = 20000
MARGIN = 3  # voxels, at the ends of a crop and at walls, where the CT has no surface that could be compared
HALF, WHOLE = 0.5 * SPACING[0], SPACING[0]
REQUESTS = {
    "Bone Decimator, smoothing half a voxel, all triangles": Request(tolerance=0.0, smoothing=HALF),
    "Bone Decimator, automatic smoothing, half a voxel": Request(tolerance=HALF, smoothing="automatic"),
    "Bone Decimator, automatic smoothing, one voxel": Request(tolerance=WHOLE, smoothing="automatic"),
}


class Case:
    """Labels (z, y, x), the surface of the CT in RAS, and a segmentation node."""

    def __init__(self, values, parts):
        self.labels = np.where(values >= HU, part_numbers(values.shape) if parts > 1 else 1, 0).astype(np.uint8)
        self.truth = true_surface(values)
        segments = {f"part {k}": image_of(self.labels == k, TO_RAS) for k in range(1, parts + 1)}
        self.scene, self.node, self.ids = scene_with(**segments)
        neighbors = sum(dilated(self.labels == k, 1).astype(int) for k in range(1, parts + 1))
        self.excluded = dilated(neighbors > 1, MARGIN)
        for axis in range(3):
            rolled = np.moveaxis(self.excluded, axis, 0)
            rolled[:MARGIN] = rolled[-MARGIN:] = True


def part_numbers(shape):
    """1 to 4, by two oblique planes."""
    z, y, x = np.meshgrid(*(np.arange(n) - 0.5 * n for n in shape), indexing="ij")
    return 1 + (x + 0.3 * y + 0.4 * z > 0) + 2 * (0.3 * x - y + 0.2 * z > 0)


def true_surface(values):
    """Of the CT resampled to a third of its voxel size."""
    image = vtk.vtkImageData()
    image.SetDimensions(*values.shape[::-1])
    image.SetSpacing(*SPACING)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values, np.float32).ravel(), deep=True))
    finer = vtk.vtkImageResample()
    finer.SetInputData(image)
    finer.SetInterpolationModeToCubic()
    for axis in range(3):
        finer.SetAxisMagnificationFactor(axis, 3.0)
    contour = vtk.vtkFlyingEdges3D()
    contour.SetInputConnection(finer.GetOutputPort())
    contour.SetValue(0, HU)
    contour.ComputeNormalsOff()
    to_ras = vtk.vtkTransform()
    to_ras.Scale(-1.0, -1.0, 1.0)
    moved = vtk.vtkTransformPolyDataFilter()
    moved.SetTransform(to_ras)
    moved.SetInputConnection(contour.GetOutputPort())
    moved.Update()
    return moved.GetOutput()


def near_differences(labels):
    """Voxels with a neighbor of another label."""
    near = np.zeros(labels.shape, bool)
    for axis in range(3):
        differs = np.diff(labels.astype(int), axis=axis) != 0
        rolled = np.moveaxis(near, axis, 0)
        rolled[:-1] |= np.moveaxis(differs, axis, 0)
        rolled[1:] |= np.moveaxis(differs, axis, 0)
    return near


def dilated(mask, steps):
    for _ in range(steps):
        mask = near_differences(mask) | mask
    return mask


def arrays_of(surface):
    return (vtk_to_numpy(surface.GetPoints().GetData()).astype(float),
            vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def normals_and_areas(surface):
    points, triangles = arrays_of(surface)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    return normals / np.maximum(lengths, 1e-30)[:, None], 0.5 * lengths


def samples_of(surface, case, seed):
    """Points uniform over the area where the CT can be compared, and the normals there."""
    points, triangles = arrays_of(surface)
    normals, areas = normals_and_areas(surface)
    random = np.random.default_rng(seed)
    chosen = random.choice(len(triangles), 3 * SAMPLES, p=areas / areas.sum())
    u = random.random((len(chosen), 2))
    u[u.sum(1) > 1] = 1 - u[u.sum(1) > 1]
    a, b, c = (points[triangles[chosen, k]] for k in range(3))
    found = a + u[:, :1] * (b - a) + u[:, 1:] * (c - a)
    voxels = np.rint(found / np.diag(TO_RAS)[:3]).astype(int)
    size = np.array(case.labels.shape[::-1])
    is_in = ((voxels >= 0) & (voxels < size)).all(axis=1)
    x, y, z = np.clip(voxels, 0, size - 1).T
    kept = np.flatnonzero(is_in & ~case.excluded[z, y, x])[:SAMPLES]
    return found[kept], normals[chosen[kept]]


def nearest(samples, surface):
    """Squared distances, and the nearest triangles."""
    locator = vtk.vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    squared, cells = np.empty(len(samples)), np.empty(len(samples), int)
    at, cell, sub, distance = [0.0, 0.0, 0.0], vtk.reference(0), vtk.reference(0), vtk.reference(0.0)
    for i, point in enumerate(samples):
        locator.FindClosestPoint(point, at, cell, sub, distance)
        squared[i], cells[i] = distance, cell
    return squared, cells


def distance_and_angle(surfaces, case):
    """RMS of both directions, mm, and the mean angle between the normals, degrees."""
    append = vtk.vtkAppendPolyData()
    for surface in surfaces:
        append.AddInputData(surface)
    append.Update()
    samples, normals = samples_of(append.GetOutput(), case, 1)
    there, cells = nearest(samples, case.truth)
    back, _ = nearest(samples_of(case.truth, case, 2)[0], append.GetOutput())
    angles = np.degrees(np.arccos(np.clip((normals * normals_and_areas(case.truth)[0][cells]).sum(1), -1, 1)))
    # Triangles of an isosurface may face inwards.
    return np.sqrt(np.concatenate([there, back]).mean()), min(angles.mean(), 180.0 - angles.mean())


def inside(surface, shape, finer=1):
    """Voxels (z, y, x) within a closed surface, of a grid `finer` times as fine."""
    flipped = vtk.vtkTransform()
    flipped.Scale(-1.0, -1.0, 1.0)
    moved = vtk.vtkTransformPolyDataFilter()
    moved.SetTransform(flipped)
    moved.SetInputData(surface)
    stencil = vtk.vtkPolyDataToImageStencil()
    stencil.SetInputConnection(moved.GetOutputPort())
    stencil.SetOutputSpacing(*(SPACING / finer))
    stencil.SetOutputOrigin(*(-0.5 * (finer - 1) / finer * SPACING))
    size = finer * np.array(shape[::-1])
    stencil.SetOutputWholeExtent(0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1)
    to_image = vtk.vtkImageStencilToImage()
    to_image.SetInputConnection(stencil.GetOutputPort())
    to_image.SetInsideValue(1)
    to_image.SetOutsideValue(0)
    to_image.SetOutputScalarTypeToUnsignedChar()
    to_image.Update()
    return vtk_to_numpy(to_image.GetOutput().GetPointData().GetScalars()).reshape(size[::-1])


def changed_voxels(surfaces, case):
    """How many are not in their segment, or in two."""
    found = [inside(surface, case.labels.shape) > 0 for surface in surfaces]
    wrong = [mask != (case.labels == k) for k, mask in enumerate(found, 1)]
    return np.count_nonzero(np.logical_or.reduce(wrong))


def gap_and_overlap(surfaces, case):
    """mm^3 within no segment, and within two, where all 26 neighbors of a voxel belong to segments."""
    finer = 3
    count = sum(inside(surface, case.labels.shape, finer).astype(int) for surface in surfaces)
    background = np.pad(case.labels == 0, 1, constant_values=True)
    for axis in range(3):
        background = background | np.roll(background, 1, axis) | np.roll(background, -1, axis)
    deep = np.kron(~background[1:-1, 1:-1, 1:-1], np.ones((finer, finer, finer), bool))
    volume = SPACING.prod() / finer**3
    return np.count_nonzero(deep & (count == 0)) * volume, np.count_nonzero(deep & (count > 1)) * volume


def intersections(surfaces, verify):
    """Intersecting pairs of triangles within each surface; not a number without the program."""
    if not verify.exists():
        return float("nan")
    total = 0
    for surface in surfaces:
        with tempfile.TemporaryDirectory() as folder:
            writer = vtk.vtkPLYWriter()
            writer.SetFileName(folder + "/surface.ply")
            writer.SetInputData(surface)
            writer.Write()
            shape = subprocess.run([verify, "--shape", folder + "/surface.ply"], capture_output=True, text=True, check=True)
        total += json.loads(shape.stdout)["self_intersections"]
    return total


def slicers(case, factor):
    """The first call converts all segments."""
    slicers_surface(case.node, list(case.ids.values())[0], factor)
    surfaces = []
    for segment in case.ids.values():
        surfaces.append(vtk.vtkPolyData())
        case.node.GetClosedSurfaceRepresentation(segment, surfaces[-1])
    return surfaces, "none"


def ours(case, request):
    models, _ = BoneDecimatorLogic(case.scene, WheelEngine()).decimate_segments(case.node, request)
    report = json.loads(models[0].GetPolyData().GetFieldData().GetAbstractArray("BoneDecimateReport").GetValue(0))
    proved = report["proof"]["upper"] if "proof" in report else report["smoothing"]["largest_displacement"]
    return [model.GetPolyData() for model in models], f"{np.ceil(1e3 * proved) / 1e3:.3f}"


def methods():
    yield "Slicer, not smoothed (factor 0)", lambda case: slicers(case, 0.0)
    yield "Slicer, default smoothing (factor 0.5)", lambda case: slicers(case, 0.5)
    for name, request in REQUESTS.items():
        yield name, lambda case, request=request: ours(case, request)


def save(surfaces, folder, name):
    folder.mkdir(parents=True, exist_ok=True)
    for i, surface in enumerate(surfaces, 1):
        writer = vtk.vtkXMLPolyDataWriter()
        writer.SetFileName(str(folder / f"{name}, {i}.vtp"))
        writer.SetInputData(surface)
        writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--ct", type=Path, default=CRANIUM)
    parser.add_argument("--verify", type=Path, default=Path(os.environ.get("BONEDECIMATE_PROGRAM", "none") + "-verify"))
    parser.add_argument("--save", type=Path, help="write the surfaces here, as .vtp")
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    with tarfile.open(arguments.ct) as archive:
        matrix = next(member for member in archive if member.name.endswith("matrix.dat"))
        values = np.frombuffer(archive.extractfile(matrix).read(), dtype=np.int16).reshape(108, 256, 256)
    print("| segmentation | surfaces | triangles | RMS, mm | normals, degrees | proved, mm | voxels changed | gap, mm^3 | "
          "overlap, mm^3 | intersecting pairs | CPU s |")
    print("|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|")
    for name, ((x0, x1), (y0, y1), (z0, z1)) in CROPS.items():
        for parts in (1, 4):
            title = f"{name}, {parts} segment{'s' * (parts > 1)}"
            if arguments.names and not any(each in title for each in arguments.names):
                continue
            case = Case(values[z0:z1, y0:y1, x0:x1], parts)
            for label, method in methods():
                start = time.process_time()
                surfaces, proved = method(case)
                seconds = time.process_time() - start
                rms, angle = distance_and_angle(surfaces, case)
                gap, overlap = gap_and_overlap(surfaces, case)
                triangles = sum(surface.GetNumberOfPolys() for surface in surfaces)
                print(f"| {title} | {label} | {triangles:,} | {rms:.3f} | {angle:.1f} | {proved} | "
                      f"{changed_voxels(surfaces, case):,} | {gap:.1f} | {overlap:.1f} | "
                      f"{intersections(surfaces, arguments.verify):,} | {seconds:.2f} |", flush=True)
                if arguments.save:
                    save(surfaces, arguments.save, f"{title}, {label}")


if __name__ == "__main__":
    main()
