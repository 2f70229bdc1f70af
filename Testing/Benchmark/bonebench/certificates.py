# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The certificate beside other programs that bound the two-sided distance, on the results that the audit left.

A pair is a bone and a result, or two results of a bone. A line of certificates.csv for each pair and program; lines that the file has
are not measured again.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any, Callable, Iterator, Sequence

from .bones import count_triangles
from .records import Record, read_file, text, write_file
from .workers import Outcome, Programs, call, processor_seconds, run

GAP = 1e-4  # mm, between the bounds of other programs
CPU_SECONDS = 120  # limit of one program on one pair
RESULTS = (("Fast", "0.1"), ("Fast", "0.5"), ("Fast", "1"), ("OpenMesh-ModHausdorff", "0.5"), ("meshoptimizer-simplify", "0.5"))
COLUMNS = ("bone", "first", "second", "first_triangles", "second_triangles", "program", "lower_mm", "upper_mm", "cpu_seconds",
           "failure")
WORKER = Path(__file__).with_name("cascading_worker.py")


def certificate(programs: Programs, reference: Path, result: Path) -> dict[str, Any]:
    """Bounds of the two-sided distance by this project; empty if it rejects the surfaces."""
    file = result.with_suffix(".json")
    failure, _ = run([programs.folder / "bonedecimate", "certify", reference, result, "--json", file, "--no-means",
                      "--no-boundaries", "--threads", 1, "--quiet"])
    return {} if failure else json.loads(file.read_text(encoding="utf-8"))


def by_certify(programs: Programs, first: Path, second: Path) -> Outcome:
    """This project's command, which reads the files, too."""
    before = processor_seconds()
    proved = certificate(programs, first, second)
    seconds = processor_seconds() - before
    return {"lower": proved["lower"], "upper": proved["upper"], "cpu_seconds": seconds} if proved else {"failure": "rejected"}


def by_cascading(_programs: Programs, first: Path, second: Path) -> Outcome:
    """cascading-upper-bounds of PyPI."""
    return call([sys.executable, "-B", WORKER, first, second, GAP], seconds=3600, cpu_seconds=CPU_SECONDS)


def by_cgal(programs: Programs, first: Path, second: Path) -> Outcome:
    """bounded_error_Hausdorff_distance: a distance within the error."""
    outcome = call([programs.path("hausdorff"), first, second, GAP], seconds=3600, cpu_seconds=CPU_SECONDS)
    if "failure" in outcome:
        return outcome
    found = outcome["cgal"]
    distance = max(found["reference_to_result"], found["result_to_reference"])
    return {"lower": distance - GAP, "upper": distance + GAP, "cpu_seconds": found["cpu_seconds"]}


BOUNDS: dict[str, Callable[[Programs, Path, Path], Outcome]] = {
    "bonedecimate certify": by_certify, "cascading-upper-bounds": by_cascading, "CGAL bounded error": by_cgal}


def pairs(work: Path, bone: str) -> Iterator[tuple[str, str, Path, Path]]:
    """Two results, and the bone with each."""
    results = {f"{name} {tolerance} mm": work / "audit" / f"{bone}-{name}-{tolerance}.ply" for name, tolerance in RESULTS}
    there = {name: file for name, file in results.items() if file.is_file()}
    if {"Fast 0.1 mm", "Fast 1 mm"} <= there.keys():
        yield "Fast 0.1 mm", "Fast 1 mm", there["Fast 0.1 mm"], there["Fast 1 mm"]
    for name, file in there.items():
        yield "input", name, work / f"{bone}.ply", file


def compare(programs: Programs, work: Path, bones: Sequence[str]) -> None:
    """Adds what the file lacks of these bones."""
    file = work / "audit" / "certificates.csv"
    records = read_file(file)
    done = {(record["bone"], record["first"], record["second"], record["program"]) for record in records}
    for bone in bones:
        for first, second, one, two in pairs(work, bone):
            for name, bounds in BOUNDS.items():
                if (bone, first, second, name) in done:
                    continue
                outcome = bounds(programs, one, two)
                records.append({
                    "bone": bone, "first": first, "second": second, "first_triangles": text(count_triangles(one)),
                    "second_triangles": text(count_triangles(two)), "program": name,
                    **{f"{key}_mm": f"{outcome[key]:.9f}" if key in outcome else "" for key in ("lower", "upper")},
                    "cpu_seconds": text(outcome.get("cpu_seconds"), 3), "failure": outcome.get("failure", "")})
                write_file(file, COLUMNS, records)
                print(f"  {bone}: {records[-1]}", flush=True)
