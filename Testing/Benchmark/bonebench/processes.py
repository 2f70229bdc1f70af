# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Several processes: the filter in ParaView on 1, 2 and 4 ranks, each with a part of the triangles, and what their joined results are."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator

from .certificates import certificate
from .document import ROOT
from .peer_worker import write_ply

if TYPE_CHECKING:
    from .features import Lab

Row = dict[str, Any]
ERROR = 0.5  # mm
RUNS = (("maxilla", "Fast"), ("maxilla", "Balanced"), ("cranium", "Fast"))
RANKS = (1, 2, 4)
SCRIPT = ROOT / "Testing" / "Benchmark" / "rank_parts.py"


def prefix_of_paraview(build: Path) -> Path | None:
    """The folder of the ParaView that the build has its plugin for."""
    lines = (build / "CMakeCache.txt").read_text(encoding="utf-8").splitlines()
    found = [Path(line.partition("=")[2]) for line in lines if line.startswith("BONEDECIMATE_PARAVIEW_PREFIX:")]
    return next((prefix for prefix in found if (prefix / "bin" / "pvbatch").is_file()), None)


def run_ranks(build: Path, prefix: Path, surface: Path, mode: str, ranks: int, result: Path) -> list[float]:
    """Writes the part of each rank; returns their processor seconds."""
    libraries = [str(folder) for folder in (prefix / "lib", *(prefix / "lib").glob("*-linux-gnu")) if folder.is_dir()]
    environment = {**os.environ, "LD_LIBRARY_PATH": os.pathsep.join(libraries), "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
                   "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
    environment.pop("PYTHONPATH", None)
    plugin = next((build / "paraview").glob("lib*/**/BoneDecimate.so"))
    subprocess.run(["mpiexec", "-n", str(ranks), str(prefix / "bin" / "pvbatch"), "--sym", str(SCRIPT), str(plugin), str(surface), mode, str(ERROR), str(result)],
                   env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    return [json.loads(Path(f"{result}-{rank}.json").read_text(encoding="ascii")) for rank in range(ranks)]


def join(parts: list[Path], result: Path) -> None:
    """One surface, equal points merged."""
    import numpy as np
    import pyvista

    surfaces = [surface for surface in map(pyvista.read, parts) if surface.n_cells]
    offsets = np.cumsum([0, *(surface.n_points for surface in surfaces)])
    points, which = np.unique(np.vstack([surface.points for surface in surfaces]), axis=0, return_inverse=True)
    triangles = np.vstack([surface.regular_faces + offset for surface, offset in zip(surfaces, offsets)])
    write_ply(str(result), points, which.reshape(-1)[triangles])


def processes(lab: Lab) -> Iterator[Row]:
    """Triangles, proved distance and intersecting pairs of the joined parts, and processor seconds of the first rank."""
    build = lab.programs.folder.parent
    prefix = prefix_of_paraview(build)
    if prefix is None or not shutil.which("mpiexec"):
        print("  processes: left out without mpiexec, or a ParaView and its plugin (Utilities/install_paraview.sh)")
        return
    for name, mode in RUNS:
        surface = lab.bone(name).file
        for ranks in RANKS:
            seconds = run_ranks(build, prefix, surface, mode, ranks, lab.folder / "rank")
            joined = lab.folder / "joined.ply"
            join([lab.folder / f"rank-{rank}.ply" for rank in range(ranks)], joined)
            shape = lab.verifier.describe(joined)
            yield {"surface": name, "mode": f"`{mode}`", "ranks": ranks, "triangles": shape["triangles"],
                   "certified, mm": certificate(lab.programs, surface, joined)["upper"], "intersecting pairs": shape["self_intersections"],
                   "CPU s, rank 0": seconds[0], "CPU s, all ranks": sum(seconds)}
