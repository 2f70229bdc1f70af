#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether volume meshers take surfaces as they are: tables of Documentation/results/triangle-shapes.md.

    meshers.py --programs build/release/bin [--work FOLDER] [--error 0.5] [--angles 0,20,30] [--lengths 2] [--peers] [--meshers TetGen,gmsh] SURFACE|leg|small-leg...

Each closed surface as it is, decimated with each least angle, remeshed with each length of edges, and with --peers remeshed by MeshLab and
pyacvd to the number of triangles of the first length, goes to TetGen, gmsh and fTetWild (pip install tetgen gmsh pytetwild pyvista, and
pymeshlab pyacvd for the peers). Nothing is repaired, and each mesher runs in a process of its own. Printed are the triangles, the
tetrahedra and the smallest dihedral angle in degrees, or why there are none; then how many surfaces of each kind each mesher took.
"""
import argparse
import subprocess
from collections import defaultdict
from pathlib import Path

from bonebench import remeshing, volume_meshers
from bonebench.bones import Workshop
from bonebench.contest import Verifier
from bonebench.workers import Programs


def cell_of(outcome):
    """A cell of the table."""
    if "failure" in outcome:
        return f"failed: {outcome['failure'][:70]}"
    return f"{outcome['cells']:,}, {outcome['angle']:.1f}"


def as_stl(surface):
    """What every mesher here reads; single precision, of ours as of peers."""
    import pyvista
    file = surface.with_suffix(".stl")
    pyvista.read(surface).triangulate().save(file)
    return file


def triangles_of(surface):
    import pyvista
    return pyvista.read(surface).n_cells


def decimated(arguments, surface, result, *options):
    """One run of the program with the error; its result."""
    subprocess.run([arguments.programs / "bonedecimate", surface, result, "--mode", arguments.mode, "--max-error", str(arguments.error),
                    "--measure", "off", "--quiet", *options], check=True, stdout=subprocess.DEVNULL)
    return result


def surfaces_of(arguments, programs, bone):
    """(kind, file) of all surfaces of a bone."""
    yield "as it is", as_stl(bone)
    for angle in filter(None, arguments.angles.split(",")):
        yield f"least angle {angle}", decimated(arguments, bone, arguments.work / "angle.stl", *(["--min-angle", angle] if float(angle) else []))
    lengths = list(filter(None, arguments.lengths.split(",")))
    for length in lengths:
        yield f"edge length {length} mm", decimated(arguments, bone, arguments.work / f"length{length}.stl", "--edge-length", length)
    if not arguments.peers or not lengths:
        return
    count = triangles_of(arguments.work / f"length{lengths[0]}.stl")
    for peer in (remeshing.ISOTROPIC, remeshing.PYACVD):
        result = arguments.work / f"{peer.key}.ply"
        if peer.is_here(programs) and "failure" not in remeshing.to_count(programs, peer, bone, result, count, float(lengths[0])):
            yield peer.name, as_stl(result)


def find_bones(arguments, programs):
    """Closed surfaces; a sentence about others."""
    workshop = Workshop(programs, arguments.work)
    for name in arguments.surfaces:
        bone = workshop.file(Path(name), (1.0,)) if Path(name).is_file() else workshop.bone(name, (1.0,))
        if bone is None:
            continue
        shape = Verifier(programs, 1).describe(bone.file)
        if shape["boundary_edges"]:
            print(f"{bone.name} is left out: {shape['boundary_edges']} boundary edges.")
            continue
        print(f"{bone.name}: {shape['components']} fragments, {shape['self_intersections']} intersecting pairs.")
        yield bone.name, bone.file
    for complaint in workshop.complaints:
        print(complaint)


def print_success(taken, meshers):
    """How many surfaces of a kind each mesher took."""
    print("\n| surface |", " | ".join(meshers), "|\n|---|" + "---:|" * len(meshers))
    for kind, outcomes in taken.items():
        cells = " | ".join(f"{sum(outcomes[name])} of {len(outcomes[name])}" for name in meshers)
        print(f"| {kind} | {cells} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=Path, required=True, help="folder of the programs; target BenchmarkPrograms")
    parser.add_argument("--work", type=Path, default=Path("meshers"), help="folder for surfaces")
    parser.add_argument("--error", type=float, default=0.5, help="mm")
    parser.add_argument("--mode", default="Balanced")
    parser.add_argument("--angles", default="0,20,30", help="degrees")
    parser.add_argument("--lengths", default="2", help="mm")
    parser.add_argument("--meshers", default=",".join(volume_meshers.MESHERS), help="those that take part, if they are installed")
    parser.add_argument("--peers", action="store_true", help="MeshLab's and pyacvd's surfaces, too")
    parser.add_argument("surfaces", nargs="+")
    arguments = parser.parse_args()
    arguments.programs = arguments.programs.resolve()
    arguments.work.mkdir(parents=True, exist_ok=True)
    programs = Programs(arguments.programs)
    meshers = [name for name in volume_meshers.are_here() if name in arguments.meshers.split(",")]
    bones = list(find_bones(arguments, programs))
    print("| surface | how | triangles |", " | ".join(meshers), "|\n|---|---|---:|" + "---|" * len(meshers))
    taken = defaultdict(lambda: defaultdict(list))
    for name, file in bones:
        for kind, surface in surfaces_of(arguments, programs, file):
            outcomes = {mesher: volume_meshers.mesh(mesher, surface) for mesher in meshers}
            for mesher, outcome in outcomes.items():
                taken[kind][mesher].append("failure" not in outcome)
            print(f"| {name} | {kind} | {triangles_of(surface):,} |", " | ".join(map(cell_of, outcomes.values())), "|", flush=True)
    print_success(taken, meshers)


if __name__ == "__main__":
    main()
