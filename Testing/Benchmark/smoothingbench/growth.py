# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Time and memory against the number of triangles, and the bytes of the results for several numbers of threads."""

from __future__ import annotations

import os
import statistics
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules import vtkFiltersCore

from .cases import CT_SPACING, HU, ball_of_five_parts, ct_values, padded
from .methods import run_worker, save_map
from .worker import OURS

Row = dict[str, Any]
# The largest number of triangles of each step.
LIMITS = {"extract": 1e7, "vtkFlyingEdges3D": 1e7, "vtkSurfaceNets3D": 1e7, "smooth": 1e7, "windowed sinc": 1e7, "proved": 1e6,
          "keep voxels": 1e6}
WITH_PROOF, SMALL = ("proved", "keep voxels"), 3e5  # the bytes of these steps are compared on maps up to so many triangles
GROWTH_COLUMNS = ("step", "map_triangles", "input_triangles", "triangles", "voxels", "cpu_seconds", "seconds", "held_bytes",
                  "peak_bytes", "threads", "rounds", "vtk")
THREAD_COLUMNS = ("map", "step", "threads", "triangles", "cpu_seconds", "seconds", "sha256")


def triangles_of_layers(bone: np.ndarray) -> np.ndarray:
    """Of marching cubes, for each layer along x: a surface has about twice as many triangles as points."""
    points = sum((np.diff(bone, axis=axis, append=np.take(bone, [0], axis)) != 0).sum((0, 1)) for axis in range(3))
    return 2 * points


def tiled(values: np.ndarray, triangles: float) -> np.ndarray:
    """Bone of the CT, from its middle on and then repeated along x, so much of it that there are about so many triangles."""
    bone = np.roll(np.pad((values >= HU).astype(np.uint8), 1), -values.shape[2] // 2, axis=2)
    layers = triangles_of_layers(bone)
    copies = 1 + int(triangles / layers.sum())
    count = int(np.searchsorted(np.cumsum(np.tile(layers, copies)), triangles)) + 1
    return np.tile(bone, (1, 1, copies))[:, :, :count]


def write_map(values: np.ndarray, triangles: float, folder: Path) -> Path:
    path = folder / f"map-{triangles:.0f}.npz"
    if not path.exists():
        save_map(padded("growth", "CT", tiled(values, triangles), CT_SPACING, np.zeros(3)), path)
    return path


def python_of(step: str, ours: str, peers: str) -> str:
    return ours if step in OURS else peers


def steps_of(size: float) -> list[str]:
    """Without what this VTK does not have."""
    return [step for step, limit in LIMITS.items()
            if size <= limit and (step != "vtkSurfaceNets3D" or hasattr(vtkFiltersCore, step))]


def repeated(python: str, step: str, source: Path, threads: int, rounds: int) -> Row:
    """Medians of the times and the memory."""
    runs = [run_worker(python, step, source, [threads])[0] for _ in range(rounds)]
    return runs[0] | {key: statistics.median(run[key] for run in runs) for key in ("seconds", "cpu_seconds", "peak_bytes")}


def growth(ct: Path, folder: Path, ours: str, peers: str, sizes: list[float], steps: list[str],
           rounds: int) -> Iterator[Row]:
    """All steps on one size of the map, one after the other, then the next size."""
    values, threads = ct_values(ct), os.cpu_count() or 1
    for size in sizes:
        source = write_map(values, size, folder)
        with np.load(source) as file:
            voxels = file["labels"].size
        map_triangles = 0
        for step in (step for step in steps_of(size) if not steps or step in steps):
            figures = repeated(python_of(step, ours, peers), step, source, threads, rounds)
            map_triangles = map_triangles or figures["triangles"]
            yield {"step": step, "map_triangles": map_triangles, "voxels": voxels, "threads": threads, "rounds": rounds,
                   **{key: figures[key] for key in GROWTH_COLUMNS if key in figures}}


def bytes_over_threads(ct: Path, folder: Path, ours: str, sizes: list[float], counts: list[int], names: list[str]) -> Iterator[Row]:
    """Every step of this project on a map of five labels and on parts of the CT; steps with a proof on small ones."""
    maps = {"ball of five labels": folder / "ball.npz"}
    save_map(ball_of_five_parts(), maps["ball of five labels"])
    if ct.exists():
        values = ct_values(ct)
        maps |= {f"CT, {size:,.0f} triangles": write_map(values, size, folder) for size in sizes}
    large = [write_map(values, size, folder) for size in sizes if size > SMALL] if ct.exists() else []
    for name, source in ((name, source) for name, source in maps.items() if not names or name in names):
        for step in (step for step in OURS if step in LIMITS and not (source in large and step in WITH_PROOF)):
            for figures in run_worker(ours, step, source, counts):
                yield {"map": name, "step": step, **{key: figures[key] for key in THREAD_COLUMNS if key in figures}}
