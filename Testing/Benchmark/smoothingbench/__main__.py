# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark of label maps and smoothing. Testing/Benchmark/smoothing.sh runs it with all peers.

    python -m smoothingbench --programs build/release/bin --python PATH:PROGRAM --work FOLDER [--compare] [--network] [--simplify] [--growth] [--threads]
                             [--pictures] [--write-docs] [NAME ...]

Without a section all of them run. NAME selects label maps of --compare, --simplify and --threads. Figures are CSV files in FOLDER; --write-docs copies them, the page that
is generated from them, and the pictures into Documentation.
"""

from __future__ import annotations

import argparse
import csv
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from bonebench import machine

from . import cases, compare, document, growth
from .methods import Method, all_methods, whole_runs

SECTIONS = ("compare", "network", "simplify", "growth", "threads", "pictures")


def parsed() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--programs", type=Path, required=True, help="folder of bonedecimate-verify and bonedecimate-phantom")
    parser.add_argument("--python", required=True, help="the Python of this project's build, as PATH-OF-MODULES:PROGRAM")
    parser.add_argument("--work", type=Path, required=True, help="folder for the figures")
    parser.add_argument("--ct", type=Path, default=cases.CRANIUM)
    parser.add_argument("--samples", type=int, default=40000, help="of each direction")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--sizes", type=float, nargs="+", default=[1e5, 3e5, 1e6, 3e6, 1e7], help="triangles, of --growth")
    parser.add_argument("--steps", nargs="+", choices=growth.LIMITS, default=[], help="of --growth; default: all")
    parser.add_argument("--thread-sizes", type=float, nargs="*", default=[1e5, 1e6], help="triangles, of --threads")
    parser.add_argument("--thread-counts", type=int, nargs="+", default=[1, 2, 4, 8], help="of --threads")
    parser.add_argument("--with-meshlib", action="store_true", help="its license is for non-commercial use")
    parser.add_argument("--write-docs", action="store_true")
    for section in SECTIONS:
        parser.add_argument(f"--{section}", action="store_true")
    parser.add_argument("names", nargs="*")
    return parser.parse_args()


def write_rows(path: Path, columns: Iterable[str], rows: Iterable[dict[str, Any]]) -> None:
    """Each row as soon as it is there; it is printed as well."""
    with path.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, list(columns), restval="", lineterminator="\n")
        writer.writeheader()
        for row in rows:
            shown = {key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()}
            writer.writerow(shown)
            stream.flush()
            print(", ".join(f"{key} {value}" for key, value in shown.items() if value not in (None, "")), flush=True)


def compared(options: argparse.Namespace, methods: dict[str, Method], names: list[str],
             shapes: Iterable[tuple[str, Callable[[], cases.Case]]]) -> Iterable[dict[str, Any]]:
    print("methods: " + ", ".join(methods))
    for name, make in shapes:
        if not names or name in names:
            yield from compare.rows_of(make, methods, options.programs / "bonedecimate-verify", options.samples, options.rounds)


def run(section: str, options: argparse.Namespace) -> None:
    target, maps = options.work / f"smoothing-{section}.csv", options.work / "maps"
    maps.mkdir(parents=True, exist_ok=True)
    shapes = cases.all_cases(options.ct, options.programs / "bonedecimate-phantom")
    if section == "compare":
        methods = all_methods(options.python, options.with_meshlib)
        write_rows(target, compare.COLUMNS, compared(options, methods, options.names, shapes))
    elif section == "network":
        methods = all_methods(options.python, options.with_meshlib)
        write_rows(target, compare.COLUMNS, compared(options, methods, options.names, cases.network_cases(options.ct)))
    elif section == "simplify":
        names = options.names or ["phantom", *cases.CROPS]
        write_rows(target, compare.COLUMNS, compared(options, whole_runs(options.python), names, shapes))
    elif section == "growth":
        write_rows(target, growth.GROWTH_COLUMNS,
                   growth.growth(options.ct, maps, options.python, sys.executable, options.sizes, options.steps,
                                 options.rounds))
    elif section == "threads":
        write_rows(target, growth.THREAD_COLUMNS,
                   growth.bytes_over_threads(options.ct, maps, options.python, options.thread_sizes, options.thread_counts,
                                             options.names))
    else:
        from . import pictures
        pictures.write(options.work, options.python, options.programs / "bonedecimate-phantom")


def main() -> None:
    options = parsed()
    for section in SECTIONS:
        if getattr(options, section) or not any(getattr(options, each) for each in SECTIONS):
            others = machine.Others()
            run(section, options)
            document.write_conditions(options.work, section, options.rounds, options.samples, others.complaint())
    document.write_page(options.work, options.work / "smoothing-benchmark.md")
    if options.write_docs:
        document.publish(options.work)


if __name__ == "__main__":
    main()
