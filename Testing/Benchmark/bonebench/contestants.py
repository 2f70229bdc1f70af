# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The participants: the modes of this project and the peers that are installed."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from .workers import Outcome, Programs, call

WORKER = Path(__file__).with_name("peer_worker.py")
TOLERANCE_WORKER = Path(__file__).with_name("tolerance_worker.py")


@dataclass(frozen=True)
class Contestant:
    """Something that decimates: key in the raw figures, name in tables."""

    key: str
    name: str
    ours: bool = False
    mode: str = ""
    threads: int = 1
    through: str = "core"  # of ours: the VTK-free call, or "filter"
    kernels: str = ""  # of ours: "" for the best that the processor has

    def run(self, programs: Programs, bone: Path, result: Path, faces: int) -> Outcome:
        """One decimation in a process of its own."""
        if self.ours:
            kernels = ["--kernels", self.kernels] if self.kernels else []
            return call([programs.path("run"), bone, result, self.through, self.mode, self.threads,
                        "--faces", faces, *kernels])
        if self.key == "cgal":
            return call([programs.path("cgal"), bone, result, faces])
        return call([sys.executable, "-B", WORKER, self.key, bone, result, faces])


@dataclass(frozen=True)
class Peer:
    """Another program: its Python module, or "" for the one compiled from CGAL."""

    key: str
    name: str
    module: str
    install: str


PEERS = (
    Peer("cgal", "CGAL Lindstrom-Turk", "", "Debian's libcgal-dev, libgmp-dev and libmpfr-dev, then build again"),
    Peer("vtk", "vtkQuadricDecimation", "vtkmodules", "pip install vtk"),
    Peer("meshlab", "MeshLab quadric", "pymeshlab", "pip install pymeshlab"),
    Peer("meshlab-topology", "MeshLab, topology kept", "pymeshlab", "pip install pymeshlab"),
    Peer("open3d", "Open3D", "open3d", "pip install open3d, and Debian's libusb-1.0-0"),
    Peer("fast-simplification", "fast-simplification", "fast_simplification", "pip install fast-simplification"),
    Peer("pyfqmr", "pyfqmr", "pyfqmr", "pip install pyfqmr"),
    Peer("meshoptimizer", "meshoptimizer", "meshoptimizer", "pip install meshoptimizer"),
    Peer("meshlib", "MeshLib", "meshlib", "run.sh --with-meshlib; its license is non-commercial"),
)


def find_peers(programs: Programs, meshlib: bool) -> tuple[list[Contestant], list[str]]:
    """The peers that can run, CGAL first, and a sentence for each that cannot."""
    found, missing = [], []
    for peer in PEERS:
        is_there = importlib.util.find_spec(peer.module) is not None if peer.module else programs.has("cgal")
        if is_there and (meshlib or peer.key != "meshlib"):
            found.append(Contestant(peer.key, peer.name))
        else:
            missing.append(f"{peer.name} does not take part ({peer.install}).")
    return found, missing


def our_modes(programs: Programs, kind: str = "") -> list[str]:
    """The modes that the program was built with, in its own order.  @param kind "parallel" or "proving": those alone."""
    return _listed(programs, f"--{kind}-modes" if kind else "--modes")


def our_kernels(programs: Programs) -> list[str]:
    """The sets of kernels that this processor runs, the one that is used last."""
    return _listed(programs, "--kernels")


def _listed(programs: Programs, what: str) -> list[str]:
    return subprocess.run([programs.path("run"), what], capture_output=True, text=True, check=True).stdout.split()


def ours(mode: str, threads: int = 1, through: str = "core") -> Contestant:
    """One of our modes as a contestant."""
    key = f"{mode}-{threads}" + ("-filter" if through == "filter" else "")
    name = f"**{mode}**" + (f", {threads} threads" if threads > 1 else "")
    return Contestant(key, name + (", VTK filter" if through == "filter" else ""), True, mode, threads, through)


def our_contestants(modes: list[str], parallel: list[str], threads: tuple[int, ...] = (1, 2)) -> list[Contestant]:
    """Every mode on one thread, the parallel ones on more, all through the filter."""
    many = [ours(mode, count) for mode in modes for count in threads if count == 1 or mode in parallel]
    return many + [ours(mode, 1, "filter") for mode in modes]
