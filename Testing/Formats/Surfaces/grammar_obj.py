# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Wavefront OBJ."""

from truth import ALL_SHAPES, BLANKS, NUMBERS, TEXT_CHOICES, as_bytes, make_shape, single, spaced, spell

EXTENSION = "obj"
CHOICES = {
    **TEXT_CHOICES,
    "shape": ALL_SHAPES,
    "numbers": NUMBERS,
    "case": ["lower", "upper"],
    "blanks": BLANKS,
    "comments": ["none", "lines", "at ends", "in lines that go on", "with a backslash"],
    "continued": ["none", "faces", "vertices"],
    "blank lines": ["no", "yes"],
    "indices": ["positive", "negative", "both"],
    "corner": ["v", "v/vt", "v//vn", "v/vt/vn", "v/0/vn", "v/0/0", "v/vt/", "v//"],
    "texture": ["of vertices", "of corners"],
    "texture numbers": [2, 3, 1],
    "normals": ["of vertices", "of faces"],
    "colors": ["none", "to 1", "to 255", "with alpha", "weight 1", "weight"],
    "groups": ["none", "g", "g of two names", "g without a name", "o", "s", "all"],
    "materials": ["none", "one", "two", "blank in the name", "before vertices", "library of two files"],
    "order": ["vertices first", "interleaved", "faces first"],
    "others": ["none", "line", "point", "both"],
    "keyword": ["f", "fo"],
    "unused": ["no", "yes"],
    "space": ["none", "RAS", "LPS"],
    "display": ["no", "yes"],
    "curves": ["no", "yes"],
}
UNIFORM = {"shape", "corner", "texture", "normals", "colors"}


class Writer:
    def __init__(self, choices, generator):
        self.choices, self.generator = choices, generator
        self.truth = make_shape(choices["shape"], generator)
        self.lines = []

    def number(self, value):
        return spell(value, self.choices["numbers"])

    def line(self, keyword, *words, goes_on=False):
        choices, pick = self.choices, self.generator
        keyword = keyword.upper() if choices["case"] == "upper" else keyword
        line = spaced([keyword, *words], choices["blanks"], pick)
        if goes_on and len(words) > 1:
            at = pick.randrange(1, len(words) + (self.choices["last line"] == "with end"))
            first = spaced([keyword, *words[:at]], choices["blanks"], pick).rstrip()
            self.lines.append(first + " \\")
            line = spaced(words[at:], choices["blanks"], pick)
            if choices["comments"] == "in lines that go on":
                line += " # f 1 2 3"
        elif choices["comments"] == "at ends" and keyword.lower() in ("v", "vt", "vn", "f", "fo", "l"):
            line += " # v 1 2 3"
        self.lines.append(line)
        if choices["comments"] == "lines":
            self.lines.append(pick.choice(["# v 1 2 3", "#f 1 2 3", "  # usemtl x", "#"]))
        if choices["comments"] == "with a backslash" and keyword.lower() == "vt":
            self.lines.append("# a path C:\\bones\\x")
        if choices["blank lines"] == "yes" and pick.random() < 0.4:
            self.lines.append(pick.choice(["", "  ", "\t"]))

    def vertex(self, number):
        kind = self.choices["colors"]
        point, words = self.truth.points[number], []
        if kind in ("to 1", "to 255", "with alpha"):
            color = self.color(number)
            words = [str(c) if kind == "to 255" else "%.6f" % (c / 255.0) for c in color]
            words += ["1.0"] if kind == "with alpha" else []
        elif kind.startswith("weight"):
            words = ["1.0" if kind == "weight 1" else "0.5"]
        self.line("v", *map(self.number, point), *words, goes_on=self.choices["continued"] == "vertices")

    @staticmethod
    def color(number):
        return (255 - number, 20 + 11 * number % 200, 2 + 7 * number)

    def index(self, number, so_far):
        """One-based; from the end where the one that it names was there before."""
        kind = self.choices["indices"]
        if number < so_far and (kind == "negative" or (kind == "both" and self.generator.random() < 0.5)):
            return str(number - so_far)
        return str(number + 1)

    def tuples(self):
        """Texture coordinates and normals, with the number of each for each corner."""
        truth, choices = self.truth, self.choices
        corner = choices["corner"]
        self.uv, self.uv_of, self.normals, self.normal_of = [], [], [], []
        if corner in ("v/vt", "v/vt/vn", "v/vt/"):
            per_vertex = choices["texture"] == "of vertices"
            count = len(truth.points) if per_vertex else sum(map(len, truth.faces))
            size = choices["texture numbers"]
            self.uv = [((i + 1) / 64.0, 0.0 if size == 1 else 1.0 - i / 32.0) for i in range(count)]
            numbers = iter(range(count))
            self.uv_of = [[v if per_vertex else next(numbers) for v in face] for face in truth.faces]
            truth.corners["uv"] = [[self.uv[i] for i in face] for face in self.uv_of]
        if corner in ("v//vn", "v/vt/vn", "v/0/vn"):
            per_vertex = choices["normals"] == "of vertices"
            count = len(truth.points) if per_vertex else len(truth.faces)
            self.normals = [tuple(single(x) for x in ((0.6, 0.0, 0.8), (0, 1, 0), (-0.28, 0.96, 0))[i % 3]) for i in range(count)]
            self.normal_of = [[v if per_vertex else i for v in face] for i, face in enumerate(truth.faces)]
            truth.corners["normals"] = [[self.normals[i] for i in face] for face in self.normal_of]

    def write_tuples(self):
        size = self.choices["texture numbers"]
        for u, v in self.uv:
            self.line("vt", *[repr(u), repr(v), "0.5"][:size])
        for normal in self.normals:
            self.line("vn", *map(repr, normal))

    def face(self, number, vertices, tuples):
        form, words = self.choices["corner"], []
        for k, v in enumerate(self.truth.faces[number]):
            word = self.index(v, vertices)
            uv = self.index(self.uv_of[number][k], len(self.uv) if tuples else 0) if self.uv else ""
            normal = self.index(self.normal_of[number][k], len(self.normals) if tuples else 0) if self.normals else ""
            word = form.replace("vn", normal).replace("vt", uv).replace("v", word, 1) if form != "v" else word
            words.append(word)
        self.line(self.choices["keyword"], *words, goes_on=self.choices["continued"] == "faces")

    def states(self):
        """For each face the lines before it, and what ours makes of them: numbers of groups and materials."""
        truth, count = self.truth, len(self.truth.faces)
        before = [[] for _ in range(count)]
        half = count // 2
        groups = self.choices["groups"]
        names = {"g of two names": ["left right", "both"], "g without a name": ["", "one"]}.get(groups, ["one", "two"])
        if groups != "none":
            for at, name in zip((0, half), names):
                keywords = {"o": "o", "s": "s", "all": "ogs"}.get(groups, "g")
                before[at] += [(k, "1" if k == "s" else name) for k in keywords]
        if groups.startswith("g") or groups == "all":
            truth.cell_arrays["GroupIds"] = [(0.0 if i < half else 1.0,) for i in range(count)]
        materials = self.choices["materials"]
        if materials != "none":
            two = materials in ("two", "before vertices")
            names = ["dark bone", "x"] if materials == "blank in the name" else ["bone", "metal"]
            before[0].append(("usemtl", names[0]))
            if two:
                before[half].append(("usemtl", names[1]))
            truth.cell_arrays["MaterialIds"] = [(1 if two and i >= half else 0,) for i in range(count)]
            truth.field_arrays["MaterialNames"] = names[: 2 if two else 1]
        return before

    def head(self):
        if self.choices["space"] != "none":
            self.lines.append("# 3D Slicer output. SPACE=" + self.choices["space"])
            self.truth.frame = self.choices["space"]
        if self.choices["materials"] == "library of two files":
            self.line("mtllib", "one.mtl", "two.mtl")
        elif self.choices["materials"] != "none":
            self.line("mtllib", "one.mtl")
        if self.choices["display"] == "yes":
            self.line("bevel", "on")
            self.line("lod", "100")
        if self.choices["curves"] == "yes":
            self.line("vp", "0.5", "0.5")

    def elements(self):
        truth, kind = self.truth, self.choices["others"]
        if kind in ("line", "both"):
            truth.lines = [(0, 1)]
            self.line("l", "1", "2")
        if kind in ("point", "both"):
            truth.vertices = [(2,)]
            self.line("p", "3")

    def write(self):
        truth, choices = self.truth, self.choices
        if choices["unused"] == "yes":
            truth.points.append(tuple(c + 50.0 for c in truth.points[0]))
        self.tuples()
        before = self.states()
        self.head()
        order = choices["order"]
        if order == "vertices first":
            for i in range(len(truth.points)):
                self.vertex(i)
        if order != "faces first":
            self.write_tuples()
        written = len(truth.points) if order == "vertices first" else 0
        for i, face in enumerate(truth.faces):
            for state in before[i]:
                self.line(*state)
            if order == "interleaved":
                while written <= max(face):
                    self.vertex(written)
                    written += 1
            self.face(i, written, order != "faces first")
        while written < len(truth.points):
            self.vertex(written)
            written += 1
        if order == "faces first":
            self.write_tuples()
        self.elements()
        if choices["colors"] in ("to 1", "to 255", "with alpha"):
            truth.of_points("colors", [self.color(i) for i in range(len(truth.points))])
        return as_bytes(self.lines, choices, self.generator), truth


def make(choices, generator):
    return Writer(choices, generator).write()
