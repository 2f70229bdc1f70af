# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The figures of a run as flat records, one CSV file per kind. The page is written from these files alone."""

from __future__ import annotations

import csv
import json
import statistics
from pathlib import Path
from typing import Any, Iterable, Sequence

from . import machine

Figures = dict[str, Any]
Record = dict[str, str]
Records = dict[str, list[Record]]

THERE, BACK = "simplified_to_original", "original_to_simplified"
# Columns of <kind>.csv: column -> path of the value in an entry of the figures.
DISTANCES = {f"{name}_{statistic}_mm": (side, key)
             for name, side in (("to_original", THERE), ("to_result", BACK))
             for statistic, key in (("average", "average"), ("rms", "rms"), ("max", "maximum"))}
DISTANCES["hausdorff_mm"] = ("hausdorff",)
POINTS = {f"point_{statistic}_mm": (THERE, f"point_{key}")
          for statistic, key in (("max", "maximum"), ("second", "second"), ("average", "average"), ("rms", "rms"))}
SHAPE = {"components": "components", "boundary_edges": "boundary_edges", "non_manifold_edges": "non_manifold_edges",
         "non_manifold_vertices": "non_manifold_vertices", "euler": "euler",
         "self_intersecting_pairs": "self_intersections", "degenerate_triangles": "degenerate", "quality": "quality"}
COLUMNS = {
    "comparison": ["bone", "input_triangles", "requested_triangles", "method", "threads", "adapter", "triangles", "seconds",
                   "cpu_seconds", "peak_mb", *DISTANCES, *POINTS, *SHAPE, "poor_percent"],
    "growth": ["mode", "threads", "input_triangles", "seconds", "bytes_per_triangle"],
    "threads": ["bone", "requested_triangles", "mode", "threads", "kernels", "seconds", "cpu_seconds", "checksum"],
    "proved": ["bone", "input_triangles", "error_mm", "mode", "intersection_guard", "triangles", "proved_mm",
               "proved_boundary_mm", "hausdorff_mm", "self_intersecting_pairs", "runs", "seconds", "cpu_seconds",
               "certificate_seconds", "bytes_per_triangle"],
    "errors": ["bone", "error_mm", "mode", "triangles", *POINTS, "hausdorff_mm", "seconds"],
}


def value_of(entry: dict[str, Any] | None, *path: str) -> Any:
    """A measured value of an entry, or None."""
    return at(entry["measured"], path) if entry else None


def find(row: dict[str, Any], key: str) -> dict[str, Any] | None:
    """The entry of a program that ended successfully."""
    return next((entry for entry in row["entries"] if entry["key"] == key and entry["seconds"]), None)


def text(value: Any, digits: int = 6) -> str:
    """A cell: six significant digits, empty for nothing."""
    if value is None:
        return ""
    return f"{value:.{digits}g}" if isinstance(value, float) else str(value)


def at(values: dict[str, Any] | None, path: Iterable[str]) -> Any:
    """The value at a path of keys, or None."""
    found: Any = values
    for key in path:
        found = found.get(key) if found else None
    return found


def distances(values: dict[str, Any], columns: dict[str, tuple[str, ...]]) -> Record:
    """The named distances."""
    return {name: text(at(values, path)) for name, path in columns.items()}


def shape(values: dict[str, Any]) -> Record:
    """Topology and quality of the triangles."""
    cells = {name: text(values.get(key)) for name, key in SHAPE.items()}
    return {**cells, "poor_percent": text(100 * values["bad_fraction"], 3) if "bad_fraction" in values else ""}


def method(entry: dict[str, Any]) -> str:
    """The name of a mode or of a peer."""
    return entry["mode"] if entry["ours"] else entry["name"]


def of_row(row: dict[str, Any]) -> Record:
    """The columns that all records of one bone and one number of triangles have in common."""
    return {"bone": row["bone"], "input_triangles": text(row["input"]["triangles"]), "requested_triangles": text(row["requested"])}


def comparison(row: dict[str, Any]) -> list[Record]:
    """The input, every peer and every mode; seconds if nothing else ran."""
    found = [{**of_row(row), "method": "input", "triangles": text(row["input"]["triangles"]), **shape(row["input"])}]
    for entry in row["entries"]:
        if not entry["seconds"]:
            continue
        times = {"seconds": text(entry["median_seconds"]), "cpu_seconds": text(statistics.median(entry["cpu_seconds"]))}
        found.append({
            **of_row(row), "method": method(entry), "threads": text(entry["threads"]), "adapter": entry["through"],
            "triangles": text(entry["triangles"]), **(times if row["others"] <= machine.QUIET else {}), "peak_mb": text(entry["peak_bytes"] / 1e6, 4),
            **distances(entry["measured"], DISTANCES), **distances(entry["measured"], POINTS), **shape(entry["measured"])})
    return found


def proved(row: dict[str, Any]) -> Record:
    """One run with a proved largest error."""
    certificate = row["proved"]
    seconds = {name: text(row[name]) for name in ("seconds", "cpu_seconds", "certificate_seconds")}
    return {"bone": row["bone"], "input_triangles": text(row["input"]), "error_mm": text(row["error"]), "mode": row["mode"],
            "intersection_guard": row["guard"], "triangles": text(row["triangles"]),
            "proved_mm": f"{certificate['upper']:.6f}", "proved_boundary_mm": f"{certificate['boundaries']:.6f}",
            "hausdorff_mm": text(at(row["measured"], ["hausdorff"])),
            "self_intersecting_pairs": text(at(row["measured"], ["self_intersections"])), "runs": text(row["runs"]),
            **(seconds if row["others"] <= machine.QUIET else {}),
            "bytes_per_triangle": f"{(row['input_bytes'] + row['peak_bytes']) / row['input']:.0f}"}


def from_figures(figures: Figures) -> Records:
    """All records of a run."""
    return {
        "comparison": [record for row in figures["rows"] for record in comparison(row)],
        "growth": [{"mode": row["mode"], "threads": text(row["threads"]), "input_triangles": text(row["triangles"]),
                    "seconds": text(row["seconds"]), "bytes_per_triangle": f"{row['bytes'] / row['triangles']:.0f}"}
                   for row in figures["growth"]],
        "threads": [{"bone": row["bone"], "requested_triangles": text(row["requested"]), "mode": row["mode"],
                     "threads": text(row["threads"]), "kernels": row["kernels"] or "best", "seconds": text(row["seconds"]),
                     "cpu_seconds": text(row["cpu_seconds"]), "checksum": " ".join(row["checksums"])}
                    for row in figures["threads"]],
        "proved": [proved(row) for row in figures["proved"] if "failure" not in row],
        "errors": [{"bone": row["bone"], "error_mm": text(row["error"]), "mode": row["mode"],
                    "triangles": text(row["triangles"]), **distances(row["measured"], POINTS),
                    "hausdorff_mm": text(at(row["measured"], ["hausdorff"])), "seconds": text(row["seconds"])}
                   for row in figures["errors"] if "failure" not in row],
    }


def conditions(figures: Figures) -> dict[str, Any]:
    """What the figures were measured on and with."""
    versions = {entry["name"]: entry["version"] for row in figures["rows"] for entry in row["entries"]
                if not entry["ours"] and entry["version"]}
    return {"machine": figures["machine"], "commits": figures["commits"], "rounds": figures["rounds"], "samples": figures["samples"],
            "runs": figures.get("parts", 1), "versions": versions, "notes": figures["complaints"]}


def write_file(file: Path, columns: Sequence[str], records: Iterable[Record]) -> None:
    """A CSV file."""
    with file.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, columns, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(records)


def read_file(file: Path) -> list[Record]:
    """The lines of a CSV file; none if it is missing."""
    if not file.is_file():
        return []
    with file.open(newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def write(folder: Path, figures: Figures) -> None:
    """One CSV file per kind that has records, and run.json."""
    folder.mkdir(parents=True, exist_ok=True)
    for kind, records in from_figures(figures).items():
        file = folder / f"{kind}.csv"
        file.unlink(missing_ok=True)
        if records:
            write_file(file, COLUMNS[kind], records)
    (folder / "run.json").write_text(json.dumps(conditions(figures), indent=1) + "\n", encoding="utf-8")


def read(folder: Path) -> tuple[Records, dict[str, Any]]:
    """The records of a folder and the conditions of the run."""
    found = {kind: read_file(folder / f"{kind}.csv") for kind in COLUMNS}
    return found, json.loads((folder / "run.json").read_text(encoding="utf-8"))
