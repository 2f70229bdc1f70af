# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""STL in binary, with the colors that programs put into attributes."""

import struct

from grammar_stl import unit_normal
from truth import ALL_SHAPES, make_shape

EXTENSION = "stl"
CHOICES = {
    "shape": ALL_SHAPES,
    "header": ["zeros", "blanks", "text", "solid", "solid and a line", "facet", "any bytes", "RAS", "LPS", "mark"],
    "attributes": ["zero", "numbers", "VisCAM", "VisCAM for some", "Magics", "Magics for some", "Magics for none"],
    "normals": ["right", "zero", "other", "nan", "infinite"],
    "color position": ["first", "last", "middle"],
    "material": ["no", "yes"],
    "size": ["as it is", "large", "small", "far"],
    "count": ["one solid"] + ["twice"],
}
UNIFORM = {"shape", "header", "attributes", "normals"}


def header_of(choices, truth, generator):
    kind = choices["header"]
    if kind in ("RAS", "LPS"):
        truth.frame = kind
    texts = {
        "blanks": b" " * 80,
        "text": b"made for a test",
        "solid": b"solid bone",
        "solid and a line": b"solid bone\r\nfacet normal 0 0 1\n",
        "facet": b"facet",
        "any bytes": bytes(generator.randrange(128, 256) for _ in range(80)),
        "mark": b"\xef\xbb\xbfsolid",
    }
    head = texts.get(kind, b"")
    if kind in ("RAS", "LPS"):
        head = b"3D Slicer output. SPACE=" + kind.encode()
    if choices["attributes"].startswith("Magics"):
        color = b"COLOR=" + bytes([201, 102, 53, 255])
        if choices["material"] == "yes":
            color += b",MATERIAL=" + bytes([1, 2, 3, 255, 4, 5, 6, 255, 7, 8, 9, 255])
        free = max(0, 80 - len(color))
        start = {"first": 0, "last": free, "middle": free // 2}[choices["color position"]]
        if kind in ("RAS", "LPS", "solid and a line"):
            start = free
        head = head.ljust(80, b"\0")
        head = head[:start] + color + head[start + len(color) :]
    return head[:80].ljust(80, b"\0")


def attribute(kind, number):
    """The two bytes, and the color that they are for a triangle."""
    five = ((3 + 5 * number) % 32, (7 + 3 * number) % 32, (1 + 11 * number) % 32)  # red, green, blue
    color = tuple((c * 255 + 15) // 31 for c in five)
    red_first = five[0] << 10 | five[1] << 5 | five[2]
    blue_first = five[2] << 10 | five[1] << 5 | five[0]
    some = number % 2 == 0
    return {
        "zero": (0, None),
        "numbers": (number + 1, None),
        "VisCAM": (0x8000 | red_first, color),
        "VisCAM for some": (0x8000 | red_first, color) if some else (red_first, None),
        "Magics": (blue_first, color),
        "Magics for some": (blue_first, color) if some else (0x8000 | blue_first, (201, 102, 53)),
        "Magics for none": (0x8000, (201, 102, 53)),
    }[kind]


def make(choices, generator):
    scale = {"large": 1e4, "small": 1e-4}.get(choices["size"], 7.0)
    truth = make_shape(choices["shape"], generator, triangles=True, as_single=True, scale=scale)
    if choices["size"] == "far":
        truth.points = [tuple(struct.unpack("<f", struct.pack("<f", c + 1e5))[0] for c in p) for p in truth.points]
    if choices["count"] == "twice":
        truth.faces = truth.faces + [face[::-1] for face in truth.faces]
    head = header_of(choices, truth, generator)
    body, colors = struct.pack("<I", len(truth.faces)), []
    for number, face in enumerate(truth.faces):
        points = [truth.points[v] for v in face]
        nan, infinite = float("nan"), float("inf")
        normals = {"zero": (0, 0, 0), "other": (0, 0, 1), "nan": (nan,) * 3, "infinite": (infinite, 0, 0)}
        value, color = attribute(choices["attributes"], number)
        colors.append(color)
        normal = normals.get(choices["normals"]) or unit_normal(points)
        body += struct.pack("<12fH", *normal, *[c for p in points for c in p], value)
    if any(colors):
        white = (255, 255, 255)
        truth.of_faces("colors", [color or white for color in colors])
    return head + body, truth
