#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether volume meshers take the results as they are: the table of Documentation/triangle-shapes.md.

    meshers.py --program BONEDECIMATE [--error 0.5] [--mode Balanced] [--angles 0,20,30] SURFACE...

Each surface as it is and decimated with each least angle goes to TetGen and gmsh (pip install tetgen gmsh pyvista), without repair and each
in a process of its own. Printed are the triangles, the tetrahedra, the smallest dihedral angle and the seconds, or why there are none.
"""
import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

LONGEST = 300  # s, of a mesher


def mesh_by_tetgen(surface):
    """Quality mesh: points are added inside and not on the surface."""
    import pyvista
    import tetgen
    triangles = pyvista.read(surface).clean(tolerance=0.0)
    mesher = tetgen.TetGen(triangles)
    mesher.tetrahedralize(order=1, mindihedral=10, minratio=1.5, nobisect=True)
    return mesher.grid


def mesh_by_gmsh(surface):
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


MESHERS = {"TetGen": mesh_by_tetgen, "gmsh": mesh_by_gmsh}


def mesh(name, surface):
    """Prints what one mesher makes of a surface, as JSON."""
    start = time.monotonic()
    grid = MESHERS[name](surface)
    seconds = time.monotonic() - start
    angle = float(grid.cell_quality("min_angle")["min_angle"].min()) if grid.n_cells else 0.0  # dihedral
    print(json.dumps({"cells": int(grid.n_cells), "seconds": seconds, "angle": angle}))


def cell_of(name, surface):
    """A cell of the table."""
    try:
        done = subprocess.run([sys.executable, __file__, "--mesher", name, surface], capture_output=True, text=True,
                              timeout=LONGEST, check=False)
    except subprocess.TimeoutExpired:
        return f"not done after {LONGEST} s"
    if done.returncode != 0:
        said = (done.stderr.strip() or done.stdout.strip() or f"ended with {done.returncode}").splitlines()[-1]
        return f"failed: {said[:70]}"
    found = json.loads(done.stdout.strip().splitlines()[-1])
    if not found["cells"]:
        return "failed: no tetrahedra"
    return f"{found['cells']:,}, {found['angle']:.1f} degrees, {found['seconds']:.1f} s"


def triangles_of(surface):
    import pyvista
    return pyvista.read(surface).n_cells


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="bonedecimate")
    parser.add_argument("--error", type=float, default=0.5, help="mm")
    parser.add_argument("--mode", default="Balanced")
    parser.add_argument("--angles", default="0,20,30", help="degrees")
    parser.add_argument("--mesher", choices=MESHERS, help=argparse.SUPPRESS)
    parser.add_argument("surfaces", nargs="+")
    arguments = parser.parse_args()
    if arguments.mesher:
        mesh(arguments.mesher, arguments.surfaces[0])
        return
    print("| surface | least angle | triangles |", " | ".join(MESHERS), "|")
    print("|---|---:|---:|" + "---|" * len(MESHERS))
    with tempfile.TemporaryDirectory() as folder:
        for surface in arguments.surfaces:
            rows = [("as it is", surface)]
            for angle in arguments.angles.split(","):
                result = f"{folder}/{angle}.stl"
                subprocess.run([arguments.program, surface, result, "--mode", arguments.mode, "--max-error", str(arguments.error),
                                *(["--min-angle", angle] if float(angle) else [])], check=True, stdout=subprocess.DEVNULL)
                rows.append((angle, result))
            for angle, file in rows:
                cells = " | ".join(cell_of(name, file) for name in MESHERS)
                print(f"| {Path(surface).stem} | {angle} | {triangles_of(file):,} | {cells} |", flush=True)


if __name__ == "__main__":
    main()
