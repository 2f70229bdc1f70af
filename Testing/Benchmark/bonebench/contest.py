# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A bone and a count: everybody in turn, round after round, and one judge for all results."""

from __future__ import annotations

import statistics
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .bones import Bone
from .contestants import Contestant
from .workers import Answer, Programs, ask


@dataclass
class Entry:
    """What one contestant did when asked for one number of triangles."""

    who: Contestant
    asked: int
    triangles: int = 0
    version: str = ""
    seconds: list[float] = field(default_factory=list)  # of the decimation call alone, a value per round
    cpu_seconds: list[float] = field(default_factory=list)  # of all threads
    input_bytes: int = 0  # what holding the input in the contestant's own structure costs
    peak_bytes: int = 0  # the most beyond that, over the rounds
    checksums: list[str] = field(default_factory=list)
    judged: dict[str, Any] = field(default_factory=dict)
    failure: str = ""

    def add(self, answer: Answer) -> None:
        """Takes in one round."""
        if "failure" in answer:
            self.failure = answer["failure"]
            return
        self.triangles = answer["triangles"]
        self.version = answer["version"]
        self.seconds.append(answer["seconds"])
        self.cpu_seconds.append(answer["cpu_seconds"])
        self.input_bytes = max(self.input_bytes, answer["input_bytes"])
        self.peak_bytes = max(self.peak_bytes, answer["peak_bytes"])
        if "checksum" in answer and answer["checksum"] not in self.checksums:
            self.checksums.append(answer["checksum"])

    def raw(self) -> dict[str, Any]:
        """For the JSON file."""
        return {
            "who": self.who.key, "name": self.who.name, "ours": self.who.ours, "mode": self.who.mode,
            "threads": self.who.threads, "through": self.who.through if self.who.ours else "", "asked": self.asked,
            "triangles": self.triangles, "version": self.version, "seconds": self.seconds,
            "median_seconds": statistics.median(self.seconds) if self.seconds else None,
            "cpu_seconds": self.cpu_seconds, "input_bytes": self.input_bytes, "peak_bytes": self.peak_bytes,
            "checksums": self.checksums, "judged": self.judged, "failure": self.failure}


@dataclass(frozen=True)
class Judge:
    """bonedecimate-verify; where it was not built nothing is judged."""

    programs: Programs
    samples: int

    def compare(self, original: Path, simplified: Path) -> dict[str, Any]:
        """Distances both ways, topology, quality, self-intersections of the result."""
        if not self.programs.has("verify"):
            return {}
        answer = ask([self.programs.path("verify"), original, simplified, "--samples", self.samples])
        return {} if "failure" in answer else answer

    def describe(self, surface: Path) -> dict[str, Any]:
        """Topology, quality and self-intersections of one surface."""
        if not self.programs.has("verify"):
            return {}
        answer = ask([self.programs.path("verify"), "--shape", surface])
        return {} if "failure" in answer else answer


class Contest:
    """One row: our modes run at exactly the counts that the peers ended with."""

    def __init__(self, programs: Programs, judge: Judge, folder: Path) -> None:
        self.programs = programs
        self.judge = judge
        self.folder = folder
        self.entries: dict[tuple[str, int], Entry] = {}

    def hold(self, bone: Bone, count: int, peers: list[Contestant], ours: list[Contestant],
             rounds: int) -> dict[str, Any]:
        """In turn: a peer, ours at its count if no peer before ended there, the next peer; then again."""
        self.entries = {}
        for _ in range(rounds):
            visited: set[int] = set()
            for peer in peers:
                reached = self._run(bone, peer, count).triangles
                if reached and reached not in visited:
                    self._run_ours(bone, ours, reached, first=not visited)
                    visited.add(reached)
            if not visited:
                self._run_ours(bone, ours, count, first=True)
        entries = list(self.entries.values())
        reference = next((entry.asked for entry in entries if entry.who.ours), count)
        return {"bone": bone.name, "input": {"triangles": bone.triangles, **self.judge.describe(bone.file)},
                "asked": count, "reference": reference, "entries": [entry.raw() for entry in entries]}

    def _run_ours(self, bone: Bone, ours: list[Contestant], count: int, first: bool) -> None:
        for contestant in ours:
            if first or contestant.through == "core":  # the filter differs in seconds alone: once a round
                self._run(bone, contestant, count)

    def _run(self, bone: Bone, who: Contestant, count: int) -> Entry:
        entry = self.entries.setdefault((who.key, count), Entry(who, count))
        if entry.failure:
            return entry
        result = self.folder / "result.ply"
        entry.add(who.run(self.programs, bone.file, result, count))
        if not entry.failure and not entry.judged:
            entry.judged = self._judged_before(entry) or self.judge.compare(bone.file, result)
        return entry

    def _judged_before(self, entry: Entry) -> dict[str, Any]:
        """Of an equal result, as two threads and the filter make it."""
        for other in self.entries.values():
            if other is not entry and other.judged and set(entry.checksums) & set(other.checksums):
                return other.judged
        return {}
