# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One run of a peer with a tolerance, in this process alone: tolerance_worker.py PEER INPUT.ply OUTPUT.ply MM

A function for each peer. Its settings are the defaults, except those that are named in audit.py and in the function.
"""

from __future__ import annotations

import importlib.metadata
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, Callable

import numpy as np
from peer_worker import (Corners, Points, Prepared, measure, prepare_meshlib, prepare_meshoptimizer, prepare_vtk,
                         vtk_result, vtk_surface)

FIRST_TOLERANCE = 0.01  # fTetWild crashes on an envelope that is larger than its input
LENGTH_PER_TOLERANCE = 10.0  # of edges that a remesher strives for, where its tolerance lets it
UPDATE = """
import { MeshoptSimplifier as simplifier } from 'meshoptimizer';
import { readFileSync, writeFileSync } from 'fs';
await simplifier.ready;
const [folder, error] = process.argv.slice(1);
const read = (name, type) => new type(new Uint8Array(readFileSync(folder + name)).buffer);
const points = read('/points', Float32Array), corners = read('/corners', Uint32Array), none = new Float32Array(0);
const [count] = simplifier.simplifyWithUpdate(corners, points, 3, none, 0, [], null, 0, Number(error), ['ErrorAbsolute']);
writeFileSync(folder + '/points', points);
writeFileSync(folder + '/corners', corners.subarray(0, count));
"""


def compact(points: np.ndarray, corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Without points that belong to no triangle."""
    used, renumbered = np.unique(corners, return_inverse=True)
    return points[used], renumbered.reshape(-1, 3)


def with_meshoptimizer_update(points: Points, corners: Corners, tolerance: float) -> Prepared:
    """meshopt_simplifyWithUpdate with an absolute error, of the package for npm: in Node.js, whose start is measured too."""
    folder = tempfile.TemporaryDirectory()
    names = [Path(folder.name) / name for name in ("points", "corners")]
    points.tofile(names[0])
    corners.astype(np.uint32).tofile(names[1])

    def call() -> None:
        subprocess.run(["node", "--input-type=module", "-e", UPDATE, folder.name, str(tolerance)],
                       cwd=os.environ["NODE_PACKAGES"], check=True)

    def result() -> tuple[np.ndarray, np.ndarray]:
        with folder:
            return compact(np.fromfile(names[0], np.float32).reshape(-1, 3), np.fromfile(names[1], np.uint32))

    return call, result


def with_mmgs(points: Points, corners: Corners, tolerance: float) -> Prepared:
    """Remeshing with hausd."""
    import mmgpy

    mesh = mmgpy.MmgMeshS(points.astype(np.float64), corners)
    return lambda: mesh.remesh(hausd=tolerance, verbose=-1), lambda: (mesh.get_vertices(), mesh.get_triangles())


def with_manifold(points: Points, corners: Corners, tolerance: float) -> Prepared:
    """Manifold.simplify; it says with a status of its own what it does not take."""
    import manifold3d

    solid = manifold3d.Manifold(manifold3d.Mesh64(points.astype(np.float64), corners.astype(np.uint64)))
    if solid.status() != manifold3d.Error.NoError:
        raise SystemExit(f"rejected: {solid.status()}")
    kept: list[Any] = []

    def result() -> tuple[np.ndarray, np.ndarray]:
        mesh = kept[0].to_mesh64()
        return mesh.vert_properties[:, :3], mesh.tri_verts

    return lambda: kept.append(solid.simplify(tolerance)), result


def with_decimate_pro(points: Points, corners: Corners, tolerance: float) -> Prepared:
    """vtkDecimatePro with an absolute and accumulated error, as many triangles as that allows, topology preserved."""
    from vtkmodules.vtkFiltersCore import vtkDecimatePro

    decimate = vtkDecimatePro()
    decimate.SetInputData(vtk_surface(points, corners))
    decimate.SetTargetReduction(1.0)
    decimate.SetErrorIsAbsolute(1)
    decimate.SetAbsoluteError(tolerance)
    decimate.AccumulateErrorOn()
    decimate.PreserveTopologyOn()
    return decimate.Update, lambda: vtk_result(decimate)


def with_meshlab_remeshing(points: Points, corners: Corners, tolerance: float) -> Prepared:
    """Isotropic explicit remeshing with long edges, adapted to the curvature, whose steps maxsurfdist limits."""
    import pymeshlab

    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(points.astype(np.float64), corners))

    def call() -> None:
        meshes.meshing_isotropic_explicit_remeshing(
            adaptive=True, targetlen=pymeshlab.PureValue(LENGTH_PER_TOLERANCE * tolerance), checksurfdist=True,
            maxsurfdist=pymeshlab.PureValue(tolerance))

    return call, lambda: (meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix())


def with_ftetwild(points: Points, corners: Corners, tolerance: float) -> Prepared:
    """fTetWild's envelope, relative to the diagonal of the bounding box; the surface of its tetrahedra is the result."""
    import pytetwild

    diagonal = float(np.linalg.norm(np.ptp(points, axis=0)))
    kept: list[Any] = []

    def call() -> None:
        os.chdir(tempfile.gettempdir())  # where it leaves a file
        kept.append(pytetwild.tetrahedralize(points.astype(np.float64), corners, epsilon=tolerance / diagonal, coarsen=True,
                                             num_threads=1, quiet=True))

    def result() -> tuple[np.ndarray, np.ndarray]:
        where, cells = kept[0][0], np.asarray(kept[0][1])
        sides = cells[:, [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]]].reshape(-1, 3)
        _, first, uses = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
        return compact(np.asarray(where), sides[first[uses == 1]])

    return call, result


def with_open3d(points: Points, corners: Corners, tolerance: float) -> Prepared:
    """simplify_quadric_decimation with maximum_error, as few triangles as that allows."""
    import open3d

    mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(points.astype(np.float64)),
                                        open3d.utility.Vector3iVector(corners))
    kept: list[Any] = []
    return (lambda: kept.append(mesh.simplify_quadric_decimation(4, maximum_error=tolerance)),
            lambda: (np.asarray(kept[0].vertices), np.asarray(kept[0].triangles)))


def with_pyfqmr(points: Points, corners: Corners, tolerance: float) -> Prepared:
    """simplify_mesh_lossless with epsilon, boundary kept."""
    import pyfqmr

    mesh = pyfqmr.Simplify()
    mesh.setMesh(points.astype(np.float64), corners)
    return (lambda: mesh.simplify_mesh_lossless(verbose=False, epsilon=tolerance, preserve_border=True),
            lambda: mesh.getMesh()[:2])


PREPARE: dict[str, tuple[str, Callable[[Points, Corners, float], Prepared]]] = {
    "decimate-pro": ("vtk", with_decimate_pro),
    "ftetwild": ("pytetwild", with_ftetwild),
    "manifold": ("manifold3d", with_manifold),
    "meshlab-remeshing": ("pymeshlab", with_meshlab_remeshing),
    "meshlib": ("meshlib", lambda points, corners, tolerance: prepare_meshlib(points, corners, 4, tolerance)),
    "meshoptimizer": ("meshoptimizer", lambda points, corners, tolerance: prepare_meshoptimizer(points, corners, 4, tolerance)),
    "meshoptimizer-update": ("", with_meshoptimizer_update),
    "mmgs": ("mmgpy", with_mmgs),
    "open3d": ("open3d", with_open3d),
    "pyfqmr": ("pyfqmr", with_pyfqmr),
    "vtk": ("vtk", lambda points, corners, tolerance: prepare_vtk(points, corners, 4, tolerance)),
}


def version_of(package: str) -> str:
    """Of a package of Python, or of that of npm."""
    if package:
        return importlib.metadata.version(package)
    description = Path(os.environ["NODE_PACKAGES"], "node_modules", "meshoptimizer", "package.json")
    return json.loads(description.read_text(encoding="utf-8"))["version"]


if __name__ == "__main__":
    peer, prepare = PREPARE[sys.argv[1]]
    measure(version_of(peer), prepare, *sys.argv[2:4], float(sys.argv[4]), FIRST_TOLERANCE)
