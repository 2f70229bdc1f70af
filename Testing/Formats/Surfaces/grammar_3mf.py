# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""3MF packages: core specification, production parts, materials."""

import io
import zipfile

from truth import ALL_SHAPES, Truth, make_shape, single, spell

EXTENSION = "3mf"
ROUNDING = 1e-14  # of products of transforms, relative to the largest coordinate
CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
MATERIAL = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02"
PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
UNITS = {"micron": 1e-3, "millimeter": 1.0, "centimeter": 10.0, "inch": 25.4, "foot": 304.8, "meter": 1000.0}
TRANSFORMS = {
    "none": None,
    "identity": (1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0),
    "translation": (1, 0, 0, 0, 1, 0, 0, 0, 1, 10, -20, 30.5),
    "turn": (0, 1, 0, -1, 0, 0, 0, 0, 1, 1, 2, 3),
    "scale": (2, 0, 0, 0, 0.5, 0, 0, 0, 4, 0, 0, 0),
    "mirror": (-1, 0, 0, 0, 1, 0, 0, 0, 1, 5, 0, 0),
    "general": (0.75, 0.25, 0, -0.5, 1.25, 0.125, 0.0625, 0, 1.5, 3, -4, 5),
}
CHOICES = {
    "shape": ALL_SHAPES,
    "numbers": ["shortest", "17 digits", "exponent", "plus", "long"],
    "unit": ["millimeter", "not given", "micron", "centimeter", "inch", "foot", "meter"],
    "build": ["object", "two items", "components", "nested components", "one object twice"],
    "item transform": list(TRANSFORMS),
    "component transform": list(TRANSFORMS),
    "prefix": ["none", "core", "m"],
    "type": ["not given", "model", "surface"],
    "other objects": ["none", "support", "solidsupport", "other", "not built", "empty"],
    "printable": ["not given", "1", "0 of another", "0 and a shared one"],
    "part": ["one model", "components in another part", "items in another part"],
    "materials": ["none", "base", "of triangles", "color group"],
    "metadata": ["no", "yes"],
    "comments": ["no", "yes"],
    "declaration": ["usual", "none", "mark", "single quotes", "standalone"],
    "attribute order": ["usual", "reverse"],
    "quotes": ["double", "single"],
    "layout": ["lines", "one line", "indented"],
    "compression": ["deflated", "stored"],
    "entries": ["usual", "model first", "another name", "thumbnail"],
    "target": ["/", "relative"],
    "ids": ["usual", "large", "not in order"],
    "required": ["none", "production", "material"],
    "unknown elements": ["no", "yes"],
}
UNIFORM = {"shape", "build", "item transform", "component transform", "unit"}


def moved(point, transform):
    if transform is None:
        return point
    m = transform
    return tuple(point[0] * m[a] + point[1] * m[3 + a] + point[2] * m[6 + a] + m[9 + a] for a in range(3))


def mirrors(transform):
    m = transform or TRANSFORMS["identity"]
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]) < 0


class Writer:
    def __init__(self, choices, generator):
        self.choices, self.generator = choices, generator
        self.shape = make_shape(choices["shape"], generator, triangles=True, as_single=True)
        self.ids = {"usual": [1, 2, 3, 4, 5], "large": [1000001, 2147483647, 7, 90, 12345], "not in order": [5, 3, 4, 2, 1]}[choices["ids"]]
        self.prefix = {"none": "", "core": "core:", "m": "m:"}[choices["prefix"]]
        self.truth = Truth([], [], unit=UNITS.get(choices["unit"], 1.0))
        self.parts = {}

    # What the build makes, as points and faces.
    def put(self, points, faces, transforms):
        factor = UNITS.get(self.choices["unit"], 1.0)
        first = len(self.truth.points)
        for point in points:
            for transform in transforms:
                point = moved(point, transform)
            self.truth.points.append(tuple(c * factor for c in point))
        turned = sum(map(mirrors, transforms)) % 2 == 1
        for a, b, c in faces:
            self.truth.faces.append(tuple(first + v for v in ((a, c, b) if turned else (a, b, c))))

    def tag(self, name, attributes=(), close=False, prefix=None):
        pairs = [(k, v) for k, v in attributes if v is not None]
        pairs = pairs[::-1] if self.choices["attribute order"] == "reverse" else pairs
        quote = "'" if self.choices["quotes"] == "single" else '"'
        words = [f"{k}={quote}{v}{quote}" for k, v in pairs]
        return "<" + " ".join([(self.prefix if prefix is None else prefix) + name, *words]) + ("/>" if close else ">")

    def end(self, name):
        return f"</{self.prefix}{name}>"

    def transform(self, name):
        numbers = TRANSFORMS[self.choices[name]]
        return None if numbers is None else " ".join("%g" % n for n in numbers)

    def mesh(self, number, points, faces, kind=None):
        kind = kind or {"not given": None}.get(self.choices["type"], self.choices["type"])
        materials = self.choices["materials"]
        pid = "100" if materials in ("base", "color group") and kind not in ("support", "other") else None
        lines = [self.tag("object", [("id", number), ("type", kind), ("pid", pid), ("pindex", pid and 0), ("name", f"bone {number}")])]
        if self.choices["metadata"] == "yes" and kind is None:
            lines += [self.tag("metadatagroup"), self.tag("metadata", [("name", "Note")]) + "x" + self.end("metadata"), self.end("metadatagroup")]
        lines += [self.tag("mesh"), self.tag("vertices")]
        for p in points:
            words = [spell(c, self.choices["numbers"]) for c in p]
            lines.append(self.tag("vertex", zip("xyz", words), close=True))
            if self.choices["comments"] == "yes":
                lines.append('<!-- <vertex x="1" y="2" z="3"/> -->')
        lines += [self.end("vertices"), self.tag("triangles")]
        for face in faces:
            extra = [("pid", 100), ("p1", 0), ("p2", 0), ("p3", 1)] if materials == "of triangles" and kind in (None, "model", "surface") else []
            lines.append(self.tag("triangle", [("v1", face[0]), ("v2", face[1]), ("v3", face[2]), *extra], close=True))
        return lines + [self.end("triangles"), self.end("mesh"), self.end("object")]

    def compound(self, number, references):
        kind = "surface" if self.choices["type"] == "surface" else None
        lines = [self.tag("object", [("id", number), ("type", kind)]), self.tag("components")]
        lines += [self.tag("component", reference, close=True) for reference in references]
        return lines + [self.end("components"), self.end("object")]

    def path(self, kind):
        return ("p:path", "/3D/parts/bone.model") if self.choices["part"] == kind else ("p:path", None)

    def objects(self):
        """Lines of resources of the model and of another part, and of the build."""
        choices, shape = self.choices, self.shape
        inner = TRANSFORMS[choices["component transform"]]
        outer = TRANSFORMS[choices["item transform"]]
        a, b, c, *_ = self.ids
        other_part, here, items = [], [], []
        build = choices["build"]
        target = other_part if choices["part"] != "one model" else here
        item = [("objectid", a), ("transform", self.transform("item transform")), ("printable", "1" if choices["printable"] == "1" else None)]
        if build in ("object", "two items", "one object twice"):
            halves = [shape.faces] if build != "two items" else [shape.faces[: len(shape.faces) // 2], shape.faces[len(shape.faces) // 2 :]]
            target = other_part if choices["part"] == "items in another part" else here
            for number, faces in zip((a, b), halves):
                points, faces = compact(shape.points, faces)
                target += self.mesh(number, points, faces)
                self.put(points, faces, [outer])
                items.append([("objectid", number), *item[1:], self.path("items in another part")])
            if build == "one object twice":
                far = "1 0 0 0 1 0 0 0 1 400 0 0"
                items.append([("objectid", a), ("transform", far), self.path("items in another part")])
                self.put(points, faces, [(1, 0, 0, 0, 1, 0, 0, 0, 1, 400, 0, 0)])
            return other_part, here, items
        where = "components in another part"
        target = other_part if choices["part"] == where else here
        target += self.mesh(a, shape.points, shape.faces)
        reference = [("objectid", a), ("transform", self.transform("component transform")), self.path(where)]
        here += self.compound(b, [reference])
        if build == "nested components":
            here += self.compound(c, [[("objectid", b), ("transform", self.transform("component transform"))]])
        self.put(shape.points, shape.faces, [inner, *([inner] if build == "nested components" else []), outer])
        items.append([("objectid", c if build == "nested components" else b), *item[1:]])
        return other_part, here, items

    def others(self):
        """Objects that are not read, and their items."""
        kind, number = self.choices["other objects"], 4000
        points, faces = [(900.0, 0.0, 0.0), (910.0, 0.0, 0.0), (900.0, 10.0, 0.0)], [(0, 1, 2)]
        lines, items = [], []
        if kind in ("support", "solidsupport", "other", "not built"):
            lines += self.mesh(number, points, faces, None if kind == "not built" else kind)
            items += [] if kind in ("not built", "other") else [[("objectid", number)]]
        elif kind == "empty":
            lines += self.mesh(number, [], [])
            items.append([("objectid", number)])
        if self.choices["printable"].startswith("0"):
            lines += self.mesh(4001, points, faces)
            items.append([("objectid", 4001), ("printable", "0")])
        return lines, items

    def materials(self):
        kind = self.choices["materials"]
        if kind in ("base", "of triangles"):
            lines = [self.tag("basematerials", [("id", 100)])]
            for name, color in (("bone", "#FFEEDD"), ("metal", "#112233FF")):
                lines.append(self.tag("base", [("name", name), ("displaycolor", color)], close=True))
            return lines + [self.end("basematerials")]
        if kind == "color group":
            return ['<mat:colorgroup id="100"><mat:color color="#FF0000FF"/></mat:colorgroup>']
        return []

    def model(self, lines, items):
        choices = self.choices
        heads = {
            "usual": '<?xml version="1.0" encoding="UTF-8"?>',
            "mark": '\ufeff<?xml version="1.0" encoding="utf-8"?>',
            "single quotes": "<?xml version='1.0' encoding='UTF-8'?>",
            "standalone": '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>',
        }
        out = [heads[choices["declaration"]]] if choices["declaration"] != "none" else []
        spaces = [("xmlns" + (":" + self.prefix[:-1] if self.prefix else ""), CORE), ("xmlns:mat", MATERIAL), ("xmlns:p", PRODUCTION)]
        spaces.append(("xmlns:own", "urn:bonedecimate:own"))
        required = {"production": "p", "material": "mat"}.get(choices["required"])
        unit = None if choices["unit"] == "not given" else choices["unit"]
        out.append(self.tag("model", [("unit", unit), ("xml:lang", "en-US"), *spaces, ("requiredextensions", required)]))
        if choices["metadata"] == "yes":
            out.append(self.tag("metadata", [("name", "Application")]) + "a test &amp; more" + self.end("metadata"))
        if choices["unknown elements"] == "yes":
            out.append('<own:extra><own:vertex x="1" y="2" z="3"/></own:extra>')
        out += [self.tag("resources"), *self.materials(), *lines, self.end("resources")]
        if choices["comments"] == "yes":
            out.append("<!-- the build -->")
        out += [self.tag("build"), *[self.tag("item", item, close=True) for item in items], self.end("build"), self.end("model")]
        layout = choices["layout"]
        text = {"one line": "", "indented": "\r\n  "}.get(layout, "\n").join(out)
        return text.encode("utf-8")

    def write(self):
        other_part, here, items = self.objects()
        lines, more = self.others()
        name = "3D/bone model.model" if self.choices["entries"] == "another name" else "3D/3dmodel.model"
        name = name.replace(" ", "_")
        start = ("" if self.choices["target"] == "relative" else "/") + name
        rels = "http://schemas.openxmlformats.org/package/2006/relationships"
        model_type = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
        entries = {
            "[Content_Types].xml": '<?xml version="1.0" encoding="UTF-8"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/'
            'content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default '
            'Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/><Default Extension="png" '
            'ContentType="image/png"/></Types>',
            "_rels/.rels": f'<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="{rels}"><Relationship Target="{start}" Id="rel0" '
            f'Type="{model_type}"/></Relationships>',
            name: self.model(here + lines, items + more),
        }
        if other_part:
            entries["3D/parts/bone.model"] = self.model(other_part, [])
            folder, file = name.rsplit("/", 1)
            entries[f"{folder}/_rels/{file}.rels"] = (
                f'<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="{rels}"><Relationship Target="/3D/parts/bone.model" '
                f'Id="rel1" Type="{model_type}"/></Relationships>'
            )
        if self.choices["entries"] == "thumbnail":
            entries["Metadata/thumbnail.png"] = b"\x89PNG\r\n\x1a\n"
        names = sorted(entries, key=lambda n: n != name) if self.choices["entries"] == "model first" else list(entries)
        buffer = io.BytesIO()
        with zipfile.ZipFile(buffer, "w", zipfile.ZIP_STORED if self.choices["compression"] == "stored" else zipfile.ZIP_DEFLATED) as archive:
            for entry in names:
                archive.writestr(zipfile.ZipInfo(entry, (2024, 1, 1, 0, 0, 0)), entries[entry], archive.compression)
        return buffer.getvalue(), self.truth


def compact(points, faces):
    """The points that the faces name, and the faces with their numbers."""
    used = sorted({v for face in faces for v in face})
    number = {v: i for i, v in enumerate(used)}
    return [tuple(map(single, points[v])) for v in used], [tuple(number[v] for v in face) for face in faces]


def make(choices, generator):
    return Writer(choices, generator).write()
