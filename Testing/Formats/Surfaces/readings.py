# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What readers give, in one form: points, faces, the values of each corner and of each face."""

import dataclasses

ATTRIBUTE_NAMES = {"uv": ("TCoords",), "normals": ("Normals",), "colors": ("RGB", "RGBA")}


@dataclasses.dataclass
class Reading:
    points: list
    faces: list
    corners: dict  # "uv", "normals", "colors" -> for each face a value for each corner
    point_arrays: dict  # name -> values of the points
    cell_arrays: dict  # name -> values of the faces
    types: dict = dataclasses.field(default_factory=dict)  # of arrays by name
    field_arrays: dict = dataclasses.field(default_factory=dict)
    lines: list = dataclasses.field(default_factory=list)
    vertices: list = dataclasses.field(default_factory=list)
    frame: str = ""
    warnings: list = dataclasses.field(default_factory=list)


def triangles_of(strip):
    """Every second triangle of a strip is turned."""
    return [(strip[i], strip[i + 1 + i % 2], strip[i + 2 - i % 2]) for i in range(len(strip) - 2)]


def tuples(array):
    size = max(1, array["components"])
    values = array["values"]
    return [tuple(values[i : i + size]) for i in range(0, len(values), size)]


def of_plain(found):
    corners = {}
    for name in ("uv", "normals", "colors"):
        if name in found:
            values = iter(found[name]["values"])
            kind = found[name]["of"]
            listed = list(values)
            numbers = iter(range(len(listed)))
            corners[name] = [
                [tuple(listed[v if kind == "points" else i if kind == "faces" else next(numbers)]) for v in face]
                for i, face in enumerate(found["faces"])
            ]
    arrays = {name: tuples(array) for name, array in found.get("point_data", {}).items()}
    return Reading(found["points"], [tuple(f) for f in found["faces"]], corners, arrays, {})


class VtkReading:
    """The form of VTK: polygons and strips, cell data of vertices and lines first."""

    def __init__(self, found):
        self.found = found
        first = len(found["verts"]) + len(found["lines"])
        self.faces = [tuple(f) for f in found["polys"]]
        self.cells = [first + i for i in range(len(self.faces))]
        for i, strip in enumerate(found["strips"]):
            triangles = triangles_of(strip)
            self.faces += triangles
            self.cells += [first + len(found["polys"]) + i] * len(triangles)

    def take(self):
        found = self.found
        point_arrays = {name: tuples(array) for name, array in found["point_data"].items()}
        cell_arrays = self.of_faces({name: tuples(array) for name, array in found["cell_data"].items()})
        fields = {name: array["values"] for name, array in found["field_data"].items()}
        types = {n: a["type"] for data in ("point_data", "cell_data") for n, a in found[data].items()}
        reading = Reading(found["points"], self.faces, {}, point_arrays, cell_arrays, types, fields)
        reading.lines = [tuple(line) for line in found["lines"]]
        reading.vertices = [tuple(vertex) for vertex in found["verts"]]
        reading.frame = (fields.get("SPACE") or [""])[0]
        reading.warnings = found.get("warnings", [])
        self.take_corners(reading)
        return reading

    def of_faces(self, arrays):
        return {n: [v[i] for i in self.cells] for n, v in arrays.items() if len(v) > max(self.cells, default=-1)}

    def take_corners(self, reading):
        points = reading.point_arrays
        for kind, names in ATTRIBUTE_NAMES.items():
            active = self.found.get(kind) if kind != "colors" else None
            for name in (active, *names):
                if name in points:
                    reading.corners[kind] = [[points[name][v] for v in face] for face in reading.faces]
                    break
                if name in reading.cell_arrays and kind != "normals":
                    reading.corners[kind] = [[reading.cell_arrays[name][i]] * len(f) for i, f in enumerate(reading.faces)]
        materials = reading.field_arrays.get("MaterialNames")
        ids = reading.cell_arrays.get("MaterialIds")
        if "uv" in reading.corners and materials and ids:
            # Texture coordinates of each material are an array of its own.
            named = [points.get(materials[int(ids[i][0])], points.get("TCoords")) for i in range(len(reading.faces))]
            reading.corners["uv"] = [[values[v] for v in f] for values, f in zip(named, reading.faces)] if all(named) else []


def reading_of(found):
    return VtkReading(found).take() if "polys" in found else of_plain(found)
