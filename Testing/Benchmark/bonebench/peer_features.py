# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of single features in which other programs take part, as far as they are installed: remeshing, volume meshers, label maps, strokes."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator

from . import remeshing, volume_meshers
from .document import ROOT
from .peer_worker import write_ply

if TYPE_CHECKING:
    from .features import Lab

Row = dict[str, Any]
LENGTH, ERROR = 2.0, 0.5  # mm
SCRIPTS = ROOT / "Testing" / "Benchmark"


def remeshed(lab: Lab, surface: Path, result: Path) -> Iterator[tuple[str, Row]]:
    """Ours with a length and an error; all others at its number of triangles. Names, and what each says of its run."""
    programs = lab.programs
    first = remeshing.ours(programs, surface, result, "Balanced", error=ERROR, EdgeLength=LENGTH)
    yield f"**`EdgeLength` {LENGTH:g} mm, {ERROR:g} mm proved**", first
    count = first["triangles"]
    yield "**`MinimumAngle` 25**", remeshing.ours(programs, surface, result, "Balanced", faces=count, MinimumAngle=25)
    yield "**`Balanced`**", remeshing.ours(programs, surface, result, "Balanced", faces=count)
    for peer in remeshing.PEERS:
        if peer.is_here(programs) and (lab.with_meshlib or peer is not remeshing.MESHLIB):
            yield peer.name, remeshing.to_count(programs, peer, surface, result, count, LENGTH)


def remeshers(lab: Lab) -> Iterator[Row]:
    """Remeshing at equal numbers of triangles."""
    result = lab.folder / "result.ply"
    for bone in lab.bones():
        for name, outcome in remeshed(lab, bone.file, result):
            if "failure" in outcome:
                yield {"bone": bone.name, "program": name, "triangles": outcome["failure"][:80]}
                continue
            shape = lab.verifier.describe(result)
            small = {f"below {limit} degrees, %": round(100 * count / shape["triangles"], 1)
                     for limit, count in zip((10, 20, 30), shape["below_10_20_30_degrees"])}
            yield {"bone": bone.name, "program": name, "triangles": shape["triangles"], "quality": shape["quality"], **small,
                   **lab.distances(bone.file), "proved, mm": outcome.get("proved", {}).get("upper"),
                   "intersecting pairs": shape["self_intersections"], "fragments": shape["components"]}


def as_stl(surface: Path) -> Path:
    """What every mesher here reads; single precision, of ours as of peers."""
    import pyvista

    file = surface.with_suffix(".stl")
    pyvista.read(surface).triangulate().save(file)
    return file


def to_mesh(lab: Lab, bone: Path) -> Iterator[tuple[str, Path | str]]:
    """The surfaces of a bone that meshers get, or why there is none, and how they were made."""
    yield "as it is", as_stl(bone)
    for words in ((), ("--min-angle", 20), ("--min-angle", 30), ("--edge-length", LENGTH)):
        lab.run(bone, "--mode", "Balanced", "--max-error", ERROR, "--measure", "off", *words, result="mesh.stl")
        how = {"--min-angle": "`MinimumAngle` {} degrees", "--edge-length": "`EdgeLength` {:g} mm"}
        yield how[words[0]].format(words[1]) if words else f"{ERROR:g} mm", lab.folder / "mesh.stl"
    count = triangles_in(lab.folder / "mesh.stl")
    for peer in (remeshing.ISOTROPIC, remeshing.PYACVD):
        result = lab.folder / f"{peer.key}.ply"
        if peer.is_here(lab.programs):
            outcome = remeshing.to_count(lab.programs, peer, bone, result, count, LENGTH)
            yield peer.name, f"failed: {outcome['failure'][:70]}" if "failure" in outcome else as_stl(result)


def triangles_in(stl: Path) -> int:
    """Of a binary STL file."""
    with stl.open("rb") as stream:
        return int.from_bytes(stream.read(84)[80:], "little")


def closed_surfaces(lab: Lab) -> Iterator[tuple[str, Path]]:
    """The bones that are closed, and a phantom of many fragments, capped."""
    import pyvista

    for bone in lab.bones():
        if not lab.verifier.describe(bone.file)["boundary_edges"]:
            yield bone.name, bone.file
    capped = lab.folder / "capped.ply"
    lab.run(lab.bone("small-leg").file, capped, command="cap")
    surface = pyvista.read(capped)
    write_ply(str(capped), surface.points, surface.regular_faces)  # as peers read it
    yield "leg of the phantom, capped", capped


def meshers(lab: Lab) -> Iterator[Row]:
    """Tetrahedra and their smallest dihedral angle, of closed bones."""
    here = volume_meshers.are_here()
    for name, file in closed_surfaces(lab):
        for how, surface in to_mesh(lab, file):
            row: Row = {"surface": name, "how": how, "triangles": surface if isinstance(surface, str) else triangles_in(surface)}
            for mesher in [] if isinstance(surface, str) else here:
                outcome = volume_meshers.mesh(mesher, surface)
                row[mesher] = f"failed: {outcome['failure'][:70]}" if "failure" in outcome else f"{outcome['cells']:,}, {outcome['angle']:.1f}"
            yield row


def rows_of(python: str, script: str, *words: object) -> Iterator[Row]:
    """What a script of this folder prints as JSON."""
    done = subprocess.run([python, "-B", str(SCRIPTS / script), "--json", *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{script}: {done.stderr}")
    yield from json.loads(done.stdout.splitlines()[-1])


def label_maps(lab: Lab) -> Iterator[Row]:
    """Extraction, by the VTK of the filters and by that of the peers."""
    lab.use_filters()
    yield from rows_of(lab.python, "label_maps.py")
    os.environ.pop("PYTHONPATH")
    if sys.executable != lab.python:
        yield from (row for row in rows_of(sys.executable, "label_maps.py") if "SurfaceNets" in row["filter"])


def sharp_edges(lab: Lab) -> Iterator[Row]:
    """Solids with edges, smoothed with and without FeatureAngle."""
    yield from rows_of(lab.python, "sharp_edges.py", lab.programs.folder / "bonedecimate")


def strokes(lab: Lab) -> Iterator[Row]:
    """A brush on the cranium."""
    lab.use_filters()
    yield from rows_of(lab.python, "strokes.py", lab.bone("cranium").file)
