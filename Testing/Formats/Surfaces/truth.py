# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What a variant holds: the generator's own arrays, with which every reader is compared."""

import dataclasses
import struct
from decimal import Decimal

SHAPES = {
    # Vertices and polygons, counterclockwise from outside. No two vertices are equal.
    "tetrahedron": (((0, 0, 0), (9, 0, 0), (0, 9, 0), (0, 0, 9)), ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))),
    "cube": (
        tuple((9 * (i & 1), 8 * (i >> 1 & 1), 7 * (i >> 2)) for i in range(8)),
        ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)),
    ),
    # A letter L and a letter V beside it: concave, open.
    "concave": (
        ((0, 0, 0), (9, 0, 0), (9, 3, 0), (3, 3, 0), (3, 9, 0), (0, 9, 0), (12, 0, 0), (15, 9, 0), (12, 4, 0), (9.5, 9, 0)),
        ((0, 1, 2, 3, 4, 5), (6, 7, 8, 9)),
    ),
    "open": (((0, 0, 0), (9, 0, 1), (9, 8, 0), (0, 8, 1), (4, 4, 5)), ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4))),
    "two components": (
        ((0, 0, 0), (9, 0, 0), (0, 9, 0), (0, 0, 9), (20, 0, 0), (29, 0, 0), (29, 9, 1), (20, 9, 2)),
        ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2), (4, 5, 6), (4, 6, 7)),
    ),
}
ALL_SHAPES = list(SHAPES)


@dataclasses.dataclass
class Truth:
    """points: 3 numbers each; faces: their vertices. corners: "uv", "normals", "colors" -> for each face the value of each
    corner or None. point_arrays, cell_arrays: name -> values for each point, face; a value is a tuple."""

    points: list
    faces: list
    corners: dict = dataclasses.field(default_factory=dict)
    point_arrays: dict = dataclasses.field(default_factory=dict)
    cell_arrays: dict = dataclasses.field(default_factory=dict)
    field_arrays: dict = dataclasses.field(default_factory=dict)
    lines: list = dataclasses.field(default_factory=list)
    vertices: list = dataclasses.field(default_factory=list)
    frame: str = ""
    unit: float = 1.0  # of the coordinates in the file, in those of points
    types: dict = dataclasses.field(default_factory=dict)  # of arrays, as VTK names them
    rejected: str = ""  # why the file breaks its specification
    words: tuple = ()  # options of the program, such as --unit

    def of_points(self, name, values):
        """The value of each point, at the corners of all faces."""
        self.corners[name] = [[values[v] for v in face] for face in self.faces]

    def of_faces(self, name, values):
        self.corners[name] = [[values[i]] * len(face) for i, face in enumerate(self.faces)]


def single(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


def make_shape(name, generator, triangles=False, as_single=False, scale=7.0):
    """The truth of a shape whose coordinates need all 17 digits (single precision: all 9)."""
    vertices, faces = SHAPES[name]
    offset = [generator.uniform(-200, 200) for _ in range(3)]
    points = [tuple(scale * c + o + generator.uniform(-0.1, 0.1) for c, o in zip(v, offset)) for v in vertices]
    if as_single:
        points = [tuple(map(single, p)) for p in points]
    if triangles:
        faces = [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]
    return Truth(points, [tuple(f) for f in faces])


NUMBERS = ["shortest", "17 digits", "exponent", "capital", "plus", "long", "bare", "zeros"]


def spell(value, style):
    """A decimal that is this double. Text readers round it to nearest."""
    sign = "-" if value < 0 or str(value)[0] == "-" else "+" if style == "plus" else ""
    size = abs(value)
    if style == "exponent":
        text = "%.16e" % size
    elif style == "capital":
        text = "%.16E" % size
    elif style == "17 digits":
        text = "%.17g" % size
    elif style == "long":
        text = format(Decimal(size), "f")  # all digits that the double has
    else:
        text = repr(size)
        if style == "bare" and "e" not in text:
            whole, _, part = text.partition(".")
            text = ("" if whole == "0" and part != "0" else whole) + "." + ("" if part == "0" else part)
        elif style == "zeros":
            text = "00" + text
    return sign + text


LINE_ENDS = {"LF": "\n", "CRLF": "\r\n", "CR": "\r"}


def as_bytes(lines, choices, generator):
    """Lines of text with the line end, the byte-order mark and the end of the last line of the choices."""
    ends = list(LINE_ENDS.values())[:2] if choices["line end"] == "mixed" else [LINE_ENDS[choices["line end"]]]
    text = ""
    for i, line in enumerate(lines):
        last = i == len(lines) - 1 and choices.get("last line") == "without end"
        text += line + ("" if last else generator.choice(ends))
    return (b"\xef\xbb\xbf" if choices.get("mark") == "yes" else b"") + text.encode("utf-8")


TEXT_CHOICES = {
    "line end": ["LF", "CRLF", "CR", "mixed"],
    "mark": ["no", "yes"],
    "last line": ["with end", "without end"],
}
BLANKS = ["one", "tab", "several", "indented", "trailing", "no-break"]


def spaced(words, blanks, generator):
    """A line of words with blanks of a kind."""
    if blanks == "several":
        return "".join(w + generator.choice([" ", "  ", " \t ", "\t"]) for w in words).rstrip()
    between = {"tab": "\t", "no-break": "\u00a0"}.get(blanks, " ")
    line = between.join(words)
    return {"indented": "  \t" + line, "trailing": line + " \t "}.get(blanks, line)


def strips_of(triangles):
    """Strips of two triangles where the next one goes on as a fan, otherwise of one, and their triangles as a reader has them."""
    strips, faces, i = [], [], 0
    while i < len(triangles):
        a, b, c = triangles[i]
        if i + 1 < len(triangles) and triangles[i + 1][:2] == (a, c):
            d = triangles[i + 1][2]
            strips.append((b, c, a, d))
            faces += [(b, c, a), (c, d, a)]
            i += 2
        else:
            strips.append((a, b, c))
            faces.append((a, b, c))
            i += 1
    return strips, faces
