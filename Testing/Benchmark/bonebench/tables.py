# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Markdown tables from the records: one table per question."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Callable, Iterable, Sequence

from . import thesis
from .records import Record

PAGE_OF_MODES = Path(__file__).resolve().parents[3] / "Documentation" / "explanation" / "modes.md"
TABLE_OF_MODES = next(part for part in PAGE_OF_MODES.read_text(encoding="utf-8").split("\n\n") if part.startswith("| mode | use |"))
MODES = re.findall(r"(?m)^\| `(\w+)` \|", TABLE_OF_MODES)  # a test compares the page with the program
Cell = Callable[[Record], str]


def number(value: str | float | None, digits: int = 3) -> str:
    """Plain decimals with that many significant digits; a dash for nothing."""
    if value in (None, ""):
        return "-"
    figure = float(value)
    if figure == 0:
        return "0"
    decimals = max(0, digits - 1 - int(f"{abs(figure):e}".split("e")[1]))
    return f"{figure:,.{decimals}f}"


def count(value: str | None) -> str:
    """A whole number with separators; a dash for nothing."""
    return f"{int(value):,}" if value else "-"


def cell(value: str) -> str:
    """A text as it is, a whole number with separators, or a number with three digits."""
    if re.fullmatch(r"-?[0-9]+", value):
        return f"{int(value):,}"
    try:
        return number(value)
    except ValueError:
        return value


def markdown(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; the first column to the left, figures to the right."""
    lines = ["| " + " | ".join(head) + " |", "|---" + "|---:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def titled(name: str) -> str:
    """The modes of this project in bold."""
    return f"**{name}**" if name in MODES else name


def worst(record: Record, statistic: str) -> float | None:
    """The larger of both directions."""
    values = [record[f"{side}_{statistic}_mm"] for side in ("to_original", "to_result")]
    return max((float(value) for value in values if value), default=None)


def methods(records: Sequence[Record]) -> list[str]:
    """Modes first, then the other programs, as the files list them."""
    names = list(dict.fromkeys(record["method"] for record in records if record["method"] != "input"))
    return [name for name in MODES if name in names] + [name for name in names if name not in MODES]


def single_threaded(records: Sequence[Record]) -> list[Record]:
    """One record per method: one thread, without the VTK filter."""
    return [record for record in records if record["threads"] == "1" and record["adapter"] != "filter"]


def goals(records: Sequence[Record]) -> list[tuple[str, str]]:
    """Each bone with each requested number of triangles."""
    return list(dict.fromkeys((record["bone"], record["requested_triangles"]) for record in records))


def of_goal(records: Sequence[Record], goal: tuple[str, str]) -> list[Record]:
    """The records of one bone and one requested number of triangles."""
    return [record for record in records if (record["bone"], record["requested_triangles"]) == goal]


def by_method(records: Sequence[Record], cell: Cell) -> str:
    """One line per bone and number of triangles, one column per method."""
    columns = methods(records)
    lines = []
    for goal in goals(records):
        found = {record["method"]: record for record in single_threaded(of_goal(records, goal))}
        cells = [cell(found[name]) if name in found else "-" for name in columns]
        lines.append([f"{goal[0]}, {count(goal[1])}", *cells])
    return markdown(["input, triangles", *map(titled, columns)], lines)


def seconds_of_modes(records: Sequence[Record]) -> str:
    """The modes on one and more threads and through the VTK filter, one line per bone and number of triangles."""
    kinds = list(dict.fromkeys((record["method"], record["threads"], record["adapter"]) for record in records
                               if record["method"] in MODES))
    lines = []
    for goal in goals(records):
        found = {(record["method"], record["threads"], record["adapter"]): record for record in of_goal(records, goal)}
        cells = [number(found[kind]["seconds"]) if kind in found else "-" for kind in kinds]
        lines.append([f"{goal[0]}, {count(goal[1])}", *cells])
    head = [titled(mode) + (f", {threads} threads" if threads != "1" else "") + (", VTK filter" if adapter == "filter" else "")
            for mode, threads, adapter in kinds]
    return markdown(["input, triangles", *head], lines)


def summary(records: Sequence[Record], goal: tuple[str, str], full: bool) -> str:
    """All methods on one bone, closest first. @param full Adds more threads, triangles, self-intersections and quality."""
    found = of_goal(records, goal) if full else single_threaded(of_goal(records, goal))
    chosen = [record for record in found if record["method"] != "input" and record["adapter"] != "filter"]
    chosen.sort(key=lambda record: float(record["to_result_rms_mm"] or 0))
    head = ["", "s", "peak MB", "average mm", "RMS mm", "Hausdorff mm" if full else "H mm", "components",
            "non-manifold edges"]
    more = ["triangles", "self-intersecting pairs", "quality"]
    lines = []
    for record in chosen:
        name = titled(record["method"]) + (f", {record['threads']} threads" if record["threads"] != "1" else "")
        shape = next((r for r in chosen if r["method"] == record["method"] and r["components"]), record)
        cells = [name, number(record["seconds"]), f"{float(record['peak_mb']):.0f}", number(worst(record, "average")),
                 number(worst(record, "rms")), number(record["hausdorff_mm"]), count(shape["components"]),
                 count(shape["non_manifold_edges"])]
        if full:
            cells += [count(record["triangles"]), count(shape["self_intersecting_pairs"]), number(shape["quality"])]
        lines.append(cells)
    return markdown(head + (more if full else []), lines)


def topology(records: Sequence[Record]) -> str:
    """How often each method keeps the topology of the input, over all lines of the comparison."""
    lines = []
    for name in methods(records):
        pairs = []
        for goal in goals(records):
            found = {record["method"]: record for record in single_threaded(of_goal(records, goal))}
            source = next((r for r in of_goal(records, goal) if r["method"] == "input"), None)
            if source and name in found and found[name]["components"]:
                pairs.append((source, found[name]))
        if pairs:
            lines.append([titled(name), *(kept(pairs, key) for key in ("components", "euler", "non_manifold_edges")),
                          f"{sum(int(r['self_intersecting_pairs'] or 0) for _, r in pairs):,}",
                          f"{sum(int(r['degenerate_triangles'] or 0) for _, r in pairs):,}",
                          number(sum(float(r["quality"]) for _, r in pairs) / len(pairs))])
    return markdown(["", "components kept", "Euler number kept", "no new non-manifold edge", "self-intersecting pairs, sum",
                     "degenerate triangles, sum", "mean quality"], lines)


def kept(pairs: Sequence[tuple[Record, Record]], key: str) -> str:
    """In how many results a count equals that of the input; non-manifold edges may also become fewer."""
    equal = [int(result[key]) <= int(source[key]) if key == "non_manifold_edges" else result[key] == source[key]
             for source, result in pairs]
    return f"{sum(equal)} of {len(pairs)}"


def proved_triangles(proved: Sequence[Record]) -> str:
    """The modes with a proved largest error."""
    modes = [mode for mode in MODES if any(record["mode"] == mode for record in proved)]
    lines = []
    for bone, error in dict.fromkeys((record["bone"], record["error_mm"]) for record in proved):
        mine = {r["mode"]: r for r in proved if (r["bone"], r["error_mm"], r["intersection_guard"]) == (bone, error, "on")}
        lines.append([f"{bone}, {error} mm", *(count(mine.get(mode, {}).get("triangles")) for mode in modes)])
    return markdown(["input, error", *map(titled, modes)], lines)


def proved_cost(proved: Sequence[Record]) -> str:
    """Bound, seconds and memory with the intersection guard, and what changes without it."""
    lines = []
    for on in (record for record in proved if record["intersection_guard"] == "on"):
        key = (on["bone"], on["error_mm"], on["mode"])
        off = next((r for r in proved if (r["bone"], r["error_mm"], r["mode"]) == key and r["intersection_guard"] == "off"), {})
        lines.append([f"{on['bone']}, {on['error_mm']} mm", titled(on["mode"]), on["proved_mm"], on["proved_boundary_mm"],
                      number(on["seconds"]), number(on["certificate_seconds"]), on["bytes_per_triangle"],
                      count(on["self_intersecting_pairs"]), count(off.get("triangles")), number(off.get("seconds")),
                      count(off.get("self_intersecting_pairs"))])
    return markdown(["input, error", "mode", "proved mm", "proved, boundaries mm", "s", "of these the certificate",
                     "bytes per input triangle", "self-intersecting pairs", "without guard: triangles", "without guard: s",
                     "without guard: self-intersecting pairs"], lines)


def growth(records: Sequence[Record]) -> str:
    """Seconds and bytes per input triangle."""
    lines = []
    for record in sorted(records, key=lambda r: (r["mode"], int(r["threads"]), int(r["input_triangles"]))):
        per_triangle = 1e6 * float(record["seconds"]) / int(record["input_triangles"])
        lines.append([titled(record["mode"]), record["threads"], count(record["input_triangles"]), number(record["seconds"]),
                      number(per_triangle), record["bytes_per_triangle"]])
    return markdown(["mode", "threads", "input triangles", "s", "us per input triangle", "bytes per input triangle"], lines)


def threads(records: Sequence[Record]) -> str:
    """Speed-up over one thread with the best kernels, and whether the result has the same bytes."""
    lines = []
    for record in records:
        one = next(r for r in records if r["mode"] == record["mode"] and r["threads"] == "1" and r["kernels"] == "best")
        same = "yes" if record["checksum"] == one["checksum"] and " " not in one["checksum"] else "NO"
        lines.append([titled(record["mode"]), record["threads"], record["kernels"], number(record["seconds"]),
                      number(record["cpu_seconds"]), f"{float(one['seconds']) / float(record['seconds']):.2f}", same])
    return markdown(["mode", "threads", "kernels", "s", "CPU s", "speed-up", "same bytes"], lines)


def point_cells(record: Record) -> str:
    """Largest, average and RMS distance of the points of a result to the original, mm."""
    keys = ("point_max_mm", "point_average_mm", "point_rms_mm")
    return ", ".join(number(record[key]) for key in keys) if record.get(keys[0]) else "-"


def thesis_counts(records: Sequence[Record]) -> str:
    """The thesis's measure at its own numbers of triangles."""
    meshlab, lines = "MeshLab quadric", []
    for goal in goals(records):
        bone, faces = goal[0], int(goal[1])
        printed = thesis.BY_COUNT.get(bone, {}).get(faces)
        if printed is None:
            continue
        beside = thesis.MESHLAB.get(bone, {}).get(faces)
        found = {record["method"]: record for record in single_threaded(of_goal(records, goal))}
        lines.append([f"{bone}, {faces:,}", ", ".join(map(number, (printed[1], printed[3], printed[4]))),
                      ", ".join(map(number, beside)) if beside else "-",
                      *(point_cells(found[name]) if name in found else "-" for name in (meshlab, *MODES))])
    return markdown(["input, triangles", "printed in the thesis", f"{meshlab}, printed there", f"{meshlab}, today", *map(titled, MODES)],
                    lines) if lines else ""


def thesis_errors(records: Sequence[Record]) -> str:
    """The thesis's measure with a largest error instead of a number of triangles."""
    lines = []
    for bone, error in dict.fromkeys((record["bone"], record["error_mm"]) for record in records):
        printed = thesis.BY_ERROR.get(bone, {}).get(float(error))
        if printed:
            lines.append([f"{bone}, {error} mm", "printed in the thesis", f"{printed[0]:,}",
                          ", ".join(map(number, (printed[1], printed[3], printed[4]))), "-"])
        lines += [[f"{bone}, {error} mm", titled(r["mode"]), count(r["triangles"]), point_cells(r), number(r["hausdorff_mm"])]
                  for r in records if (r["bone"], r["error_mm"]) == (bone, error)]
    return markdown(["input, error", "", "triangles", "largest, average, RMS mm", "Hausdorff mm"], lines)
