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
TRIANGLES_PER_LAYER = 2600  # of the CT, per voxel along x, on average
# The largest number of triangles of each step.
LIMITS = {"extract": 1e7, "vtkFlyingEdges3D": 1e7, "vtkSurfaceNets3D": 1e7, "smooth": 1e7, "windowed sinc": 1e7, "proved": 1e6,
          "keep voxels": 1e6}
GROWTH_COLUMNS = ("step", "map_triangles", "input_triangles", "triangles", "voxels", "cpu_seconds", "seconds", "held_bytes",
                  "peak_bytes", "threads", "rounds", "vtk")
THREAD_COLUMNS = ("map", "step", "threads", "triangles", "cpu_seconds", "seconds", "sha256")


def tiled(values: np.ndarray, triangles: float) -> np.ndarray:
    """Bone of the CT, side by side along x until there are about so many triangles, or a part of it from its middle."""
    bone = np.pad((values >= HU).astype(np.uint8), 1)
    count = round(triangles / TRIANGLES_PER_LAYER)
    first = max(0, (bone.shape[2] - count) // 2)
    return np.concatenate([bone] * (1 + count // bone.shape[2]), axis=2)[:, :, first:first + count]


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
    """Every step of this project on parts of the CT, and on a map of five labels."""
    maps = {"ball of five labels": folder / "ball.npz"}
    save_map(ball_of_five_parts(), maps["ball of five labels"])
    if ct.exists():
        values = ct_values(ct)
        maps |= {f"CT, {size:,.0f} triangles": write_map(values, size, folder) for size in sizes}
    for name, source in ((name, source) for name, source in maps.items() if not names or name in names):
        for step in (step for step in OURS if step != "extract and smooth"):
            for figures in run_worker(ours, step, source, counts):
                yield {"map": name, "step": step, **{key: figures[key] for key in THREAD_COLUMNS if key in figures}}
