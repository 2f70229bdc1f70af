# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The label maps and the true surfaces: crops of a CT, the phantom of Data/, analytic shapes, and maps of several labels."""

from __future__ import annotations

import subprocess
import tarfile
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkImagingCore import vtkImageResample
from vtkmodules.vtkIOImage import vtkMetaImageReader

from bonebench.bones import CROPS, HU

from .surfaces import Surface, arrays_of, image_of, isosurface

CRANIUM = Path("/usr/share/doc/invesalius-examples/examples/Cranium.inv3")
CT_SPACING = (0.9570312, 0.9570312, 1.5)
MARGIN = 6  # voxels that the methods get beyond the crop on each side, so that its ends do not count
FIRST, SECOND = "marching cubes", "finer grid"  # the truths
Coordinates = tuple[np.ndarray, np.ndarray, np.ndarray]
Distance = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


@dataclass
class Case:
    """A label map (indices z, y, x) with background on all sides, and what is known of its surfaces. Lengths in mm."""

    name: str
    kind: str
    labels: np.ndarray
    spacing: np.ndarray
    origin: np.ndarray
    truths: dict[str, Surface] = field(default_factory=dict)
    box: np.ndarray | None = None  # low and high corner of what is measured; None: all
    probes: np.ndarray | None = None  # (n, 2, 2, 3): two segments, whose first hits are as far apart as the shape is thick

    def values(self) -> list[int]:
        return [int(value) for value in np.unique(self.labels) if value]


def padded(name: str, kind: str, labels: np.ndarray, spacing: tuple[float, ...], origin: np.ndarray, **more: object) -> Case:
    step = np.asarray(spacing, float)
    return Case(name, kind, np.pad(labels.astype(np.uint8), 1), step, np.asarray(origin, float) - step, **more)


def ct_values(path: Path) -> np.ndarray:
    """Hounsfield units, indices z, y, x."""
    with tarfile.open(path) as archive:
        matrix = next(member for member in archive if member.name.endswith("matrix.dat"))
        return np.frombuffer(archive.extractfile(matrix).read(), dtype=np.int16).reshape(108, 256, 256)


def gray_level_truths(values: np.ndarray, spacing: tuple[float, ...], origin: np.ndarray) -> dict[str, Surface]:
    """Marching cubes of the gray values, and of the same values interpolated at a third of the voxel size (trilinear)."""
    image = image_of(values.astype(np.float32), spacing, origin)
    finer = vtkImageResample()
    finer.SetInputData(image)
    finer.SetInterpolationModeToLinear()
    for axis in range(3):
        finer.SetAxisMagnificationFactor(axis, 3.0)
    finer.Update()
    return {FIRST: arrays_of(isosurface(image, HU)), SECOND: arrays_of(isosurface(finer.GetOutput(), HU))}


def crop_of(values: np.ndarray, ranges: tuple) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The values with the margin, the origin, and the box without it."""
    low = np.array([max(0, start - MARGIN) for start, _ in ranges])
    high = np.array([min(end + MARGIN, count) for (_, end), count in zip(ranges, values.shape[::-1])])
    part = values[low[2]:high[2], low[1]:high[1], low[0]:high[0]]
    box = np.array([[start for start, _ in ranges], [end - 1 for _, end in ranges]]) * CT_SPACING
    return part, low * CT_SPACING, box


def ct_case(values: np.ndarray, name: str) -> Case:
    part, origin, box = crop_of(values, CROPS[name])
    return padded(name, "CT", part >= HU, CT_SPACING, origin, truths=gray_level_truths(part, CT_SPACING, origin), box=box)


def interpolated(values: np.ndarray, positions: list[np.ndarray]) -> np.ndarray:
    """Trilinear, at the voxel coordinates of each axis (z, y, x)."""
    for axis, at in enumerate(positions):
        low = np.clip(np.floor(at).astype(int), 0, values.shape[axis] - 2)
        weight = (at - low).reshape([-1 if k == axis else 1 for k in range(3)])
        values = (1 - weight) * values.take(low, axis) + weight * values.take(low + 1, axis)
    return values


def network_cases(ct: Path) -> Iterator[tuple[str, Callable[[], Case]]]:
    """Crops as a network segments them on a coarser grid: the map's copy on the voxels of the scan, and the map itself."""
    values = ct_values(ct)
    for kind in ("network, file", "network, model"):
        for name in ("vault", "thin bone", "skull base"):
            for model in (1.5, 3.0):
                yield name, lambda kind=kind, name=name, model=model: network_case(values, kind, name, model)


def network_case(values: np.ndarray, kind: str, name: str, model: float) -> Case:
    """The two grids have their first corner in common, as most libraries resample."""
    part, origin, box = crop_of(values, CROPS[name])
    spacing, title, truths = np.array(CT_SPACING[::-1]), f"{name}, {model:g} mm", gray_level_truths(part, CT_SPACING, origin)
    counts = np.floor(np.array(part.shape) * spacing / model).astype(int)
    coarse = interpolated(part.astype(float), [(np.arange(n) + 0.5) * model / step - 0.5 for n, step in zip(counts, spacing)]) >= HU
    corner = np.asarray(origin) - 0.5 * np.asarray(CT_SPACING)
    on_model = padded(title, kind, coarse, (model,) * 3, corner + 0.5 * model, truths=truths, box=box)
    if kind == "network, model":
        return on_model
    margin = np.ceil(model / spacing).astype(int)  # voxels of the scan that the network's layer of background covers
    nearest = [np.clip(np.floor((np.arange(-more, n + more) + 0.5) * step / model).astype(int) + 1, 0, last + 1)
               for n, more, step, last in zip(part.shape, margin, spacing, counts)]
    first = np.asarray(origin) - margin[::-1] * CT_SPACING
    return Case(title, kind, on_model.labels[np.ix_(*nearest)], np.asarray(CT_SPACING), first, truths, box)


def phantom_case(program: Path) -> Case:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "phantom.mha"
        subprocess.run([program, file, "--size", "small"], check=True, capture_output=True)
        reader = vtkMetaImageReader()
        reader.SetFileName(str(file))
        reader.Update()
    image = reader.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])
    origin, spacing = np.array(image.GetOrigin()), image.GetSpacing()
    ends = np.array(image.GetDimensions()) - 1
    box = origin + np.array([[MARGIN] * 3, ends - MARGIN]) * spacing
    return padded("phantom", "phantom", values >= HU, spacing, origin, truths=gray_level_truths(values, spacing, origin), box=box)


def tilted(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> Coordinates:
    """Oblique to the grid."""
    return 0.8 * x + 0.36 * y + 0.48 * z, -0.6 * x + 0.48 * y + 0.64 * z, -0.8 * y + 0.6 * z


def untilted(points: np.ndarray) -> np.ndarray:
    """Of (..., 3) points: the inverse of `tilted`."""
    return points @ np.array([[0.8, 0.36, 0.48], [-0.6, 0.48, 0.64], [0.0, -0.8, 0.6]])


def sphere(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    return np.sqrt(x * x + y * y + z * z) - 10.0


def torus(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    x, y, z = tilted(x, y, z)
    return np.sqrt((np.sqrt(x * x + y * y) - 9.0)**2 + z * z) - 3.5


def capsule(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    x, y, z = tilted(x, y, z)
    return np.sqrt((x - np.clip(x, -6.0, 6.0))**2 + y * y + z * z) - 4.0


def ellipsoid(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Negative inside, not a distance."""
    x, y, z = tilted(x, y, z)
    return 7.0 * (np.sqrt((x / 12.0)**2 + (y / 9.0)**2 + (z / 7.0)**2) - 1.0)


def box(coordinates: Coordinates, half: tuple[float, float, float], offset: float = 0.0) -> np.ndarray:
    """A tilted box; offset along its z axis."""
    x, y, z = tilted(*coordinates)
    q = [np.abs(c) - h for c, h in zip((x, y, z - offset), half)]
    return np.sqrt(sum(np.maximum(c, 0.0)**2 for c in q)) + np.minimum(np.maximum.reduce(q), 0.0)


def cube(*coordinates: np.ndarray) -> np.ndarray:
    return box(coordinates, (7.0, 7.0, 7.0))


def plate(*coordinates: np.ndarray) -> np.ndarray:
    return box(coordinates, (9.0, 9.0, 0.75))


def gap(*coordinates: np.ndarray) -> np.ndarray:
    """Two blocks 1 mm apart."""
    return np.minimum(box(coordinates, (8.0, 8.0, 2.5), 3.0), box(coordinates, (8.0, 8.0, 2.5), -3.0))


def probes(outward: bool) -> np.ndarray:
    """Segments normal to the plate, from outside inward, or from the middle of the gap outward."""
    x, y = (c.ravel() for c in np.meshgrid(np.arange(-6.0, 6.1, 0.2), np.arange(-6.0, 6.1, 0.2)))
    ends = [[np.stack([x, y, np.full_like(x, z)], -1) for z in segment]
            for segment in (((0.0, 4.0), (0.0, -4.0)) if outward else ((4.0, -4.0), (-4.0, 4.0)))]
    return untilted(np.array(ends).transpose(2, 0, 1, 3))


def sampled(distance: Distance, size: float, step: tuple[float, ...]) -> np.ndarray:
    counts = [int(np.ceil(size / s)) for s in step]
    z, y, x = np.meshgrid(*(np.arange(n) * s - 0.5 * size for n, s in zip(counts[::-1], step[::-1])), indexing="ij")
    return distance(x, y, z)


def analytic_case(name: str, distance: Distance, size: float, spacing: tuple[float, ...], lines: np.ndarray | None = None) -> Case:
    """Points closer than a quarter of a millimeter to each other sample the truth."""
    fine, origin = (0.2, 0.2, 0.2), np.full(3, -0.5 * size)
    truth = arrays_of(isosurface(image_of(sampled(distance, size, fine).astype(np.float32), fine, origin), 0.0))
    return padded(name, "analytic", sampled(distance, size, spacing) < 0.0, spacing, origin, truths={FIRST: truth}, probes=lines)


def analytic_cases() -> Iterator[Callable[[], Case]]:
    half, thick = (0.5, 0.5, 0.5), (0.5, 0.5, 3.0)
    shapes = [("sphere", sphere, 28.0, half), ("torus", torus, 32.0, half), ("capsule", capsule, 28.0, half),
              ("ellipsoid", ellipsoid, 32.0, half), ("cube", cube, 32.0, half),
              ("plate of 1.5 mm", plate, 32.0, half, probes(False)), ("gap of 1 mm", gap, 32.0, half, probes(True)),
              ("sphere, thick slices", sphere, 28.0, thick), ("torus, thick slices", torus, 32.0, thick),
              ("ellipsoid, thick slices", ellipsoid, 32.0, thick)]
    for shape in shapes:
        yield shape[0], lambda shape=shape: analytic_case(*shape)


def parts(coordinates: Coordinates) -> np.ndarray:
    """Labels 1 to 5: quadrants between two oblique planes, and a ball."""
    x, y, z = tilted(*coordinates)
    quadrants = 1 + (x > 0.0) + 2 * (y > 0.0)
    return np.where((x - 3.0)**2 + y * y + z * z < 16.0, 5, quadrants)


def ball_of_five_parts() -> Case:
    spacing, size = (0.5, 0.5, 0.5), 22.0
    labels = sampled(lambda *c: np.where(sphere(*c) < -1.0, parts(c), 0), size, spacing)
    return padded("ball of five labels", "labels", labels, spacing, np.full(3, -0.5 * size))


def ct_of_five_parts(values: np.ndarray) -> Case:
    """The bone of the skull base in oblique blocks, with five labels in turn."""
    part, origin, _ = crop_of(values, CROPS["skull base"])
    z, y, x = np.meshgrid(*(np.arange(n) * s for n, s in zip(part.shape, CT_SPACING[::-1])), indexing="ij")
    x, y, z = (c / 24.0 for c in tilted(x, y, z))
    cells = np.floor(x) + 2 * np.floor(y) + 3 * np.floor(z)
    labels = np.where(part >= HU, 1 + cells.astype(int) % 5, 0)
    return padded("CT, five labels", "labels", labels, CT_SPACING, origin)


def ct_of_two_tissues(values: np.ndarray) -> Case:
    """Bone and soft tissue of the vault: nearly all walls are between the two."""
    part, origin, _ = crop_of(values, CROPS["vault"])
    return padded("CT, two labels", "labels", np.where(part >= HU, 1, np.where(part >= -200, 2, 0)), CT_SPACING, origin)


def all_cases(ct: Path, phantom: Path) -> Iterator[tuple[str, Callable[[], Case]]]:
    """Names, and functions that make the cases. Without the CT or the phantom's program theirs are missing."""
    yield from analytic_cases()
    if phantom.exists():
        yield "phantom", lambda: phantom_case(phantom)
    yield "ball of five labels", ball_of_five_parts
    if ct.exists():
        values = ct_values(ct)
        for name in CROPS:
            yield name, lambda name=name: ct_case(values, name)
        yield "CT, two labels", lambda: ct_of_two_tissues(values)
        yield "CT, five labels", lambda: ct_of_five_parts(values)
