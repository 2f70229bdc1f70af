#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sharp edges of segmentations, smoothed with and without them: the table of Documentation/results/measurements.md.

    sharp_edges.py BONEDECIMATE [--spacing 0.5 1] [--json]

Each solid is voxelized in three oblique positions; a voxel belongs to it if its center does. The surface of the label map is not smoothed, smoothed
automatically, and smoothed with FeatureAngle 45. Random points of the result within 1.5 voxels of an edge of the solid are compared with the
nearest point of the solid, and points of the edge with the result.
"""
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPlaneCollection, vtkPolyData, vtkStaticCellLocator, vtkStaticPointLocator
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkClipClosedSurface
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource
from vtkmodules.vtkIOPLY import vtkPLYReader

SIZE = 12.0  # mm
NEAR = 1.5  # voxels
SAMPLES = 20000
STEP = 0.05  # mm, between points of an edge
METHODS = {"not smoothed": ("--smooth", "0"), "smoothed": ("--smooth", "auto"), "edges kept": ("--smooth", "auto", "--feature-angle", "45")}
POSITIONS = ((0.3, 0.5, 0.2), (0.9, -0.4, 0.7), (-0.6, 0.8, 1.3))  # angles around x, y and z


def segments_between(points):
    """Points on the closed line through the points."""
    ends = np.roll(points, -1, axis=0)
    counts = np.maximum(1, np.ceil(np.linalg.norm(ends - points, axis=1) / STEP).astype(int))
    return np.concatenate([a + (b - a) * np.arange(count)[:, None] / count for a, b, count in zip(points, ends, counts)])


class Solid:
    """Planes (normal, offset) that bound it, a radius around z (None: no cylinder), and points of its edges."""

    def __init__(self, planes, radius, edges):
        self.planes = [(np.array(normal, float) / np.linalg.norm(normal), offset) for normal, offset in planes]
        self.radius = radius
        self.edges = edges

    def contains(self, points):
        inside = np.ones(len(points), bool) if self.radius is None else np.hypot(points[:, 0], points[:, 1]) <= self.radius
        for normal, offset in self.planes:
            inside &= points @ normal <= offset
        return inside

    def surface(self):
        """Points and triangles."""
        source = vtkCubeSource() if self.radius is None else vtkCylinderSource()
        if self.radius is None:
            source.SetBounds(*(4 * SIZE * np.array((-1, 1) * 3)))
        else:
            source.SetRadius(self.radius)
            source.SetHeight(8 * SIZE)
            source.SetResolution(1440)
        source.Update()
        start = source.GetOutput()
        if self.radius is not None:  # VTK's cylinder is around y
            points = vtk_to_numpy(start.GetPoints().GetData())[:, [2, 0, 1]]
            start.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
        planes = vtkPlaneCollection()
        for normal, offset in self.planes:
            plane = vtkPlane()
            plane.SetNormal(*-normal)
            plane.SetOrigin(*(normal * offset))
            planes.AddItem(plane)
        clean, clip, triangles = vtkCleanPolyData(), vtkClipClosedSurface(), vtkTriangleFilter()
        clean.SetInputData(start)
        clip.SetInputConnection(clean.GetOutputPort())
        clip.SetClippingPlanes(planes)
        triangles.SetInputConnection(clip.GetOutputPort())
        triangles.Update()
        return triangles.GetOutput()


def box(sides):
    return [(sign * np.eye(3)[axis], sides[axis] / 2) for axis in range(3) for sign in (-1, 1)]


def edges_of_box(sides):
    """Each twice, as part of two faces."""
    corners = np.array(((-1, -1), (1, -1), (1, 1), (-1, 1)), float) / 2
    return np.concatenate([segments_between(np.insert(corners, axis, end, axis=1) * sides) for axis in range(3) for end in (-0.5, 0.5)])


def ring(height_of):
    turn = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
    x, y = SIZE / 2 * np.cos(turn), SIZE / 2 * np.sin(turn)
    return np.stack((x, y, height_of(x)), axis=1)


def wedge(degrees):
    """Its edge runs along z through the origin, without what is near the ends."""
    half = np.radians(degrees) / 2
    sides = [((np.sin(half) * -1, np.cos(half), 0), 0.0), ((np.sin(half) * -1, -np.cos(half), 0), 0.0)]
    ends = [((1, 0, 0), SIZE * np.cos(half)), ((0, 0, 1), SIZE / 2), ((0, 0, -1), SIZE / 2)]
    z = np.arange(-SIZE / 4, SIZE / 4, STEP)
    return Solid(sides + ends, None, np.stack((0 * z, 0 * z, z), axis=1))


def solids():
    cube, plate = (np.array((SIZE, SIZE, height)) for height in (SIZE, 3.0))
    ends = [((0, 0, 1), SIZE / 2), ((0, 0, -1), SIZE / 2)]
    rings = np.concatenate([ring(lambda x, z=z: np.full_like(x, z)) for z in (-SIZE / 2, SIZE / 2)])
    return {f"cube, {SIZE:g} mm": Solid(box(cube), None, edges_of_box(cube)), f"ends of a cylinder, {SIZE:g} mm": Solid(ends, SIZE / 2, rings),
            "cylinder cut at 45 degrees": Solid([((1, 0, 1), 0.0), ends[1]], SIZE / 2, ring(lambda x: -x)[::4]),
            **{f"wedge of {degrees} degrees": wedge(degrees) for degrees in (60, 90, 120)}, "plate of 3 mm": Solid(box(plate), None, edges_of_box(plate))}


def rotation(angles):
    turn = np.eye(3)
    for axis, angle in enumerate(angles):
        c, s = np.cos(angle), np.sin(angle)
        step = np.eye(3)
        a, b = (axis + 1) % 3, (axis + 2) % 3
        step[a, a], step[a, b], step[b, a], step[b, b] = c, -s, s, c
        turn = step @ turn
    return turn


def write_map(solid, turn, spacing, header):
    """A label map around the solid, whose center is the origin of its coordinates."""
    count = int(np.ceil(2 * 1.6 * SIZE / spacing))
    first = -spacing * (count - 1) / 2
    ticks = first + spacing * np.arange(count)
    z, y, x = np.meshgrid(ticks, ticks, ticks, indexing="ij")
    inside = solid.contains(np.stack((x.ravel(), y.ravel(), z.ravel()), axis=1) @ turn)
    header.with_suffix(".raw").write_bytes(inside.astype(np.uint8).tobytes())
    header.write_text(f"ObjectType = Image\nNDims = 3\nDimSize = {count} {count} {count}\nElementSpacing = {spacing} {spacing} {spacing}\n"
                      f"Offset = {first} {first} {first}\nElementType = MET_UCHAR\nElementDataFile = {header.stem}.raw\n", encoding="ascii")


def vtk_points(coordinates):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(coordinates, deep=True))
    return points


class Nearest:
    """Of a surface."""

    def __init__(self, surface):
        self.triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
        self.surface = surface
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(surface)
        self.locator.BuildLocator()

    def normals(self):
        a, b, c = (self.points[self.triangles[:, i]] for i in range(3))
        across = np.cross(b - a, c - a)
        return across / np.maximum(np.linalg.norm(across, axis=1), 1e-30)[:, None]

    def samples(self):
        """Random points, evenly over the area, and their triangles."""
        random = np.random.default_rng(1)
        a, b, c = (self.points[self.triangles[:, i]] for i in range(3))
        areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        chosen = random.choice(len(areas), SAMPLES, p=areas / areas.sum())
        u, v = random.random((2, SAMPLES, 1))
        u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
        return a[chosen] + u * (b - a)[chosen] + v * (c - a)[chosen], chosen

    def distances(self, points):
        """To the surface, and the nearest triangles."""
        cell, sub, squared, at = mutable(0), mutable(0), mutable(0.0), [0.0] * 3
        found = []
        for point in points:
            self.locator.FindClosestPoint(point, at, cell, sub, squared)
            found.append((float(squared), int(cell)))
        return np.sqrt([item[0] for item in found]), np.array([item[1] for item in found], int)


def near(points, edges, distance):
    """Which points are that near to a point of the edges."""
    cloud, locator, squared = vtkPolyData(), vtkStaticPointLocator(), mutable(0.0)
    cloud.SetPoints(vtk_points(edges))
    locator.SetDataSet(cloud)
    locator.BuildLocator()
    return np.array([locator.FindClosestPointWithinRadius(distance, point, squared) >= 0 for point in points])


def compare(result, truth, edges, spacing):
    """Squared distances to the solid and angles at its edges, squared distances of the edges."""
    samples, triangles = result.samples()
    chosen = near(samples, edges, NEAR * spacing)
    distances, nearest = truth.distances(samples[chosen])
    cosines = np.einsum("ij,ij->i", result.normals()[triangles[chosen]], truth.normals()[nearest])
    return distances**2, np.degrees(np.arccos(np.clip(cosines, -1, 1))), result.distances(edges)[0] ** 2


def read(path):
    reader = vtkPLYReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def turned(surface, turn):
    surface.SetPoints(vtk_points(vtk_to_numpy(surface.GetPoints().GetData()).astype(float) @ turn.T))
    return surface


def row_of(name, solid, spacing, program, folder):
    """Means over the positions."""
    found = {method: [] for method in METHODS}
    for angles in POSITIONS:
        turn = rotation(angles)
        write_map(solid, turn, spacing, folder / "solid.mhd")
        truth, edges = Nearest(turned(solid.surface(), turn)), solid.edges @ turn.T
        for method, words in METHODS.items():
            subprocess.run([program, folder / "solid.mhd", folder / "solid.ply", "--segments", "all", "--target-reduction", "0", "--measure", "off",
                            "--quiet", *words], check=True, stderr=subprocess.DEVNULL)
            found[method].append(compare(Nearest(read(folder / "solid.ply")), truth, edges, spacing))
    row = {"edge": name, "voxels, mm": spacing}
    for method, parts in found.items():
        distances, angles, of_edge = (np.concatenate(part) for part in zip(*parts))
        row[f"{method}: RMS, mm"] = round(float(np.sqrt(distances.mean())), 3)
        row[f"{method}: degrees"] = round(float(angles.mean()), 1)
        row[f"{method}: edge, mm"] = round(float(np.sqrt(of_edge.mean())), 3)
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("--spacing", type=float, nargs="+", default=[0.5, 1.0], help="of the voxels, mm")
    parser.add_argument("--json", action="store_true", help="in the last line, for features.sh")
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as name:
        for spacing in options.spacing:
            for edge, solid in solids().items():
                rows.append(row_of(edge, solid, spacing, options.program.resolve(), Path(name)))
                print(", ".join(f"{column} {value}" for column, value in rows[-1].items()), flush=True)
    if options.json:
        print(json.dumps(rows))


if __name__ == "__main__":
    main()
