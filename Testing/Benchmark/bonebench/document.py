# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts tables and plots together: the full page, and the section of the README between its two marks."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import tables

Figures = dict[str, Any]
METHOD = Path(__file__).parents[1] / "method.md"
BEGIN, END = "<!-- benchmark: begin, written by Testing/Benchmark/run.sh -->", "<!-- benchmark: end -->"
LEGEND = """`s`: median seconds of the decimation call; `CPU s`: of all threads; `MB`: peak beyond the held input. `s>o`: the result's
area to the original, `o>s`: the original's to the result; `H`: the largest of both. Distances in mm. In brackets: times
CGAL Lindstrom-Turk's. Ours run at exactly the number of triangles with which the first peer ended. In the thesis's
measure, points of the result to the original, meshoptimizer has nothing: it keeps points of the input.
"""


def introduction(figures: Figures) -> str:
    """Where and with what it ran."""
    machine = figures["machine"]
    versions = {entry["name"]: entry["version"] for row in figures["rows"] for entry in row["entries"]
                if not entry["ours"] and entry["version"]}
    lines = [f"{machine['processor']}, {machine['cores']} cores, {machine['memory_gb']:.0f} GB; {machine['system']}. "
             f"Rounds: {figures['rounds']}; samples a direction: {figures['samples']:,}."]
    if figures.get("parts", 1) > 1:
        lines.append(f"Put together from {figures['parts']} runs of the command, each of a part of it (`--from`); machine and "
                     "rounds are those of the first.")
    if versions:
        lines.append("Peers: " + ", ".join(f"{name} {version}" for name, version in versions.items()) + ".")
    return "\n".join(lines + figures["complaints"]) + "\n"


def row_section(row: dict[str, Any]) -> str:
    """Everything about one bone at one count."""
    parts = [f"### {row['bone']}: {row['input']['triangles']:,} triangles to {row['asked']:,}\n",
             tables.distance_table(row), tables.shape_table(row)]
    pairs = tables.pairs_table(row)
    if pairs:
        parts.append("Against each peer, ours run at exactly its count (another count reached is in brackets):\n\n" + pairs)
    thesis = tables.thesis_table(row)
    if thesis:
        parts.append("The thesis's measure:\n\n" + thesis)
    return "\n".join(parts)


def page(figures: Figures, plots: list[tuple[str, str]], images: str) -> str:
    """The full page in Markdown. @param images Folder of the plots as seen from the page."""
    parts = [METHOD.read_text(encoding="utf-8"), "## This run\n", introduction(figures)]
    if figures["rows"]:
        parts += ["## Our modes, in ratios\n", "Times the peer's, at the peer's own count; below 1 is in our favour.\n",
                  tables.targets_table(figures["rows"])]
    parts += [f"![{caption}]({images}/{name})\n" for name, caption in plots]
    if figures["growth"]:
        runs = min(row["runs"] for row in figures["growth"])
        parts += ["## Growth\n", f"Generated specimens brought to a fifth; runs of each: {runs}. Bytes: the most held while "
                  "it ran, input and output included, beyond the bare program.\n", tables.growth_table(figures["growth"])]
    if figures["threads"]:
        first = figures["threads"][0]
        parts += ["## Threads and kernels\n", f"{first['bone']} to {first['asked']:,}.\n", tables.threads_table(figures["threads"])]
    if figures["rows"]:
        parts += ["## Everybody\n", LEGEND, *(row_section(row) for row in figures["rows"])]
    if figures.get("promises"):
        beside = {row["bone"]: row["peer_faces"] for row in figures["promises"]}
        parts += ["## A largest error that is proved\n", "Two threads, once, with the certificate that each run ends with; "
                  "judged by another. "
                  "CGAL's Lindstrom-Turk in the same run: "
                  + ", ".join(f"{bone} to {faces:,}" for bone, faces in beside.items()) + ".\n",
                  tables.promise_table([row for row in figures["promises"] if row["guard"] == "on"]),
                  "With `KeepClearance` switched off, so that triangles may come to intersect and gaps to close:\n",
                  tables.promise_table([row for row in figures["promises"] if row["guard"] == "off"])]
    if figures.get("promises_of_peers"):
        parts += ["The others: those that take an error asked for it, in whatever unit theirs has; then the fewest triangles at "
                  "which they stay within it, found by trial, within 5 %. H is sampled, the largest distance at least that.\n",
                  tables.peers_promise_table(figures["promises_of_peers"])]
    if figures["errors"]:
        parts += ["## Asked for a largest error\n", "One thread, once; points of the result to the original, mm, as the "
                  "thesis measured; H both ways.\n", tables.error_table(figures["errors"])]
    return "\n".join(parts)


def readme_section(figures: Figures, plots: list[tuple[str, str]]) -> str:
    """The main table, one plot and the command that makes them."""
    rows = figures["rows"]
    row = next((r for r in rows if r["bone"] == "cranium"), rows[0])
    pieces = row["input"].get("components", 1)
    text = [BEGIN, "## Beside the others\n",
            f"The {row['bone']} of a CT, {row['input']['triangles']:,} triangles"
            + (f" in {pieces} components" if pieces > 1 else "") + f", brought to {row['asked']:,}; closest first, ours in\n"
            "bold, one thread unless said otherwise. Average and RMS: the larger of both directions; H: the largest of both.\n",
            tables.summary_table(row)]
    wanted = next((plot for plot in plots if plot[0] == "benchmark-maxilla-error.png"), None)
    if wanted:
        text.append(f"![{wanted[1]}](Documentation/images/{wanted[0]})\n")
    text += [line + "\n" for line in figures["complaints"] if "do not quote" in line]
    text += ["`Testing/Benchmark/run.sh` installs the others into its build folder, runs everybody in turn and writes this "
             "section and\n[Documentation/benchmark.md](Documentation/benchmark.md).\n", END]
    return "\n".join(text)


def write_readme(readme: Path, section: str) -> None:
    """Replaces what lies between the marks; before "## What it does not do yet" if they are not there."""
    text = readme.read_text(encoding="utf-8")
    if BEGIN in text:
        before, rest = text.split(BEGIN, 1)
        text = before + section + rest.split(END, 1)[1]
    else:
        head, rest = text.split("## What it does not do yet", 1)
        text = head + section + "\n\n## What it does not do yet" + rest
    readme.write_text(text, encoding="utf-8")
