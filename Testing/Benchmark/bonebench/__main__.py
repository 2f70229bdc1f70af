# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The one command: run.sh prepares programs and peers and calls this."""

from __future__ import annotations

import argparse
import json
import re
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from . import document, machine, pages, proved_errors, records, sections, thesis
from .bones import Bone, Workshop
from .contest import Contest, Verifier
from .contestants import Contestant, find_peers, our_contestants, our_modes
from .workers import Programs

Rows = tuple[tuple[str, tuple[float, ...]], ...]
THESIS_COUNTS = (65000.0, 40000.0, 10000.0, 1000.0)
FULL: Rows = (("maxilla", THESIS_COUNTS), ("frontal", THESIS_COUNTS), ("cranium", (134000.0,)))
PROVED_BONES = ("maxilla", "frontal", "cranium")
QUICK: Rows = (("maxilla", (10000.0,)), ("small-leg", (0.2,)))
SHORT: Rows = (("small-leg", (0.2,)),)


def arguments() -> argparse.Namespace:
    """The options of the command line."""
    parser = argparse.ArgumentParser(prog="run.sh", description="Our modes and other programs on the same bones.")
    parser.add_argument("--quick", action="store_true", help="one round: maxilla to 10,000 and a phantom")
    parser.add_argument("--short", action="store_true", help="one round of our modes on a phantom, no peers: a test")
    parser.add_argument("--growth", action="store_true", help="our modes on 0.1 to 10 million triangles, nothing else")
    parser.add_argument("--threads", action="store_true", help="our modes on 1, 2, 4 and 8 threads, nothing else")
    parser.add_argument("--thesis", action="store_true", help="our modes with the largest errors of the thesis, nothing else")
    parser.add_argument("--proved", action="store_true",
                        help="our modes with proved errors, nothing else")
    parser.add_argument("--bone", action="append", nargs="+", default=[], metavar="FILE [COUNT]",
                        help="a surface file and numbers of triangles (below 1: fractions; without: 0.1 0.02); without "
                             "--rows, only these")
    parser.add_argument("--rows", metavar="PATTERN", help="only the rows whose 'BONE COUNT' matches")
    parser.add_argument("--modes", metavar="A,B", help="only these of our modes")
    parser.add_argument("--peers", metavar="A,B", help="only these peers, by the keys in benchmark.json; none: no peers")
    parser.add_argument("--rounds", type=int, help="rounds of each contestant (3; --quick and --short: 1)")
    parser.add_argument("--samples", type=int, default=200000, help="samples in each direction (200000)")
    parser.add_argument("--largest", type=int, default=10_000_000, help="largest specimen of the growth (10000000)")
    parser.add_argument("--with-meshlib", action="store_true",
                        help="let MeshLib take part; its license is for non-commercial use")
    parser.add_argument("--output", type=Path, help="folder for figures, page and plots (BUILD/benchmark/results)")
    parser.add_argument("--from", dest="earlier", nargs="+", type=Path, metavar="JSON",
                        help="run nothing: page and plots again from the figures of earlier runs, put together")
    parser.add_argument("--write-docs", action="store_true",
                        help="write Documentation/results/benchmark.md, its data and images and the section of the README")
    parser.add_argument("--programs", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--work", type=Path, required=True, help=argparse.SUPPRESS)
    return parser.parse_args()


def choose_bones(options: argparse.Namespace, workshop: Workshop) -> list[Bone]:
    """The rows of this run."""
    rows: Rows = SHORT if options.short else QUICK if options.quick else FULL
    if options.growth or options.threads or options.proved or options.thesis or (options.bone and not options.rows):
        rows = ()
    bones = [workshop.bone(name, goals) for name, goals in rows]
    for file, *counts in options.bone:
        bones.append(workshop.file(Path(file), tuple(float(count) for count in counts) or (0.1, 0.02)))
    return [bone for bone in bones if bone is not None]


def run_rows(options: argparse.Namespace, bones: list[Bone], contest: Contest, peers: list[Contestant],
             figures: dict[str, Any]) -> None:
    """Every bone at every count; what is there is saved after each, for a full run takes hours."""
    ours = our_contestants(chosen_modes(options, figures["modes"]), our_modes(contest.programs, "parallel"),
                           (1,) if options.short else (1, 2))
    for bone in bones:
        for count in bone.counts():
            if not options.rows or re.search(options.rows, f"{bone.name} {count}"):
                begin = time.monotonic()
                figures["rows"].append(contest.hold(bone, count, peers, ours, figures["rounds"]))
                save(options, figures)
                print(f"  {bone.name} {count:,}: {time.monotonic() - begin:.0f} s", flush=True)


def run_sections(options: argparse.Namespace, workshop: Workshop, verifier: Verifier, figures: dict[str, Any], scratch: Path) -> None:
    """Growth, threads, proved errors and the thesis's error mode: all of them without other options."""
    whole = not (options.short or options.growth or options.threads or options.proved or options.thesis or options.quick
                 or options.bone or options.rows)
    programs, rounds, modes = workshop.programs, figures["rounds"], chosen_modes(options, figures["modes"])
    if whole or options.thesis:
        for name, errors in thesis.BY_ERROR.items():
            bone = workshop.bone(name, (1.0,))
            if bone is not None:
                figures["errors"] += sections.error_mode(programs, verifier, bone, modes, tuple(errors), scratch)
    if whole or options.proved:
        run_proved_errors(options, workshop, verifier, figures, scratch)
    if whole or options.threads:
        parallel = [mode for mode in our_modes(programs, "parallel") if mode in modes]
        candidate = workshop.bone("cranium", (134000.0,)) or workshop.bone("specimen-1000000", (0.2,))
        if candidate is not None:
            figures["threads"] = sections.threads(programs, candidate, parallel, rounds, scratch)
        save(options, figures)
    if whole or options.growth:
        sizes = [size for size in sections.GROWTH_SIZES if size <= options.largest]
        for row in sections.growth(programs, workshop, modes, sizes, rounds, scratch):
            figures["growth"].append(row)
            save(options, figures)
            print(f"  {row['triangles']:,} triangles {row['key']}: {row['seconds']:.2f} s", flush=True)


def run_proved_errors(options: argparse.Namespace, workshop: Workshop, verifier: Verifier, figures: dict[str, Any],
                      scratch: Path) -> None:
    """Our modes with a largest error, saved line by line."""
    programs = workshop.programs
    proving = chosen_modes(options, our_modes(programs, "proving"))
    for name in PROVED_BONES:
        bone = workshop.bone(name, (1.0,)) if not options.rows or re.search(options.rows, name) else None
        if bone is None:
            continue
        for row in proved_errors.with_error(programs, verifier, bone, proving, figures["rounds"], scratch):
            figures["proved"].append(row)
            save(options, figures)
            print(f"  {name} {row['error']} mm {row['mode']}, guard {row['guard']}: {row.get('triangles')}", flush=True)


def participants(options: argparse.Namespace, programs: Programs) -> tuple[list[Contestant], list[str]]:
    """The peers of this run, and a sentence for each thing that is missing or amiss."""
    alone = options.short or options.growth or options.threads or options.proved or options.thesis
    peers, missing = ([], []) if alone else find_peers(programs, options.with_meshlib)
    if options.peers is not None:
        peers = [peer for peer in peers if peer.key in options.peers.split(",")]
    if not programs.has("verify"):
        missing.append("bonedecimate-verify was not built (it needs Debian's libcgal-dev, libgmp-dev and libmpfr-dev): "
                       "times and memory only.")
    for line in missing:
        print(line)
    return peers, missing


def chosen_modes(options: argparse.Namespace, modes: list[str]) -> list[str]:
    """Those of our modes that take part."""
    return [mode for mode in modes if not options.modes or mode in options.modes.split(",")]


def measure(options: argparse.Namespace) -> dict[str, Any]:
    """All raw figures of the run."""
    programs, folder = Programs(options.programs.resolve()), options.work.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    workshop, verifier = Workshop(programs, folder), Verifier(programs, options.samples)
    peers, missing = participants(options, programs)
    bones = choose_bones(options, workshop)
    figures: dict[str, Any] = {
        "machine": machine.describe(), "modes": our_modes(programs), "samples": options.samples,
        "rounds": options.rounds or (1 if options.quick or options.short else 3),
        "parts": 1, "rows": [], "growth": [], "threads": [], "errors": [], "proved": [],
        "complaints": missing, "commits": [machine.commit()]}
    with tempfile.TemporaryDirectory(dir=folder) as name:  # of this run alone: another may be at work
        scratch = Path(name)
        run_rows(options, bones, Contest(programs, verifier, scratch), peers, figures)
        others = machine.Others()
        run_sections(options, workshop, verifier, figures, scratch)
    has_seconds = figures["growth"] or figures["threads"]  # others say of each figure what ran beside it
    figures["complaints"] = missing + workshop.complaints + [line for line in [others.complaint()] if line and has_seconds]
    return figures


def save(options: argparse.Namespace, figures: dict[str, Any]) -> Path:
    """The raw figures so far; returns their folder."""
    output: Path = (options.output or options.work / "results").resolve()
    output.mkdir(parents=True, exist_ok=True)
    (output / "benchmark.json").write_text(json.dumps(figures, indent=1), encoding="utf-8")
    return output


def put_together(files: list[Path]) -> dict[str, Any]:
    """The figures of several runs as one, and how many they were; machine and rounds are the first one's."""
    runs: list[dict[str, Any]] = [json.loads(file.read_text(encoding="utf-8")) for file in files]
    for key in ("rows", "growth", "threads", "errors", "proved"):
        runs[0][key] = [item for run in runs for item in run.get(key, [])]
    runs[0]["rows"] = quietest(runs[0]["rows"])
    runs[0]["commits"] = sorted({commit for run in runs for commit in run["commits"]})
    runs[0]["parts"] = sum(run.get("parts", 1) for run in runs)
    runs[0]["complaints"] = list(dict.fromkeys(line for run in runs for line in run["complaints"]))
    # Of how busy the machine was the worst counts; the sentences differ in that number alone.
    busy = sorted(line for line in runs[0]["complaints"] if line.startswith(machine.BUSY))
    runs[0]["complaints"] = [line for line in runs[0]["complaints"] if line not in busy[:-1]]
    rounds = sorted({run["rounds"] for run in runs})
    if len(rounds) > 1:
        runs[0]["complaints"].append(f"Some parts have {' or '.join(map(str, rounds))} rounds.")
    samples = sorted({run["samples"] for run in runs})
    if len(samples) > 1:
        runs[0]["complaints"].append(f"Some parts have {' or '.join(f'{count:,}' for count in samples)} samples a direction.")
    return runs[0]


def quietest(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Of runs of the same row the one with the least other load."""
    best: dict[tuple[str, int], dict[str, Any]] = {}
    for row in rows:
        key = row["bone"], row["requested"]
        if key not in best or row["others"] < best[key]["others"]:
            best[key] = row
    return list(best.values())


def draw(figures: dict[str, Any], folder: Path) -> list[str]:
    """The plots, if matplotlib is installed; returns the names of the files."""
    try:
        from . import plots
    except ImportError:
        print("matplotlib is missing: no plots")
        return []
    return [name for name, _ in plots.draw_all(figures, folder)]


def write(options: argparse.Namespace, figures: dict[str, Any]) -> None:
    """Raw figures, data files, page and plots; with --write-docs also into the source tree."""
    output = save(options, figures)
    records.write(output / document.DATA, figures)
    made = draw(figures, output)
    data, run = records.read(output / document.DATA)
    (output / "benchmark.md").write_text(document.page(data, run, made, "."), encoding="utf-8")
    print(f"{output}/benchmark.md, benchmark.json, {document.DATA} and {len(made)} plots")
    if options.write_docs:
        draw(figures, document.IMAGES)
        records.write(document.RESULTS / document.DATA, figures)
        pages.write()
        print(f"{document.RESULTS}/benchmark.md, {document.DATA} and the section of the README")


def main() -> int:
    """Measures and writes."""
    options = arguments()
    figures = put_together(options.earlier) if options.earlier else measure(options)
    if not any(figures[key] for key in ("rows", "growth", "threads", "errors", "proved")):
        print("nothing was measured:", *figures["complaints"])
        return 1
    write(options, figures)
    return 0


if __name__ == "__main__":
    sys.exit(main())
