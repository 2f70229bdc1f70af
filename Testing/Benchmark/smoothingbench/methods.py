# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The methods: each makes the closed surface of every label of a map, and says how long that took."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules import vtkFiltersCore
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import NOT_SMOOTHED, OURS
from .cases import Case
from .surfaces import Surface, arrays_of, image_of, isosurface
from .worker import WHOLE, sinc_of, surface_nets

HERE = Path(__file__).resolve().parents[1]


@dataclass
class Result:
    """The surfaces by label, and what they took."""

    surfaces: dict[int, Surface]
    seconds: float
    cpu_seconds: float
    figures: dict[str, Any] = field(default_factory=dict)


Method = Callable[[Case], Result]


def timed(case: Case, call: Callable[[Case], dict[int, Surface]]) -> Result:
    cpu, wall = time.process_time(), time.perf_counter()
    surfaces = call(case)
    return Result(surfaces, time.perf_counter() - wall, time.process_time() - cpu)


def run_worker(python: str, step: str, source: Path, threads: list[int], target: Path | None = None) -> list[dict[str, Any]]:
    """What the worker prints for each number of threads; `python` may begin with a path of modules: PATH:PROGRAM."""
    modules, _, program = python.rpartition(":")
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, [modules, str(HERE)])), "PYTHONDONTWRITEBYTECODE": "1"}
    words = [program, "-m", "smoothingbench.worker", step, source, ",".join(map(str, threads))] + ([target] if target else [])
    done = subprocess.run(words, env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{step}: {done.stderr[-2000:]}")
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]


def save_map(case: Case, path: Path) -> None:
    np.savez(path, labels=case.labels, spacing=case.spacing, origin=case.origin)


def ours(python: str, step: str) -> Method:
    """In a process with the Python for which this project is built."""
    def method(case: Case) -> Result:
        with tempfile.TemporaryDirectory() as folder:
            source, target = Path(folder) / "map.npz", Path(folder) / "surfaces.npz"
            save_map(case, source)
            (figures,) = run_worker(python, step, source, [1], target)
            with np.load(target) as file:
                surfaces = {value: Surface(file[f"points {value}"], file[f"triangles {value}"]) for value in case.values()}
        return Result(surfaces, figures["seconds"], figures["cpu_seconds"], figures)
    return method


def each_label(smooth: Callable[[Case, vtkPolyData], Surface]) -> Method:
    """Extracts and smooths one label after the other."""
    def call(case: Case) -> dict[int, Surface]:
        return {value: smooth(case, isosurface(image_of((case.labels == value).astype(np.uint8), case.spacing, case.origin), 0.5))
                for value in case.values()}
    return lambda case: timed(case, call)


def windowed_sinc(factor: float) -> Method:
    def smooth(_case: Case, surface: vtkPolyData) -> Surface:
        sinc = sinc_of(factor)
        sinc.SetInputData(surface)
        sinc.Update()
        return arrays_of(sinc.GetOutput())
    return each_label(smooth)


def constrained(case: Case, surface: vtkPolyData) -> Surface:
    """With the bound of this project's smoothing."""
    smooth = vtkFiltersCore.vtkConstrainedSmoothingFilter()
    smooth.SetInputData(surface)
    smooth.SetConstraintStrategyToConstraintDistance()
    smooth.SetConstraintDistance(0.5 * case.spacing.min())
    smooth.SetNumberOfIterations(100)
    smooth.Update()
    return arrays_of(smooth.GetOutput())


def label_of_nets(nets: vtkPolyData, value: int) -> Surface:
    """Triangles with the label on one side; the normal points to the second."""
    points, triangles = arrays_of(nets)
    sides = vtk_to_numpy(nets.GetCellData().GetArray("BoundaryLabels"))
    first, second = triangles[sides[:, 0] == value], triangles[sides[:, 1] == value][:, ::-1]
    used, corners = np.unique(np.concatenate([first, second]), return_inverse=True)
    return Surface(points[used], corners.reshape(-1, 3))


def nets(case: Case) -> Result:
    def call(case: Case) -> dict[int, Surface]:
        (filter_,) = surface_nets(image_of(case.labels, case.spacing, case.origin), 0)
        filter_.Update()
        return {value: label_of_nets(filter_.GetOutput(), value) for value in case.values()}
    return timed(case, call)


def meshlab(name: str, **parameters: Any) -> Method:
    def smooth(_case: Case, surface: vtkPolyData) -> Surface:
        import pymeshlab
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(*arrays_of(surface)))
        getattr(meshes, name)(**parameters)
        return Surface(meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix().astype(np.int64))
    return each_label(smooth)


def meshlib(_case: Case, surface: vtkPolyData) -> Surface:
    from meshlib import mrmeshnumpy, mrmeshpy
    points, triangles = arrays_of(surface)
    mesh = mrmeshnumpy.meshFromFacesVerts(triangles.astype(np.int32), points)
    relaxation = mrmeshpy.MeshRelaxParams()
    relaxation.iterations = 5
    mrmeshpy.relaxKeepVolume(mesh, relaxation)
    return Surface(mrmeshnumpy.getNumpyVerts(mesh), mrmeshnumpy.getNumpyFaces(mesh.topology).astype(np.int64))


def all_methods(python: str, with_meshlib: bool) -> dict[str, Method]:
    """Those that this Python has the packages for."""
    methods = {NOT_SMOOTHED: ours(python, "extract"), OURS: ours(python, "extract and smooth"),
               "windowed sinc 0.2": windowed_sinc(0.2), "windowed sinc 0.5": windowed_sinc(0.5)}
    if hasattr(vtkFiltersCore, "vtkConstrainedSmoothingFilter"):
        methods["vtkConstrainedSmoothingFilter"] = each_label(constrained)
    if hasattr(vtkFiltersCore, "vtkSurfaceNets3D"):
        methods["vtkSurfaceNets3D"] = nets
    if importlib.util.find_spec("pymeshlab"):
        methods["Taubin"] = meshlab("apply_coord_taubin_smoothing", stepsmoothnum=10)
        methods["HC Laplacian"] = meshlab("apply_coord_hc_laplacian_smoothing")
    if with_meshlib:
        methods["MeshLib, volume kept"] = each_label(meshlib)
    return methods


def whole_runs(python: str) -> dict[str, Method]:
    """From the label map to a simplified surface, and the first of the methods above for comparison."""
    return {NOT_SMOOTHED: ours(python, "extract")} | {step: ours(python, step) for step in WHOLE}
