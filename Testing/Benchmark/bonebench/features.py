# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of single features: a CSV file a table. Runs of the program are on one thread.

    python3 -m bonebench.features --programs FOLDER --work FOLDER [--write-docs] [--bone FILE ...] [--skull FILE] [TABLE ...]

The tables are parts of pages in Documentation/results, which pages.py writes from the files.
"""

from __future__ import annotations

import argparse
import array
import itertools
import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterator, Sequence

from . import browser_times, certify_times, file_sizes, machine, normal_tolerances, pages, peer_features, processes
from .bones import CROPS, HU, Bone, Workshop, count_triangles
from .contest import Verifier
from .document import DATA, RESULTS
from .records import BACK, THERE, Record, text, write_file
from .workers import Programs

Row = dict[str, Any]
CROPS_OF_VOXELS = ("vault", "thin bone")
BONES = ("maxilla", "frontal")  # without --bone


@dataclass(frozen=True)
class Done:
    """A run that ended well: its report, processor seconds of the process and its largest memory."""

    report: dict[str, Any]
    cpu_seconds: float
    megabytes: float

    def below(self, degrees: int) -> int:
        """Triangles of the result with a smallest angle below a multiple of 10 degrees."""
        return sum(self.report["output"]["shape"]["smallest_angles"][:degrees // 10])

    @property
    def triangles(self) -> int:
        """Of the result."""
        return self.report["output"]["triangles"]


@dataclass(frozen=True)
class Lab:
    """Programs, bones and a folder for results."""

    programs: Programs
    workshop: Workshop
    verifier: Verifier
    folder: Path
    names: Sequence[str]  # of bones, or files
    skull: Path | None  # a surface with non-manifold edges
    python: str  # with the VTK of the filters
    with_meshlib: bool
    is_large: bool  # with surfaces of 10^7 and 10^8 triangles

    def use_filters(self) -> None:
        """Lets programs of Python find the filters."""
        os.environ["PYTHONPATH"] = str(self.programs.folder.parent / "lib" / "python3" / "dist-packages")

    def bone(self, name: str) -> Bone:
        """A bone of the CT, which has to be there."""
        bone = self.workshop.bone(name, (1.0,))
        if bone is None:
            sys.exit(self.workshop.complaints[-1])
        return bone

    def bones(self) -> list[Bone]:
        """Those that the caller chose."""
        found = [self.workshop.file(Path(name), (1.0,)) if Path(name).is_file() else self.bone(name) for name in self.names]
        return [bone for bone in found if bone]

    def run(self, source: Path, *options: object, result: str = "result.ply", command: str = "") -> Done:
        """The program with its report; the result stays until the next run."""
        report = self.folder / "report.json"
        words = [self.programs.folder / "bonedecimate", command, source, "" if command else self.folder / result, *options, "--quiet"]
        words += [] if command else ["--threads", 1, "--report", report]
        process = subprocess.Popen([str(word) for word in words if word != ""], stdout=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"{' '.join(map(str, words))} ended with {process.returncode}")
        said = {} if command else json.loads(report.read_text(encoding="utf-8"))
        return Done(said, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)

    def distances(self, source: Path, result: Path | None = None) -> Row:
        """Of the result, by the independent verifier: the larger of both directions."""
        measured = self.verifier.compare(source, result or self.folder / "result.ply")
        ways = (measured[THERE], measured[BACK])
        return {"mean, mm": max(way["average"] for way in ways), "RMS, mm": max(way["rms"] for way in ways), "Hausdorff, mm": measured["hausdorff"]}

    def crop(self, name: str) -> Path:
        """The bone of a part of the CT as a label map."""
        self.bone("cranium")  # unpacks the CT
        voxels = (self.workshop.folder / "matrix.dat").read_bytes()
        (x0, x1), (y0, y1), (z0, z1) = CROPS[name]
        rows = (array.array("h", voxels[2 * (x0 + 256 * (y + 256 * z)):2 * (x1 + 256 * (y + 256 * z))])
                for z in range(z0, z1) for y in range(y0, y1))
        header = self.folder / f"{name.replace(' ', '-')}.mhd"
        header.with_suffix(".raw").write_bytes(bytes(value >= HU for row in rows for value in row))
        header.write_text(f"ObjectType = Image\nNDims = 3\nDimSize = {x1 - x0} {y1 - y0} {z1 - z0}\nElementSpacing = 0.9570312 0.9570312 1.5\n"
                          f"ElementType = MET_UCHAR\nElementDataFile = {header.stem}.raw\n", encoding="ascii")
        return header


def angles(lab: Lab) -> Iterator[Row]:
    """What a least angle costs at 0.5 mm."""
    for bone, mode in itertools.product(lab.bones(), ("Fast", "Balanced")):
        row: Row = {"input": bone.name, "input triangles": bone.triangles, "mode": f"`{mode}`"}
        for degrees in (0, 20, 30):
            done = lab.run(bone.file, "--mode", mode, "--max-error", 0.5, "--min-angle", degrees, "--measure", "off")
            row[f"{degrees} degrees: triangles"] = done.triangles
            if degrees:
                row[f"below {degrees}"] = done.below(degrees)
        yield row


def angles_by_count(lab: Lab) -> Iterator[Row]:
    """What a least angle costs at a number of triangles."""
    bone = lab.bone("maxilla")
    for degrees in (0, 10, 15, 20, 25):
        done = lab.run(bone.file, "--mode", "Balanced", "--target-triangles", 10000, "--min-angle", degrees, "--measure", "off")
        yield {"degrees": degrees, "triangles": done.triangles, **lab.distances(bone.file),
               "mean radius ratio": done.report["output"]["shape"]["mean_radius_ratio"], "triangles below 20 degrees": done.below(20)}


def lengths(lab: Lab) -> Iterator[Row]:
    """Edges of one length, and of a length that follows the curvature."""
    for bone, (length, chord) in itertools.product(lab.bones(), ((3, None), (6, 0.2), (2, None), (5, 0.2))):
        chordal = ("--chordal-error", chord) if chord else ()
        done = lab.run(bone.file, "--mode", "Fast", "--max-error", 0.5, "--edge-length", length, *chordal, "--measure", "off")
        quality = lab.verifier.describe(lab.folder / "result.ply")["quality"]
        yield {"input": bone.name, "EdgeLength, mm": length, "ChordalError, mm": chord, "triangles": done.triangles, "quality": quality,
               **lab.distances(bone.file)}


def voxels(lab: Lab) -> Iterator[Row]:
    """What it costs that every voxel keeps its label."""
    for name, error, keep in itertools.product(CROPS_OF_VOXELS, (0.25, 0.478, 0.957), ("off", "on")):
        done = lab.run(lab.crop(name), "--segments", "all", "--format", "ply", "--max-error", error, "--keep-voxels", keep, "--measure", "off",
                       result="labels")
        yield {"crop": name, "input triangles": done.report["input"]["triangles"], "largest error, mm": error, "KeepVoxels": keep,
               "triangles": done.triangles, "voxels changed": done.report["voxels"]["changed"], "CPU s": done.cpu_seconds}


def tunnels(lab: Lab) -> Iterator[Row]:
    """The maxilla with few triangles, with and without its tunnels."""
    bone = lab.bone("maxilla")
    for size in (0, 2, 5):
        options = ("--close-tunnels", size) if size else ()
        done = lab.run(bone.file, "--mode", "Balanced", "--target-triangles", 1000, *options, "--measure", "off")
        said = done.report.get("tunnels", {})
        yield {"size, mm": size or None, "tunnels closed": said.get("closed"), "left": sum(said["left"].values()) if said else None,
               "tunnels.distance, mm": said.get("distance"), "triangles": done.triangles, **lab.distances(bone.file)}


def levels(lab: Lab) -> Iterator[Row]:
    """One recorded run, and its levels beside runs of their own."""
    bone = lab.bone("cranium")
    counts = (420382, 265242, 167357, 105595, 66626)
    found: dict[int, Row] = {count: {"triangles": count} for count in counts}
    for mode in ("Fast", "Balanced"):
        lab.run(bone.file, "--mode", mode, "--triangles", ",".join(map(str, counts)), "--output", lab.folder / "level.ply", "--no-errors",
                command="levels")
        for count in counts:
            level = next(file for file in lab.folder.glob("level-*.ply") if abs(count_triangles(file) - count) <= 1)
            found[count][f"level, `{mode}`: mean, mm"] = lab.distances(bone.file, level)["mean, mm"]
            lab.run(bone.file, "--mode", mode, "--target-triangles", count, "--measure", "off")
            found[count][f"a run, `{mode}`: mean, mm"] = lab.distances(bone.file)["mean, mm"]
    yield from found.values()


def slabs(lab: Lab) -> Iterator[Row]:
    """Volumes that are read in parts: their side in voxels, and the memory."""
    volume = lab.folder / "trabeculae.mha"
    large = [(860, "2G"), (1500, "4G")] if lab.is_large else []
    made = None
    for side, memory in [(320, None), (320, "512M"), (320, "256M"), *large]:
        if side != made:
            subprocess.run([lab.programs.path("phantom"), volume, "--trabeculae", str(side)], check=True, stdout=subprocess.DEVNULL)
            made = side
        options = ("--memory", memory) if memory else ()
        done = lab.run(volume, "--iso", 127.5, "--mode", "Fast", "--max-error", "halfvoxel", "--measure", "off", *options)
        yield {"--trabeculae": side, "triangles of the volume": done.report["input"]["triangles"], "--memory": memory, "slabs": done.report.get("slabs", {}).get("count"),
               "triangles": done.triangles, "proved, mm": done.report["proof"]["upper"], "CPU s": done.cpu_seconds,
               "largest memory, MB": round(done.megabytes)}
    volume.unlink()


def non_manifold(lab: Lab) -> Iterator[Row]:
    """A skull with non-manifold edges at a fifth of its triangles."""
    if lab.skull is None:
        return
    bone = lab.workshop.file(lab.skull, (1.0,))
    for mode in ("Fast", "Balanced", "Accurate"):
        lab.run(lab.skull, "--mode", mode, "--target-reduction", 0.8, "--measure", "off")
        shape = lab.verifier.describe(lab.folder / "result.ply")
        yield {"mode": f"`{mode}`", "triangles": shape["triangles"], "non-manifold edges": shape["non_manifold_edges"],
               "boundary edges": shape["boundary_edges"], "components": shape["components"], **lab.distances(bone.file)}


def tolerance(lab: Lab) -> Iterator[Row]:
    """The runs that look for the smallest error of a number of triangles."""
    said = lab.folder / "tolerance.json"
    for mode in ("Fast", "Balanced"):
        lab.run(lab.bone("frontal").file, "--mode", mode, "--triangles", 4000, "--precision", 0.05, "--json", said, command="tolerance")
        for run in json.loads(said.read_text(encoding="utf-8"))["runs"]:
            yield {"mode": f"`{mode}`", "largest error, mm": run["max_error_mm"] or "by number alone", "triangles": run["triangles"],
                   "proved, mm": run["proved_mm"], "4,000 reached": "yes" if run["reached"] else "no"}


TABLES: dict[str, Callable[[Lab], Iterator[Row]]] = {
    "angles": angles, "angles-by-count": angles_by_count, "lengths": lengths, "voxels": voxels, "tunnels": tunnels, "levels": levels, "slabs": slabs,
    "non-manifold": non_manifold, "tolerance": tolerance, "remeshers": peer_features.remeshers, "meshers": peer_features.meshers, "label-maps": peer_features.label_maps,
    "sharp-edges": peer_features.sharp_edges, "strokes": peer_features.strokes, "processes": processes.processes,
    "certify": certify_times.certify, "normal-tolerance": normal_tolerances.normal_tolerance,
    "file-sizes": file_sizes.file_sizes, "browser": browser_times.browser}


def file_of(table: str) -> str:
    """The name of its file."""
    return f"features-{table}.csv"


def records_of(rows: list[Row], commit: str) -> list[Record]:
    """The rows as cells, each with the commit."""
    return [{**{column: text(value, 4) for column, value in row.items()}, "commit": commit} for row in rows]


def arguments() -> argparse.Namespace:
    """The options of the command line."""
    parser = argparse.ArgumentParser(prog="features.sh", description="Tables of single features: runs of the program on one thread.")
    parser.add_argument("tables", nargs="*", metavar="TABLE", help=f"by default all: {', '.join(TABLES)}")
    parser.add_argument("--bone", action="append", default=[], metavar="FILE", help="a surface file, or the name of a bone of the benchmark")
    parser.add_argument("--skull", type=Path, metavar="FILE", help="a surface with non-manifold edges, for the table non-manifold")
    parser.add_argument("--samples", type=int, default=200000, help="samples in each direction (200000)")
    parser.add_argument("--write-docs", action="store_true", help="write the tables into Documentation/results")
    parser.add_argument("--large", action="store_true", help="slabs of surfaces of 10^7 and 10^8 triangles, too; two hours and 8 GB of disk")
    parser.add_argument("--with-meshlib", action="store_true", help="MeshLib takes part, too; its license is non-commercial")
    parser.add_argument("--python", default=sys.executable, help=argparse.SUPPRESS)
    parser.add_argument("--programs", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--work", type=Path, required=True, help=argparse.SUPPRESS)
    options = parser.parse_args()
    unknown = [name for name in options.tables if name not in TABLES]
    if unknown:
        parser.error(f"no table {', '.join(unknown)}: there are {', '.join(TABLES)}")
    return options


def main() -> int:
    """Runs, and writes a file a table."""
    options = arguments()
    programs, work = Programs(options.programs.resolve()), options.work.resolve()
    folder = work / "features"
    folder.mkdir(parents=True, exist_ok=True)
    lab = Lab(programs, Workshop(programs, work), Verifier(programs, options.samples), folder, options.bone or BONES, options.skull, options.python, options.with_meshlib,
              options.large)
    commit = machine.commit()
    for table in options.tables or TABLES:
        rows = []
        for row in TABLES[table](lab):
            print(f"  {table}: " + ", ".join(f"{column} {text(value, 4)}" for column, value in row.items()), flush=True)
            rows.append(row)
            write_file(folder / file_of(table), [*rows[0], "commit"], records_of(rows, commit))
        if rows and options.write_docs:
            shutil.copyfile(folder / file_of(table), RESULTS / DATA / file_of(table))
    if options.write_docs:
        pages.write()
    return 0


if __name__ == "__main__":
    sys.exit(main())
