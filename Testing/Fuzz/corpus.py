#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Inputs for the fuzzers: made here, or found by them, kept as texts with one input a line in hexadecimal.

    corpus.py make core|files|logs|predicates FOLDER    the first inputs, a file each; without GLB and 3MF, whose first ones are kept
    corpus.py unpack TEXT FOLDER                       what is kept, a file each
    corpus.py pack FOLDER TEXT                         a folder's files (let the fuzzer merge them before), the longest of them left out
"""

from __future__ import annotations

import pathlib
import random
import sys

LONGEST = 2600  # bytes of an input that is kept
OPTIONS = 25  # bytes that FuzzCore.cxx takes for them

TETRAHEDRON = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)), ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))


def octahedron():
    points = ((2, 0, 0), (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2))
    faces = [(a, b, c) if (a + b + c) % 2 == 0 else (b, a, c) for a in (0, 1) for b in (2, 3) for c in (4, 5)]
    return points, faces


def grid(cells, height, generator):
    side = cells + 1
    points = [(x, y, generator.uniform(0, height)) for y in range(side) for x in range(side)]
    faces = []
    for y in range(cells):
        for x in range(cells):
            corner = y * side + x
            faces += [(corner, corner + 1, corner + side), (corner + 1, corner + side + 1, corner + side)]
    return points, faces


def voxels(cells):
    """The sides of unit cubes, each two triangles: flat parts, and stairs as label maps have them."""
    points, faces = {}, []
    for cell in sorted(cells):
        for axis in range(3):
            for step in (-1, 1):
                if tuple(c + step * (k == axis) for k, c in enumerate(cell)) in cells:
                    continue
                u, v = (axis + 1) % 3, (axis + 2) % 3
                corners = []
                for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1))[::step]:
                    corner = tuple(c + (step > 0) * (k == axis) + du * (k == u) + dv * (k == v) for k, c in enumerate(cell))
                    corners.append(points.setdefault(corner, len(points)))
                faces += [(corners[0], corners[1], corners[2]), (corners[0], corners[2], corners[3])]
    return list(points), faces


BOX = {(x, y, z) for x in range(3) for y in range(2) for z in range(2)}
STAIRS = {(x, y, z) for x in range(3) for y in range(2) for z in range(3 - x)}


def soup(generator):
    points = [tuple(generator.uniform(-3, 3) for _ in range(3)) for _ in range(generator.randrange(4, 40))]
    return points, [tuple(generator.randrange(len(points)) for _ in range(3)) for _ in range(generator.randrange(1, 90))]


def core_input(surface, generator):
    points, faces = surface
    options = bytes(generator.randrange(256) for _ in range(OPTIONS))
    coordinates = bytes(max(0, min(249, round(c * 16) + 128)) for point in points for c in point)
    return options + bytes([len(points)]) + coordinates + bytes(corner for face in faces for corner in face)


def core_inputs():
    generator = random.Random(1)
    for _ in range(12):
        for surface in (TETRAHEDRON, octahedron(), grid(4, 0, generator), grid(6, 1, generator), soup(generator)):
            yield core_input(surface, generator)
    generator = random.Random(3)
    for _ in range(6):
        for cells in (BOX, STAIRS):
            yield core_input(voxels(cells), generator)


def file_inputs():
    """Each with the number of its row in the table of formats, from 1."""
    points, faces = TETRAHEDRON
    def rows(items, begin="", add=0):
        return "".join(begin + " ".join(str(i + add) if add else str(i) for i in item) + "\n" for item in items)

    corners = [(3, *face) for face in faces]
    yield 5, rows(points, "v ") + rows(faces, "f ", 1)
    yield 5, rows(points, "v ") + "vn 0 0 1\ng bone\n" + rows([(-1, -2, -3)], "f ") + "f 1/1/1 2//1 3/1\n"
    facets = "".join("facet normal 0 0 0\nouter loop\n" + rows((points[c] for c in f), "vertex ") + "endloop\nendfacet\n" for f in faces)
    yield 4, "solid bone\n" + facets + "endsolid bone\n"
    yield 4, "\0" * 80 + "\x01\0\0\0" + "\0" * 50
    header = "ply\nformat %s 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n"
    yield 3, header % ("ascii", 4, 4) + rows(points) + rows(corners)
    yield 3, header % ("binary_little_endian", 1, 1) + "\0" * 12 + "\3" + "\0" * 12
    yield 3, header % ("binary_big_endian", 1, 1) + "\0" * 12 + "\3" + "\0" * 12
    legacy = "# vtk DataFile Version %s\nbone\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n" + rows(points)
    yield 2, legacy % "3.0" + "POLYGONS 4 16\n" + rows(corners)
    yield 2, legacy % "5.1" + "POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY vtktypeint64\n0 2 1 0 1 3 1 2 3 0 3 2\n"
    yield 2, legacy % "3.0" + "POINT_DATA 4\nSCALARS a float 1\nLOOKUP_TABLE default\n0 1 2 3\n"
    yield 1, (
        '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">\n<PolyData>'
        '<Piece NumberOfPoints="4" NumberOfPolys="4"><Points><DataArray type="Float32" NumberOfComponents="3" '
        'format="ascii">0 0 0</DataArray></Points></Piece></PolyData></VTKFile>\n'
    )


def log_inputs():
    """Changes of the recordings of FuzzLogs.cxx, and short files of any bytes."""
    generator = random.Random(2)
    values = (0, 1, 2, 3, 7, 20, 60, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x7FF80000, 0x7F800000)
    for number in range(64):
        changes = b"".join(
            generator.randrange(0, 4096).to_bytes(2, "big")
            + (generator.choice(values) if generator.random() < 0.6 else generator.randrange(200)).to_bytes(4, "big")
            for _ in range(number % 5)
        )
        yield bytes([number % 4, number % 8 != 7, 0]) + changes
    for length in (0, 4, 8, 36, 44, 90):
        version = (2).to_bytes(4, "little")
        yield bytes([0, 1, 1]) + version + bytes(generator.randrange(3) for _ in range(length))


def predicate_inputs():
    """Bytes of which many are in the middle, where coordinates are 0."""
    generator = random.Random(4)
    for number in range(100):
        yield bytes([number % 5]) + bytes(generator.choice((128, generator.randrange(256))) for _ in range(60))


def write(folder, inputs):
    folder.mkdir(parents=True, exist_ok=True)
    for number, data in enumerate(inputs):
        (folder / f"{number:04}").write_bytes(data)


def main():
    verb, what, where = sys.argv[1:4]
    if verb == "make":
        files = (bytes([kind]) + text.encode("latin-1") for kind, text in file_inputs())
        inputs = {"core": core_inputs(), "files": files, "logs": log_inputs(), "predicates": predicate_inputs()}
        write(pathlib.Path(where), inputs[what])
    elif verb == "unpack":
        write(pathlib.Path(where), map(bytes.fromhex, pathlib.Path(what).read_text(encoding="ascii").split()))
    else:
        found = {file.read_bytes() for file in pathlib.Path(what).iterdir()}
        lines = sorted((data.hex() for data in found if 0 < len(data) <= LONGEST), key=lambda line: (len(line), line))
        pathlib.Path(where).write_text("\n".join(lines) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()
