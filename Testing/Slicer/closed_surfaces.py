#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of a segmentation node by the panel's logic and by Slicer's own conversion: the table of Documentation/results/slicer.md.

    closed_surfaces.py [--picture FILE.png] [NAME ...]

The segmentations are the phantom of Data (small) and parts of the CT of Debian's package invesalius-examples, at 226 HU, as one
segment and cut into four. NAME selects some of them. Needs the wheels slicer-core and bonedecimate, which run.sh installs, and
the programs bonedecimate-phantom and bonedecimate-verify beside BONEDECIMATE_PROGRAM.
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
from BoneDecimatorLib.checks import AUTOMATIC  # noqa: E402
from BoneDecimatorLib.engines import WheelEngine  # noqa: E402
from BoneDecimatorLib.logic import BoneDecimatorLogic  # noqa: E402
from BoneDecimatorLib.request import Request  # noqa: E402
from BoneDecimatorLib.surfaces import report_of  # noqa: E402
from segmentation_test import image_of, scene_with, slicers_surface  # noqa: E402

PROGRAM = os.environ["BONEDECIMATE_PROGRAM"]
CRANIUM = Path("/usr/share/doc/invesalius-examples/examples/Cranium.inv3")
HU = 226
CROPS = {"vault": ((150, 230), (60, 140), (50, 105)), "thin bone": ((70, 150), (110, 190), (10, 60))}  # voxels x, y, z
SAMPLES = 20000
MARGIN = 3  # voxels, at the ends of a volume and at walls, where the CT has no surface that could be compared
# By fractions of a voxel: largest error, smoothing.
RUNS = {"smoothing half a voxel, all triangles": (0.0, 0.5), "automatic smoothing, half a voxel": (0.5, AUTOMATIC),
        "automatic smoothing, one voxel": (1.0, AUTOMATIC)}
COLORS = ((0.95, 0.85, 0.65), (0.55, 0.75, 0.95), (0.65, 0.9, 0.6), (0.95, 0.6, 0.55))


class Case:
    """Labels (z, y, x), the surface of the CT in RAS, and a segmentation node."""

    def __init__(self, values, spacing, parts):
        self.spacing = np.array(spacing)
        to_ras = np.diag((-spacing[0], -spacing[1], spacing[2], 1.0))  # as of a scan in LPS
        self.labels = np.where(values >= HU, part_numbers(values.shape) if parts > 1 else 1, 0).astype(np.uint8)
        self.truth = true_surface(values, spacing)
        segments = {f"part {k}": image_of(self.labels == k, to_ras) for k in range(1, parts + 1)}
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


def true_surface(values, spacing):
    """Of the CT resampled to a third of its voxel size."""
    image = vtk.vtkImageData()
    image.SetDimensions(*values.shape[::-1])
    image.SetSpacing(*spacing)
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
    contour.Update()
    return turned(contour.GetOutput())


def turned(surface):
    """From LPS to RAS, or back."""
    half_turn = vtk.vtkTransform()
    half_turn.Scale(-1.0, -1.0, 1.0)
    moved = vtk.vtkTransformPolyDataFilter()
    moved.SetTransform(half_turn)
    moved.SetInputData(surface)
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
    voxels = np.rint(found * (-1.0, -1.0, 1.0) / case.spacing).astype(int)
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


def inside(surface, case, finer=1):
    """Voxels (z, y, x) within a closed surface, of a grid `finer` times as fine."""
    stencil = vtk.vtkPolyDataToImageStencil()
    stencil.SetInputData(turned(surface))
    stencil.SetOutputSpacing(*(case.spacing / finer))
    stencil.SetOutputOrigin(*(-0.5 * (finer - 1) / finer * case.spacing))
    size = finer * np.array(case.labels.shape[::-1])
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
    found = [inside(surface, case) > 0 for surface in surfaces]
    wrong = [mask != (case.labels == k) for k, mask in enumerate(found, 1)]
    return np.count_nonzero(np.logical_or.reduce(wrong))


def gap_and_overlap(surfaces, case):
    """mm^3 within no segment, and within two, where all 26 neighbors of a voxel belong to segments."""
    finer = 3
    count = sum(inside(surface, case, finer).astype(int) for surface in surfaces)
    background = np.pad(case.labels == 0, 1, constant_values=True)
    for axis in range(3):
        background = background | np.roll(background, 1, axis) | np.roll(background, -1, axis)
    deep = np.kron(~background[1:-1, 1:-1, 1:-1], np.ones((finer, finer, finer), bool))
    volume = case.spacing.prod() / finer**3
    return np.count_nonzero(deep & (count == 0)) * volume, np.count_nonzero(deep & (count > 1)) * volume


def intersections(surfaces):
    """Intersecting pairs of triangles within each surface."""
    total = 0
    for surface in surfaces:
        with tempfile.TemporaryDirectory() as folder:
            writer = vtk.vtkPLYWriter()
            writer.SetFileName(folder + "/surface.ply")
            writer.SetInputData(surface)
            writer.Write()
            shape = subprocess.run([PROGRAM + "-verify", "--shape", folder + "/surface.ply"], capture_output=True, text=True,
                                   check=True)
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


def ours(case, largest, smoothing):
    voxel = case.spacing.min()
    request = Request(tolerance=largest * voxel, smoothing=smoothing if smoothing == AUTOMATIC else smoothing * voxel)
    models, _ = BoneDecimatorLogic(case.scene, WheelEngine()).decimate_segments(case.node, request)
    report = report_of(models[0].GetPolyData())
    proved = report["proof"]["upper"] if "proof" in report else report["smoothing"]["largest_displacement"]
    return [model.GetPolyData() for model in models], f"{np.ceil(1e3 * proved) / 1e3:.3f}"


def methods():
    yield "Slicer, not smoothed (factor 0)", lambda case: slicers(case, 0.0)
    yield "Slicer, default smoothing (factor 0.5)", lambda case: slicers(case, 0.5)
    for name, numbers in RUNS.items():
        yield f"Bone Decimator, {name}", lambda case, numbers=numbers: ours(case, *numbers)


def volumes():
    """Name, values, spacing."""
    with tempfile.TemporaryDirectory() as folder:
        path = folder + "/phantom.mha"
        subprocess.run([PROGRAM + "-phantom", path, "--size", "small"], check=True)
        reader = vtk.vtkMetaImageReader()
        reader.SetFileName(path)
        reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])
    yield "phantom", values, image.GetSpacing()
    with tarfile.open(CRANIUM) as archive:
        matrix = next(member for member in archive if member.name.endswith("matrix.dat"))
        values = np.frombuffer(archive.extractfile(matrix).read(), dtype=np.int16).reshape(108, 256, 256)
    for name, ((x0, x1), (y0, y1), (z0, z1)) in CROPS.items():
        yield name, values[z0:z1, y0:y1, x0:x1], (0.9570312, 0.9570312, 1.5)


def draw(results, path):
    """Three in a row, flat shaded. @param results Surfaces by title."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    rows = (len(results) + 2) // 3
    window.SetSize(3 * 400, rows * 460)
    window.SetMultiSamples(8)
    backdrop = vtk.vtkRenderer()
    backdrop.SetBackground(1.0, 1.0, 1.0)
    window.AddRenderer(backdrop)
    camera = None
    for k, (title, surfaces) in enumerate(results.items()):
        renderer = vtk.vtkRenderer()
        left, bottom = k % 3 / 3, 1.0 - (k // 3 + 1) / rows
        renderer.SetViewport(left, bottom, left + 1 / 3, bottom + 1 / rows)
        renderer.SetBackground(1.0, 1.0, 1.0)
        window.AddRenderer(renderer)
        for surface, color in zip(surfaces, COLORS):
            flat = vtk.vtkPolyData()
            flat.SetPoints(surface.GetPoints())
            flat.SetPolys(surface.GetPolys())
            mapper = vtk.vtkPolyDataMapper()
            mapper.SetInputData(flat)
            actor = vtk.vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().SetColor(*color)
            actor.GetProperty().SetInterpolationToFlat()
            renderer.AddActor(actor)
        text = vtk.vtkTextActor()
        text.SetInput(f"{title}\n{sum(surface.GetNumberOfPolys() for surface in surfaces):,} triangles")
        text.GetTextProperty().SetColor(0.0, 0.0, 0.0)
        text.GetTextProperty().SetFontSize(14)
        text.SetPosition(8, 424)
        renderer.AddViewProp(text)
        if camera is None:
            camera = renderer.GetActiveCamera()
            camera.SetPosition(0.6, 1.0, 0.3)
            camera.SetFocalPoint(0.0, 0.0, 0.0)
            camera.SetViewUp(0.0, 0.0, 1.0)
            renderer.ResetCamera()
            camera.Zoom(1.3)
        renderer.SetActiveCamera(camera)
    window.Render()
    shot = vtk.vtkWindowToImageFilter()
    shot.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(shot.GetOutputPort())
    writer.Write()


def row(title, label, case, method):
    """Prints it, and returns the surfaces."""
    start = time.process_time()
    surfaces, proved = method(case)
    seconds = time.process_time() - start
    rms, angle = distance_and_angle(surfaces, case)
    gap, overlap = gap_and_overlap(surfaces, case)
    triangles = sum(surface.GetNumberOfPolys() for surface in surfaces)
    print(f"| {title} | {label} | {triangles:,} | {rms:.3f} | {angle:.1f} | {proved} | {changed_voxels(surfaces, case):,} | "
          f"{gap:.1f} | {overlap:.1f} | {intersections(surfaces):,} | {seconds:.2f} |", flush=True)
    return surfaces


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--picture", type=Path, help="draw the last segmentation here")
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    print("| segmentation | surfaces | triangles | RMS, mm | normals, degrees | proved, mm | voxels changed | gap, mm^3 | "
          "overlap, mm^3 | intersecting pairs | CPU s |")
    print("|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|")
    results = {}
    for name, values, spacing in volumes():
        for parts in (1, 4):
            title = f"{name}, {parts} segment{'s' * (parts > 1)}"
            if not arguments.names or any(each in title for each in arguments.names):
                case = Case(values, spacing, parts)
                results = {label: row(title, label, case, method) for label, method in methods()}
    if arguments.picture and results:
        draw(results, arguments.picture)


if __name__ == "__main__":
    main()
