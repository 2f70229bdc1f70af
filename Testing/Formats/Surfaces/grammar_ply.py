# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""PLY, in text and in both byte orders."""

import struct

from truth import ALL_SHAPES, LINE_ENDS, NUMBERS, make_shape, single, spell, strips_of

EXTENSION = "ply"
# name of PLY, the later name, struct, VTK's name, most
TYPES = {
    "char": ("int8", "b", "signed char", 127),
    "uchar": ("uint8", "B", "unsigned char", 255),
    "short": ("int16", "h", "short", 32767),
    "ushort": ("uint16", "H", "unsigned short", 65535),
    "int": ("int32", "i", "int", 2**31 - 1),
    "uint": ("uint32", "I", "unsigned int", 2**32 - 1),
    "float": ("float32", "f", "float", 0),
    "double": ("float64", "d", "double", 0),
}
WHOLE = ["char", "uchar", "short", "ushort", "int", "uint"]
CHOICES = {
    "form": ["ascii", "binary_little_endian", "binary_big_endian"],
    "shape": ALL_SHAPES,
    "coordinates": ["float", "double"],
    "type names": ["old", "new"],
    "count type": ["uchar", "int", "uint", "char", "short", "ushort"],
    "index type": ["int", "uint", "uchar", "short", "ushort", "char"],
    "list name": ["vertex_indices", "vertex_index"],
    "order": ["xyz", "xyz last", "mixed"],
    "normals": ["none", "float", "double"],
    "texture": ["none", "u v", "s t", "texture_u", "of corners"],
    "colors": ["none", "rgb", "rgba", "diffuse", "faces", "float", "alpha first"],
    "extra": ["none", *TYPES, "list", "two"],
    "extra of faces": ["none", *TYPES, "list before", "list behind", "intensity"],
    "elements": ["none", "edge", "edge first", "empty", "two"],
    "element order": ["vertex first", "face first"],
    "strips": ["no", "one list", "restarts"],
    "comments": ["none", "comment", "obj_info", "RAS", "LPS", "long"],
    "line end": ["LF", "CRLF", "CR"],
    "last line": ["with end", "without end"],
    "mark": ["no", "yes"],
    "numbers": NUMBERS,
    "layout": ["lines", "blank lines", "several blanks", "broken lines"],
    "unused": ["no", "yes"],
}
UNIFORM = {"form", "shape", "coordinates", "normals", "colors", "count type", "index type"}


class Element:
    def __init__(self, name, count):
        self.name, self.count, self.properties, self.values = name, count, [], []

    def add(self, name, kind, values, count_type=None):
        """values: for each element a number or, with a type of counts, a list."""
        self.properties.append((name, kind, count_type))
        self.values.append(values)


class Writer:
    def __init__(self, choices, generator):
        self.choices, self.generator = choices, generator
        as_single = choices["coordinates"] == "float"
        self.truth = make_shape(choices["shape"], generator, as_single=as_single, triangles=choices["strips"] != "no")
        if choices["strips"] != "no":
            self.strip_rows, self.truth.faces = strips_of(self.truth.faces)
        if choices["unused"] == "yes":
            self.truth.points.append(tuple(single(c + 50.0) for c in self.truth.points[0]))

    def extra_values(self, kind, count):
        most = TYPES[kind][3]
        if most == 0:
            return [single(self.generator.uniform(-5, 5)) if kind == "float" else self.generator.uniform(-5, 5) for _ in range(count)]
        least = -most - 1 if kind in ("char", "short", "int") else 0
        return [self.generator.choice([least, most, self.generator.randint(least, most)]) for _ in range(count)]

    def vertices(self):
        truth, choices = self.truth, self.choices
        count = len(truth.points)
        element = Element("vertex", count)
        columns = [(n, choices["coordinates"], [p[i] for p in truth.points]) for i, n in enumerate("xyz")]
        others = self.normals(count) + self.texture(count) + self.colors(count)
        kinds = {"none": [], "list": [], "two": ["double", "ushort"]}.get(choices["extra"], [choices["extra"]])
        for kind in kinds:
            values = self.extra_values(kind, count)
            others.append(("quality_" + kind, kind, values))
            truth.point_arrays["quality_" + kind] = [(v,) for v in values]
            truth.types["quality_" + kind] = TYPES[kind][2]
        if choices["order"] == "xyz last":
            columns = others + columns
        elif choices["order"] == "mixed":
            columns += others
            self.generator.shuffle(columns)
        else:
            columns += others
        for name, kind, values in columns:
            element.add(name, kind, values)
        if choices["extra"] == "list":
            element.add("neighbors", "int", [list(range(i % 3)) for i in range(count)], "uchar")
        return element

    def normals(self, count):
        kind = self.choices["normals"]
        if kind == "none":
            return []
        normals = [((0.6, 0.0, 0.8), (0.0, 1.0, 0.0), (-0.28, 0.96, 0.0))[i % 3] for i in range(count)]
        if kind == "float":
            normals = [tuple(map(single, n)) for n in normals]
        self.truth.of_points("normals", normals)
        return [(n, kind, [v[i] for v in normals]) for i, n in enumerate(("nx", "ny", "nz"))]

    def texture(self, count):
        kind = self.choices["texture"]
        names = {"u v": ("u", "v"), "s t": ("s", "t"), "texture_u": ("texture_u", "texture_v")}.get(kind)
        if names is None:
            return []
        values = [((i + 1) / 64.0, 1.0 - i / 32.0) for i in range(count)]
        self.truth.of_points("uv", values)
        return [(n, "float", [v[i] for v in values]) for i, n in enumerate(names)]

    def colors(self, count):
        kind = self.choices["colors"]
        if kind in ("none", "faces"):
            return []
        names = ["red", "green", "blue"] + (["alpha"] if kind in ("rgba", "alpha first") else [])
        values = [(255 - i, 20 + 11 * i % 200, 2 + 7 * i, 9 + i)[: len(names)] for i in range(count)]
        self.truth.of_points("colors", values)
        prefix = "diffuse_" if kind == "diffuse" else ""
        columns = [(prefix + n, "uchar", [v[i] for v in values]) for i, n in enumerate(names)]
        if kind == "float":
            columns = [(n, "float", [single(c / 255.0) for c in v]) for n, _, v in columns]
        return columns[-1:] + columns[:-1] if kind == "alpha first" else columns

    def faces(self):
        truth, choices = self.truth, self.choices
        count = len(truth.faces)
        element = Element("face", count)
        extra = choices["extra of faces"]
        kinds = {"none": [], "intensity": ["uchar"], "list before": ["float"], "list behind": ["float"]}.get(extra, [extra])
        name = "intensity" if extra == "intensity" else "thickness"
        before, behind = [], []
        for kind in kinds:
            values = self.extra_values(kind, count)
            (before if extra == "list before" or self.generator.random() < 0.4 else behind).append((name, kind, values, None))
            if choices["strips"] == "no":
                truth.cell_arrays[name] = [(v,) for v in values]
                truth.types[name] = TYPES[kind][2]
        if extra.startswith("list"):
            lists = ("marks", "short", [[i] * (i % 3) for i in range(count)], "uchar")
            (before if extra == "list before" else behind).append(lists)
        if choices["colors"] == "faces":
            values = [(255 - i, 20 + 11 * i, 2 + 7 * i) for i in range(count)]
            truth.of_faces("colors", values) if choices["strips"] == "no" else None
            behind += [(n, "uchar", [v[i] for v in values], None) for i, n in enumerate(("red", "green", "blue"))]
        if choices["texture"] == "of corners":
            self.corner_texture(behind)
        for row in before:
            element.add(*row)
        if choices["strips"] == "no" or before or behind:
            element.add(choices["list name"], choices["index type"], truth.faces, choices["count type"])
        for row in behind:
            element.add(*row)
        return element

    def corner_texture(self, behind):
        truth, corner, lists = self.truth, 0, []
        if self.choices["strips"] != "no":
            return
        truth.corners["uv"] = []
        for face in truth.faces:
            values = [((corner + k) / 64.0, 1.0 - (corner + k) / 32.0) for k in range(len(face))]
            truth.corners["uv"].append(values)
            lists.append([x for pair in values for x in pair])
            corner += len(face)
        behind.append(("texcoord", "float", lists, "uchar"))

    def strips(self):
        """In one list with -1 behind each strip, or in a list each."""
        element = Element("tristrips", 1)
        faces = self.strip_rows
        if self.choices["strips"] == "restarts":
            numbers = []
            for face in faces:
                numbers += [*face, -1]
            element.add("vertex_indices", "int", [numbers], "int")
            return element
        element.count = len(faces)
        element.add("vertex_indices", "int", faces, "int")
        return element

    def elements(self):
        vertices, choices = self.vertices(), self.choices
        if choices["strips"] == "no":
            surface = [self.faces()]
        else:
            surface = [self.strips()]
        ordered = [vertices, *surface] if choices["element order"] == "vertex first" else [*surface, vertices]
        edge = Element("edge", 2)
        edge.add("vertex1", "int", [0, 1])
        edge.add("vertex2", "int", [1, 2])
        material = Element("material", 1)
        material.add("shininess", "double", [0.5])
        material.add("name", "uchar", [[66, 111]], "uchar")
        empty = Element("camera", 0)
        empty.add("view_px", "float", [])
        others = {"edge": [edge], "edge first": [edge], "empty": [empty], "two": [edge, material], "none": []}[choices["elements"]]
        return others + ordered if choices["elements"] == "edge first" else ordered + others

    def header(self, elements):
        choices = self.choices
        lines = ["ply", f"format {choices['form']} 1.0"]
        text = choices["comments"]
        if text in ("RAS", "LPS"):
            lines.append("comment 3D Slicer output. SPACE=" + text)
            self.truth.frame = text
        elif text == "long":
            lines += ["comment " + "end_header element face 7 " * 40, "comment", "comment TextureFile bone.png"]
        elif text != "none":
            lines.append(text + " made for a test, element vertex 9")
        for element in elements:
            lines.append(f"element {element.name} {element.count}")
            if text == "comment":
                lines.append("comment property float w")
            for name, kind, count_type in element.properties:
                lines.append("property " + ("list %s " % self.type(count_type) if count_type else "") + self.type(kind) + " " + name)
        return lines + ["end_header"]

    def type(self, kind):
        return TYPES[kind][0] if self.choices["type names"] == "new" else kind

    def words(self, value, kind):
        return spell(float(value), self.choices["numbers"]) if kind in ("float", "double") else str(value)

    def element_words(self, element, i):
        words = []
        for (_, kind, count_type), values in zip(element.properties, element.values):
            if count_type:
                words.append(str(len(values[i])))
            words += [self.words(v, kind) for v in (values[i] if count_type else [values[i]])]
        return words

    def text_body(self, elements):
        layout, lines = self.choices["layout"], []
        for element in elements:
            for i in range(element.count):
                words = self.element_words(element, i)
                if layout == "broken lines":
                    at = self.generator.randrange(1, len(words)) if len(words) > 1 else 1
                    lines += [" ".join(words[:at])] + [" ".join(words[at:])] * (at < len(words))
                else:
                    lines.append({"several blanks": " \t "}.get(layout, " ").join(words) + (" " if layout == "several blanks" else ""))
                if layout == "blank lines":
                    lines.append("")
        return lines

    def binary_body(self, elements):
        order = "<" if self.choices["form"] == "binary_little_endian" else ">"
        body = b""
        for element in elements:
            for i in range(element.count):
                for (_, kind, count_type), values in zip(element.properties, element.values):
                    if count_type:
                        body += struct.pack(order + TYPES[count_type][1], len(values[i]))
                    for value in values[i] if count_type else [values[i]]:
                        body += struct.pack(order + TYPES[kind][1], value)
        return body

    def write(self):
        elements = self.elements()
        end = LINE_ENDS[self.choices["line end"]]
        head = end.join(self.header(elements)) + end
        mark = b"\xef\xbb\xbf" if self.choices["mark"] == "yes" else b""
        if self.choices["form"] != "ascii":
            return mark + head.encode() + self.binary_body(elements), self.truth
        if self.choices["layout"] == "broken lines":
            self.truth.rejected = "an element of text is a line"
        text = end.join(self.text_body(elements))
        return mark + (head + text + ("" if self.choices["last line"] == "without end" else end)).encode(), self.truth


def make(choices, generator):
    return Writer(choices, generator).write()
