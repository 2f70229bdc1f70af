#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A proximal femur under load in CalculiX, from the full surface and from results: the table of Documentation/results/triangle-shapes.md.

    bone_under_load.py --program BONEDECIMATE [--work FOLDER] [--error 0.5] [--size 4] FEMUR

Needs ccx (Debian's calculix-ccx) and pip install pytetwild pyvista. The full surface, the decimated one and those with a least angle or a
length of edges are meshed by fTetWild with the same length of edges, to tetrahedra of second order. All have the same material (17 GPa, 0.3). The
lowest 5 mm along z are fixed; 1000 N along -z act on the surface within 12 mm of the highest point. Printed are the mean displacement of the loaded
part along the force and the largest displacement, and their difference from those of the full surface.
"""
import argparse
import subprocess
from pathlib import Path

import numpy
import pyvista

from bonebench import volume_meshers

MODULUS, RATIO, FORCE = 17000.0, 0.3, 1000.0  # MPa, 1, N
FIXED, LOADED = 5.0, 12.0  # mm
# Corners between which the nodes 5 to 10 of C3D10 lie.
MIDDLES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
SIDES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))


def second_order(points, cells):
    """Nodes and ten of them for each tetrahedron; positive volumes."""
    corners = points[cells]
    volumes = numpy.einsum("ij,ij->i", numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), corners[:, 3] - corners[:, 0])
    cells = numpy.where(volumes[:, None] < 0, cells[:, [1, 0, 2, 3]], cells)[numpy.abs(volumes) > 0]
    edges = numpy.sort(numpy.concatenate([cells[:, pair] for pair in MIDDLES]), axis=1)
    unique, index = numpy.unique(edges, axis=0, return_inverse=True)
    nodes = numpy.concatenate([points, points[unique].mean(axis=1)])
    return nodes, numpy.concatenate([cells, len(points) + index.reshape(6, -1).T], axis=1), unique


def outer_triangles(cells):
    """Sides that one tetrahedron has."""
    sides = numpy.concatenate([cells[:, side] for side in SIDES])
    _, index, count = numpy.unique(numpy.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    return sides[index[count == 1]]


def loads_of(nodes, outer, edges, corner_count, head):
    """Force of each node along -z: a third of that of a side on each node in the middle of its edges."""
    centers = nodes[outer].mean(axis=1)
    loaded = outer[numpy.linalg.norm(centers - head, axis=1) < LOADED]
    areas = 0.5 * numpy.linalg.norm(numpy.cross(nodes[loaded[:, 1]] - nodes[loaded[:, 0]], nodes[loaded[:, 2]] - nodes[loaded[:, 0]]), axis=1)
    middle = {tuple(edge): corner_count + i for i, edge in enumerate(edges)}
    loads = numpy.zeros(len(nodes))
    for side, area in zip(loaded, areas):
        for a, b in ((0, 1), (1, 2), (2, 0)):
            loads[middle[tuple(sorted((side[a], side[b])))]] += area / 3
    return FORCE * loads / loads.sum()


def write_lines(file, numbers):
    """A list of node ids for CalculiX."""
    for begin in range(0, len(numbers), 10):
        file.write(", ".join(str(number + 1) for number in numbers[begin:begin + 10]) + "\n")


def write_case(path, nodes, elements, fixed, loads):
    """CalculiX's input; numbers of nodes begin with 1."""
    with path.open("w", encoding="ascii") as file:
        file.write("*NODE, NSET=ALL\n" + "".join(f"{i + 1}, {x:.9g}, {y:.9g}, {z:.9g}\n" for i, (x, y, z) in enumerate(nodes)))
        file.write("*ELEMENT, TYPE=C3D10, ELSET=BONE\n" + "".join(f"{i + 1}, {', '.join(map(str, row + 1))}\n" for i, row in enumerate(elements)))
        file.write("*NSET, NSET=FIXED\n")
        write_lines(file, fixed)
        file.write(f"*MATERIAL, NAME=BONE\n*ELASTIC\n{MODULUS}, {RATIO}\n*SOLID SECTION, ELSET=BONE, MATERIAL=BONE\n")
        file.write("*BOUNDARY\nFIXED, 1, 3\n*STEP\n*STATIC\n*CLOAD\n")
        file.write("".join(f"{node + 1}, 3, {-loads[node]:.9g}\n" for node in numpy.flatnonzero(loads)))
        file.write("*NODE PRINT, NSET=ALL\nU\n*END STEP\n")


def read_displacements(path, count):
    """Of all nodes, from the .dat file."""
    found = numpy.full((count, 3), numpy.nan)
    for line in path.read_text(encoding="ascii").splitlines():
        words = line.split()
        if len(words) == 4 and words[0].isdigit():
            found[int(words[0]) - 1] = [float(word) for word in words[1:]]
    return found


def solve(surface, arguments, head, bottom):
    """Nodes, mean displacement of the loaded part along the force and largest displacement, mm."""
    volume = arguments.work / "volume.vtu"
    outcome = volume_meshers.mesh("fTetWild", surface, volume, arguments.size, cpu_seconds=3600)
    if "failure" in outcome:
        raise SystemExit(f"{surface}: {outcome['failure']}")
    grid = pyvista.read(volume)
    points = numpy.asarray(grid.points, float)
    nodes, elements, edges = second_order(points, grid.cells_dict[pyvista.CellType.TETRA])
    loads = loads_of(nodes, outer_triangles(elements[:, :4]), edges, len(points), head)
    used = numpy.zeros(len(nodes), bool)
    used[elements.ravel()] = True
    fixed = numpy.flatnonzero(used & (nodes[:, 2] < bottom + FIXED))
    write_case(arguments.work / "load.inp", nodes, elements, fixed, loads)
    subprocess.run(["ccx", "load"], cwd=arguments.work, check=True, stdout=subprocess.DEVNULL)
    displacements = read_displacements(arguments.work / "load.dat", len(nodes))
    return len(elements), float(-(loads * numpy.nan_to_num(displacements[:, 2])).sum() / FORCE), float(
        numpy.nanmax(numpy.linalg.norm(displacements, axis=1)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default="bonedecimate")
    parser.add_argument("--work", type=Path, default=Path("load"), help="folder for files")
    parser.add_argument("--error", default="0.5", help="mm")
    parser.add_argument("--size", type=float, default=4.0, help="mm, edges of tetrahedra")
    parser.add_argument("femur", type=Path)
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    full = pyvista.read(arguments.femur)
    head, bottom = full.points[full.points[:, 2].argmax()], full.points[:, 2].min()
    print("| surface | triangles | tetrahedra | head, mm | | largest, mm | |\n|---|---:|---:|---:|---:|---:|---:|")
    reference = None
    for name, options in (("full", None), (f"{arguments.error} mm", ()), (f"{arguments.error} mm, least angle 30", ("--min-angle", "30")),
                          (f"{arguments.error} mm, edge length 3 mm", ("--edge-length", "3"))):
        surface = arguments.femur if options is None else arguments.work / "surface.stl"
        if options is not None:
            subprocess.run([arguments.program, arguments.femur, surface, "--mode", "Balanced", "--max-error", arguments.error, "--measure", "off",
                            "--quiet", *options], check=True)
        count, *figures = solve(surface, arguments, head, bottom)
        reference = reference or figures
        cells = " | ".join(f"{own:.5f} | {100 * (own / full_one - 1):+.2f} %" for own, full_one in zip(figures, reference))
        print(f"| {name} | {pyvista.read(surface).n_cells:,} | {count:,} | {cells} |", flush=True)


if __name__ == "__main__":
    main()
