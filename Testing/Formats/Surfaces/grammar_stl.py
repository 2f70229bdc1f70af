# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""STL in text."""

from truth import ALL_SHAPES, BLANKS, NUMBERS, TEXT_CHOICES, as_bytes, make_shape, spaced, spell

EXTENSION = "stl"
CHOICES = {
    **TEXT_CHOICES,
    "shape": ALL_SHAPES,
    "numbers": NUMBERS,
    "case": ["lower", "upper", "capital"],
    "blanks": BLANKS,
    "name": ["none", "word", "words", "facet", "numbers", "RAS", "LPS"],
    "solids": ["one", "two", "empty one", "three"],
    "blank lines": ["no", "first", "between"],
    "end": ["endfacet", "end facet"],
    "name at the end": ["no", "yes"],
    "normals": ["right", "zero", "other", "nan", "exponent"],
    "lines": ["usual", "a word a line", "a facet a line"],
    "between": ["nothing", "blank line"],
}
UNIFORM = {"shape", "name"}


class Writer:
    def __init__(self, choices, generator):
        self.choices, self.generator = choices, generator
        self.truth = make_shape(choices["shape"], generator, triangles=True)
        self.lines, self.pending = [], []

    def line(self, *words):
        form = self.choices["lines"]
        case = {"lower": str.lower, "upper": str.upper, "capital": str.capitalize}[self.choices["case"]]
        keywords = ("solid", "facet", "normal", "outer", "loop", "vertex", "endloop", "endfacet", "endsolid", "end")
        is_solid = words[0] in ("solid", "endsolid")
        cased = [case(w) if w in keywords and (i == 0 or not is_solid) else w for i, w in enumerate(words)]
        if is_solid or form == "usual":
            self.lines.append(spaced(cased, self.choices["blanks"], self.generator))
        elif form == "a word a line":
            self.lines += [spaced([w], self.choices["blanks"], self.generator) for w in cased]
        else:
            self.pending += cased
            if words[0] == "endfacet" or words[:2] == ("end", "facet"):
                self.lines.append(spaced(self.pending, self.choices["blanks"], self.generator))
                self.pending = []
        if self.choices["blank lines"] == "between" and self.generator.random() < 0.2:
            self.lines.append("")

    def facet(self, face):
        points = [self.truth.points[v] for v in face]
        normals = {"zero": "0 0 0", "other": "0 0 1", "nan": "nan nan nan", "exponent": "1e0 -0.0e+00 0E0"}
        normal = normals.get(self.choices["normals"]) or "%.6g %.6g %.6g" % unit_normal(points)
        self.line("facet", "normal", *normal.split())
        self.line("outer", "loop")
        for point in points:
            self.line("vertex", *[spell(c, self.choices["numbers"]) for c in point])
        self.line("endloop")
        self.line(*self.choices["end"].split())

    def solid(self, faces, number):
        kind = self.choices["name"]
        name = {"word": "bone", "words": "left bone of 3", "facet": "facet", "numbers": "1 2 3", "none": ""}.get(kind)
        if name is None:
            name = "3D Slicer output. SPACE=" + kind
            self.truth.frame = kind
        name = (name + str(number) if kind == "word" else name).split()
        self.line("solid", *name)
        for face in faces:
            self.facet(face)
        self.line("endsolid", *(name if self.choices["name at the end"] == "yes" else []))

    def write(self):
        faces = self.truth.faces
        if self.choices["blank lines"] == "first":
            self.lines += ["", "  "]
        kind = self.choices["solids"]
        parts = {"one": [faces], "two": [faces[:1], faces[1:]], "empty one": [faces, []]}.get(kind) or [faces[:1], faces[1:2], faces[2:]]
        for number, part in enumerate(parts):
            self.solid(part, number)
            if self.choices["between"] == "blank line":
                self.lines.append("")
        return as_bytes(self.lines, self.choices, self.generator), self.truth


def unit_normal(points):
    a, b, c = points
    u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = sum(x * x for x in n) ** 0.5
    return tuple(x / length for x in n)


def make(choices, generator):
    return Writer(choices, generator).write()
