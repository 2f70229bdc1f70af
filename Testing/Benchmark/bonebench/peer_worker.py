# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One decimation by a peer from Python, in this process alone: peer_worker.py PEER INPUT.ply OUTPUT.ply FACES|MMmm

Measured: the seconds of the decimation call alone, the mesh already in the peer's own structure; the processor's seconds
over all threads; the memory (resident pages, Linux) that holding the input costs and the most beyond it during the call.
"""

from __future__ import annotations

import ctypes
import importlib.metadata
import json
import resource
import sys
import time
from pathlib import Path
from typing import Any, Callable, TypeAlias

import numpy as np

Points: TypeAlias = np.ndarray  # n x 3, float32 as in the file
Corners: TypeAlias = np.ndarray  # m x 3, int32
Result = Callable[[], tuple[np.ndarray, np.ndarray]]
# The peer's import happens first; what comes back are the call to be timed and how to get at its result.
Prepared = tuple[Callable[[], Any], Result]


def read_ply(path: str) -> tuple[Points, Corners]:
    """The benchmark's own files: float32 points of inputs, float64 of results, triangles."""
    data = Path(path).read_bytes()
    head, body = data.split(b"end_header\n", 1)
    words = head.split()
    points, faces = (int(words[words.index(name) + 1]) for name in (b"vertex", b"face"))
    kind = np.dtype("<f8" if b"double x" in head else "<f4")
    where = np.frombuffer(body, kind, 3 * points).reshape(-1, 3).copy()
    rows = np.frombuffer(body, np.dtype([("n", "u1"), ("corners", "<i4", 3)]), faces, where.nbytes)
    return where, np.ascontiguousarray(rows["corners"])


def write_ply(path: str, points: np.ndarray, corners: np.ndarray) -> None:
    """In double precision, so that nothing of the result is lost."""
    rows = np.empty(len(corners), np.dtype([("n", "u1"), ("corners", "<i4", 3)]))
    rows["n"], rows["corners"] = 3, corners
    axes = "".join(f"property double {axis}\n" for axis in "xyz")
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n{axes}element face {len(corners)}\n"
            "property list uchar int vertex_indices\nend_header\n")
    Path(path).write_bytes(head.encode() + np.ascontiguousarray(points, "<f8").tobytes() + rows.tobytes())


def vtk_surface(points: Points, corners: Corners) -> Any:
    """A vtkPolyData."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    coordinates, cells, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
    coordinates.SetData(numpy_to_vtk(points, deep=1))
    offsets = np.arange(0, corners.size + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtk(offsets, deep=1), numpy_to_vtk(corners.ravel().astype(np.int64), deep=1))
    surface.SetPoints(coordinates)
    surface.SetPolys(cells)
    return surface


def vtk_result(filter_: Any) -> tuple[np.ndarray, np.ndarray]:
    """Points and corners of its output."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    output = filter_.GetOutput()
    return (vtk_to_numpy(output.GetPoints().GetData()),
            vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def prepare_vtk(points: Points, corners: Corners, faces: int, error: float | None = None) -> Prepared:
    """vtkQuadricDecimation with its defaults, to the count, or to a maximum error, whatever the other."""
    from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

    quadric = vtkQuadricDecimation()
    quadric.SetInputData(vtk_surface(points, corners))
    quadric.SetTargetReduction(1.0 - faces / len(corners))
    if error is not None:
        quadric.SetMaximumError(error)
    return quadric.Update, lambda: vtk_result(quadric)


def prepare_meshlab(points: Points, corners: Corners, faces: int, topology: bool = False) -> Prepared:
    """Quadric edge collapse with optimal placement and MeshLab's usual quality threshold, boundary kept."""
    import pymeshlab

    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(points.astype(np.float64), corners))

    def call() -> None:
        meshes.meshing_decimation_quadric_edge_collapse(
            targetfacenum=faces, qualitythr=0.3, optimalplacement=True, autoclean=True, preserveboundary=True,
            preservetopology=topology, preservenormal=topology)

    return call, lambda: (meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix())


def prepare_meshlab_topology(points: Points, corners: Corners, faces: int) -> Prepared:
    """The same, with topology and normals kept."""
    return prepare_meshlab(points, corners, faces, topology=True)


def prepare_open3d(points: Points, corners: Corners, faces: int) -> Prepared:
    """simplify_quadric_decimation with its defaults."""
    import open3d

    mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(points.astype(np.float64)),
                                        open3d.utility.Vector3iVector(corners))
    kept: list[Any] = []
    return (lambda: kept.append(mesh.simplify_quadric_decimation(faces)),
            lambda: (np.asarray(kept[0].vertices), np.asarray(kept[0].triangles)))


def prepare_fast_simplification(points: Points, corners: Corners, faces: int) -> Prepared:
    """simplify with its defaults (Sp4cerat's fast quadric)."""
    import fast_simplification

    kept: list[Any] = []
    return lambda: kept.append(fast_simplification.simplify(points, corners, target_count=faces)), lambda: kept[0]


def prepare_pyfqmr(points: Points, corners: Corners, faces: int) -> Prepared:
    """Another implementation of the same algorithm, boundary kept."""
    import pyfqmr

    mesh = pyfqmr.Simplify()
    mesh.setMesh(points.astype(np.float64), corners)
    return (lambda: mesh.simplify_mesh(target_count=faces, preserve_border=True, verbose=0), lambda: mesh.getMesh()[:2])


def prepare_meshoptimizer(points: Points, corners: Corners, faces: int, error: float | None = None) -> Prepared:
    """meshopt_simplify to the count, or to an absolute error, whatever the other."""
    import meshoptimizer

    absolute = 4  # meshopt_SimplifyErrorAbsolute

    indices = np.ascontiguousarray(corners.ravel(), np.uint32)
    kept: list[Any] = []

    def call() -> None:
        out = np.empty_like(indices)
        count = meshoptimizer.simplify(out, indices, points, target_index_count=3 * faces,
                                       target_error=1e9 if error is None else error, options=0 if error is None else absolute)
        kept.append(out[:count])

    def result() -> tuple[np.ndarray, np.ndarray]:
        used, compact = np.unique(kept[0], return_inverse=True)
        return points[used], compact.reshape(-1, 3)

    return call, result


def prepare_meshlib(points: Points, corners: Corners, faces: int, error: float | None = None) -> Prepared:
    """decimateMesh to the count, or to an error, whatever the other."""
    from meshlib import mrmeshnumpy, mrmeshpy

    mesh = mrmeshnumpy.meshFromFacesVerts(corners, points.astype(np.float64))
    settings = mrmeshpy.DecimateSettings()
    settings.maxDeletedFaces = len(corners) - faces
    settings.maxError = 1e9 if error is None else error
    settings.packMesh = True
    return (lambda: mrmeshpy.decimateMesh(mesh, settings),
            lambda: (mrmeshnumpy.getNumpyVerts(mesh), mrmeshnumpy.getNumpyFaces(mesh.topology)))


def prepare_meshlab_remeshing(points: Points, corners: Corners, length: float) -> Prepared:
    """Isotropic explicit remeshing with its defaults: ten iterations, reprojection to the input."""
    import pymeshlab

    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(points.astype(np.float64), corners))
    return (lambda: meshes.meshing_isotropic_explicit_remeshing(iterations=10, targetlen=pymeshlab.PureValue(length)),
            lambda: (meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()))


def prepare_meshlib_remeshing(points: Points, corners: Corners, length: float) -> Prepared:
    """remesh with its defaults, splits as many as it takes."""
    from meshlib import mrmeshnumpy, mrmeshpy

    mesh = mrmeshnumpy.meshFromFacesVerts(corners, points.astype(np.float64))
    settings = mrmeshpy.RemeshSettings()
    settings.targetEdgeLen = length
    settings.maxEdgeSplits = 10_000_000
    settings.packMesh = True
    return (lambda: mrmeshpy.remesh(mesh, settings),
            lambda: (mrmeshnumpy.getNumpyVerts(mesh), mrmeshnumpy.getNumpyFaces(mesh.topology)))


def prepare_pyacvd(points: Points, corners: Corners, faces: int) -> Prepared:
    """Clusters, of which each becomes a vertex, of a surface that is divided until it has ten points for each."""
    import pyacvd
    import pyvista

    surface = pyvista.PolyData.from_regular_faces(points.astype(np.float64), corners)
    kept: list[Any] = []

    def call() -> None:
        clustering = pyacvd.Clustering(surface)
        divisions = int(np.ceil(np.log(10 * (faces / 2) / len(points)) / np.log(4)))
        if divisions > 0:
            clustering.subdivide(divisions)
        clustering.cluster(max(4, faces // 2))
        kept.append(clustering.create_mesh())

    return call, lambda: (np.asarray(kept[0].points), np.asarray(kept[0].regular_faces))


def prepare_itk_wasm(points: Points, corners: Corners, faces: int) -> Prepared:
    """The remeshing of Geogram, as WebAssembly. It takes the number of points in percent of the input's."""
    from itkwasm import FloatTypes, IntTypes, Mesh, MeshType
    from itkwasm_mesh_filters_wasi import smooth_remesh

    kind = MeshType(dimension=3, pointComponentType=FloatTypes.Float32, cellComponentType=IntTypes.UInt32)
    cells = np.empty((len(corners), 5), np.uint32)
    cells[:, 0], cells[:, 1], cells[:, 2:] = 2, 3, corners  # a polygon of three points
    mesh = Mesh(kind, numberOfPoints=len(points), points=points.ravel(), numberOfCells=len(corners),
                cellBufferSize=cells.size, cells=cells.ravel())
    kept: list[Any] = []

    def call() -> None:
        kept.append(smooth_remesh(mesh, number_points=100 * faces / len(corners)))

    return call, lambda: (np.asarray(kept[0].points).reshape(-1, 3), np.asarray(kept[0].cells).reshape(-1, 5)[:, 2:])


PREPARE: dict[str, tuple[str, Callable[[Points, Corners, Any], Prepared]]] = {
    "vtk": ("vtk", prepare_vtk),
    "meshlab": ("pymeshlab", prepare_meshlab),
    "meshlab-topology": ("pymeshlab", prepare_meshlab_topology),
    "open3d": ("open3d", prepare_open3d),
    "fast-simplification": ("fast-simplification", prepare_fast_simplification),
    "pyfqmr": ("pyfqmr", prepare_pyfqmr),
    "meshoptimizer": ("meshoptimizer", prepare_meshoptimizer),
    "meshlib": ("meshlib", prepare_meshlib),
    "pyacvd": ("pyacvd", prepare_pyacvd),
    "itk-wasm": ("itkwasm-mesh-filters", prepare_itk_wasm),
    "meshlab-remeshing": ("pymeshlab", prepare_meshlab_remeshing),
    "meshlib-remeshing": ("meshlib", prepare_meshlib_remeshing),
}
# Those whose goal is a length of edges, mm.
TAKE_LENGTHS = ("meshlab-remeshing", "meshlib-remeshing")


def held(field: str) -> int:
    """Bytes of a line of /proc/self/status; 0 where there is none."""
    status = Path("/proc/self/status")
    lines = status.read_text(encoding="ascii").splitlines() if status.exists() else []
    return next((1024 * int(line.split()[1]) for line in lines if line.startswith(field)), 0)


def give_back_memory() -> None:
    """Freed pages go back to the system, so that what an earlier step freed is not reused unseen."""
    try:
        ctypes.CDLL(None).malloc_trim(0)
    except (AttributeError, OSError):
        pass


def forget_peak() -> None:
    """From here on VmHWM is the most since now."""
    try:
        Path("/proc/self/clear_refs").write_text("5", encoding="ascii")
    except OSError:
        pass


def warm_up(prepare: Callable[[Points, Corners, Any], Prepared], goal: float) -> None:
    """Imports the peer and what it loads at its first call, on a tetrahedron with sides of 1: none of it is the decimation's."""
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
    corners = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], np.int32)
    try:
        prepare(points, corners, goal)[0]()
    except Exception:  # a peer may reject so small a mesh; it is imported by then
        pass


def with_goal(peer: str, goal: str) -> tuple[Callable[[Points, Corners, Any], Prepared], float]:
    """The function of a peer and its goal: a number of triangles, or with "mm" behind it a length of edges."""
    return PREPARE[peer][1], float(goal.removesuffix("mm")) if peer in TAKE_LENGTHS else int(goal)


def measure(version: str, prepare: Callable[[Points, Corners, Any], Prepared], source: str, target: str, goal: float,
            first_goal: float) -> None:
    """Reads, runs under the clock, writes and prints JSON. first_goal: of the call on a tetrahedron, which is not measured."""
    warm_up(prepare, first_goal)
    give_back_memory()
    program = held("VmRSS:")
    call, result = prepare(*read_ply(source), goal)
    give_back_memory()
    forget_peak()
    with_input = held("VmRSS:")
    cpu, wall = processor_seconds(), time.perf_counter()
    call()
    wall, cpu = time.perf_counter() - wall, processor_seconds() - cpu
    most = held("VmHWM:")
    vertices, triangles = result()
    write_ply(target, vertices, triangles)
    print("\n" + json.dumps({
        "triangles": len(triangles), "version": version, "seconds": wall, "cpu_seconds": cpu,
        "input_bytes": with_input - program, "peak_bytes": most - with_input}))


def processor_seconds() -> float:
    """Of this process and of those it has run."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


if __name__ == "__main__":
    worker, wanted = with_goal(sys.argv[1], sys.argv[4])
    measure(importlib.metadata.version(PREPARE[sys.argv[1]][0]), worker, *sys.argv[2:4], wanted, 4)
