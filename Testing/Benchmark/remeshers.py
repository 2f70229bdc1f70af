#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Remeshing by this project and by peers at equal numbers of triangles: tables of Documentation/results/triangle-shapes.md.

    remeshers.py --programs build/release/bin [--work FOLDER] [--length 2] [--lengths 1.5,2,3] [--with-meshlib] [BONE|SURFACE.ply ...]

Peers come from PyPI (pip install pymeshlab pyacvd, and with --with-meshlib meshlib) and are left out where they are missing. The number
of triangles is that of this project with the length and the largest error; peers that take a length are run until they have it within 1 %.
"""
import argparse
import itertools
import json
import subprocess
from pathlib import Path

from bonebench import remeshing
from bonebench.bones import Workshop
from bonebench.contest import Verifier
from bonebench.workers import Programs

HEAD = ("| bone | program | triangles | quality | below 10 | below 20 | below 30 degrees | mean, mm | RMS, mm | Hausdorff, mm | proved, mm "
        "| intersecting pairs | fragments | seconds |\n|---|---|" + "---:|" * 12)
LENGTHS_HEAD = ("| bone | length, mm | triangles | mean quality | mean edge, mm | shorter | longer |\n|---|" + "---:|" * 6)


def line(bone, name, outcome, measured):
    """A row of the table; both directions, the larger figure."""
    if "failure" in outcome:
        return f"| {bone} | {name} | {outcome['failure'][:80]} |" + " |" * 11
    ways = (measured["simplified_to_original"], measured["original_to_simplified"])
    small = " | ".join(f"{100 * count / measured['triangles']:.1f} %" for count in measured["below_10_20_30_degrees"])
    proved = f"{outcome['proved']['upper']:.3f}" if "proved" in outcome else "-"
    mean, rms = (max(way[figure] for way in ways) for figure in ("average", "rms"))
    return (f"| {bone} | {name} | {measured['triangles']:,} | {measured['quality']:.3f} | {small} | {mean:.4f} | {rms:.4f} "
            f"| {measured['hausdorff']:.3f} | {proved} | {measured['self_intersections']} | {measured['components']} "
            f"| {outcome['seconds']:.1f} |")


def rows(arguments, programs, bone, peers, folder):
    """Ours with a length and the error; all others at its number of triangles."""
    result = folder / "remeshed.ply"
    length, error = arguments.length, arguments.error
    first = remeshing.ours(programs, bone, result, "Balanced", error=error, EdgeLength=length)
    yield f"**`EdgeLength` {length:g} mm, {error:g} mm proved**", first, result
    if "failure" in first:
        return
    count = first["triangles"]
    yield "**`MinimumAngle` 25**", remeshing.ours(programs, bone, result, "Balanced", faces=count, MinimumAngle=25), result
    yield "**`Balanced`**", remeshing.ours(programs, bone, result, "Balanced", faces=count), result
    for peer in peers:
        yield peer.name, remeshing.to_count(programs, peer, bone, result, count, length), result


def print_lengths(arguments, programs, bones, folder):
    """EdgeLength alone, by the report of the program."""
    print("\n" + LENGTHS_HEAD)
    for (name, file), length in itertools.product(bones, arguments.lengths.split(",")):
        report = folder / "report.json"
        subprocess.run([programs.folder / "bonedecimate", file, folder / "length.ply", "--mode", "Balanced", "--max-error",
                        str(arguments.error), "--edge-length", length, "--measure", "off", "--report", report, "--quiet"], check=True)
        edges = json.loads(report.read_text(encoding="utf-8"))["edges"]
        shape = Verifier(programs, 1).describe(folder / "length.ply")
        print(f"| {name} | {length} | {shape['triangles']:,} | {shape['quality']:.3f} | {edges['mean_length']:.2f} | {edges['shorter']:,} "
              f"| {edges['longer']:,} |", flush=True)


def find_bones(arguments, programs):
    """Names of the benchmark's bones, or files."""
    workshop = Workshop(programs, arguments.work)
    for name in arguments.bones:
        bone = workshop.file(Path(name), (1.0,)) if Path(name).is_file() else workshop.bone(name, (1.0,))
        if bone is not None:
            yield bone.name, bone.file
    for complaint in workshop.complaints:
        print(complaint)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=Path, required=True, help="folder of the programs; target BenchmarkPrograms")
    parser.add_argument("--work", type=Path, default=Path("remeshers"), help="folder for bones and results")
    parser.add_argument("--length", type=float, default=2.0, help="mm, of the comparison")
    parser.add_argument("--lengths", default="1.5,2,3", help="mm, of the table of EdgeLength")
    parser.add_argument("--error", type=float, default=0.5, help="mm")
    parser.add_argument("--samples", type=int, default=200000, help="per direction, of distances")
    parser.add_argument("--with-meshlib", action="store_true", help="its license is non-commercial")
    parser.add_argument("bones", nargs="*", default=["maxilla", "frontal"])
    arguments = parser.parse_args()
    programs = Programs(arguments.programs.resolve())
    arguments.work.mkdir(parents=True, exist_ok=True)
    bones = list(find_bones(arguments, programs))
    wanted = [peer for peer in remeshing.PEERS if arguments.with_meshlib or peer is not remeshing.MESHLIB]
    for peer in wanted:
        if not peer.is_here(programs):
            print(f"{peer.name} does not take part: not installed.")
    verifier = Verifier(programs, arguments.samples)
    print(HEAD)
    for bone, file in bones:
        for name, outcome, result in rows(arguments, programs, file, [peer for peer in wanted if peer.is_here(programs)], arguments.work):
            print(line(bone, name, outcome, {} if "failure" in outcome else verifier.compare(file, result)), flush=True)
    print_lengths(arguments, programs, bones, arguments.work)


if __name__ == "__main__":
    main()
