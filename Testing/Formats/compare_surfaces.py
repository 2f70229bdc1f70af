#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the program's readers of surfaces with those of others, on variants from the grammar of each format.

    compare_surfaces.py --program build/release/bin/bonedecimate --format obj --variants 2000 --python VENV/bin/python3

Ends with 1 if a difference has no explanation. requirements.txt has the readers for --python.
"""

import argparse
import collections
import concurrent.futures
import importlib
import itertools
import pathlib
import random
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER / "Surfaces")]

import compare  # noqa: E402
import explained  # noqa: E402
import pairwise  # noqa: E402
import readings  # noqa: E402
import workers  # noqa: E402

FORMATS = ["obj", "ply", "stl", "stl_binary", "vtk", "vtp", "3mf", "glb"]
SINGLE = 4e-7
# Readers of others: name -> formats and tolerance. Those of VTK are there once for each Python. MeshLab does not end on many variants
# of STL text and crashes on GLB files.
READERS = {
    "vtk": (("obj", "ply", "stl", "stl_binary", "vtk", "vtp", "glb"), SINGLE),
    "trimesh": (("obj", "ply", "stl", "stl_binary", "3mf", "glb"), SINGLE),
    "pymeshlab": (("obj", "ply", "stl_binary", "3mf"), SINGLE),
    "assimp": (("obj", "ply", "stl", "stl_binary", "3mf", "glb"), SINGLE),
    "lib3mf": (("3mf",), SINGLE),
}
# Give coordinates in the unit of the file, which lib3mf and the program make millimeters.
IN_UNIT_OF_FILE = ("trimesh", "pymeshlab", "assimp")
SEED = 48


class Variant:
    def __init__(self, number, choices, grammar, folder):
        self.choices = choices
        self.rounding = getattr(grammar, "ROUNDING", 0.0)
        content, self.truth = grammar.make(choices, random.Random(f"{SEED} {grammar.__name__} {number}"))
        self.path = folder / f"{number:05}.{grammar.EXTENSION}"
        self.path.write_bytes(content)


def make_variants(name, count, folder):
    """At least count; a count below those of all pairs gives some of them, evenly."""
    grammar = importlib.import_module("grammar_" + name)
    rows = list(enumerate(pairwise.variants(grammar.CHOICES, count, SEED, grammar.UNIFORM)))
    chosen = rows if count == 0 else [rows[i * len(rows) // count] for i in range(count)] if count < len(rows) else rows
    return [Variant(number, row, grammar, folder) for number, row in chosen]


def kinds_of(variant, found, tolerance):
    """tolerance: None for the program, which has every bit."""
    if found.get("error"):
        return [] if variant.truth.rejected else ["rejected"]
    if variant.truth.rejected:
        return ["not rejected"]
    try:
        used = variant.rounding if tolerance is None else tolerance
        return compare.differences(variant.truth, readings.reading_of(found), used, tolerance is None)
    except (ValueError, IndexError, TypeError, KeyError) as error:
        return ["unreadable: " + type(error).__name__]


def unit_of(reader, variant):
    """Of the points that a reader gives, in those of the truth."""
    if reader == "program" and variant.path.suffix == ".glb":
        return 1e-3  # the file is in meters, the program's result in millimeters
    return variant.truth.unit if reader in IN_UNIT_OF_FILE else 1.0


def in_unit_of_truth(found, unit):
    if unit != 1.0 and "points" in found:
        found["points"] = [[c * unit for c in point] for point in found["points"]]
    return found


def read_all(workers_of_reader, variants, tolerance, reader):
    """For each variant the kinds of differences, and the result if there are some; by the first worker that is there."""
    results = None
    for worker in workers_of_reader:
        results = results or worker.read_all([variant.path for variant in variants])
    rows = []
    for variant, found in zip(variants, results or []):
        found = in_unit_of_truth(found, unit_of(reader, variant))
        kinds = kinds_of(variant, found, tolerance)
        if reader == "program":  # the VTP that it writes has one type for both kinds of char
            kinds = [kind for kind in kinds if not kind.startswith("type of")]
        rows.append((kinds, found if kinds else None))
    return rows


class ProgramWorker:
    """The program itself: what it writes as --heatmap is the input as it was read."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def read_all(self, paths):
        heats = [self.folder / (path.stem + ".heat.vtp") for path in paths]
        errors = [self.run(path, heat) for path, heat in zip(paths, heats)]
        found = workers.worker_of(sys.executable, "vtk").read_all(heats)
        return [{"error": error} if error else surface for error, surface in zip(errors, found)]

    def run(self, path, heat):
        words = [self.program, path, self.folder / "out.vtp", "--heatmap", heat, "--target-reduction", "0", "--measure", "off"]
        done = subprocess.run(list(map(str, words)), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8", check=False)
        return done.stderr if done.returncode != 0 else ""


def other_readers(arguments, form):
    """name -> workers and tolerance, of this Python and of --python."""
    pythons = [sys.executable] + ([arguments.python] if arguments.python else [])
    found = {}
    for name, (forms, tolerance) in READERS.items():
        if form not in forms:
            continue
        keys = {name: pythons[::-1]} if name != "vtk" else dict(zip(("vtk of Debian", "vtk of PyPI"), [[p] for p in pythons]))
        for key, of_key in keys.items():
            if not arguments.readers or key in arguments.readers:
                found[key] = ([workers.worker_of(python, name) for python in of_key], tolerance)
    return found


def read_with_all(arguments, variants, form, folder):
    driver = str(pathlib.Path(arguments.program).with_name("bonedecimate-read-surfaces"))
    tasks = {"ours": ([workers.Worker([driver], False)], variants, None)}
    if arguments.by_program:
        some = variants[:: -(-len(variants) // arguments.by_program)]
        tasks["program"] = ([ProgramWorker(arguments.program, folder)], some, None)
    for name, (of_reader, tolerance) in other_readers(arguments, form).items() if not arguments.own else ():
        tasks[name] = (of_reader, variants, tolerance)
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        futures = {name: pool.submit(read_all, *task, name) for name, task in tasks.items()}
        results = {name: list(zip(tasks[name][1], future.result())) for name, future in futures.items()}
        return {name: rows for name, rows in results.items() if rows}


class Table:
    """Counts differences, and keeps those without an explanation."""

    def __init__(self, extension):
        self.extension = extension
        self.explained, self.unexplained = collections.Counter(), []
        self.used = collections.Counter()

    def add(self, reader, variant, kinds, found):
        for kind in kinds:
            reasons = [e for e in explained.EXPLAINED if e.covers(self.extension, reader, kind, variant.choices)]
            if reasons and reader not in ("ours", "program"):
                self.explained[reader] += 1
                self.used[reasons[0]] += 1
            else:
                self.unexplained.append((reader, kind, variant, found))


def analyze(table, all_results, grammar):
    """The choices that predict the differences without an explanation, to find their cause."""
    groups = collections.defaultdict(list)
    for reader, kind, variant, found in table.unexplained:
        groups[reader, kind].append((variant, found))

    def unusual(variant):
        return [i for i in variant.choices.items() if i[0] in grammar.UNIFORM or i[1] != grammar.CHOICES[i[0]][0]]

    for (reader, kind), members in sorted(groups.items(), key=lambda g: g[0]):
        members.sort(key=lambda m: len(unusual(m[0])))
        print(f"\n{reader}: {kind}, {len(members)} variants")
        failing = {id(v) for v, kinds in all_results[reader] if kinds[0]}
        everything = [v for v, _ in all_results[reader]]
        unknown = 0
        while members:
            variant, found = members[0]
            keys = predictors_of(unusual(variant), everything, failing)
            key = max(keys, key=lambda k: sum(has(v, k) for v, _ in members), default=None)
            covered = [m for m in members if key and has(m[0], key)] or members[:1]
            unknown += not key
            if unknown > 5:
                break
            error = str(found.get("error"))[:110].replace("\n", " ").replace(str(variant.path), "")
            print("   ", dict(key) if key else ("?", dict(unusual(variant))), len(covered), variant.path.name, error if kind == "rejected" else "")
            members = [m for m in members if m not in covered]


def has(variant, key):
    return all(variant.choices[name] == value for name, value in key)


def predictors_of(items, everything, failing):
    """Choices, alone or by two, with which every variant differs."""
    for size in (1, 2):
        found = [key for key in itertools.combinations(items, size) if all(id(v) in failing for v in everything if has(v, key))]
        if found:
            return found
    return []


def compare_format(arguments, name):
    """Prints a row of the table; how many differences have no explanation."""
    with tempfile.TemporaryDirectory(prefix="bonedecimate-formats-") as temporary:
        folder = pathlib.Path(arguments.keep or temporary) / name
        folder.mkdir(parents=True, exist_ok=True)
        variants = make_variants(name, arguments.variants, folder)
        results = read_with_all(arguments, variants, name, folder)
        table = Table(name)
        for reader, rows in results.items():
            for variant, (kinds, found) in rows:
                table.add(reader, variant, kinds, found)
        others = [r for r in results if r not in ("ours", "program")]
        own = sum(reader in ("ours", "program") for reader, *_ in table.unexplained)
        print(
            f"| {name} | {len(variants)} | {', '.join(others)} | {own} | {len(table.unexplained) - own} | {sum(table.explained.values())} |",
            flush=True,
        )
        if arguments.analyze:
            analyze(table, results, importlib.import_module("grammar_" + name))
    return table


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="bonedecimate; bonedecimate-read-surfaces is beside it")
    parser.add_argument("--format", action="append", choices=FORMATS, help="default: all")
    parser.add_argument("--variants", type=int, default=2000, help="0: all pairs and single values alone")
    parser.add_argument("--python", help="Python of the environment of requirements.txt")
    parser.add_argument("--readers", action="append", help="of others; default: all that are there")
    parser.add_argument("--by-program", type=int, default=40, help="variants that the program itself reads, too")
    parser.add_argument("--keep", help="folder for the files")
    parser.add_argument("--own", action="store_true", help="the program's readers alone")
    parser.add_argument("--analyze", action="store_true", help="which choices predict differences without an explanation")
    arguments = parser.parse_args()
    arguments.program = str(pathlib.Path(arguments.program).resolve())
    print("| format | variants | readers | faults of the program | differences of others | explained |\n|---|---:|---|---:|---:|---:|")
    tables = [compare_format(arguments, name) for name in arguments.format or FORMATS]
    return 1 if any(table.unexplained for table in tables) else 0


if __name__ == "__main__":
    sys.exit(main())
