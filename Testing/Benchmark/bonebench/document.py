# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of the benchmark and its section of the README, from the data files alone."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import tables
from .records import Records

ROOT = Path(__file__).resolve().parents[3]
RESULTS, IMAGES = ROOT / "Documentation" / "results", ROOT / "Documentation" / "images"
METHOD = Path(__file__).parents[1] / "method.md"
DATA = "benchmark-data"
PLOT_SUFFIXES = {"error": "RMS distance against the number of triangles", "curve": "fraction of the input's surface within a distance"}


def conditions(run: dict[str, Any]) -> str:
    """Machine, rounds, versions and what disturbed the run."""
    machine = run["machine"]
    lines = [f"* Machine: {machine['processor']}, {machine['cores']} cores, {machine['memory_gb']:.0f} GB; {machine['system']}.",
             f"* Rounds: {run['rounds']}. Samples per direction: {run['samples']:,}."]
    if run["runs"] > 1:
        lines.append(f"* The figures come from {run['runs']} runs; machine and rounds are those of the first.")
    if run["versions"]:
        lines.append(f"* Commit of this project: {'; '.join(run['commits'])}. Versions of the others: " + "; ".join(f"{name} {version}" for name, version in run["versions"].items()) + ".")
    return "\n".join(lines + [f"* {note}" for note in run["notes"]]) + "\n"


def main_goal(data: Records) -> tuple[str, str]:
    """The bone and number of triangles of the summary: the cranium, or the first."""
    goals = tables.goals(data["comparison"])
    return next((goal for goal in goals if goal[0] == "cranium"), goals[0])


def comparison(data: Records) -> list[str]:
    """Distance, time, memory and topology at equal numbers of triangles."""
    compared = data["comparison"]
    timed = [record for record in compared if record["seconds"]]
    bone, count = main_goal(data)
    return [
        "## How close is the result to the input?\n",
        "RMS distance in mm at equal numbers of triangles. Modes of this project are bold.\n",
        tables.by_method(compared, lambda r: tables.number(tables.worst(r, "rms"))),
        "## How large is the largest distance?\n",
        "Sampled Hausdorff distance in mm.\n",
        tables.by_method(compared, lambda r: tables.number(r["hausdorff_mm"])),
        "## How long does it take?\n",
        "Seconds on one thread, where nothing else ran.\n",
        tables.by_method(timed, lambda r: tables.number(r["seconds"])),
        "The modes on one thread, on two, and through the VTK filter:\n",
        tables.seconds_of_modes(timed),
        "## One input with all figures\n",
        f"`{bone}` with {int(count):,} requested triangles, closest first, one thread unless stated otherwise.\n",
        tables.summary(compared, (bone, count), full=True),
        "## Does the topology stay the same?\n",
        f"Over the {len(tables.goals(compared))} lines of the tables above: how many results have the components and the Euler "
        "number of the input and no new non-manifold edge.\n",
        tables.topology(compared)]


def proved(data: Records) -> list[str]:
    """Runs with a proved largest error."""
    return [
        "## How many triangles does a largest error take?\n",
        "The modes run with `MaximumError` and prove it for every point of both surfaces. What other programs do with a largest error is "
        "the [audit](audit.md).\n",
        tables.proved_triangles(data["proved"]),
        "## What does the proof cost?\n",
        "On two threads, with the certificate that ends each run. Seconds are medians; a dash where other programs used the processor. The last "
        "three columns are single runs with `IntersectionGuard` off, which lets triangles intersect and gaps close.\n",
        tables.proved_cost(data["proved"])]


def sections(data: Records) -> list[str]:
    """Every question for which there are records."""
    parts = comparison(data) if data["comparison"] else []
    if data["proved"]:
        parts += proved(data)
    if data["growth"]:
        parts += ["## How do time and memory grow?\n", "Generated specimens decimated to a fifth. Bytes are the peak during the "
                  "run, input and output included, beyond the bare program.\n", tables.growth(data["growth"])]
    if data["threads"]:
        first = data["threads"][0]
        parts += ["## What do threads and vector kernels bring?\n",
                  f"`{first['bone']}` with {int(first['requested_triangles']):,} requested triangles. `best` is what a run uses by "
                  "default; `plain` is C++ without vector instructions. The last column compares the result with that on one "
                  "thread.\n",
                  tables.threads(data["threads"])]
    return parts


THESIS = """# The tables of the thesis

H. Brand\u00e3o's thesis (Groningen, 2018) measures its method on a maxilla of 105,002 triangles and a frontal bone of 78,640, which are not public. This page
repeats its tables with the modes of today on the surfaces that come nearest, [those of the benchmark](benchmark.md#what-is-compared). The
page is generated by `Testing/Benchmark/run.sh`.

Its measure is the distance from the points of the result to the input, in mm: largest, average, root mean square. It sees neither the inside of large triangles
nor what is missing from the result, so the benchmark measures both surfaces in full.
"""


def thesis_page(data: Records) -> str:
    """The thesis's two tables with figures of today."""
    parts = [THESIS, "## With a number of triangles\n", tables.thesis_counts(data["comparison"])]
    if data["errors"]:
        parts += ["## With a largest error\n", "The thesis measures the points that a collapse makes; this project proves the error in both directions, except "
                  "in mode `Thesis`. The last column is the sampled two-sided distance, which the thesis does not print.\n",
                  tables.thesis_errors(data["errors"])]
    return "\n".join(parts)


FILES = """| file | one line per | columns |
|---|---|---|
| [comparison.csv](benchmark-data/comparison.csv) | input, number of triangles, program | seconds, memory, distances in both directions, distances of points, topology |
| [proved.csv](benchmark-data/proved.csv) | input, error, mode, intersection guard | triangles, proved bounds, seconds, memory |
| [growth.csv](benchmark-data/growth.csv) | mode, threads, size | seconds, bytes |
| [threads.csv](benchmark-data/threads.csv) | mode, threads, kernels | seconds, checksum of the result |
| [errors.csv](benchmark-data/errors.csv) | input, error, mode | the measure of the [thesis](thesis.md) with a largest error instead of a number of triangles |

`to_original` is the distance from the result to the input, `to_result` the distance from the input to the result. Lengths are mm, memory is
10^6 bytes. `run.json` has machine, versions and notes. `python3 -m bonebench.pages` in `Testing/Benchmark` writes this page again from
these files.
"""


def caption(name: str) -> str:
    """What a plot shows, from its file name."""
    if name == "benchmark-growth.png":
        return "Time and memory against the number of input triangles"
    bone, _, kind = name.removeprefix("benchmark-").removesuffix(".png").rpartition("-")
    return f"{bone}: {PLOT_SUFFIXES.get(kind, kind)}"


def page(data: Records, run: dict[str, Any], plots: list[str], images: str) -> str:
    """The full page in Markdown. @param plots Names of the image files. @param images Their folder as seen from the page."""
    parts = [METHOD.read_text(encoding="utf-8"), "## This run\n", conditions(run), *sections(data)]
    if plots:
        parts += ["## Plots\n", *(f"![{caption(name)}]({images}/{name})\n" for name in plots)]
    files = [line for line in FILES.splitlines() if not line.startswith("| [") or data[line[3:].split(".csv")[0]]]
    return "\n".join([*parts, "## Data files\n", *files, ""])


def readme_section(data: Records, run: dict[str, Any]) -> str:
    """The main table and the command that measures it."""
    bone, count = main_goal(data)
    source = next(record for record in data["comparison"] if (record["bone"], record["method"]) == (bone, "input"))
    pieces = int(source["components"] or 1)
    text = ["## Comparison\n",
            f"The {bone} of a CT, {int(source['triangles']):,} triangles" + (f" in {pieces} components" if pieces > 1 else "")
            + f", reduced to {int(count):,} on one thread; this project in bold. Each distance is the\n"
            "larger of both directions; H is the Hausdorff distance, sampled. No run has a largest error. The input has 2 non-manifold edges. [All figures](Documentation/results/benchmark.md) "
            "(`Testing/Benchmark/run.sh`).\n",
            tables.summary(data["comparison"], (bone, count), full=False)]
    text += [f"{note}\n" for note in run["notes"] if "do not quote" in note and bone not in note]
    return "\n".join(text)
