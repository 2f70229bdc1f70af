# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Markdown from the raw figures: nothing here measures or runs anything."""

from __future__ import annotations

import statistics
from typing import Any, Iterable, Sequence

from . import thesis

Entry = dict[str, Any]
Row = dict[str, Any]
THERE, BACK = "simplified_to_original", "original_to_simplified"
RATIO_COLUMNS = ((THERE, "average"), (THERE, "rms"), (BACK, "average"), (BACK, "rms"))


def number(value: float | None, digits: int = 3) -> str:
    """Plain decimals with that many significant digits; a dash for nothing."""
    if value is None:
        return "-"
    if value == 0:
        return "0"
    decimals = max(0, digits - 1 - _exponent(abs(value)))
    return f"{value:,.{decimals}f}"


def _exponent(value: float) -> int:
    return int(f"{value:e}".split("e")[1])


def markdown(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; the first column to the left, figures to the right."""
    lines = ["| " + " | ".join(head) + " |", "|---" + "|---:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def ratio(value: float | None, base: float | None) -> str:
    """How many times the other's; two decimals."""
    return f"{value / base:.2f}" if value is not None and base else "-"


def judged(entry: Entry | None, *path: str) -> Any:
    """A figure of the judge, or None."""
    value: Any = entry["judged"] if entry else None
    for key in path:
        value = value.get(key) if value else None
    return value


def find(row: Row, who: str, asked: int | None = None) -> Entry | None:
    """The entry of a contestant that came to an end, at a count if one is given."""
    return next((entry for entry in row["entries"] if entry["who"] == who and entry["seconds"]
                 and asked in (None, entry["asked"])), None)


def at_reference(row: Row) -> list[Entry]:
    """Peers, and ours at the count that the first peer ended with, or asked for if there is none."""
    return [entry for entry in row["entries"] if not entry["ours"] or entry["asked"] == row["reference"]]


def in_core(row: Row) -> list[Entry]:
    """Ours by the call without VTK."""
    return [entry for entry in row["entries"] if entry["ours"] and entry["through"] == "core" and entry["seconds"]]


def beside(value: float | None, base: float | None) -> str:
    """A figure, and in brackets how many times the base's it is."""
    return number(value) + (f" ({value / base:.2f})" if value is not None and base else "")


def distance_table(row: Row) -> str:
    """Seconds, memory and distances of everybody; in brackets the ratios to CGAL's."""
    base = find(row, "cgal")
    head = ["", "triangles", "s", "CPU s", "MB", "s>o average", "s>o RMS", "o>s average", "o>s RMS", "s>o max",
            "o>s max", "H"]
    lines = []
    for entry in at_reference(row):
        if not entry["seconds"]:
            lines.append([entry["name"], f"failed: {entry['failure']}"] + [""] * (len(head) - 2))
            continue
        cells = [entry["name"], f"{entry['triangles']:,}",
                 beside(entry["median_seconds"], base["median_seconds"] if base else None),
                 number(statistics.median(entry["cpu_seconds"])), f"{entry['peak_bytes'] / 1e6:.0f}"]
        cells += [beside(judged(entry, *column), judged(base, *column)) for column in RATIO_COLUMNS]
        cells += [number(judged(entry, side, "maximum")) for side in (THERE, BACK)]
        lines.append(cells + [beside(judged(entry, "hausdorff"), judged(base, "hausdorff"))])
    return markdown(head, lines)


SHAPE = ("components", "boundary_edges", "non_manifold_edges", "non_manifold_vertices", "euler", "self_intersections",
         "degenerate")


def shape_table(row: Row) -> str:
    """Topology and triangles of everybody below the input's own."""

    def cells(name: str, shape: dict[str, Any]) -> list[str]:
        counts = [f"{shape[key]:,}" if key in shape else "-" for key in SHAPE]
        bad = f"{100 * shape['bad_share']:.1f}" if "bad_share" in shape else "-"
        return [name, *counts, number(shape.get("quality")), bad]

    head = ["", "components", "border edges", "non-manifold edges", "non-manifold vertices", "Euler",
            "self-intersecting pairs", "degenerate", "quality", "bad %"]
    entries = [entry for entry in at_reference(row) if entry["seconds"] and entry["judged"]
               and entry["threads"] == 1 and entry["through"] != "filter"]
    return markdown(head, [cells("the input", row["input"])] + [cells(e["name"], e["judged"]) for e in entries])


def best_peer_h(row: Row) -> float | None:
    """The least H of the peers that kept at least as many triangles as asked for, within 1 %."""
    values = [judged(entry, "hausdorff") for entry in row["entries"] if not entry["ours"] and entry["seconds"]
              and abs(entry["triangles"] - row["asked"]) <= max(4, 0.01 * row["asked"])]
    return min((value for value in values if value), default=None)


def targets_table(rows: Sequence[Row]) -> str:
    """Our modes, a line per bone and count: every ratio that the targets speak of, each at that peer's own count."""
    head = ["bone, asked for", "mode", "s>o avg", "s>o RMS", "o>s avg", "o>s RMS", "H / LT", "H / best peer", "time / LT",
            "time / meshoptimizer", "time / MeshLib"]
    lines = []
    for row in rows:
        for entry in in_core(row):
            if entry["asked"] != row["reference"]:
                continue
            base = find(row, "cgal")
            cells = [f"{row['bone']} {row['asked']:,}", entry["name"]]
            cells += [ratio(judged(entry, *column), judged(base, *column)) for column in RATIO_COLUMNS]
            cells += [ratio(judged(entry, "hausdorff"), judged(base, "hausdorff")),
                      ratio(judged(entry, "hausdorff"), best_peer_h(row))]
            cells += [time_ratio(row, entry["who"], peer) for peer in ("cgal", "meshoptimizer", "meshlib")]
            lines.append(cells)
    return markdown(head, lines)


def time_ratio(row: Row, who: str, peer: str) -> str:
    """Our median seconds at the count the peer ended with, over the peer's."""
    theirs = find(row, peer)
    mine = find(row, who, theirs["triangles"]) if theirs else None
    return ratio(mine["median_seconds"], theirs["median_seconds"]) if mine and theirs else "-"


def pairs_table(row: Row) -> str:
    """Each peer against each of our modes at exactly the peer's count: below 1 is in our favour."""
    modes = list(dict.fromkeys((entry["who"], entry["name"]) for entry in in_core(row)))
    head = ["time, s>o RMS, o>s RMS, H: ours / theirs", "triangles"] + [name for _, name in modes]
    lines = []
    for peer in row["entries"]:
        if peer["ours"] or not peer["seconds"]:
            continue
        cells = [peer["name"], f"{peer['triangles']:,}"]
        for who, _ in modes:
            mine = find(row, who, peer["triangles"])
            parts = [time_ratio(row, who, peer["who"])]
            parts += [ratio(judged(mine, side, "rms"), judged(peer, side, "rms")) for side in (THERE, BACK)]
            parts.append(ratio(judged(mine, "hausdorff"), judged(peer, "hausdorff")))
            exact = mine is not None and mine["triangles"] == peer["triangles"]
            cells.append(", ".join(parts) + ("" if exact or mine is None else f" ({mine['triangles']:,})"))
        lines.append(cells)
    return markdown(head, lines) if lines else ""


def summary_table(row: Row) -> str:
    """The short table of the README: one bone, everybody."""
    head = ["", "s", "peak MB", "average mm", "RMS mm", "H mm", "components", "non-manifold edges"]
    lines = []
    for entry in sorted(at_reference(row), key=lambda e: judged(e, BACK, "rms") or 0.0):
        if not entry["seconds"] or entry["through"] == "filter":
            continue
        worst = [max(judged(entry, side, key) or 0 for side in (THERE, BACK)) for key in ("average", "rms")]
        lines.append([entry["name"], number(entry["median_seconds"]), f"{entry['peak_bytes'] / 1e6:.0f}",
                      *(number(value or None) for value in worst), number(judged(entry, "hausdorff")),
                      str(judged(entry, "components") or "-"), str(judged(entry, "non_manifold_edges") or 0)])
    return markdown(head, lines)


def thesis_table(row: Row) -> str:
    """The thesis's own measure, at its own counts, of everybody; its figures are for other meshes of the same bones."""
    printed = thesis.BY_COUNT.get(row["bone"], {}).get(row["asked"])
    if printed is None:
        return ""
    faces, largest, _, average, rms, seconds = printed
    lines = [["the thesis, its own mesh", f"{faces:,}", number(largest), "-", number(average), number(rms),
              number(seconds)]]
    lines += [_thesis_cells(entry["name"], entry["triangles"], entry, entry["median_seconds"])
              for entry in at_reference(row)
              if entry["seconds"] and entry["threads"] == 1 and entry["through"] != "filter"]
    return markdown(["points to the original", "triangles", "max", "second", "average", "RMS", "s"], lines)


def _thesis_cells(name: str, triangles: int, entry: Entry, seconds: float | None) -> list[str]:
    figures = [number(judged(entry, THERE, key)) for key in ("point_maximum", "point_second", "point_average", "point_rms")]
    return [name, f"{triangles:,}", *figures, number(seconds)]


def error_table(rows: Sequence[Row]) -> str:
    """Asked for a largest error in mm: the thesis's figures and our modes, points to the original."""
    lines, seen = [], set()
    for row in rows:
        printed = thesis.BY_ERROR.get(row["bone"], {}).get(row["error"])
        asked = f"{row['bone']} {row['error']} mm"
        if printed is not None and asked not in seen:
            faces, largest, second, average, rms, _ = printed
            lines.append([f"{asked}: the thesis, its own mesh", f"{faces:,}", number(largest), number(second),
                          number(average), number(rms), "-", "-"])
        seen.add(asked)
        if "failure" not in row:
            cells = _thesis_cells(f"{asked}: **{row['mode']}**", row["triangles"], row, row["seconds"])
            lines.append(cells[:-1] + [number(judged(row, "hausdorff")), cells[-1]])
    return markdown(["asked for", "triangles", "max", "second", "average", "RMS", "H", "s"], lines)


def promise_table(rows: Sequence[Row]) -> str:
    """Asked for a proved largest error: triangles, what the certificate proves of the result, and what that cost."""
    head = ["bone, error", "mode", "triangles", "proved <= mm", "borders <= mm", "H, sampled", "self-intersecting pairs", "s",
            "of these the certificate", "the rest / CGAL's", "bytes / triangle"]
    lines = []
    for row in rows:
        if "failure" in row:
            continue
        proved = row["proved"]
        used = (row["input_bytes"] + row["peak_bytes"]) / row["input"]
        lines.append([f"{row['bone']} {row['error']} mm", f"**{row['mode']}**", f"{row['triangles']:,}",
                      f"{proved['upper']:.6f}", f"{proved['borders']:.6f}", number(judged(row, "hausdorff")),
                      str(judged(row, "self_intersections")), number(row["seconds"]),
                      number(proved["own_seconds"]), ratio(row["seconds"] - proved["own_seconds"], row["peer_seconds"]),
                      f"{used:.0f}"])
    return markdown(head, lines)


def peers_promise_table(rows: Sequence[Row]) -> str:
    """Asked for an error: what peers give that can be asked, and the fewest triangles by trial; sampled distances."""
    lines = []
    for row in rows:
        asked, by_trial = row["asked"], row["by_trial"]
        cells = [f"{row['bone']} {row['error']} mm", row["name"]]
        for answer in (asked, by_trial):
            there = "triangles" in answer
            cells += [f"{answer['triangles']:,}" if there else "-", number(judged(answer, "hausdorff") if there else None)]
        lines.append(cells + [number(by_trial.get("seconds"))])
    return markdown(["bone, error", "", "asked for it: triangles", "H", "by trial: triangles", "H", "s, last trial"], lines)


def growth_table(rows: Sequence[Row]) -> str:
    """Seconds and bytes per input triangle, and their growth from the specimen next to a million triangles."""
    head = ["mode", "input triangles", "s", "us / triangle", "bytes / triangle", "time per triangle / that at 1 million"]
    lines = []
    for row in sorted(rows, key=lambda r: (r["mode"], r["threads"])):
        same = [r for r in rows if r["who"] == row["who"]]
        base = min(same, key=lambda r: abs(r["triangles"] - 1_000_000))
        name = f"**{row['mode']}**" + (f", {row['threads']} threads" if row["threads"] > 1 else "")
        lines.append([name, f"{row['triangles']:,}", number(row["seconds"]),
                      number(1e6 * row["seconds"] / row["triangles"]), f"{row['bytes'] / row['triangles']:.0f}",
                      ratio(row["seconds"] / row["triangles"], base["seconds"] / base["triangles"])])
    return markdown(head, lines)


def threads_table(rows: Sequence[Row]) -> str:
    """Speed-up over one thread with the best kernels, and whether the bytes are the same."""
    lines = []
    for row in rows:
        one = next(r for r in rows if r["mode"] == row["mode"] and r["threads"] == 1)
        same = "yes" if row["checksums"] == one["checksums"] and len(one["checksums"]) == 1 else "NO"
        lines.append([f"**{row['mode']}**", str(row["threads"]), row["kernels"] or "best", number(row["seconds"]),
                      number(row["cpu_seconds"]), ratio(one["seconds"], row["seconds"]), same, ", ".join(row["checksums"])])
    return markdown(["mode", "threads", "kernels", "s", "CPU s", "times faster", "same bytes", "checksum"], lines)
