# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The programs of the audit, and how each is set to a largest distance."""

from __future__ import annotations

import importlib.util
import os
import shutil
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Sequence

from .contestants import TOLERANCE_WORKER, WORKER, our_modes
from .workers import Programs

NODE_PACKAGE = Path(os.environ.get("NODE_PACKAGES", "node"), "node_modules", "meshoptimizer")


@dataclass(frozen=True)
class Request:
    """The arguments of a run."""

    programs: Programs
    bone: Path
    result: Path
    tolerance: float  # mm
    count: int = 0  # triangles of mode Fast with this tolerance, for programs that take nothing but a number


Command = Callable[[Request], Sequence[object]]


def with_mode(mode: str) -> Command:
    """A mode of this project with the largest error."""
    return lambda request: [request.programs.path("run"), request.bone, request.result, "core", mode, 1, "--error", request.tolerance]


def with_tolerance(key: str) -> Command:
    """A peer of tolerance_worker.py."""
    return lambda request: [sys.executable, "-B", TOLERANCE_WORKER, key, request.bone, request.result, request.tolerance]


def with_count(key: str) -> Command:
    """A peer of peer_worker.py that takes no tolerance, at the number of triangles of Fast."""
    return lambda request: [sys.executable, "-B", WORKER, key, request.bone, request.result, request.count]


def with_openmesh(request: Request) -> Sequence[object]:
    """The command of Debian's libopenmesh-apps: quadrics order the collapses, ModHausdorff and normals limit them."""
    return ["OpenMesh-commandlineDecimater", "-M", "Q", "-M", f"HD:{request.tolerance}", "-M", "NF:60", "-n", "0.0001",
            "-i", request.bone, "-o", request.result]


def with_cgal_envelope(request: Request) -> Sequence[object]:
    """CGAL's edge collapse with Polyhedral_envelope_filter."""
    return [request.programs.path("cgal"), request.bone, request.result, f"{request.tolerance}mm"]


def with_cgal_count(request: Request) -> Sequence[object]:
    """CGAL's edge collapse at the number of triangles of Fast."""
    return [request.programs.path("cgal"), request.bone, request.result, request.count]


@dataclass(frozen=True)
class Program:
    """A row of the audit. needs: a Python module, a command, a file, or a program of the benchmark."""

    name: str
    needs: str
    command: Command
    setting: str

    @property
    def takes_count(self) -> bool:
        """Whether it has no tolerance."""
        return self.setting.startswith("no tolerance")

    def is_here(self, programs: Programs) -> bool:
        """Whether it can run."""
        return (programs.has(self.needs) or Path(self.needs).exists() or shutil.which(self.needs) is not None
                or importlib.util.find_spec(self.needs.replace("/", "_")) is not None)


FAST_COUNT = "no tolerance; gets the number of triangles of **Fast**"
PROGRAMS = (
    Program("OpenMesh ModHausdorff", "OpenMesh-commandlineDecimater", with_openmesh,
            "`-M Q -M HD:mm -M NF:60 -n 0.0001` of its command line: largest distance of removed points"),
    Program("mmgs", "mmgpy", with_tolerance("mmgs"), "`hausd`, \"maximal Hausdorff distance\" of its manual"),
    Program("Manifold", "manifold3d", with_tolerance("manifold"),
            "`simplify(tolerance)`: \"all surfaces will have moved by less than tolerance\""),
    Program("MeshLib", "meshlib", with_tolerance("meshlib"), "`maxError`, \"estimated distance deviation from the original mesh\""),
    Program("meshoptimizer simplify", "meshoptimizer", with_tolerance("meshoptimizer"),
            "`target_error` with `ErrorAbsolute`, \"an approximate measure of the deviation\""),
    Program("meshoptimizer simplifyWithUpdate", str(NODE_PACKAGE), with_tolerance("meshoptimizer-update"), "the same"),
    Program("vtkDecimatePro", "vtkmodules", with_tolerance("decimate-pro"),
            "`AbsoluteError` with `AccumulateError`, \"a global error bounds\"; `PreserveTopology`"),
    Program("vtkQuadricDecimation", "vtkmodules", with_tolerance("vtk"), "`MaximumError`, \"maximum allowed absolute error\""),
    Program("MeshLab isotropic remeshing", "pymeshlab", with_tolerance("meshlab-remeshing"),
            "`maxsurfdist`; `adaptive`, `targetlen` ten times the tolerance"),
    Program("CGAL polyhedral envelope", "cgal", with_cgal_envelope,
            "`Polyhedral_envelope_filter(distance)` on Lindstrom-Turk: the result is within the envelope of the input"),
    Program("fTetWild", "pytetwild", with_tolerance("ftetwild"),
            "`epsilon`, relative to the diagonal; surface of the tetrahedra, `coarsen`"),
    Program("Open3D", "open3d", with_tolerance("open3d"),
            "`maximum_error`, \"the maximum error where a vertex is allowed to be merged\", without a unit"),
    Program("pyfqmr", "pyfqmr", with_tolerance("pyfqmr"),
            "`simplify_mesh_lossless(epsilon)`, \"maximal error after which a vertex is not deleted\", without a unit"),
    Program("MeshLab quadric", "pymeshlab", with_count("meshlab"), FAST_COUNT),
    Program("fast-simplification", "fast_simplification", with_count("fast-simplification"), FAST_COUNT),
    Program("CGAL Lindstrom-Turk", "cgal", with_cgal_count, FAST_COUNT),
)
OURS = "`MaximumError`, proved in both directions"


def our_programs(programs: Programs) -> list[Program]:
    """The modes that prove an error, Fast first."""
    return [Program(mode, "run", with_mode(mode), OURS) for mode in our_modes(programs, "proving")]
