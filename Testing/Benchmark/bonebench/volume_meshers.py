# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volume meshers from PyPI (tetgen, gmsh, pytetwild, with pyvista), none of which repairs the surface beforehand.

As a program: volume_meshers.py MESHER SURFACE [RESULT.vtu] prints what one mesher makes of a surface, as JSON.
"""

from __future__ import annotations

import importlib.util
import json
import os
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

try:
    from .workers import Outcome, call
except ImportError:  # as a program, outside of the package
    Outcome = dict

LONGEST = 300  # s of processor time, of a mesher


def mesh_by_tetgen(surface: str) -> Any:
    """Quality mesh: points are added inside and not on the surface."""
    import pyvista
    import tetgen

    mesher = tetgen.TetGen(pyvista.read(surface).clean(tolerance=0.0))
    mesher.tetrahedralize(order=1, mindihedral=10, minratio=1.5, nobisect=True)
    return mesher.grid


def mesh_by_gmsh(surface: str) -> Any:
    """The triangles of the file as the boundary of one volume."""
    import gmsh
    import numpy
    import pyvista

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.merge(surface)
    surfaces = [tag for _, tag in gmsh.model.getEntities(2)]
    gmsh.model.geo.addVolume([gmsh.model.geo.addSurfaceLoop(surfaces)])
    gmsh.model.geo.synchronize()
    gmsh.model.mesh.generate(3)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    _, corners = gmsh.model.mesh.getElementsByType(4)
    index = numpy.zeros(int(tags.max()) + 1, dtype=int)
    index[tags.astype(int)] = numpy.arange(len(tags))
    cells = index[corners.astype(int)].reshape(-1, 4)
    return pyvista.UnstructuredGrid({pyvista.CellType.TETRA: cells}, coordinates.reshape(-1, 3))


def mesh_by_ftetwild(surface: str, length: float | None = None) -> Any:
    """fTetWild takes any triangles and keeps within an envelope of 1/1000 of the diagonal. length: mm, of edges; default diagonal / 20."""
    import pytetwild
    import pyvista

    return pytetwild.tetrahedralize_pv(pyvista.read(surface).clean(tolerance=0.0), edge_length_abs=length, num_threads=1)


MESHERS = {"TetGen": mesh_by_tetgen, "gmsh": mesh_by_gmsh, "fTetWild": mesh_by_ftetwild}
PACKAGES = {"TetGen": "tetgen", "gmsh": "gmsh", "fTetWild": "pytetwild"}


def are_here() -> list[str]:
    """The meshers that are installed."""
    return [name for name, package in PACKAGES.items() if importlib.util.find_spec(package) is not None]


def mesh(name: str, surface: Path, *more: object, cpu_seconds: int = LONGEST) -> Outcome:
    """Runs a mesher in a process of its own: cells, seconds, angle (smallest dihedral, degrees), or {"failure": why}."""
    outcome = call([sys.executable, "-B", __file__, name, surface, *more], cpu_seconds=cpu_seconds)
    if "failure" not in outcome and not outcome["cells"]:
        return {"failure": "no tetrahedra"}
    return outcome


def main(name: str, surface: str, result: str = "", length: str = "") -> None:
    """Meshes, writes and prints JSON. In a folder of its own, as meshers leave files behind where they run."""
    surface, result = str(Path(surface).resolve()), str(Path(result).resolve()) if result else ""
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        start = time.monotonic()
        grid = MESHERS[name](surface, float(length)) if length else MESHERS[name](surface)
        seconds = time.monotonic() - start
        os.chdir("/")
    angle = float(grid.cell_quality("min_angle")["min_angle"].min()) if grid.n_cells else 0.0  # dihedral
    if result:
        grid.save(result)
    print("\n" + json.dumps({"cells": int(grid.n_cells), "seconds": seconds, "angle": angle}))


if __name__ == "__main__":
    main(*sys.argv[1:5])
