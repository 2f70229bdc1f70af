# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each program gets a largest distance in mm, and its result is measured independently of it.

    python3 -m bonebench.audit --programs FOLDER --work FOLDER [--write-docs] [--bone FILE ...]

A line of audit.csv for each bone, program and tolerance, failures included. Lines that the file has are not measured again.
"""

from __future__ import annotations

import argparse
import shutil
import struct
import sys
from dataclasses import replace
from pathlib import Path
from typing import Sequence

from . import audit_page, certificates, pages
from .audit_programs import PROGRAMS, Program, Request, our_programs, with_mode, with_openmesh
from .bones import Bone, Workshop
from .contest import Verifier
from .document import DATA, RESULTS
from .records import Record, read_file, text, write_file
from .workers import Outcome, Programs, call, processor_seconds, run

ROOT = Path(__file__).resolve().parents[3]
TOLERANCES = (0.1, 0.5, 1.0)  # mm
BONES = ("maxilla", "frontal")  # without --bone
CPU_SECONDS = 300  # limit of one run
LARGEST_ERROR = 10.0  # mm; at a true distance that is larger, `Fast` is not compared
COLUMNS = ("bone", "input_triangles", "input_components", "input_pairs", "program", "version", "tolerance_mm", "requested_triangles", "triangles",
           "lower_mm", "true_mm", "to_original_mm", "to_result_mm", "sampled_mm", "components", "non_manifold_edges",
           "self_intersecting_pairs", "cpu_seconds", "fast_triangles", "failure", "command")


def measured(request: Request, program: Program) -> Outcome:
    """Runs a program once: its JSON, or the same of OpenMesh, which prints none; and its command line without folders."""
    command, before = program.command(request), processor_seconds()
    request.result.unlink(missing_ok=True)
    if program.command is not with_openmesh:
        outcome = call(command, 10 * CPU_SECONDS, CPU_SECONDS)
    else:
        failure, _ = run(command, 10 * CPU_SECONDS, CPU_SECONDS)
        seconds, (_, version) = processor_seconds() - before, run(["dpkg-query", "-Wf${Version}", "libopenmesh-apps"])
        outcome = {"failure": failure} if failure else {
            "version": version, "cpu_seconds": seconds, "triangles": to_binary(request.result)}
    return {**outcome, "command": " ".join(Path(str(word)).name for word in command)}


def to_binary(ply: Path) -> int:
    """Rewrites the text that OpenMesh writes as the verifier reads it; returns the number of triangles."""
    lines = ply.read_text(encoding="ascii").splitlines()
    head = lines.index("end_header") + 1
    points, faces = (int(line.split()[2]) for line in lines[:head] if line.startswith("element"))
    where = (struct.pack("<3d", *map(float, line.split()[:3])) for line in lines[head:head + points])
    corners = (struct.pack("<B3i", *map(int, line.split()[:4])) for line in lines[head + points:head + points + faces])
    header = "\n".join(lines[:head]).replace("ascii", "binary_little_endian").replace(" float", " double") + "\n"
    ply.write_bytes(header.encode() + b"".join(where) + b"".join(corners))
    return faces


def measures(request: Request, verifier: Verifier, is_ours: bool) -> dict[str, str]:
    """The columns of a result that are measured."""
    proved = certificates.certificate(request.programs, request.bone, request.result)
    sampled = verifier.compare(request.bone, request.result)
    if not proved or not sampled:
        return {"failure": "its result cannot be measured"}
    is_compared = not is_ours and proved["upper"] <= LARGEST_ERROR
    fast = with_mode("Fast")(replace(request, result=request.result.with_suffix(".fast.ply"), tolerance=proved["upper"]))
    return {"lower_mm": f"{proved['lower']:.7f}", "true_mm": f"{proved['upper']:.7f}",
            "to_original_mm": f"{proved['result_to_reference']['upper']:.7f}",
            "to_result_mm": f"{proved['reference_to_result']['upper']:.7f}", "sampled_mm": f"{sampled['hausdorff']:.7f}",
            "components": text(sampled["components"]), "non_manifold_edges": text(sampled["non_manifold_edges"]),
            "self_intersecting_pairs": text(sampled["self_intersections"]),
            "fast_triangles": text(call(fast, 10 * CPU_SECONDS, CPU_SECONDS).get("triangles")) if is_compared else ""}


def record_of(request: Request, program: Program, verifier: Verifier) -> Record:
    """A line of the file without its first columns."""
    outcome = measured(request, program)
    commit = f" ({run(['git', '-C', ROOT, 'rev-parse', '--short=8', 'HEAD'])[1].strip()})" if program.needs == "run" else ""
    found = {"program": program.name, "version": outcome.get("version", "") + commit, "tolerance_mm": text(request.tolerance),
             "requested_triangles": text(request.count) if program.takes_count else "", "triangles": text(outcome.get("triangles")),
             "cpu_seconds": text(outcome.get("cpu_seconds"), 3), "failure": outcome.get("failure", ""), "command": outcome["command"]}
    if not found["failure"]:
        found.update(measures(request, verifier, program.needs == "run") if outcome["triangles"] else {"failure": "its result has no triangles"})
    return found


class Audit:
    """The lines of a file, which is written again after each."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self.records = read_file(file)

    def has(self, bone: Bone, program: Program, tolerance: float) -> bool:
        """Whether the file has the line."""
        return self.find(bone, program.name, tolerance) is not None

    def find(self, bone: Bone, name: str, tolerance: float) -> Record | None:
        """The line, or None."""
        key = (bone.name, name, text(tolerance))
        return next((r for r in self.records if (r["bone"], r["program"], r["tolerance_mm"]) == key), None)

    def add(self, record: Record) -> None:
        """Adds a line and writes the file."""
        self.records.append(record)
        write_file(self.file, COLUMNS, self.records)


def run_bone(audit: Audit, programs: Programs, verifier: Verifier, bone: Bone, chosen: Sequence[Program], folder: Path) -> None:
    """Every program with every tolerance on a bone; Fast first, whose numbers of triangles others get."""
    shape = verifier.describe(bone.file)
    for tolerance in TOLERANCES:
        for program in chosen:
            if audit.has(bone, program, tolerance):
                continue
            fast = audit.find(bone, "Fast", tolerance) or {}
            name = f"{bone.name}-{program.name}-{tolerance:g}.ply".replace(" ", "-")
            request = Request(programs, bone.file, folder / name, tolerance, int(fast.get("triangles") or 0))
            found = record_of(request, program, verifier)
            audit.add({"bone": bone.name, "input_triangles": text(bone.triangles), "input_components": text(shape["components"]),
                       "input_pairs": text(shape["self_intersections"]), **found})
            print(f"  {bone.name} {tolerance:g} mm {program.name}: {found['triangles']} triangles, {found.get('true_mm')} mm "
                  f"{found['failure']}", flush=True)


def arguments() -> argparse.Namespace:
    """The options of the command line."""
    parser = argparse.ArgumentParser(prog="audit.sh", description="Each program gets a largest distance; its result is measured.")
    parser.add_argument("--bone", action="append", default=[], metavar="FILE", help="a surface file, or the name of a bone of the benchmark")
    parser.add_argument("--only", metavar="A,B", help="only these programs, by their names")
    parser.add_argument("--certificates", action="store_true", help="compare the certificate with other programs on the results")
    parser.add_argument("--samples", type=int, default=200000, help="samples in each direction (200000)")
    parser.add_argument("--with-meshlib", action="store_true", help="let MeshLib take part; its license is for non-commercial use")
    parser.add_argument("--write-docs", action="store_true", help="write Documentation/results/audit.md and its data")
    parser.add_argument("--programs", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--work", type=Path, required=True, help=argparse.SUPPRESS)
    return parser.parse_args()


def participants(options: argparse.Namespace, programs: Programs) -> list[Program]:
    """The modes and the programs that can run; prints which cannot."""
    peers = [program for program in PROGRAMS if options.with_meshlib or program.name != "MeshLib"]
    for program in peers:
        if not program.is_here(programs):
            print(f"{program.name} does not take part: {program.needs} is missing")
    return [program for program in (*our_programs(programs), *peers)
            if program.is_here(programs) and (not options.only or program.name in options.only.split(","))]


def main() -> int:
    """Measures and writes."""
    options = arguments()
    programs, work = Programs(options.programs.resolve()), options.work.resolve()
    folder = work / "audit"
    folder.mkdir(parents=True, exist_ok=True)
    workshop, verifier = Workshop(programs, work), Verifier(programs, options.samples)
    audit, chosen = Audit(folder / "audit.csv"), participants(options, programs)
    made = [workshop.file(Path(name), (1.0,)) if Path(name).is_file() else workshop.bone(name, (1.0,)) for name in options.bone or BONES]
    bones = [bone for bone in made if bone is not None]
    for bone in bones:
        run_bone(audit, programs, verifier, bone, chosen, folder)
    if options.certificates:
        certificates.compare(programs, work, [bone.name for bone in bones])
    print(*workshop.complaints, sep="\n")
    (folder / "audit.md").write_text(audit_page.page(folder), encoding="utf-8")
    if options.write_docs:
        for name in audit_page.FILES:
            if (folder / name).is_file():
                shutil.copyfile(folder / name, RESULTS / DATA / name)
        pages.write()
    return 0 if audit.records else 1


if __name__ == "__main__":
    sys.exit(main())
