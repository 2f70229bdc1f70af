# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes variants of a format, reads each with ours and with the readers of others, and collects what differs."""

import collections
import dataclasses
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zlib

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import explained
import isolation
import pairwise
import truth

TYPES = {"unsigned char": np.uint8, "signed char": np.int8, "short": np.int16, "unsigned short": np.uint16, "int": np.int32,
         "unsigned int": np.uint32, "long long": np.int64, "unsigned long long": np.uint64, "float": np.float32,
         "double": np.float64, "long": np.int64, "unsigned long": np.uint64, "char": np.int8}
AT_ONCE = 100  # variants in files at the same time
TRUTH = "the generator"


@dataclasses.dataclass
class Difference:
    reader: str
    kind: str  # of explained.KINDS
    number: int  # of the variant
    choice: dict
    detail: str = ""


@dataclasses.dataclass
class Result:
    format: str
    variants: int = 0
    read: int = 0  # by ours
    readers: dict = dataclasses.field(default_factory=dict)  # name: how many variants it read
    found: list = dataclasses.field(default_factory=list)  # differences that are not explained
    explained: collections.Counter = dataclasses.field(default_factory=collections.Counter)


def variant_seed(name, number):
    return zlib.crc32(f"{name} {number}".encode())


def read_ours(driver, files):
    """@param files (path, truth) of each. @return A Reading or a sentence for each, in this order."""
    lines = []
    for number, (path, expected) in enumerate(files):
        words = [str(path), str(path.parent) + f"/ours{number}.bin", *(f"{value:.17g}" for value in expected.spacing)]
        lines.append("\t".join(words))
    completed = subprocess.run([driver], input="\n".join(lines) + "\n", check=True, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, encoding="utf-8", errors="surrogateescape")
    return [reading_of(json.loads(line), words.split("\t")[1]) for line, words in zip(completed.stdout.splitlines(), lines)]


def reading_of(found, voxels):
    if found["problem"]:
        return found["problem"]
    array = np.fromfile(voxels, TYPES[found["type"]]).reshape(found["size"], order="F")
    os.remove(voxels)
    segments = [(one["label"], one["name"], one["color"]) for one in found["segments"]]
    labels = {"steps": found["labels"].get("steps")}
    layers = np.array(found["layers"]) if found["layers"] else None
    return truth.Reading(array, np.array(found["origin"]), np.array(found["steps"]), segments, found["note"], layers, labels)


def against_truth(ours, expected):
    """(kind, detail) of each difference."""
    if expected.rejected:
        if not isinstance(ours, str):
            return [("reads", expected.rejected)]
        fits = any(part in ours for part in expected.rejected.split("|"))
        return [] if fits else [("sentence", ours)]
    if isinstance(ours, str):
        return [("rejects", ours)]
    kinds = [(kind, "") for kind in truth.differences(ours, expected) + truth.label_differences(ours, expected)]
    kinds += [("note", f"{part}: {ours.note}") for part in expected.notes if part not in ours.note]
    return kinds + ([("note", ours.note)] if ours.note and not expected.notes else [])


def against_other(other, ours, expected):
    """(kind, detail) of each difference of another reader from ours."""
    if isinstance(other, truth.NotRead):
        return [] if isinstance(ours, str) else [("rejects", str(other))]
    if isinstance(ours, str):
        return [("reads", ours)]
    if expected.spacing:  # which the other one does not know
        other.origin = None
    if other.is_in_units and other.origin is not None:
        other.origin, other.steps = other.origin * expected.unit, other.steps * expected.unit
    if other.is_turned and other.origin is not None and np.linalg.det(ours.steps) * np.linalg.det(other.steps) < 0:
        other = truth.reversed_layers(other)
    if other.is_label_map and ours.labels["steps"] is not None:
        ours = dataclasses.replace(ours, steps=np.array(ours.labels["steps"]))
    return [(kind, "") for kind in truth.differences(other, ours)]


def compare_one(result, number, choice, expected, ours, others):
    """@param others What the readers of others found, by name."""
    differences = [Difference(TRUTH, kind, number, choice, detail) for kind, detail in against_truth(ours, expected)]
    result.read += 0 if isinstance(ours, str) else 1
    for name, other in others.items():
        result.readers[name] = result.readers.get(name, 0) + (not isinstance(other, truth.NotRead))
        differences += [Difference(name, kind, number, choice, detail) for kind, detail in against_other(other, ours, expected)]
    for difference in differences:
        reason = explained.reason(result.format, difference) if difference.reader != TRUTH else ""
        if reason:
            result.explained[(difference.reader, difference.kind, reason)] += 1
        else:
            result.found.append(difference)


def compare(name, module, readers, count, driver, only=None, keep=None):
    """@param only Numbers of variants; None: all. @param keep A folder that gets the files of differences."""
    rows = list(enumerate(pairwise.uniform_variants(module.CHOICES, count, variant_seed(name, 0))))[: max(count, 1)]
    rows = [row for row in rows if only is None or row[0] in only]
    result = Result(name, len(rows))
    for first in range(0, len(rows), AT_ONCE):
        with tempfile.TemporaryDirectory(prefix="bonedecimate-test-") as temporary:
            some = rows[first:first + AT_ONCE]
            files = []
            for number, choice in some:
                folder = pathlib.Path(temporary) / str(number)
                folder.mkdir()
                files.append(module.write(folder, choice, np.random.default_rng(variant_seed(name, number + 1))))
            ours = read_ours(driver, files)
            paths = [(path, choice) for (path, _truth), (_number, choice) in zip(files, some)]
            others = {reader: isolation.read_all(read, paths) for reader, read in readers.items()}
            for i, (number, choice) in enumerate(some):
                before = len(result.found)
                compare_one(result, number, choice, files[i][1], ours[i], {reader: found[i] for reader, found in others.items()})
                if keep and len(result.found) > before:
                    shutil.copytree(pathlib.Path(temporary) / str(number), pathlib.Path(keep) / f"{name}-{number}", dirs_exist_ok=True)
    return result


def common_choices(differences, rows):
    """The choices that lead to differences more often than all others: where to look."""
    numbers = {difference.number for difference in differences}
    rates = []
    for name in rows[0][1]:
        for value in {repr(choice[name]) for _number, choice in rows}:
            those = [number for number, choice in rows if repr(choice[name]) == value]
            hits = sum(number in numbers for number in those)
            rates.append((hits / len(those), f"{name} = {value} ({hits} of {len(those)})"))
    return "; ".join(text for _rate, text in sorted(rates, reverse=True)[:5])


def print_found(result, module, count):
    rows = list(enumerate(pairwise.uniform_variants(module.CHOICES, count, variant_seed(result.format, 0))))
    groups = collections.defaultdict(list)
    for difference in result.found:
        words = difference.detail.split(":")[0] if difference.reader != TRUTH else difference.detail
        groups[(difference.reader, difference.kind, words[:120])].append(difference)
    for (reader, kind, words), differences in sorted(groups.items(), key=lambda item: -len(item[1])):
        print(f"{result.format}: {reader}: {kind} {words}: {len(differences)} variants, first {differences[0].number} "
              f"{differences[0].detail}\n    {common_choices(differences, rows)}")
