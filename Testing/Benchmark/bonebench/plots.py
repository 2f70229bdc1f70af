# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The plots, from the raw figures, by matplotlib; readable at the width of a page and without color vision."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Sequence

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend first)
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.ticker import FuncFormatter, NullFormatter  # noqa: E402

from .records import BACK, THERE, find, value_of  # noqa: E402

Row = dict[str, Any]
Entry = dict[str, Any]
# Okabe and Ito's colors; peers stay gray, the one we are measured against darker.
OURS = ("#D55E00", "#0072B2", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
PEER, RIVAL = "#9A9A9A", "#404040"
MARKERS = "os^Dv"
STYLE: Any = {
    "font.size": 11, "axes.titlesize": 12, "axes.titleweight": "bold", "axes.titlelocation": "left",
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.color": "#E4E4E4",
    "axes.axisbelow": True, "lines.linewidth": 1.6, "figure.dpi": 150, "savefig.bbox": "tight", "svg.hashsalt": "0"}


def look(entry: Entry, modes: Sequence[str]) -> dict[str, Any]:
    """Color, dash and weight of a contestant."""
    if not entry["ours"]:
        color = RIVAL if entry["key"] == "cgal" else PEER
        return {"color": color, "linestyle": "-", "linewidth": 1.4, "marker": "o", "markersize": 3, "zorder": 2}
    index = modes.index(entry["mode"])
    return {"color": OURS[index % len(OURS)], "linestyle": "-" if entry["threads"] == 1 else (0, (3, 2)),
            "linewidth": 2.4, "marker": MARKERS[index % len(MARKERS)], "markersize": 6, "zorder": 3}


def ink(style: dict[str, Any]) -> str:
    """The color of a name: a peer's is darker than its line, to be read."""
    return "#5E5E5E" if style["color"] == PEER else str(style["color"])


def plain(name: str) -> str:
    """A table's name without Markdown."""
    return name.replace("*", "")


def label_ends(axes: Axes, ends: Sequence[tuple[float, float, str, dict[str, Any]]]) -> None:
    """Names to the right of the lines' ends, pushed apart where they would cover each other."""
    if not ends:
        return
    pixels = [(axes.transData.transform((x, y))[1], x, y, name, style) for x, y, name, style in ends]
    pixels.sort(key=lambda item: item[0])
    step = 1.28 * 9 * axes.figure.dpi / 72
    heights = [item[0] for item in pixels]
    for _ in range(200):
        for i in range(1, len(heights)):
            overlap = step - (heights[i] - heights[i - 1])
            if overlap > 0.01:
                heights[i - 1] -= overlap / 2
                heights[i] += overlap / 2
        # The topmost may not run into the title.
        heights[-1] = min(heights[-1], axes.transAxes.transform((0.0, 1.0))[1])
    right = axes.transAxes.transform((1.0, 0.0))[0]
    for (_, x, y, name, style), height in zip(pixels, heights):
        begin = tuple(axes.transData.inverted().transform((right + 0.10 * axes.figure.dpi, height)))
        axes.annotate(name, xy=(x, y), xytext=begin, textcoords="data", fontsize=9, va="center", color=ink(style),
                      fontweight="bold" if style["zorder"] == 3 else "normal", annotation_clip=False,
                      arrowprops={"arrowstyle": "-", "color": style["color"], "linewidth": 0.6, "shrinkA": 1,
                                  "shrinkB": 3, "alpha": 0.6, "relpos": (0.0, 0.5)})


def series(rows: Sequence[Row], keep: Callable[[Entry], bool]) -> dict[str, list[tuple[Row, Entry]]]:
    """Contestant -> its entries over the rows of one bone, by falling number of triangles."""
    found: dict[str, list[tuple[Row, Entry]]] = {}
    for row in sorted(rows, key=lambda r: -r["requested"]):
        for entry in row["entries"]:
            if entry["seconds"] and entry["through"] != "filter" and keep(entry):
                found.setdefault(entry["key"], []).append((row, entry))
    return found


def count_axis(axes: Axes, rows: Sequence[Row], note: Callable[[Row], str] = lambda _: "") -> None:
    """Triangles, from many to few, each requested count a tick with a note below it."""
    notes = {row["requested"]: note(row) for row in rows}
    counts = sorted(notes)
    axes.set_xscale("log")
    # One that is near the next stands two lines lower, to be read beside it.
    near = [bool(notes[count]) and larger < 2 * count for count, larger in zip(counts, [*counts[1:], float("inf")])]
    axes.set_xticks(counts, [("\n\n" if low else "") + f"{count:,}{notes[count]}" for count, low in zip(counts, near)])
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.tick_params(axis="x", which="minor", length=0)
    axes.set_xlim(1.25 * counts[-1], counts[0] / 1.15)
    axes.set_xlabel("requested triangles")


def draw(axes: Axes, lines: dict[str, list[tuple[Row, Entry]]], modes: Sequence[str],
         value: Callable[[Row, Entry], float | None]) -> None:
    """A line a contestant, with its name at the end; axes must have their limits after this."""
    ends = []
    for points in lines.values():
        known = [(row["requested"], y) for row, entry in points if (y := value(row, entry)) is not None]
        style = look(points[0][1], modes)
        if known:
            axes.plot(*zip(*known), **style)
            ends.append((*known[-1], plain(points[0][1]["name"]), style))
    axes.figure.canvas.draw()
    label_ends(axes, ends)


def worst_rms(entry: Entry | None) -> float | None:
    """The larger of the two directions."""
    values = [value for side in (THERE, BACK) if (value := value_of(entry, side, "rms")) is not None]
    return max(values, default=None)


def error_plot(rows: Sequence[Row], modes: Sequence[str], target: Path) -> bool:
    """RMS distance against triangles, relative to CGAL Lindstrom-Turk's, whose mm stand below."""
    rows = [row for row in rows if worst_rms(find(row, "cgal")) is not None]
    if not rows:
        return False
    figure, axes = plt.subplots(figsize=(7.2, 4.6))
    count_axis(axes, rows, lambda row: f"\n({worst_rms(find(row, 'cgal')):.2g} mm)")
    axes.set_xlabel("requested triangles (RMS distance of CGAL Lindstrom-Turk)")
    top = 2.2
    axes.set_ylim(0.6, top)

    def value(row: Row, entry: Entry) -> float | None:
        mine, base = worst_rms(entry), worst_rms(find(row, "cgal"))
        return min(mine / base, top) if mine and base else None

    axes.set_ylabel("times CGAL Lindstrom-Turk's")
    axes.set_title(f"RMS distance, the larger of both directions: {title_of(rows)}", pad=12)
    draw(axes, series(rows, lambda e: e["threads"] == 1), modes, value)
    if any((worst_rms(e) or 0) > top * (worst_rms(find(r, "cgal")) or 1) for r in rows for e in r["entries"]):
        axes.text(0.01, 0.98, f"what lies above {top:g} is drawn at {top:g}", transform=axes.transAxes, fontsize=8.5,
                  va="top", color="#606060")
    figure.savefig(target)
    plt.close(figure)
    return True


def curve_plot(row: Row, modes: Sequence[str], target: Path) -> bool:
    """The fraction of the original's surface lies within x mm of the result."""
    entries = [entry for entry in row["entries"] if entry["seconds"] and entry["threads"] == 1
               and entry["through"] != "filter" and value_of(entry, BACK, "percentiles")]
    if not entries:
        return False
    figure, axes = plt.subplots(figsize=(7.2, 4.6))
    ends = []
    for entry in entries:
        style = {**look(entry, modes), "marker": ""}
        values = value_of(entry, BACK, "percentiles")
        axes.plot([max(value, 1e-9) for value in values], range(len(values)), **style)
        ends.append((values[50], entry, style))
    reach = sorted(value_of(entry, BACK, "percentiles")[99] for entry in entries)
    axes.set_xlim(0, 1.05 * reach[len(reach) // 2])
    axes.set_ylim(0, 101)
    axes.set_xlabel("mm from the original's surface to the result")
    axes.set_ylabel("% of the original's surface within that")
    axes.set_title(f"{row['bone']}, {row['requested']:,} of {row['input']['triangles']:,} triangles", pad=12)
    order = sorted(ends, key=lambda item: item[0])
    handles = [Line2D([], [], **style, label=plain(entry["name"])) for _, entry, style in order]
    axes.legend(handles=handles, title="closest first (median)", alignment="left", loc="lower right", fontsize=9,
                title_fontsize=9, framealpha=1.0, edgecolor="#D0D0D0", labelcolor=[ink(style) for _, _, style in order])
    figure.savefig(target)
    plt.close(figure)
    return True


def growth_plot(rows: Sequence[Row], modes: Sequence[str], target: Path) -> bool:
    """Microseconds and bytes per input triangle against their number."""
    if not rows:
        return False
    figure, panels = plt.subplots(1, 2, figsize=(11.0, 4.2), gridspec_kw={"wspace": 0.5})
    views: tuple[tuple[str, Callable[[Row], float]], ...] = (
        ("Microseconds per input triangle", lambda row: 1e6 * row["seconds"] / row["triangles"]),
        ("Peak bytes per input triangle", lambda row: row["bytes"] / row["triangles"]))
    for axes, (title, value) in zip(panels, views):
        ends = []
        axes.set_xscale("log")
        for key in dict.fromkeys(row["key"] for row in rows):
            points = sorted((row for row in rows if row["key"] == key), key=lambda row: row["triangles"])
            style = look({"ours": True, **points[0]}, modes)
            axes.plot([row["triangles"] for row in points], [value(row) for row in points], **style)
            name = points[0]["mode"] + (f", {points[0]['threads']} threads" if points[0]["threads"] > 1 else "")
            ends.append((points[-1]["triangles"], value(points[-1]), name, style))
        axes.set_ylim(0, 1.15 * max(value(row) for row in rows))
        axes.set_title(title, pad=10)
        axes.set_xlabel("input triangles")
        axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x / 1e6:g} million"))
        figure.canvas.draw()
        label_ends(axes, ends)
    figure.savefig(target)
    plt.close(figure)
    return True


def title_of(rows: Sequence[Row]) -> str:
    """The bone and its size."""
    return f"{rows[0]['bone']}, {rows[0]['input']['triangles']:,} triangles"


def draw_all(figures: dict[str, Any], folder: Path) -> list[tuple[str, str]]:
    """What says more than the tables: bones with three rows and more, and the largest; returns names and captions."""
    folder.mkdir(parents=True, exist_ok=True)
    modes, rows = figures["modes"], figures["rows"]
    made = []
    with plt.rc_context(STYLE):
        bones = dict.fromkeys(row["bone"] for row in rows)
        several = [bone for bone in bones if sum(row["bone"] == bone for row in rows) > 2]
        largest = max(rows, key=lambda row: row["input"]["triangles"])["bone"] if rows else None
        for bone in several:
            mine = [row for row in rows if row["bone"] == bone]
            made += [(f"benchmark-{bone}-error.png", f"{bone}: distance against triangles")] * error_plot(
                mine, modes, folder / f"benchmark-{bone}-error.png")
        for bone in dict.fromkeys([*several, *filter(None, [largest])]):
            row = next(row for row in rows if row["bone"] == bone)
            row = next((r for r in rows if r["bone"] == bone and r["requested"] == 10000), row)
            made += [(f"benchmark-{bone}-curve.png", f"{bone}: cumulative error")] * curve_plot(
                row, modes, folder / f"benchmark-{bone}-curve.png")
        made += [("benchmark-growth.png", "growth of time and memory")] * growth_plot(
            figures["growth"], modes, folder / "benchmark-growth.png")
    return made
