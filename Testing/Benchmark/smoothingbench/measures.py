# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What is measured on a surface. Lengths in mm, angles in degrees."""

from __future__ import annotations

import json
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from bonebench.peer_worker import write_ply
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkImagingStencil import vtkImageStencilToImage, vtkPolyDataToImageStencil

from .cases import Case
from .surfaces import Surface, polydata_of


def normals_and_areas(surface: Surface) -> tuple[np.ndarray, np.ndarray]:
    a, b, c = (surface.points[surface.triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    return normals / np.maximum(lengths, 1e-30)[:, None], 0.5 * lengths


def is_in(box: np.ndarray | None, points: np.ndarray) -> np.ndarray:
    if box is None:
        return np.ones(len(points), bool)
    return ((points >= box[0]) & (points <= box[1])).all(axis=1)


def samples_of(surface: Surface, box: np.ndarray | None, count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Points uniform over the area within the box, and the normals there."""
    normals, areas = normals_and_areas(surface)
    corners = [surface.points[surface.triangles[:, k]] for k in range(3)]
    areas = areas * is_in(box, sum(corners) / 3.0)
    random = np.random.default_rng(seed)
    chosen = random.choice(len(areas), count, p=areas / areas.sum())
    u = random.random((count, 2))
    u[u.sum(1) > 1] = 1 - u[u.sum(1) > 1]
    a, b, c = (corner[chosen] for corner in corners)
    return a + u[:, :1] * (b - a) + u[:, 1:] * (c - a), normals[chosen]


class Locator:
    """Nearest triangles of a surface."""

    def __init__(self, surface: Surface) -> None:
        self.polydata = polydata_of(surface)
        self.normals = normals_and_areas(surface)[0]
        self.tree = vtkStaticCellLocator()
        self.tree.SetDataSet(self.polydata)
        self.tree.BuildLocator()

    def nearest(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Distances, and the nearest triangles."""
        squared, cells = np.empty(len(points)), np.empty(len(points), np.int64)
        at, cell, sub, distance = [0.0, 0.0, 0.0], reference(0), reference(0), reference(0.0)
        for i, point in enumerate(points):
            self.tree.FindClosestPoint(point, at, cell, sub, distance)
            squared[i], cells[i] = distance, cell
        return np.sqrt(squared), cells

    def first_hit(self, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
        """Where a segment meets the surface first; NaN where it does not."""
        t, at, coordinates, sub = reference(0.0), [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], reference(0)
        if not self.tree.IntersectWithLine(begin, end, 1e-9, t, at, coordinates, sub):
            return np.full(3, np.nan)
        return np.array(at)


def accuracy(surface: Surface, truth: Surface, of_truth: Locator, box: np.ndarray | None, count: int) -> tuple[float, float]:
    """RMS distance in both directions, and the mean angle between the normals of the surface and those of the truth."""
    points, normals = samples_of(surface, box, count, 1)
    there, cells = of_truth.nearest(points)
    back, _ = Locator(surface).nearest(samples_of(truth, box, count, 2)[0])
    cosines = (normals * of_truth.normals[cells]).sum(1)
    angles = np.degrees(np.arccos(np.clip(cosines, -1, 1))).mean()
    return float(np.sqrt((np.concatenate([there, back])**2).mean())), float(min(angles, 180.0 - angles))


def roughness(surface: Surface, box: np.ndarray | None) -> float:
    """Mean angle between the normals of neighboring triangles."""
    corners = surface.triangles
    edges = np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
    faces = np.tile(np.arange(len(corners)), 3)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    edges, faces = edges[order], faces[order]
    pairs = (edges[1:] == edges[:-1]).all(1) & is_in(box, surface.points[edges[1:]].mean(1))
    normals, _ = normals_and_areas(surface)
    cosines = (normals[faces[:-1][pairs]] * normals[faces[1:][pairs]]).sum(1)
    return float(np.degrees(np.arccos(np.clip(cosines, -1, 1))).mean())


def displacement(surface: Surface, of_input: Locator, box: np.ndarray | None) -> float:
    """The largest distance of a point from the surface that is not smoothed."""
    points = surface.points[is_in(box, surface.points)]
    return float(of_input.nearest(points)[0].max())


def voxelized(surface: Surface, shape: tuple[int, ...], spacing: np.ndarray, origin: np.ndarray,
              tolerance: float | None = None) -> np.ndarray:
    """Which voxel centers are inside; within the tolerance of the surface they may count as inside (None: VTK's default)."""
    stencil = vtkPolyDataToImageStencil()
    stencil.SetInputData(polydata_of(surface))
    if tolerance is not None:
        stencil.SetTolerance(tolerance)
    stencil.SetOutputSpacing(*spacing)
    stencil.SetOutputOrigin(*origin)
    stencil.SetOutputWholeExtent(0, shape[2] - 1, 0, shape[1] - 1, 0, shape[0] - 1)
    to_image = vtkImageStencilToImage()
    to_image.SetInputConnection(stencil.GetOutputPort())
    to_image.SetInsideValue(1)
    to_image.SetOutputScalarTypeToUnsignedChar()
    to_image.Update()
    return vtk_to_numpy(to_image.GetOutput().GetPointData().GetScalars()).reshape(shape) > 0


def at_boundary(labels: np.ndarray) -> np.ndarray:
    """Voxels with a neighbor of another label."""
    near = np.zeros(labels.shape, bool)
    for axis in range(3):
        differs = np.diff(labels.astype(np.int16), axis=axis) != 0
        low, high = [slice(None)] * 3, [slice(None)] * 3
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        near[tuple(low)] |= differs
        near[tuple(high)] |= differs
    return near


def voxels_in(case: Case) -> np.ndarray:
    """Those whose centers are in the case's box."""
    inside = np.ones(case.labels.shape, bool)
    for axis, count in enumerate(case.labels.shape[::-1]):
        if case.box is not None:
            at = case.origin[axis] + case.spacing[axis] * np.arange(count)
            keep = (at >= case.box[0, axis]) & (at <= case.box[1, axis])
            inside &= keep.reshape([-1 if other == 2 - axis else 1 for other in range(3)])
    return inside


def changed_voxels(case: Case, surfaces: dict[int, Surface]) -> tuple[int, int]:
    """Voxels that are not in exactly their label's surface, and voxels at a boundary."""
    wrong = np.zeros(case.labels.shape, bool)
    for value, surface in surfaces.items():
        wrong |= voxelized(surface, case.labels.shape, case.spacing, case.origin) != (case.labels == value)
    counted = voxels_in(case)
    return int((wrong & counted).sum()), int((at_boundary(case.labels) & counted).sum())


# Of positions from the middles between voxel centers, in voxels: surfaces that are not smoothed pass through these middles.
ASIDE = np.array([0.031, 0.043, 0.017])


def gaps_and_overlaps(case: Case, surfaces: dict[int, Surface]) -> tuple[float, float]:
    """Volumes, mm^3, by eight points per voxel: in no label although the voxels around have two labels or more and none is
    background, and in two labels."""
    shape = tuple(2 * count for count in case.labels.shape)
    count = np.zeros(shape, np.uint8)
    for surface in surfaces.values():
        count += voxelized(surface, shape, 0.5 * case.spacing, case.origin + (ASIDE - 0.25) * case.spacing, 0.0)
    least = most = np.pad(case.labels, 1)
    for axis in range(3):  # of the eight voxels of a cell
        least, most = np.minimum(least, np.roll(least, -1, axis)), np.maximum(most, np.roll(most, -1, axis))
    between = (least > 0) & (most > least)
    cells = np.ix_(*((np.arange(n) + 1) // 2 for n in shape))
    volume = case.spacing.prod() / 8.0
    return float(((count == 0) & between[cells]).sum() * volume), float(np.maximum(count.astype(int) - 1, 0).sum() * volume)


def thickness(case: Case, surface: Surface) -> tuple[float, float]:
    """Least and mean distance between the first hits of the case's pairs of segments."""
    locator = Locator(surface)
    hits = np.array([[locator.first_hit(*segment) for segment in pair] for pair in case.probes])
    lengths = np.linalg.norm(hits[:, 0] - hits[:, 1], axis=1)
    if np.isnan(lengths).any():  # torn, or closed
        return 0.0, float(np.nan_to_num(lengths).mean())
    return float(lengths.min()), float(lengths.mean())


def shape_of(surface: Surface, verify: Path) -> dict[str, Any]:
    """Components, edges and intersecting pairs, counted by bonedecimate-verify with CGAL; nothing without that program."""
    if not verify.exists():
        return {}
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "surface.ply"
        write_ply(str(file), *surface)
        shape = subprocess.run([verify, "--shape", file], capture_output=True, text=True, check=True)
    return json.loads(shape.stdout)
