# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's legacy format: PolyData in text and binary, before and since version 5."""

import struct

from truth import ALL_SHAPES, NUMBERS, make_shape, single, spell, strips_of

EXTENSION = "vtk"
# struct, VTK's name, most
TYPES = {
    "unsigned_char": ("B", "unsigned char", 255),
    "char": ("b", "char", 127),
    "short": ("h", "short", 32767),
    "unsigned_short": ("H", "unsigned short", 65535),
    "int": ("i", "int", 2**31 - 1),
    "unsigned_int": ("I", "unsigned int", 2**32 - 1),
    "vtktypeint64": ("q", "long long", 2**62 + 1),
    "float": ("f", "float", 0),
    "double": ("d", "double", 0),
}
ARRAYS = ["none", *TYPES, "two", "four components", "color scalars", "normals", "vectors", "texture", "tensors", "field", "own table"]
CHOICES = {
    "form": ["ASCII", "BINARY"],
    "version": ["3.0", "2.0", "4.2", "5.1"],
    "shape": ALL_SHAPES,
    "coordinates": ["double", "float", "int", "float with more digits"],
    "numbers": NUMBERS,
    "cells": ["polygons", "strips", "both"],
    "offsets": ["vtktypeint64", "int"],
    "other cells": ["none", "vertices", "lines", "both", "behind"],
    "arrays of points": ARRAYS,
    "arrays of cells": ARRAYS,
    "data order": ["points first", "cells first"],
    "field": ["none", "numbers", "text", "RAS", "LPS"],
    "title": ["text", "empty", "RAS", "LPS", "BINARY"],
    "case": ["usual", "lower"],
    "names": ["plain", "percent"],
    "metadata": ["no", "yes"],
    "layout": ["lines", "one line", "a number a line"],
    "line end": ["LF", "CRLF"],
    "mark": ["no", "yes"],
    "blank lines": ["no", "yes"],
    "last line": ["with end", "without end"],
}
UNIFORM = {"form", "version", "shape", "coordinates", "arrays of points", "arrays of cells"}


class Writer:
    def __init__(self, choices, generator):
        self.choices, self.generator = choices, generator
        # Text can have more digits than its type: ours keeps them.
        self.kind = choices["coordinates"].split()[0]
        is_text = choices["form"] == "ASCII" and self.kind != choices["coordinates"]
        as_single = self.kind == "float" and not is_text
        self.truth = make_shape(choices["shape"], generator, as_single=as_single, triangles=choices["cells"] != "polygons")
        if choices["coordinates"] == "int":
            self.truth.points = [tuple(float(round(c)) for c in p) for p in self.truth.points]
        self.end = "\r\n" if choices["line end"] == "CRLF" and choices["form"] == "ASCII" else "\n"
        self.out = b"\xef\xbb\xbf" if choices["mark"] == "yes" else b""
        self.first = 0  # cells before the faces
        faces = self.truth.faces
        half = {"polygons": len(faces), "strips": 0, "both": len(faces) // 2}[choices["cells"]]
        self.polygons, (self.strips, triangles) = faces[:half], strips_of(faces[half:])
        self.truth.faces = self.polygons + triangles
        self.cell_of = list(range(half)) + [half + i for i, s in enumerate(self.strips) for _ in s[2:]]

    def line(self, *words):
        words = list(map(str, words))
        if self.choices["case"] == "lower" and words and words[0] != "#":
            words = [w.lower() if w.isupper() and len(w) > 1 and w not in ("SPACE", "RAS", "LPS") else w for w in words]
        self.out += (" ".join(words) + self.end).encode()

    def values(self, kind, rows):
        """Rows of numbers, in text or binary."""
        if self.choices["form"] == "BINARY":
            flat = [v for row in rows for v in row]
            self.out += struct.pack(">%d%s" % (len(flat), TYPES[kind][0]), *flat) + b"\n"
            return
        style = self.choices["numbers"]
        texts = [[spell(float(v), style) if kind in ("float", "double") else str(v) for v in row] for row in rows]
        layout = self.choices["layout"]
        if layout == "one line":
            texts = [[w for row in texts for w in row]]
        elif layout == "a number a line":
            texts = [[w] for row in texts for w in row]
        for row in texts:
            self.line(*row)

    def blank(self):
        if self.choices["blank lines"] == "yes":
            self.line()

    def cells(self, keyword, rows):
        size = sum(len(row) + 1 for row in rows)
        if self.choices["version"] != "5.1":
            self.line(keyword, len(rows), size)
            self.values("int", [[len(row), *row] for row in rows])
            return
        self.line(keyword, len(rows) + 1, size - len(rows))
        offsets = [sum(map(len, rows[:i])) for i in range(len(rows) + 1)]
        kind = self.choices["offsets"]
        self.line("OFFSETS", kind)
        self.values(kind, [offsets])
        self.line("CONNECTIVITY", kind)
        self.values(kind, rows)

    def numbers(self, kind, count, components):
        most, pick = TYPES[kind][2], self.generator
        if most == 0:
            number = (lambda: single(pick.uniform(-5, 5))) if kind == "float" else (lambda: pick.uniform(-5, 5))
        else:
            signed = kind in ("char", "short", "int", "vtktypeint64")
            # Text of 8 bits that VTK takes for letters is read by it as numbers, too.
            number = lambda: pick.choice([-most if signed else 0, most, pick.randint(0, most)])  # noqa: E731
        return [tuple(number() for _ in range(components)) for _ in range(count)]

    def name(self, text):
        """As the file has it, and as it is."""
        return (text + "%20a%25", text + " a%") if self.choices["names"] == "percent" else (text, text)

    def keep(self, of_points, name, rows, kind=None):
        arrays = self.truth.point_arrays if of_points else self.truth.cell_arrays
        arrays[name] = rows if of_points else [rows[self.first + i] for i in self.cell_of]
        if kind:
            self.truth.types[name] = TYPES[kind][1]

    def scalars(self, of_points, count, kind, components=1, table="default"):
        written, name = self.name(("p_" if of_points else "c_") + kind)
        rows = self.numbers(kind, count, components)
        self.line("SCALARS", written, kind, components)
        self.line("LOOKUP_TABLE", table)
        self.values(kind, rows)
        self.keep(of_points, name, rows, kind)

    def attribute(self, of_points, count):
        choice = self.choices["arrays of points" if of_points else "arrays of cells"]
        prefix = "p_" if of_points else "c_"
        written, name = self.name(prefix + "values")
        if choice in TYPES:
            self.scalars(of_points, count, choice)
        elif choice == "two":
            self.scalars(of_points, count, "float")
            self.scalars(of_points, count, "short")
        elif choice == "four components":
            self.scalars(of_points, count, "double", 4)
        elif choice == "own table":
            self.scalars(of_points, count, "float", 1, "mine")
            self.line("LOOKUP_TABLE", "mine", 2)
            if self.choices["form"] == "BINARY":
                self.values("unsigned_char", [(0, 0, 0, 255), (255, 255, 255, 255)])
            else:
                self.values("float", [(0, 0, 0, 1), (1, 1, 1, 1)])
        elif choice == "color scalars":
            rows = self.numbers("unsigned_char", count, 3)
            self.line("COLOR_SCALARS", written, 3)
            if self.choices["form"] == "BINARY":
                self.values("unsigned_char", rows)
            else:
                self.values("float", [[v / 255.0 for v in row] for row in rows])
            self.keep(of_points, name, rows)
        elif choice in ("normals", "vectors"):
            rows = [((0.6, 0.0, 0.8), (0.0, 1.0, 0.0), (0.0, 0.0, -1.0))[i % 3] for i in range(count)]
            self.line(choice.upper(), written, "double")
            self.values("double", rows)
            if choice == "normals" and of_points:
                self.truth.of_points("normals", rows)
            self.keep(of_points, name, rows)
        elif choice == "texture":
            rows = [((i + 1) / 64.0, 1.0 - i / 32.0) for i in range(count)]
            self.line("TEXTURE_COORDINATES", written, 2, "float")
            self.values("float", rows)
            if of_points:
                self.truth.of_points("uv", rows)
            self.keep(of_points, name, rows)
        elif choice == "tensors":
            rows = self.numbers("float", count, 9)
            self.line("TENSORS", written, "float")
            self.values("float", rows)
            self.keep(of_points, name, rows)
        elif choice == "field":
            self.line("FIELD", "FieldData", 2)
            for kind, components in (("int", 1), ("double", 3)):
                rows = self.numbers(kind, count, components)
                written, name = self.name(prefix + "field_" + kind)
                self.line(written, components, count, kind)
                self.values(kind, rows)
                self.keep(of_points, name, rows, kind)
                if self.choices["metadata"] == "yes":
                    self.line("METADATA")
                    self.line("INFORMATION", 0)
                    self.line()

    def field(self):
        choice = self.choices["field"]
        if choice == "none":
            return
        self.line("FIELD", "FieldData", 1)
        if choice == "numbers":
            self.line("Patient", 1, 2, "double")
            self.values("double", [(1.5,), (2.5,)])
            self.truth.field_arrays["Patient"] = [1.5, 2.5]
            return
        text = {"text": "a name"}.get(choice, choice)
        name = "Note" if choice == "text" else "SPACE"
        self.line(name, 1, 1, "string")
        if self.choices["form"] == "BINARY":
            self.out += bytes([0xC0 | len(text)]) + text.encode() + b"\n"
        else:
            self.line(text.replace(" ", "%20"))
        if name == "SPACE":
            self.truth.frame = self.truth.frame or choice  # the title has it first, as in 3D Slicer
        else:
            self.truth.field_arrays[name] = [text]

    def surface(self):
        truth, choices = self.truth, self.choices
        kind = choices["other cells"]
        truth.vertices = [(0,), (1,)] if kind in ("vertices", "both", "behind") else []
        truth.lines = [(0, 1, 2)] if kind in ("lines", "both") else []
        self.first = len(truth.vertices) + len(truth.lines)
        if kind != "behind" and truth.vertices:
            self.cells("VERTICES", truth.vertices)
        if truth.lines:
            self.cells("LINES", truth.lines)
        if self.polygons:
            self.cells("POLYGONS", self.polygons)
        if self.strips:
            self.cells("TRIANGLE_STRIPS", self.strips)
        self.blank()
        if kind == "behind":
            self.cells("VERTICES", truth.vertices)

    def write(self):
        truth, choices = self.truth, self.choices
        self.line("#", "vtk", "DataFile", "Version", choices["version"])
        title = {"text": "made for a test", "empty": "", "BINARY": "BINARY"}.get(choices["title"])
        if title is None:
            title = "3D Slicer output. SPACE=" + choices["title"]
            truth.frame = choices["title"]
        self.out += (title + self.end).encode()
        self.line(choices["form"])
        self.blank()
        self.line("DATASET", "POLYDATA")
        self.field()
        self.blank()
        self.line("POINTS", len(truth.points), self.kind)
        as_is = self.kind != "int"
        self.values(self.kind, truth.points if as_is else [tuple(map(int, p)) for p in truth.points])
        self.surface()
        order = (True, False) if choices["data order"] == "points first" else (False, True)
        for of_points in order:
            if choices["arrays of points" if of_points else "arrays of cells"] != "none":
                count = len(truth.points) if of_points else self.first + len(self.polygons) + len(self.strips)
                self.blank()
                self.line("POINT_DATA" if of_points else "CELL_DATA", count)
                self.attribute(of_points, count)
        if choices["last line"] == "without end" and self.out.endswith(self.end.encode()):
            self.out = self.out[: -len(self.end)]
        return self.out, truth


def make(choices, generator):
    return Writer(choices, generator).write()
