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

from . import document, machine, promises, sections, thesis
from .bones import Bone, Workshop
from .contest import Contest, Judge
from .contestants import Contestant, find_peers, our_contestants, our_modes
from .workers import Programs

ROOT = Path(__file__).resolve().parents[3]
Rows = tuple[tuple[str, tuple[float, ...]], ...]
THESIS_COUNTS = (65000.0, 40000.0, 10000.0, 1000.0)
FULL: Rows = (("maxilla", THESIS_COUNTS), ("frontal", THESIS_COUNTS), ("cranium", (134000.0,)), ("vault", (0.2, 0.05)),
              ("leg", (0.2, 0.05)), ("specimen-1000000", (0.2,)))
PROMISED_BONES = (("maxilla", 10000.0), ("frontal", 10000.0), ("vault", 2000.0), ("cranium", 134000.0))
QUICK: Rows = (("maxilla", (10000.0,)), ("small-leg", (0.2,)))
SHORT: Rows = (("small-leg", (0.2,)),)


def arguments() -> argparse.Namespace:
    """What may be asked for."""
    parser = argparse.ArgumentParser(prog="run.sh", description="Our modes and other programs on the same bones.")
    parser.add_argument("--quick", action="store_true", help="one round: maxilla to 10,000 and a phantom")
    parser.add_argument("--short", action="store_true", help="one round of our modes on a phantom, no peers: a test")
    parser.add_argument("--growth", action="store_true", help="our modes on 0.1 to 10 million triangles, nothing else")
    parser.add_argument("--threads", action="store_true", help="our modes on 1, 2, 4 and 8 threads, nothing else")
    parser.add_argument("--promises", action="store_true", help="our modes asked for proved errors, peers beside them, nothing else")
    parser.add_argument("--bone", action="append", nargs="+", default=[], metavar="FILE [COUNT]",
                        help="a surface file and numbers of triangles (below 1: shares; without: 0.1 0.02); without "
                             "--rows, only these")
    parser.add_argument("--rows", metavar="PATTERN", help="only the rows whose 'BONE COUNT' matches")
    parser.add_argument("--modes", metavar="A,B", help="only these of our modes")
    parser.add_argument("--peers", metavar="A,B", help="only these peers, by the keys in benchmark.json; none: nobody")
    parser.add_argument("--rounds", type=int, help="rounds of each contestant (3; --quick and --short: 1)")
    parser.add_argument("--samples", type=int, default=200000, help="samples of the judge a direction (200000)")
    parser.add_argument("--largest", type=int, default=10_000_000, help="largest specimen of the growth (10000000)")
    parser.add_argument("--with-meshlib", action="store_true",
                        help="let MeshLib take part; its licence is for non-commercial use")
    parser.add_argument("--output", type=Path, help="folder for figures, page and plots (BUILD/benchmark/results)")
    parser.add_argument("--from", dest="earlier", nargs="+", type=Path, metavar="JSON",
                        help="run nothing: page and plots again from the figures of earlier runs, put together")
    parser.add_argument("--write-docs", action="store_true",
                        help="write Documentation/benchmark.md, its images and the README's section")
    parser.add_argument("--programs", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--work", type=Path, required=True, help=argparse.SUPPRESS)
    return parser.parse_args()


def choose_bones(asked: argparse.Namespace, workshop: Workshop) -> list[Bone]:
    """The rows of this run."""
    wanted: Rows = SHORT if asked.short else QUICK if asked.quick else FULL
    if asked.growth or asked.threads or asked.promises or (asked.bone and not asked.rows):
        wanted = ()
    bones = [workshop.bone(name, goals) for name, goals in wanted]
    for file, *counts in asked.bone:
        bones.append(workshop.file(Path(file), tuple(float(count) for count in counts) or (0.1, 0.02)))
    return [bone for bone in bones if bone is not None]


def run_rows(asked: argparse.Namespace, bones: list[Bone], contest: Contest, peers: list[Contestant],
             figures: dict[str, Any]) -> None:
    """Every bone at every count; what is there is saved after each, for a full run takes hours."""
    ours = our_contestants(chosen_modes(asked, figures["modes"]), (1,) if asked.short else (1, 2))
    for bone in bones:
        for count in bone.counts():
            if not asked.rows or re.search(asked.rows, f"{bone.name} {count}"):
                begin = time.monotonic()
                figures["rows"].append(contest.hold(bone, count, peers, ours, figures["rounds"]))
                save(asked, figures)
                print(f"  {bone.name} {count:,}: {time.monotonic() - begin:.0f} s", flush=True)


def run_sections(asked: argparse.Namespace, workshop: Workshop, judge: Judge, bones: list[Bone],
                 peers: list[Contestant], figures: dict[str, Any], scratch: Path) -> None:
    """Growth, threads, proved errors and the thesis's error mode: all of them when nothing particular is asked for."""
    whole = not (asked.short or asked.growth or asked.threads or asked.promises or asked.quick or asked.bone or asked.rows)
    programs, rounds, modes = workshop.programs, figures["rounds"], chosen_modes(asked, figures["modes"])
    if whole:
        for bone in bones:
            if bone.name in thesis.BY_ERROR:
                figures["errors"] += sections.error_mode(
                    programs, judge, bone, modes, tuple(thesis.BY_ERROR[bone.name]), scratch)
    if whole or asked.promises:
        run_promises(asked, workshop, judge, peers, figures, scratch)
    if whole or asked.threads:
        parallel = [mode for mode in modes if mode != "Thesis"]
        candidate = workshop.bone("cranium", (134000.0,)) or workshop.bone("specimen-1000000", (0.2,))
        if candidate is not None:
            figures["threads"] = sections.threads(programs, candidate, parallel, rounds, scratch)
        save(asked, figures)
    if whole or asked.growth:
        sizes = [size for size in sections.GROWTH_SIZES if size <= asked.largest]
        for row in sections.growth(programs, workshop, modes, sizes, rounds, scratch):
            figures["growth"].append(row)
            save(asked, figures)
            print(f"  {row['triangles']:,} triangles {row['who']}: {row['seconds']:.2f} s", flush=True)


def run_promises(asked: argparse.Namespace, workshop: Workshop, judge: Judge, peers: list[Contestant],
                 figures: dict[str, Any], scratch: Path) -> None:
    """Ours and the peers', saved line by line: trials take long."""
    programs = workshop.programs
    proving = [mode for mode in chosen_modes(asked, figures["modes"]) if mode != "Thesis"]
    for name, count in PROMISED_BONES:
        bone = workshop.bone(name, (count,)) if not asked.rows or re.search(asked.rows, f"{name} {count}") else None
        if bone is None:
            continue
        for row in promises.our_promises(programs, judge, bone, proving, scratch):
            figures["promises"].append(row)
            save(asked, figures)
            print(f"  {name} {row['error']} mm {row['mode']}, guard {row['guard']}: {row.get('triangles')}", flush=True)
        for row in promises.of_peers(programs, judge, bone, peers, scratch):
            figures["promises_of_peers"].append(row)
            save(asked, figures)
            print(f"  {name} {row['error']} mm {row['name']}: {row['by_trial'].get('triangles')} by trial", flush=True)


def who_takes_part(asked: argparse.Namespace, programs: Programs) -> tuple[list[Contestant], list[str]]:
    """The peers of this run, and a sentence for each thing that is missing or amiss."""
    alone = asked.short or asked.growth or asked.threads
    peers, missing = ([], []) if alone else find_peers(programs, asked.with_meshlib)
    if asked.peers is not None:
        peers = [peer for peer in peers if peer.key in asked.peers.split(",")]
    if not programs.has("verify"):
        missing.append("bonedecimate-verify was not built (it needs Debian's libcgal-dev, libgmp-dev and libmpfr-dev): "
                       "times and memory only.")
    for line in missing:
        print(line)
    return peers, missing


def chosen_modes(asked: argparse.Namespace, modes: list[str]) -> list[str]:
    """Those of our modes that take part."""
    return [mode for mode in modes if not asked.modes or mode in asked.modes.split(",")]


def measure(asked: argparse.Namespace) -> dict[str, Any]:
    """All raw figures of the run."""
    programs, folder = Programs(asked.programs.resolve()), asked.work.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    others = machine.Others()
    workshop, judge = Workshop(programs, folder), Judge(programs, asked.samples)
    peers, missing = who_takes_part(asked, programs)
    bones = choose_bones(asked, workshop)
    figures: dict[str, Any] = {
        "machine": machine.describe(), "modes": our_modes(programs), "samples": asked.samples,
        "rounds": asked.rounds or (1 if asked.quick or asked.short else 3),
        "parts": 1, "rows": [], "growth": [], "threads": [], "errors": [], "promises": [],
        "promises_of_peers": [], "complaints": missing}
    with tempfile.TemporaryDirectory(dir=folder) as name:  # of this run alone: another may be at work
        scratch = Path(name)
        run_rows(asked, bones, Contest(programs, judge, scratch), peers, figures)
        run_sections(asked, workshop, judge, bones, peers, figures, scratch)
    figures["complaints"] = missing + workshop.complaints + [line for line in [others.complaint()] if line]
    return figures


def save(asked: argparse.Namespace, figures: dict[str, Any]) -> Path:
    """The raw figures so far; returns their folder."""
    output: Path = (asked.output or asked.work / "results").resolve()
    output.mkdir(parents=True, exist_ok=True)
    (output / "benchmark.json").write_text(json.dumps(figures, indent=1), encoding="utf-8")
    return output


def put_together(files: list[Path]) -> dict[str, Any]:
    """The figures of several runs as one, and how many they were; machine and rounds are the first one's."""
    runs: list[dict[str, Any]] = [json.loads(file.read_text(encoding="utf-8")) for file in files]
    for key in ("rows", "growth", "threads", "errors", "promises", "promises_of_peers"):
        runs[0][key] = [item for run in runs for item in run.get(key, [])]
    runs[0]["parts"] = sum(run.get("parts", 1) for run in runs)
    runs[0]["complaints"] = list(dict.fromkeys(line for run in runs for line in run["complaints"]))
    # Of how busy the machine was the worst counts; the sentences differ in that number alone.
    busy = sorted(line for line in runs[0]["complaints"] if line.startswith(machine.BUSY))
    runs[0]["complaints"] = [line for line in runs[0]["complaints"] if line not in busy[:-1]]
    rounds = sorted({run["rounds"] for run in runs})
    if len(rounds) > 1:
        runs[0]["complaints"].append(f"Parts of it have {' or '.join(map(str, rounds))} rounds.")
    samples = sorted({run["samples"] for run in runs})
    if len(samples) > 1:
        runs[0]["complaints"].append(f"Parts of it have {' or '.join(f'{count:,}' for count in samples)} samples a direction.")
    return runs[0]


def draw(figures: dict[str, Any], folder: Path) -> list[tuple[str, str]]:
    """The plots, where matplotlib is."""
    try:
        from . import plots
    except ImportError:
        print("matplotlib is not here: no plots")
        return []
    return plots.draw_all(figures, folder)


def write(asked: argparse.Namespace, figures: dict[str, Any]) -> None:
    """Raw figures, page and plots; with --write-docs also into the source tree."""
    output = save(asked, figures)
    made = draw(figures, output)
    (output / "benchmark.md").write_text(document.page(figures, made, "."), encoding="utf-8")
    print(f"{output}/benchmark.md, benchmark.json and {len(made)} plots")
    if asked.write_docs:
        pages = ROOT / "Documentation"
        made = draw(figures, pages / "images")
        (pages / "benchmark.md").write_text(document.page(figures, made, "images"), encoding="utf-8")
        if figures["rows"]:
            document.write_readme(ROOT / "README.md", document.readme_section(figures, made))
        print(f"{pages}/benchmark.md and the README's section")


def main() -> int:
    """Measures and writes."""
    asked = arguments()
    figures = put_together(asked.earlier) if asked.earlier else measure(asked)
    if not any(figures[key] for key in ("rows", "growth", "threads", "promises", "promises_of_peers")):
        print("nothing was measured:", *figures["complaints"])
        return 1
    write(asked, figures)
    return 0


if __name__ == "__main__":
    sys.exit(main())
