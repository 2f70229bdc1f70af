# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A bone and a number of triangles: all programs in turn, round after round, and one verifier for all results."""

from __future__ import annotations

import statistics
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from . import machine
from .bones import Bone
from .contestants import Contestant
from .workers import Outcome, Programs, call

TOO_MANY = 1.02  # times the requested number of triangles


@dataclass
class Entry:
    """The runs of one program at one requested number of triangles."""

    contestant: Contestant
    requested: int
    triangles: int = 0
    version: str = ""
    seconds: list[float] = field(default_factory=list)  # of the decimation call alone, a value per round
    cpu_seconds: list[float] = field(default_factory=list)  # of all threads
    input_bytes: int = 0  # what holding the input in the contestant's own structure costs
    peak_bytes: int = 0  # the most beyond that, over the rounds
    checksums: list[str] = field(default_factory=list)
    measured: dict[str, Any] = field(default_factory=dict)
    failure: str = ""

    def add(self, outcome: Outcome) -> None:
        """Takes in one round."""
        if "failure" in outcome:
            self.failure = outcome["failure"]
            return
        self.triangles = outcome["triangles"]
        self.version = outcome["version"]
        self.seconds.append(outcome["seconds"])
        self.cpu_seconds.append(outcome["cpu_seconds"])
        self.input_bytes = max(self.input_bytes, outcome["input_bytes"])
        self.peak_bytes = max(self.peak_bytes, outcome["peak_bytes"])
        if "checksum" in outcome and outcome["checksum"] not in self.checksums:
            self.checksums.append(outcome["checksum"])

    def raw(self) -> dict[str, Any]:
        """For the JSON file."""
        return {
            "key": self.contestant.key, "name": self.contestant.name, "ours": self.contestant.ours,
            "mode": self.contestant.mode, "threads": self.contestant.threads,
            "through": self.contestant.through if self.contestant.ours else "", "requested": self.requested,
            "triangles": self.triangles, "version": self.version, "seconds": self.seconds,
            "median_seconds": statistics.median(self.seconds) if self.seconds else None,
            "cpu_seconds": self.cpu_seconds, "input_bytes": self.input_bytes, "peak_bytes": self.peak_bytes,
            "checksums": self.checksums, "measured": self.measured, "failure": self.failure}


@dataclass(frozen=True)
class Verifier:
    """bonedecimate-verify; without it nothing is measured."""

    programs: Programs
    samples: int

    def compare(self, original: Path, simplified: Path) -> dict[str, Any]:
        """Distances both ways, topology, quality, self-intersections of the result."""
        if not self.programs.has("verify"):
            return {}
        outcome = call([self.programs.path("verify"), original, simplified, "--samples", self.samples])
        return {} if "failure" in outcome else outcome

    def describe(self, surface: Path) -> dict[str, Any]:
        """Topology, quality and self-intersections of one surface."""
        if not self.programs.has("verify"):
            return {}
        outcome = call([self.programs.path("verify"), "--shape", surface])
        return {} if "failure" in outcome else outcome


class Contest:
    """One row: the peers, then our modes at the fewest triangles that any of them ended with."""

    def __init__(self, programs: Programs, verifier: Verifier, folder: Path) -> None:
        self.programs = programs
        self.verifier = verifier
        self.folder = folder
        self.entries: dict[str, Entry] = {}

    def hold(self, bone: Bone, count: int, peers: list[Contestant], ours: list[Contestant],
             rounds: int) -> dict[str, Any]:
        """All in turn, then again. A peer that stops far above the requested number of triangles does not count."""
        self.entries, others = {}, machine.Others()
        for _ in range(rounds):
            ends = [self._run(bone, peer, count).triangles for peer in peers]
            fewest = min((end for end in ends if 0 < end <= TOO_MANY * count), default=count)
            for contestant in ours:
                self._run(bone, contestant, fewest)
        return {"bone": bone.name, "input": {"triangles": bone.triangles, **self.verifier.describe(bone.file)},
                "requested": count, "others": others.cores(), "entries": [entry.raw() for entry in self.entries.values()]}

    def _run(self, bone: Bone, contestant: Contestant, count: int) -> Entry:
        entry = self.entries.setdefault(contestant.key, Entry(contestant, count))
        if entry.failure:
            return entry
        result = self.folder / "result.ply"
        entry.add(contestant.run(self.programs, bone.file, result, count))
        if not entry.failure and not entry.measured:
            entry.measured = self._measured_before(entry) or self.verifier.compare(bone.file, result)
        return entry

    def _measured_before(self, entry: Entry) -> dict[str, Any]:
        """Of an equal result, as two threads and the filter make it."""
        for other in self.entries.values():
            if other is not entry and other.measured and set(entry.checksums) & set(other.checksums):
                return other.measured
        return {}
