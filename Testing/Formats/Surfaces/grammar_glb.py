# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""glTF 2.0 in one binary file."""

import json
import struct

from truth import ALL_SHAPES, Truth, make_shape, single, strips_of

EXTENSION = "glb"
ROUNDING = 1e-14
KINDS = {"byte": (5120, "b"), "ubyte": (5121, "B"), "short": (5122, "h"), "ushort": (5123, "H"), "uint": (5125, "I"), "float": (5126, "f")}
TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}
CHOICES = {
    "shape": ALL_SHAPES,
    "indices": ["ushort", "ubyte", "uint", "none"],
    "mode": ["triangles", "not given", "strip", "fan"],
    "buffer": ["apart", "interleaved", "stride", "offset"],
    "sparse": ["no", "some", "all"],
    "node": ["plain", "translation", "rotation", "scale", "TRS", "matrix", "mirror"],
    "parent": ["none", "translation", "rotation", "scale", "TRS", "matrix", "mirror"],
    "tree": ["one", "mesh twice", "two meshes", "mesh in the parent"],
    "primitives": ["one", "two", "two with the same points", "points beside"],
    "normals": ["no", "yes"],
    "texture": ["no", "float", "ubyte", "ushort"],
    "colors": ["no", "float 3", "float 4", "ubyte 4", "ushort 3"],
    "own": ["no", "scalar", "vector"],
    "scene": ["one", "default second", "not given", "no scenes"],
    "unused": ["no", "mesh", "node"],
    "material": ["no", "yes"],
    "extras": ["no", "yes"],
    "extensions": ["none", "used", "quantization"],
    "names": ["ASCII", "none", "Unicode"],
    "json": ["compact", "indented", "padding"],
    "chunks": ["usual", "another behind"],
    "target": ["given", "not given"],
}
UNIFORM = {"shape", "node", "parent", "mode", "indices"}
TURN = (0.0, 0.0, 0.6, 0.8)  # a quaternion of length 1


def trs(translation=(0, 0, 0), rotation=(0, 0, 0, 1), scale=(1, 1, 1)):
    """Rows of three columns and the translation."""
    x, y, z, w = rotation
    turn = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )
    return [tuple(turn[r][c] * scale[c] for c in range(3)) + (translation[r],) for r in range(3)]


def node_of(kind):
    """The properties of a node and the rows of its transform."""
    properties = {
        "translation": {"translation": (10.0, -20.0, 30.0)},
        "rotation": {"rotation": TURN},
        "scale": {"scale": (2.0, 0.5, 4.0)},
        "TRS": {"translation": (1.0, 2.0, 3.0), "rotation": TURN, "scale": (2.0, 2.0, 2.0)},
        "mirror": {"scale": (-1.0, 1.0, 1.0)},
    }.get(kind, {})
    if kind == "matrix":
        rows = [(0.75, -0.5, 0.0, 3.0), (0.25, 1.25, 0.125, -4.0), (0.0, 0.0, 1.5, 5.0)]
        columns = [rows[r][c] if r < 3 else float(c == 3) for c in range(4) for r in range(4)]
        return {"matrix": columns}, rows
    return {k: list(v) for k, v in properties.items()}, trs(**properties)


def apply(rows, point):
    return tuple(sum(row[k] * point[k] for k in range(3)) + row[3] for row in rows)


def product(a, b):
    return [tuple(sum(row[k] * b[k][c] for k in range(3)) + (row[3] if c == 3 else 0.0) for c in range(4)) for row in a]


def mirrors(rows):
    (a, b, c, _), (d, e, f, _), (g, h, i, _) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) < 0


class Buffer:
    def __init__(self, choices):
        self.choices, self.data, self.views, self.accessors = choices, b"", [], []

    def view(self, content, target=None, stride=None):
        self.data += bytes(-len(self.data) % 4)
        if self.choices["buffer"] == "offset":
            self.data += b"\xff" * 8
        entry = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content)}
        if target and self.choices["target"] == "given":
            entry["target"] = target
        if stride:
            entry["byteStride"] = stride
        self.views.append(entry)
        self.data += content
        return len(self.views) - 1

    def accessor(self, view, kind, size, rows, offset=0, normalized=False):
        entry = {"componentType": KINDS[kind][0], "count": len(rows), "type": TYPES[size]}
        if view is not None:
            entry["bufferView"] = view
        if offset:
            entry["byteOffset"] = offset
        if normalized:
            entry["normalized"] = True
        self.accessors.append(entry)
        return len(self.accessors) - 1

    def packed(self, kind, row):
        content = struct.pack("<%d%s" % (len(row), KINDS[kind][1]), *row)
        return content + bytes(-len(content) % 4)

    def attributes(self, columns):
        """name -> accessor of columns (name, kind, size, rows, normalized)."""
        found = {}
        if self.choices["buffer"] == "interleaved":
            records = [[self.packed(kind, rows[i]) for _, kind, _, rows, _ in columns] for i in range(len(columns[0][3]))]
            view = self.view(b"".join(b for r in records for b in r), 34962, sum(map(len, records[0])))
            offset = 0
            for k, (name, kind, size, rows, normalized) in enumerate(columns):
                found[name] = self.accessor(view, kind, size, rows, offset, normalized)
                offset += len(records[0][k])
            return found
        for name, kind, size, rows, normalized in columns:
            records = [self.packed(kind, row) for row in rows]
            stride = len(records[0])
            plain = struct.calcsize("<" + KINDS[kind][1]) * size
            if self.choices["buffer"] == "stride":
                records, stride = [r + b"\x7f" * 8 for r in records], stride + 8
            view = self.view(b"".join(records), 34962, stride if stride != plain or self.choices["buffer"] == "stride" else None)
            found[name] = self.accessor(view, kind, size, rows, 0, normalized)
        return found


class Writer:
    def __init__(self, choices, generator):
        self.choices, self.generator = choices, generator
        self.shape = make_shape(choices["shape"], generator, triangles=True, as_single=True, scale=0.01)
        self.shape.points = [tuple(single(c / 1000.0) for c in p) for p in self.shape.points]
        self.buffer = Buffer(choices)
        self.meshes, self.nodes, self.truth = [], [], Truth([], [])
        self.point_values = {}

    def columns(self, count):
        """Attributes of the points, and what ours makes of them."""
        choices, columns, values = self.choices, [], {}
        if choices["normals"] == "yes":
            rows = [((0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0))[i % 3] for i in range(count)]
            columns.append(("NORMAL", "float", 3, rows, False))
            values["normals"] = rows
        kind = choices["texture"]
        if kind != "no":
            most = {"float": 0, "ubyte": 255, "ushort": 65535}[kind]
            whole = [(3 + 5 * i % 250, (200 - 7 * i) % 256) for i in range(count)]
            rows = [(u / 256.0, v / 256.0) for u, v in whole] if kind == "float" else whole
            columns.append(("TEXCOORD_0", kind, 2, rows, kind != "float"))
            values["uv"] = [(u / (most or 1), 1.0 - v / (most or 1)) for u, v in rows]
        if choices["colors"] != "no":
            kind, size = choices["colors"].split()
            most = {"float": 1.0, "ubyte": 255, "ushort": 65535}[kind]
            # Linear values of which all programs make whole bytes: 0 and 1.
            rows = [tuple((i >> k & 1) * most for k in range(3)) + (most,) * (int(size) - 3) for i in range(count)]
            columns.append(("COLOR_0", kind, int(size), rows, kind != "float"))
            values["colors"] = [tuple(255 if c else 0 for c in row) for row in rows]
        if choices["own"] != "no":
            size = 1 if choices["own"] == "scalar" else 3
            rows = [tuple(single(self.generator.uniform(-5, 5)) for _ in range(size)) for _ in range(count)]
            columns.append(("_BONE", "float", size, rows, False))
            values["_BONE"] = rows
        return columns, values

    def sparse(self, points, accessor):
        """Some positions are in another buffer view."""
        entry = self.buffer.accessors[accessor]
        kind = self.choices["sparse"]
        if kind == "no":
            return
        some = list(range(len(points))) if kind == "all" else [i for i in range(len(points)) if i % 2]
        indices = self.buffer.view(struct.pack("<%dH" % len(some), *some))
        values = self.buffer.view(b"".join(struct.pack("<3f", *points[i]) for i in some))
        entry["sparse"] = {
            "count": len(some),
            "indices": {"bufferView": indices, "componentType": 5123},
            "values": {"bufferView": values},
        }
        if kind == "all":
            del entry["bufferView"]
            entry.pop("byteOffset", None)

    def primitive(self, points, faces, attributes=None):
        """faces become a mode with indices or without; their corners then are the points."""
        choices, mode = self.choices, self.choices["mode"]
        entry = {"attributes": attributes} if attributes else {}
        corners = [v for face in faces for v in face]
        if mode in ("strip", "fan"):
            (strip,), turned_faces = strips_of(faces)
            b, c, a = strip[:3]
            if mode == "strip":
                corners, faces = list(strip), turned_faces
            else:
                corners = [a, b, c, *strip[3:]] if len(strip) == 4 else list(strip)
        if choices["indices"] == "none":
            points = [points[v] for v in corners]
            # Corners are numbered in their order: a strip or fan names each once.
            number = {v: i for i, v in enumerate(corners)} if mode in ("strip", "fan") else None
            faces = [tuple(number[v] for v in f) for f in faces] if number else [(i, i + 1, i + 2) for i in range(0, len(corners), 3)]
        else:
            kind = choices["indices"]
            content = struct.pack("<%d%s" % (len(corners), KINDS[kind][1]), *corners)
            entry["indices"] = self.buffer.accessor(self.buffer.view(content, 34963), kind, 1, corners)
        modes = {"triangles": 4, "strip": 5, "fan": 6}
        if mode in modes:
            entry["mode"] = modes[mode]
        if choices["material"] == "yes":
            entry["material"] = 0
        if choices["extras"] == "yes":
            entry["extras"] = {"indices": 7}
        values = {}
        if not attributes:
            columns, values = self.columns(len(points))
            broken = [(9e9, 9e9, 9e9) if choices["sparse"] == "some" and i % 2 else p for i, p in enumerate(points)]
            entry["attributes"] = self.buffer.attributes([("POSITION", "float", 3, broken, False), *columns])
            position = self.buffer.accessors[entry["attributes"]["POSITION"]]
            position["min"] = [min(p[a] for p in points) for a in range(3)]
            position["max"] = [max(p[a] for p in points) for a in range(3)]
            self.sparse(points, entry["attributes"]["POSITION"])
        return entry, points, faces, values

    def mesh(self, points, faces):
        """The number of the mesh, and its parts as points, faces and values."""
        choices = self.choices
        half = len(faces) // 2
        several = choices["primitives"] in ("two", "two with the same points")
        groups = [faces[:half], faces[half:]] if several and half else [faces]
        if choices["mode"] in ("strip", "fan"):  # each a primitive of its own, of one or two triangles
            groups = []
            for face in faces:
                goes_on = groups and len(groups[-1]) == 1 and face[:2] == (groups[-1][0][0], groups[-1][0][2])
                groups[-1].append(face) if goes_on else groups.append([face])
        primitives, parts, shared = [], [], None
        for group in groups:
            entry, of_points, of_faces, values = self.primitive(points, group, shared and shared[0])
            if choices["primitives"] == "two with the same points" and choices["indices"] != "none":
                values = shared[1] if shared else values
                shared = shared or (entry["attributes"], values)
            primitives.append(entry)
            parts.append((of_points, of_faces, values))
        if choices["primitives"] == "points beside":
            primitives.append({"attributes": primitives[0]["attributes"], "mode": 0})
        self.meshes.append({"primitives": primitives})
        if choices["names"] != "none":
            self.meshes[-1]["name"] = "Knochen \u00e4\u2713" if choices["names"] == "Unicode" else "bone"
        return len(self.meshes) - 1, parts

    def put(self, parts, rows):
        for points, faces, values in parts:
            first = len(self.truth.points)
            self.truth.points += [apply(rows, p) for p in points]
            for a, b, c in faces:
                self.truth.faces.append(tuple(first + v for v in ((a, c, b) if mirrors(rows) else (a, b, c))))
            for name, of_points in values.items():
                self.point_values.setdefault(name, []).extend(of_points if name != "normals" else [turned(rows, n) for n in of_points])

    def scene_nodes(self):
        choices = self.choices
        kind = choices["node"]
        if choices["tree"] == "mesh in the parent" and kind == "plain":
            kind = "translation"  # beside the mesh of the parent
        properties, rows = node_of(kind)
        mesh, parts = self.mesh(self.shape.points, self.shape.faces)
        around, outer = node_of(choices["parent"])
        has_parent = choices["parent"] != "none"
        child = {**properties, "mesh": mesh}
        if choices["extras"] == "yes":
            child["extras"] = {"a": [1, None]}
        self.nodes.append(child)
        whole = product(outer, rows) if has_parent else rows
        if has_parent:
            self.nodes.append({**around, "children": [0]})
            if choices["tree"] == "mesh in the parent":
                self.nodes[1]["mesh"] = mesh
                self.put(parts, outer)
        self.put(parts, whole)
        roots = [1 if has_parent else 0]
        far = [(1.0, 0.0, 0.0, 7.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0)]
        if choices["tree"] == "mesh twice":
            self.nodes.append({"mesh": mesh, "translation": [7.0, 0.0, 0.0]})
            roots.append(len(self.nodes) - 1)
            self.put(parts, far)
        elif choices["tree"] == "two meshes":
            mesh, parts = self.mesh([tuple(single(c + 3.0) for c in p) for p in self.shape.points], self.shape.faces)
            self.nodes.append({"mesh": mesh})
            roots.append(len(self.nodes) - 1)
            self.put(parts, trs())
        return roots

    def document(self):
        choices = self.choices
        roots = self.scene_nodes()
        document = {"asset": {"version": "2.0", "generator": "a test"}}
        if choices["unused"] != "no":
            mesh, _ = self.mesh([(9.0, 9.0, 9.0), (9.0, 8.0, 9.0), (8.0, 9.0, 9.0)], [(0, 1, 2)])
            if choices["unused"] == "node" and choices["scene"] != "no scenes":
                self.nodes.append({"mesh": mesh})
        scenes = [{"nodes": roots}]
        if choices["scene"] == "default second":
            scenes = [{"nodes": [], "name": "empty"}, *scenes] if False else [{"name": "empty"}, *scenes]
        if choices["scene"] != "no scenes":
            document["scenes"] = scenes
            if choices["scene"] != "not given":
                document["scene"] = len(scenes) - 1
        document["nodes"], document["meshes"] = self.nodes, self.meshes
        if choices["material"] == "yes":
            document["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.1, 1.0]}, "doubleSided": True}]
        if choices["extensions"] == "used":
            document["extensionsUsed"] = ["EXT_of_a_test"]
            self.nodes[0]["extensions"] = {"EXT_of_a_test": {"mesh": 5}}
        if choices["extensions"] == "quantization":
            document["extensionsUsed"] = document["extensionsRequired"] = ["KHR_mesh_quantization"]
        document["accessors"], document["bufferViews"] = self.buffer.accessors, self.buffer.views
        document["buffers"] = [{"byteLength": len(self.buffer.data)}]
        return document

    def write(self):
        document = self.document()
        truth = self.truth
        for name, values in self.point_values.items():
            if name == "_BONE":
                truth.point_arrays[name] = values
            else:
                truth.of_points(name, values)
        indent = 2 if self.choices["json"] == "indented" else None
        text = json.dumps(document, indent=indent, ensure_ascii=self.choices["names"] != "Unicode").encode()
        text += b" " * (-len(text) % 4 + (8 if self.choices["json"] == "padding" else 0))
        data = self.buffer.data + bytes(-len(self.buffer.data) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
        if self.choices["chunks"] == "another behind":
            chunks += struct.pack("<I4s", 4, b"TEST") + b"abcd"
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks, truth


def turned(rows, normal):
    """By the inverse transpose, to length 1."""
    m = [row[:3] for row in rows]
    sign = -1.0 if mirrors(rows) else 1.0
    found = []
    for r in range(3):
        a, b = m[(r + 1) % 3], m[(r + 2) % 3]
        found.append(sign * sum((a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3]) * normal[c] for c in range(3)))
    length = sum(x * x for x in found) ** 0.5
    return tuple(x / length for x in found)


def make(choices, generator):
    return Writer(choices, generator).write()
