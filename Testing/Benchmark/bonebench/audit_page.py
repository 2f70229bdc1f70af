# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of the audit, from its CSV file alone."""

from __future__ import annotations

import statistics
from pathlib import Path
from typing import Callable, Sequence

from .audit_programs import OURS, PROGRAMS
from .records import Record, read_file
from .tables import count, markdown, number, titled

METHOD = Path(__file__).parents[1] / "audit-method.md"
FILES = ("audit.csv", "certificates.csv")
CERTIFICATES = """Bounds in mm of the two-sided distance of pairs of surfaces from the tables above, and CPU seconds on one thread.
`bonedecimate certify` computes to a gap of 1e-6 of the distance, seconds with reading the files. `cascading-upper-bounds` (Sacht and Jacobson 2024) computes to a gap of
1e-4 mm in each direction, and CGAL's `bounded_error_Hausdorff_distance` with an error of 1e-4 mm, which is shown as an interval. Each program has 120 s.
"""
NEAREST = """Of the other programs whose results were measured, the one that needs the fewest triangles at equal true distances: its result, and `Fast` with that distance as its
largest error. "Of" is how many were measured: without those that failed, were not run, or lost so much that their distance, more than 10 mm, is no largest error for `Fast`.
"""
PRINTED = 1.01e-7  # mm, two roundings to seven decimals
DETAILED = "0.5"  # mm, the tolerance whose results are listed in full


def measured(records: Sequence[Record]) -> list[Record]:
    """The lines with a result."""
    return [record for record in records if record["true_mm"]]


def excess(record: Record) -> float:
    """True distance divided by the tolerance."""
    return float(record["true_mm"]) / float(record["tolerance_mm"])


def over_fast(record: Record) -> float | None:
    """Triangles divided by those of Fast whose largest error is the true distance."""
    return int(record["triangles"]) / int(record["fast_triangles"]) if record["fast_triangles"] else None


def is_kept(record: Record) -> bool:
    """Whether the tolerance was kept."""
    return bool(record["true_mm"]) and excess(record) <= 1.0


def names(records: Sequence[Record], key: str) -> list[str]:
    """The values of a column in the order of the file."""
    return list(dict.fromkeys(record[key] for record in records))


def median(values: Sequence[float | None]) -> str:
    """Of the values that there are; a dash if there are none."""
    known = [value for value in values if value is not None]
    return number(statistics.median(known)) if known else "-"


def programs(records: Sequence[Record]) -> str:
    """Version and setting of each program."""
    settings = {program.name: program.setting for program in PROGRAMS}
    versions = {name: ", ".join(names([r for r in records if r["program"] == name and r["version"]], "version"))
                for name in names(records, "program")}
    return markdown(["program", "version of the package", "set to the tolerance"],
                    [[titled(name), version or "-", settings.get(name, OURS)] for name, version in versions.items()]).replace("---:", "---")


def summary(records: Sequence[Record]) -> str:
    """One line per program over all bones and tolerances."""
    lines = []
    for name in names(records, "program"):
        mine = [record for record in records if record["program"] == name]
        results = measured(mine)
        has_tolerance = not any(record["requested_triangles"] for record in mine)
        lost = sum(int(record["components"]) < int(record["input_components"]) for record in results)
        pairs = sum(int(record["self_intersecting_pairs"]) > int(record["input_pairs"]) for record in results)
        lines.append([
            titled(name), str(len(mine)), str(len(mine) - len(results)), str(sum(map(is_kept, results))) if has_tolerance else "-",
            median([excess(record) for record in results]), number(max(map(excess, results), default=None)),
            median([over_fast(record) for record in results]), str(lost), str(pairs),
            median([float(record["cpu_seconds"]) for record in results])])
    return markdown(["program", "runs", "failed", "tolerance kept", "true / requested, median", "largest", "triangles / Fast's at the true distance, median",
                     "with fewer components", "with more intersecting pairs", "CPU s, median"], lines)


def cell(record: Record | None) -> str:
    """Triangles and true distance; bold where the tolerance is kept."""
    if record is None:
        return "-"
    if not record["true_mm"]:
        return "failed"
    mark = "**" if is_kept(record) else ""
    return f"{count(record['triangles'])}, {mark}{number(record['true_mm'])}{mark}"


def of_bone(records: Sequence[Record]) -> str:
    """One line per program: all tolerances, and the other figures of one of them."""
    tolerances, lines = names(records, "tolerance_mm"), []
    for name in names(records, "program"):
        mine = {record["tolerance_mm"]: record for record in records if record["program"] == name}
        detail = mine.get(DETAILED)
        figures = ["-"] * 4
        if detail and detail["true_mm"]:
            figures = [count(detail["fast_triangles"]), detail["components"], f"{int(detail['self_intersecting_pairs']):,}",
                       number(detail["cpu_seconds"])]
        lines.append([titled(name), *(cell(mine.get(tolerance)) for tolerance in tolerances), *figures])
    return markdown(["program", *(f"{tolerance} mm: triangles, true mm" for tolerance in tolerances),
                     f"{DETAILED} mm: Fast's triangles at the true distance", "components", "intersecting pairs", "CPU s"], lines)


def better(records: Sequence[Record]) -> str:
    """Results of others with fewer triangles than Fast at the same true distance, and with a kept tolerance and fewer than any mode."""
    ours = {(r["bone"], r["tolerance_mm"]): int(r["triangles"]) for r in reversed(measured(records)) if titled(r["program"]) != r["program"]}
    lines = []
    for record in measured(records):
        ratio = over_fast(record)
        fewest = ours.get((record["bone"], record["tolerance_mm"]))
        is_ours = titled(record["program"]) != record["program"]
        wins = ratio is not None and ratio < 1.0 or is_kept(record) and fewest is not None and int(record["triangles"]) < fewest
        if wins and not is_ours:
            lines.append([record["bone"], f"{record['tolerance_mm']} mm", record["program"], count(record["triangles"]),
                          number(record["true_mm"]), count(record["fast_triangles"]),
                          f"{record['components']} of {record['input_components']}", count(record["self_intersecting_pairs"])])
    return markdown(["bone", "requested", "program", "triangles", "true mm", "Fast's triangles at the true distance", "components",
                     "intersecting pairs"], lines) if lines else "None.\n"


def nearest(records: Sequence[Record]) -> str:
    """For each bone and tolerance the result of another program that has the fewest triangles, compared with Fast at the same true distance."""
    lines = []
    for key in dict.fromkeys((r["bone"], r["tolerance_mm"]) for r in records):
        others = [r for r in measured(records) if (r["bone"], r["tolerance_mm"]) == key and r["fast_triangles"]]
        if others:
            best = min(others, key=lambda record: over_fast(record) or 0.0)
            lines.append([key[0], f"{key[1]} mm", best["program"], number(best["true_mm"]), count(best["triangles"]), count(best["fast_triangles"]),
                          number(over_fast(best)), f"{best['components']} of {best['input_components']}", str(len(others))])
    return markdown(["bone", "requested", "program", "true mm", "its triangles", "Fast's at the true distance", "ratio", "components", "of"], lines)


def faster(records: Sequence[Record]) -> str:
    """The programs with fewer CPU seconds than Fast in the median, the fastest first."""
    seconds = {name: statistics.median(float(r["cpu_seconds"]) for r in measured(records) if r["program"] == name)
               for name in names(measured(records), "program")}
    ahead = sorted((name for name in seconds if seconds[name] < seconds.get("Fast", 0.0)), key=seconds.__getitem__)
    return (f"CPU seconds in the median, against {number(seconds.get('Fast'))} of `Fast`, which proves the distance: "
            + (", ".join(f"{name} {number(seconds[name])}" for name in ahead) or "none") + ".\n")


def failures(records: Sequence[Record]) -> str:
    """Reason and command line of each run without a result."""
    lines = [[record["bone"], f"{record['tolerance_mm']} mm", record["program"], record["failure"], f"`{record['command']}`"]
             for record in records if not record["true_mm"]]
    return markdown(["bone", "requested", "program", "failure", "command line"], lines).replace("---:", "---") if lines else "None.\n"


def agreement(records: Sequence[Record]) -> str:
    """The sampled distances beside the proved ones."""
    results = measured(records)
    above = sum(float(record["sampled_mm"]) > float(record["true_mm"]) + PRINTED for record in results)
    below: Callable[[Record], float] = lambda record: 100 * (1 - float(record["sampled_mm"]) / float(record["true_mm"]))
    least = max(map(below, results), default=0.0)
    return (f"The sampled distance of the independent verifier exceeds the proved upper bound in {above} of {len(results)} results; "
            f"it is at most {least:.0f} % below it, and {median([below(record) for record in results])} % in the median.\n")


def overlaps(found: Sequence[Record]) -> bool | None:
    """Whether the intervals of all programs for a pair have a common point; None for less than two."""
    known = [r for r in found if r["upper_mm"]]
    return max(float(r["lower_mm"]) for r in known) <= min(float(r["upper_mm"]) for r in known) if len(known) > 1 else None


def pairs_of(records: Sequence[Record]) -> dict[tuple[str, ...], list[Record]]:
    """The lines of each pair: bone, surfaces and their triangles."""
    pairs: dict[tuple[str, ...], list[Record]] = {}
    for r in records:
        pairs.setdefault((r["bone"], r["first"], r["second"], r["first_triangles"], r["second_triangles"]), []).append(r)
    return pairs


def beside_others_by_bone(records: Sequence[Record]) -> str:
    """How many intervals overlap on each bone, and seconds of each program."""
    programs, lines = names(records, "program"), []
    for bone in names(records, "bone"):
        pairs = [found for key, found in pairs_of(records).items() if key[0] == bone]
        told = [overlaps(found) for found in pairs]
        seconds = [[float(r["cpu_seconds"]) for found in pairs for r in found if r["program"] == name and r["upper_mm"]] for name in programs]
        cells = [f"{number(min(one))} to {number(max(one))} s, {len(one)}" if one else "-" for one in seconds]
        lines.append([bone, str(len(pairs)), f"{told.count(True)} of {len(told) - told.count(None)}", *cells])
    return markdown(["bone", "pairs", "intervals overlap", *(f"{name}: CPU seconds, pairs" for name in programs)], lines)


def beside_others(records: Sequence[Record]) -> str:
    """Bounds and seconds of each program on each pair; whether the intervals overlap."""
    lines = []
    for (bone, first, second, *sizes), found in pairs_of(records).items():
        cells = [f"{r['lower_mm']} to {r['upper_mm']}, {number(r['cpu_seconds'])} s" if r["upper_mm"] else r["failure"] for r in found]
        lines.append([f"{bone}: {first}, {second}", " / ".join(map(count, sizes)), *cells, {True: "yes", False: "NO", None: "-"}[overlaps(found)]])
    return markdown(["pair", "triangles", *names(records, "program"), "intervals overlap"], lines)


def page(folder: Path) -> str:
    """The page in Markdown, from the files of the folder."""
    records, compared = (read_file(folder / name) for name in FILES)
    parts = [METHOD.read_text(encoding="utf-8"), programs(records), agreement(records),
             "## Is the tolerance kept?\n", f"Over {len(names(records, 'bone'))} bones; modes of this project are bold. Components and intersecting pairs are compared with the input.\n", summary(records),
             "## Bone by bone\n", "A distance is bold where it is within the tolerance; a dash is a run that was not made.\n"]
    for bone in names(records, "bone"):
        mine = [record for record in records if record["bone"] == bone]
        parts += [f"### {bone}\n", f"{count(mine[0]['input_triangles'])} triangles, components: {mine[0]['input_components']}, "
                  f"intersecting pairs: {mine[0]['input_pairs']}.\n", of_bone(mine)]
    parts += ["## How near does another program come?\n", NEAREST, nearest(records), "## Where another program needs fewer triangles\n", better(records),
              "## Which programs are faster?\n", faster(records), "## Failures\n", failures(records)]
    if compared:
        parts += ["## The certificate beside other programs\n", CERTIFICATES, beside_others(compared)]
    return "\n".join(parts)


def kept_by_program(records: Sequence[Record]) -> str:
    """What the tolerance of each program is worth, in one table."""
    lines = []
    for name in names(records, "program"):
        results = measured([record for record in records if record["program"] == name])
        if not any(record["requested_triangles"] for record in results):
            kept = f"{sum(map(is_kept, results))} of {sum(record['program'] == name for record in records)}"
            lines.append([titled(name), kept, number(max(map(excess, results), default=None)),
                          median([over_fast(record) for record in results])])
    return markdown(["", "tolerance kept", "true / requested, largest", "times the triangles of Fast at that distance"], lines)


def readme_section(records: Sequence[Record]) -> str:
    """The table with a sentence before it."""
    runs = len({(record["bone"], record["tolerance_mm"]) for record in records})
    return (f"Programs with a setting for the largest distance: {runs} runs at {', '.join(names(records, 'tolerance_mm'))} mm on {len(names(records, 'bone'))} bones "
            "([all figures](Documentation/results/audit.md),\n`Testing/Benchmark/audit.sh`). A run that failed has not kept its tolerance; slow programs have fewer runs.\n\n"
            + kept_by_program(records))
