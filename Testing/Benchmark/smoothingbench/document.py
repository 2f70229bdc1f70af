# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the page from page.md and the data files alone.

    python -m smoothingbench.document    writes Documentation/results/smoothing-benchmark.md again, without a run
"""

from __future__ import annotations

import csv
import importlib.metadata
import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path

from bonebench import machine

from . import OURS

DOCUMENTATION = Path(__file__).resolve().parents[3] / "Documentation"
TEMPLATE = Path(__file__).with_name("page.md")
RUN = "smoothing-run.json"
PACKAGES = ("vtk", "pymeshlab", "meshlib", "numpy")
Row = dict[str, str]
Rows = list[Row]


def read(path: Path) -> Rows:
    if not path.exists():
        return []
    with path.open(newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def unique(rows: Rows, column: str) -> list[str]:
    return list(dict.fromkeys(row[column] for row in rows))


def number(text: str, digits: int) -> str:
    return f"{float(text):,.{digits}f}" if text else ""


def pair(first: str, digits: int, second: str, second_digits: int) -> Callable[[Row], str]:
    return lambda row: f"{number(row[first], digits)} / {number(row[second], second_digits)}" if row[first] else ""


def one(column: str, digits: int) -> Callable[[Row], str]:
    return lambda row: number(row[column], digits)


def changed_percent(row: Row) -> str:
    """0 only if no voxel changed."""
    changed = int(row["changed_voxels"])
    percent = 100.0 * changed / int(row["boundary_voxels"])
    return f"{percent:.2f}" if percent >= 0.005 or not changed else "< 0.01"


def table(head: list[str], lines: list[list[str]], words: int = 1) -> str:
    """The first columns are words, the others numbers."""
    text = ["| " + " | ".join(head) + " |", "|" + "---|" * words + "---:|" * (len(head) - words)]
    return "\n".join(text + ["| " + " | ".join(line) + " |" for line in lines]) + "\n"


def bold(method: str) -> str:
    return f"**{method}**" if method == OURS else method


def by_shape(rows: Rows, kinds: tuple[str, ...], cell: Callable[[Row], str]) -> str:
    """A line for each method, a column for each shape of these kinds that has a figure."""
    chosen = [row for row in rows if row["kind"] in kinds and cell(row)]
    cells = {(row["method"], row["shape"]): cell(row) for row in chosen}
    shapes = unique(chosen, "shape")
    return table(["method"] + shapes,
                 [[bold(method)] + [cells.get((method, shape), "") for shape in shapes] for method in unique(chosen, "method")])


def of_labels(rows: Rows) -> str:
    """A line for each map of several labels and method."""
    columns = {"voxels changed, %": changed_percent, "air gaps, mm3": one("gap_mm3", 1), "overlaps, mm3": one("overlap_mm3", 1),
               "non-manifold edges": one("non_manifold_edges", 0), "boundary edges": one("boundary_edges", 0),
               "intersecting pairs": one("intersecting_pairs", 0), "roughness, degrees": one("roughness_degrees", 1),
               "processor s": one("cpu_seconds", 2)}
    return table(["label map", "method"] + list(columns),
                 [[row["shape"], bold(row["method"])] + [cell(row) for cell in columns.values()]
                  for row in rows if row["kind"] == "labels"], 2)


def of_whole_runs(rows: Rows) -> str:
    """A line for each shape and method."""
    columns = {"triangles": one("triangles", 0), "RMS mm / degrees": pair("rms_mm", 3, "normal_degrees", 1),
               "voxels changed, %": changed_percent, "intersecting pairs": one("intersecting_pairs", 0),
               "components": one("components", 0), "processor s": one("cpu_seconds", 2)}
    return table(["label map", "method"] + list(columns),
                 [[row["shape"], row["method"]] + [cell(row) for cell in columns.values()] for row in rows], 2)


def of_growth(rows: Rows) -> str:
    """Per million triangles of the extracted surface."""
    lines = []
    for step in unique(rows, "step"):
        for row in (row for row in rows if row["step"] == step):
            millions = float(row["input_triangles"] if int(row["input_triangles"]) else row["triangles"]) / 1e6
            lines.append([step, f"{millions * 1e6:,.0f}", number(row["voxels"], 0), number(row["seconds"], 2),
                          f"{float(row['seconds']) / millions:.2f}", f"{float(row['cpu_seconds']) / millions:.2f}",
                          f"{float(row['peak_bytes']) / millions / 1e6:,.0f}"])
    return table(["step", "triangles", "voxels", "s", "s per million", "processor s per million", "MB per million"], lines)


def of_threads(rows: Rows) -> str:
    """A line for each map and step: the beginnings of the hashes, and whether they are equal."""
    lines = []
    for name, step in dict.fromkeys((row["map"], row["step"]) for row in rows):
        runs = [row for row in rows if (row["map"], row["step"]) == (name, step)]
        sums = {row["sha256"] for row in runs}
        lines.append([name, step, number(runs[0]["triangles"], 0), ", ".join(row["threads"] for row in runs),
                      f"equal ({sums.pop()[:12]})" if len(sums) == 1 else "**different**"])
    return table(["label map", "step", "triangles of the result", "threads", "bytes"], lines, 2)


def write_conditions(work: Path, section: str, rounds: int, samples: int, note: str) -> None:
    """What a section was run on; the other sections keep their entries."""
    versions, path = {}, work / RUN
    for package in PACKAGES:
        try:
            versions[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            pass
    run = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {"sections": {}}
    run |= {"machine": machine.describe(), "versions": run.get("versions", {}) | versions}
    run["sections"][section] = {"rounds": rounds, "samples": samples, "note": note, "commit": machine.commit()}
    path.write_text(json.dumps(run, indent=2) + "\n", encoding="utf-8")


def conditions(run: dict) -> str:
    described, sections = run["machine"], run["sections"].values()
    rounds, samples = ({section[key] for section in sections} for key in ("rounds", "samples"))
    lines = [f"* Machine: {described['processor']}, {described['cores']} cores, {described['memory_gb']:.0f} GB; {described['system']}.",
             f"* Rounds: {', '.join(map(str, sorted(rounds)))}. Samples per direction: {max(samples):,}.",
             "* Versions: " + ", ".join(f"{name} {version}" for name, version in run["versions"].items())
             + ". `vtkBoneSurfaces` and `vtkBoneDecimate` are built with Debian's VTK 9.1.",
             "* Commits: " + ", ".join(f"{name} {section.get('commit', 'at or before 34978d39')}" for name, section in run["sections"].items()) + "."]
    return "\n".join(lines + [f"* {name}: {section['note']}" for name, section in run["sections"].items() if section["note"]]) + "\n"


def tables(folder: Path) -> dict[str, str]:
    compared, bone = read(folder / "smoothing-compare.csv"), ("CT", "phantom")
    every = bone + ("analytic",)
    network = read(folder / "smoothing-network.csv")
    run = json.loads((folder / RUN).read_text(encoding="utf-8"))
    return {
        "accuracy": by_shape(compared, bone, pair("rms_mm", 3, "normal_degrees", 1)),
        "finer": by_shape(compared, bone, pair("finer_rms_mm", 3, "finer_normal_degrees", 1)),
        "analytic": by_shape(compared, ("analytic",), pair("rms_mm", 3, "normal_degrees", 1)),
        "roughness": by_shape(compared, bone, one("roughness_degrees", 1)),
        "displacement": by_shape(compared, every, one("displacement_mm", 2)),
        "voxels": by_shape(compared, every, changed_percent),
        "intersections": by_shape(compared, every, one("intersecting_pairs", 0)),
        "components": by_shape(compared, every, one("components", 0)),
        "thickness": by_shape(compared, ("analytic",), pair("least_thickness_mm", 2, "mean_thickness_mm", 2)),
        "seconds": by_shape(compared, bone, one("cpu_seconds", 2)),
        "labels": of_labels(compared),
        "simplified": of_whole_runs(read(folder / "smoothing-simplify.csv")),
        "network_file": by_shape(network, ("network, file",), pair("rms_mm", 3, "normal_degrees", 1)),
        "network_model": by_shape(network, ("network, model",), pair("rms_mm", 3, "normal_degrees", 1)),
        "network_voxels": by_shape(network, ("network, model",), changed_percent),
        "growth": of_growth(read(folder / "smoothing-growth.csv")),
        "threads": of_threads(read(folder / "smoothing-threads.csv")),
        "conditions": conditions(run),
    }


def write_page(folder: Path, target: Path) -> None:
    made = tables(folder)
    text = re.sub(r"<!-- (\w+) -->\n", lambda match: made[match[1]], TEMPLATE.read_text(encoding="utf-8"))
    target.write_text(text, encoding="utf-8")


def publish(work: Path) -> None:
    """Figures and pictures of a run go to Documentation; those of sections that did not run stay. Then the page is written."""
    data = DOCUMENTATION / "results" / "benchmark-data"
    for pattern, folder in (("smoothing-*.csv", data), ("smoothing-*.png", DOCUMENTATION / "images")):
        for file in work.glob(pattern):
            shutil.copy(file, folder)
    run, before = json.loads((work / RUN).read_text(encoding="utf-8")), data / RUN
    if before.exists():
        run["sections"] = json.loads(before.read_text(encoding="utf-8"))["sections"] | run["sections"]
    before.write_text(json.dumps(run, indent=2) + "\n", encoding="utf-8")
    write_page(data, DOCUMENTATION / "results" / "smoothing-benchmark.md")


if __name__ == "__main__":
    write_page(DOCUMENTATION / "results" / "benchmark-data", DOCUMENTATION / "results" / "smoothing-benchmark.md")
