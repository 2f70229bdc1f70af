# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the methods on the label maps and measures the results: one row for each pair."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from . import NOT_SMOOTHED, measures
from .cases import Case
from .methods import Method, Result
from .surfaces import Surface

Row = dict[str, Any]
# The columns of the data file. Those without a figure for a shape stay empty.
COLUMNS = ("kind", "shape", "method", "triangles", "components", "rms_mm", "normal_degrees", "finer_rms_mm", "finer_normal_degrees",
           "roughness_degrees", "displacement_mm", "changed_voxels", "boundary_voxels", "intersecting_pairs",
           "least_thickness_mm", "mean_thickness_mm", "gap_mm3", "overlap_mm3", "non_manifold_edges", "boundary_edges",
           "cpu_seconds", "seconds")


def repeated(case: Case, method: Method, rounds: int) -> Result:
    """The surfaces of the last round, with the medians of the times."""
    results = [method(case) for _ in range(rounds)]
    last = results[-1]
    last.seconds = statistics.median(result.seconds for result in results)
    last.cpu_seconds = statistics.median(result.cpu_seconds for result in results)
    return last


def whole(surfaces: dict[int, Surface]) -> Surface:
    """All labels in one, walls twice."""
    points = [surface.points for surface in surfaces.values()]
    firsts = np.cumsum([0] + [len(one) for one in points])
    triangles = [surface.triangles + first for surface, first in zip(surfaces.values(), firsts)]
    return Surface(np.concatenate(points), np.concatenate(triangles))


def distances(case: Case, surface: Surface, truths: dict[str, measures.Locator], samples: int) -> Row:
    row: Row = {}
    for prefix, (name, truth) in zip(("", "finer_"), case.truths.items()):
        row[prefix + "rms_mm"], row[prefix + "normal_degrees"] = measures.accuracy(surface, truth, truths[name], case.box, samples)
    return row


def row_of(case: Case, result: Result, before: measures.Locator, truths: dict[str, measures.Locator], verify: Path,
           samples: int) -> Row:
    surface = whole(result.surfaces)
    shapes = [measures.shape_of(one, verify) for one in result.surfaces.values()]
    changed, boundary = measures.changed_voxels(case, result.surfaces)
    row = {"triangles": len(surface.triangles), "changed_voxels": changed, "boundary_voxels": boundary,
           "roughness_degrees": measures.roughness(surface, case.box),
           "displacement_mm": measures.displacement(surface, before, case.box),
           "cpu_seconds": result.cpu_seconds, "seconds": result.seconds, **distances(case, surface, truths, samples)}
    for column, key in (("components", "components"), ("intersecting_pairs", "self_intersections"),
                        ("non_manifold_edges", "non_manifold_edges"), ("boundary_edges", "boundary_edges")):
        row[column] = sum(shape[key] for shape in shapes) if all(shapes) else None
    if case.probes is not None:
        row["least_thickness_mm"], row["mean_thickness_mm"] = measures.thickness(case, surface)
    if case.kind == "labels":
        row["gap_mm3"], row["overlap_mm3"] = measures.gaps_and_overlaps(case, result.surfaces)
    return row


def rows_of(make: Callable[[], Case], methods: dict[str, Method], verify: Path, samples: int, rounds: int) -> Iterator[Row]:
    case = make()
    truths = {name: measures.Locator(truth) for name, truth in case.truths.items()}
    before = None
    for name, method in methods.items():
        result = repeated(case, method, rounds)
        if name == NOT_SMOOTHED:
            before = measures.Locator(whole(result.surfaces))
        yield {"kind": case.kind, "shape": case.name, "method": name,
               **row_of(case, result, before, truths, verify, samples)}
