# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's XML format of PolyData."""

import base64
import lzma
import struct
import zlib

from truth import ALL_SHAPES, NUMBERS, make_shape, single, spell, strips_of

EXTENSION = "vtp"
TYPES = {  # struct, VTK's name, most
    "UInt8": ("B", "unsigned char", 255),
    "Int8": ("b", "signed char", 127),
    "Int16": ("h", "short", 32767),
    "UInt16": ("H", "unsigned short", 65535),
    "Int32": ("i", "int", 2**31 - 1),
    "UInt32": ("I", "unsigned int", 2**32 - 1),
    "Int64": ("q", "", 2**62 + 1),
    "UInt64": ("Q", "", 2**63 + 1),
    "Float32": ("f", "float", 0),
    "Float64": ("d", "double", 0),
}
ARRAYS = ["none", *TYPES, "three components", "two arrays", "odd name", "normals", "texture", "colors"]
CHOICES = {
    "encoding": ["appended raw", "ascii", "binary", "appended base64", "mixed"],
    "compressor": ["none", "vtkZLibDataCompressor", "vtkLZMADataCompressor"],
    "header type": ["UInt32", "UInt64", "not given"],
    "byte order": ["LittleEndian", "BigEndian"],
    "version": ["1.0", "0.1", "2.2"],
    "shape": ALL_SHAPES,
    "coordinates": ["Float64", "Float32", "Int32", "Float32 with more digits"],
    "index type": ["Int64", "Int32"],
    "numbers": NUMBERS,
    "cells": ["polygons", "strips", "both"],
    "other cells": ["none", "vertices", "lines", "both"],
    "pieces": ["one", "two"],
    "arrays of points": ARRAYS,
    "arrays of cells": ARRAYS,
    "field": ["none", "numbers", "text", "RAS", "LPS"],
    "order": ["data first", "points first", "cells first"],
    "declaration": ["yes", "no"],
    "quotes": ["double", "single", "spaces"],
    "attribute order": ["usual", "reverse"],
    "comments": ["none", "between", "of points"],
    "layout": ["lines", "one line", "tabs"],
    "last line": ["with end", "without end"],
    "mark": ["no", "yes"],
    "line end": ["LF", "CRLF"],
    "empty groups": ["yes", "no"],
    "blocks": ["one", "several"],
}
UNIFORM = {"encoding", "compressor", "shape", "coordinates", "arrays of points", "arrays of cells"}


class Writer:
    def __init__(self, choices, generator):
        self.choices, self.generator = choices, generator
        # Text can have more digits than its type: ours keeps them.
        self.kind = choices["coordinates"].split()[0]
        is_text = choices["encoding"] == "ascii" and self.kind != choices["coordinates"]
        as_single = self.kind == "Float32" and not is_text
        self.truth = make_shape(choices["shape"], generator, as_single=as_single, triangles=choices["cells"] != "polygons")
        if choices["coordinates"] == "Int32":
            self.truth.points = [tuple(float(round(c)) for c in p) for p in self.truth.points]
        self.order = "<" if choices["byte order"] == "LittleEndian" else ">"
        self.appended = b""
        self.lines = []
        faces = self.truth.faces
        half = {"polygons": len(faces), "strips": 0, "both": len(faces) // 2}[choices["cells"]]
        self.polygons, (self.strips, triangles) = faces[:half], strips_of(faces[half:])
        self.truth.faces = self.polygons + triangles
        self.cell_of = list(range(half)) + [half + i for i, s in enumerate(self.strips) for _ in s[2:]]

    def tag(self, name, close=False, **attributes):
        pairs = list(attributes.items())
        if self.choices["attribute order"] == "reverse":
            pairs = pairs[::-1]
        quote = "'" if self.choices["quotes"] == "single" else '"'
        equals = " = " if self.choices["quotes"] == "spaces" else "="
        words = [f"{key}{equals}{quote}{value}{quote}" for key, value in pairs]
        self.lines.append("<" + " ".join([name, *words]) + ("/>" if close else ">"))

    def head(self, *numbers):
        kind = "Q" if self.choices["header type"] == "UInt64" else "I"
        return struct.pack(self.order + str(len(numbers)) + kind, *numbers)

    def packed(self, content, as_base64):
        """Content behind its header, perhaps compressed."""
        encode = base64.b64encode if as_base64 else bytes
        compressor = self.choices["compressor"]
        if compressor == "none":
            return encode(self.head(len(content)) + content)
        compress = zlib.compress if "ZLib" in compressor else lambda b: lzma.compress(b, format=lzma.FORMAT_XZ)
        size = 64 if self.choices["blocks"] == "several" else 32768
        blocks = [content[i : i + size] for i in range(0, len(content), size)]
        last = len(blocks[-1]) % size if blocks else 0
        small = [compress(block) for block in blocks]
        head = self.head(len(blocks), size, last, *map(len, small))
        return encode(head) + encode(b"".join(small))

    def array(self, kind, name, rows, components=None, values=None):
        attributes = {"type": kind, "Name": name}
        if values:
            attributes["NumberOfTuples"] = values
        components = components or (len(rows[0]) if rows else 1)
        if components > 1:
            attributes["NumberOfComponents"] = components
        encoding = self.choices["encoding"]
        if encoding == "mixed":
            encoding = self.generator.choice(["ascii", "binary", "appended raw"])
        flat = [v for row in rows for v in row]
        if encoding == "ascii":
            self.tag("DataArray", **attributes, format="ascii")
            style = self.choices["numbers"]
            words = [spell(float(v), style) if kind.startswith("Float") else str(v) for v in flat]
            per_line = {"one line": len(words) or 1, "tabs": 1}.get(self.choices["layout"], 6)
            for i in range(0, len(words), per_line):
                self.lines.append(("\t" if self.choices["layout"] == "tabs" else " ").join(words[i : i + per_line]))
            self.lines.append("</DataArray>")
            return
        content = struct.pack(self.order + str(len(flat)) + TYPES[kind][0], *flat)
        if encoding == "binary":
            self.tag("DataArray", **attributes, format="binary")
            self.lines.append(self.packed(content, True).decode())
            self.lines.append("</DataArray>")
            return
        self.tag("DataArray", close=True, **attributes, format="appended", offset=len(self.appended))
        self.appended += self.packed(content, self.choices["encoding"] == "appended base64")

    def cells(self, group, rows):
        if not rows and self.choices["empty groups"] == "no":
            return
        self.tag(group)
        kind = self.choices["index type"]
        self.array(kind, "connectivity", [(v,) for row in rows for v in row])
        self.array(kind, "offsets", [(sum(map(len, rows[: i + 1])),) for i in range(len(rows))])
        self.lines.append(f"</{group}>")

    def numbers(self, kind, count, components=1):
        most, pick = TYPES[kind][2], self.generator
        if most == 0:
            return [tuple(single(pick.uniform(-5, 5)) for _ in range(components)) for _ in range(count)]
        least = 0 if kind.startswith("U") else -most
        return [tuple(pick.choice([least, most, pick.randint(least, most)]) for _ in range(components)) for _ in range(count)]

    def planned(self, of_points, count):
        """Name, type and rows of each array."""
        choice = self.choices["arrays of points" if of_points else "arrays of cells"]
        prefix = "p_" if of_points else "c_"
        if choice in TYPES:
            return [(prefix + choice, choice, self.numbers(choice, count))]
        if choice == "normals":
            return [("Normals", "Float32", [((0.0, 0.0, 1.0), (0.0, 1.0, 0.0))[i % 2] for i in range(count)])]
        if choice == "texture":
            return [("TCoords", "Float32", [((i + 1) / 64.0, 1.0 - i / 32.0) for i in range(count)])]
        if choice == "colors":
            return [(prefix + "RGB", "UInt8", [(255 - i, 20 + 11 * i, 7 * i) for i in range(count)])]
        if choice == "three components":
            return [(prefix + "three", "Float64", self.numbers("Float64", count, 3))]
        if choice == "two arrays":
            return [(prefix + k, k, self.numbers(k, count)) for k in ("Int16", "Float32")]
        if choice == "odd name":
            return [(prefix + "a &lt;b&gt; &amp; c", "Float32", self.numbers("Float32", count))]
        return []

    def data(self, of_points, arrays, rows_of):
        if not arrays:
            return
        attributes = {}
        for kind, active in (("normals", "Normals"), ("texture", "TCoords")):
            if self.choices["arrays of points" if of_points else "arrays of cells"] == kind:
                attributes[active] = active
        self.tag("PointData" if of_points else "CellData", **attributes)
        for name, kind, rows in arrays:
            self.array(kind, name, rows_of(rows), len(rows[0]))
        self.lines.append("</PointData>" if of_points else "</CellData>")

    def keep(self, arrays, of_points, first):
        for name, kind, rows in arrays:
            plain = name.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
            if name in ("Normals", "TCoords"):
                key = "normals" if name == "Normals" else "uv"
                if of_points:
                    self.truth.of_points(key, rows)
                elif key == "uv":
                    self.truth.corners.setdefault(key, [[rows[first + c]] * len(f) for c, f in zip(self.cell_of, self.truth.faces)])
                continue
            (self.truth.point_arrays if of_points else self.truth.cell_arrays)[plain] = rows if of_points else [rows[first + i] for i in self.cell_of]
            if TYPES[kind][1]:
                self.truth.types[plain] = TYPES[kind][1]

    def pieces(self):
        """For each piece its points, vertices, lines, polygons and strips; vertices and lines are in the first."""
        truth = self.truth
        kind = self.choices["other cells"]
        truth.vertices = [(0,)] if kind in ("vertices", "both") else []
        truth.lines = [(0, 1, 2)] if kind in ("lines", "both") else []
        polygons, strips = self.polygons, self.strips
        if self.choices["pieces"] == "one":
            return [(truth.vertices, truth.lines, polygons, strips)]
        p, s = len(polygons) // 2, len(strips) // 2
        return [(truth.vertices, truth.lines, polygons[:p], strips[:s]), ([], [], polygons[p:], strips[s:])]

    def piece(self, number, groups, points, cells, first_cells):
        truth, choices = self.truth, self.choices
        counts = dict(zip(("NumberOfVerts", "NumberOfLines", "NumberOfPolys", "NumberOfStrips"), map(len, groups)))
        if choices["empty groups"] == "no":
            counts = {k: v for k, v in counts.items() if v}
        self.tag("Piece", NumberOfPoints=len(truth.points), **counts)
        # Cells of all pieces in the order of the result: polygons of both, then strips of both.
        polygons = [self.polygons.index(f) for f in groups[2]]
        strips = [len(self.polygons) + self.strips.index(f) for f in groups[3]]
        chosen = (list(range(first_cells)) if number == 0 else []) + [first_cells + i for i in polygons + strips]
        parts = {
            "points": lambda: self.points(),
            "point data": lambda: self.data(True, points, lambda rows: rows),
            "cell data": lambda: self.data(False, cells, lambda rows: [rows[i] for i in chosen]),
            "cells": lambda: [self.cells(g, rows) for g, rows in zip(("Verts", "Lines", "Polys", "Strips"), groups)],
        }
        orders = {
            "data first": ("point data", "cell data", "points", "cells"),
            "points first": ("points", "cells", "point data", "cell data"),
            "cells first": ("cells", "cell data", "points", "point data"),
        }
        for name in orders[choices["order"]]:
            parts[name]()
            if choices["comments"] == "between":
                self.lines.append("<!-- <DataArray> & more -->")
        self.lines.append("</Piece>")

    def points(self):
        self.tag("Points")
        if self.choices["comments"] == "of points":
            self.lines.append("<!-- in mm -->")
        as_is = self.kind != "Int32"
        self.array(self.kind, "Points", self.truth.points if as_is else [tuple(map(int, p)) for p in self.truth.points])
        self.lines.append("</Points>")

    def field(self):
        choice = self.choices["field"]
        if choice == "none":
            return
        self.tag("FieldData")
        if choice == "numbers":
            self.array("Float64", "Patient", [(1.5,), (2.5,)], values=2)
            self.truth.field_arrays["Patient"] = [1.5, 2.5]
        else:
            name, text = ("Note", "a name") if choice == "text" else ("SPACE", choice)
            self.tag("Array", type="String", Name=name, NumberOfTuples=1, format="ascii")
            self.lines.append(" ".join(str(ord(c)) for c in text) + " 0")
            self.lines.append("</Array>")
            if name == "SPACE":
                self.truth.frame = choice
            else:
                self.truth.field_arrays[name] = [text]
        self.lines.append("</FieldData>")

    def write(self):
        choices, truth = self.choices, self.truth
        if choices["pieces"] == "two" and choices["cells"] == "both" and choices["arrays of cells"] != "none":
            truth.rejected = "VTK's reader mixes up the arrays of polygons and strips"
        groups = self.pieces()
        first = len(truth.vertices) + len(truth.lines)
        points = self.planned(True, len(truth.points))
        cells = self.planned(False, first + len(self.polygons) + len(self.strips))
        if choices["declaration"] == "yes":
            self.lines.append('<?xml version="1.0"?>')
        head = {"type": "PolyData", "version": choices["version"], "byte_order": choices["byte order"]}
        if choices["header type"] != "not given":
            head["header_type"] = choices["header type"]
        if choices["compressor"] != "none":
            head["compressor"] = choices["compressor"]
        self.tag("VTKFile", **head)
        self.tag("PolyData")
        self.field()
        for number, group in enumerate(groups):
            self.piece(number, group, points, cells, first)
        self.keep(points, True, first)
        self.keep(cells, False, first)
        self.lines.append("</PolyData>")
        end = "\r\n" if choices["line end"] == "CRLF" else "\n"
        out = (b"\xef\xbb\xbf" if choices["mark"] == "yes" else b"") + end.join(self.lines).encode() + end.encode()
        if self.appended:
            encoding = "base64" if choices["encoding"] == "appended base64" else "raw"
            out += f'<AppendedData encoding="{encoding}">\n_'.encode() + self.appended + b"\n</AppendedData>" + end.encode()
        return out + b"</VTKFile>" + (b"" if choices["last line"] == "without end" else end.encode()), truth


def make(choices, generator):
    return Writer(choices, generator).write()
