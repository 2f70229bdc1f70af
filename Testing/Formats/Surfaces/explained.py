# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences that remain: which reader, in which variants, and why the program's reading is right.

explained.py prints the table of Documentation/results/formats.md.
"""

import dataclasses

VTK = ("vtk of Debian", "vtk of PyPI")


@dataclasses.dataclass(eq=False)
class Explanation:
    """when: choice -> values, all of which a variant must have. kinds: of differences, empty for all."""

    formats: tuple
    readers: tuple
    when: dict
    reason: str
    kinds: tuple = ()

    def covers(self, form, reader, kind, choices):
        return (
            form in self.formats
            and reader in self.readers
            and (not self.kinds or kind in self.kinds)
            and all(choices[name] in values for name, values in self.when.items())
        )


def each(form, readers, alternatives, reason, kinds=()):
    """An explanation for each choice of a dict."""
    return [Explanation((form,), readers, {name: values}, reason, kinds) for name, values in alternatives.items()]


OBJ = [
    *each("obj", ("vtk of Debian", "vtk of PyPI", "trimesh", "pymeshlab"), {"keyword": ("fo",)}, "do not know `fo`, the older word for `f`"),
    *each("obj", (*VTK, "trimesh", "pymeshlab", "assimp"), {"case": ("upper",)}, "pass over keywords in capitals"),
    *each("obj", (*VTK, "trimesh", "pymeshlab", "assimp"), {"mark": ("yes",)}, "pass over a first line behind a byte-order mark"),
    *each("obj", (*VTK, "trimesh", "pymeshlab", "assimp"), {"blanks": ("indented",)}, "pass over indented lines"),
    *each("obj", (*VTK, "trimesh", "pymeshlab", "assimp"), {"blanks": ("no-break",)}, "no-break spaces, which copied text has, are no blanks to them"),
    *each("obj", ("trimesh",), {"blanks": ("tab", "several")}, "takes one blank between words"),
    *each("obj", (*VTK, "trimesh", "pymeshlab"), {"line end": ("CR",)}, "a file of CR alone is one line to them"),
    *each("obj", (*VTK, "trimesh", "pymeshlab", "assimp"), {"comments": ("at ends", "in lines that go on")}, "take a comment behind numbers for more of them"),
    *each("obj", (*VTK, "trimesh", "pymeshlab", "assimp"), {"continued": ("faces", "vertices")}, "do not go on, or only in some lines, behind a backslash"),
    *each("obj", VTK, {"corner": ("v/0/vn", "v/0/0", "v/vt/", "v//")}, "take neither 0 nor nothing for no index"),
    *each("obj", ("assimp",), {"corner": ("v/0/vn", "v/0/0")}, "does not take 0 for no index"),
    *each("obj", ("assimp",), {"colors": ("weight",)}, "divides points by their weight, which polygons do not have"),
    *each("obj", ("assimp",), {"colors": ("with alpha",)}, "does not take seven numbers"),
    *each("obj", ("vtk of PyPI", "trimesh", "assimp"), {"colors": ("to 255",)}, "clamp colors between 0 and 255 to 1, or divide none or all of them by 255", ("colors",)),
    *each("obj", ("vtk of Debian", "vtk of PyPI", "pymeshlab", "assimp"), {"texture numbers": (1,)}, "do not take a texture coordinate of one number"),
    *each("obj", ("vtk of PyPI",), {"numbers": ("plus",)}, "does not take the sign +"),
    *each("obj", ("assimp",), {"display": ("yes",)}, "takes `bevel` and `lod` for other keywords"),
    *each("obj", ("trimesh",), {"indices": ("negative", "both")}, "counts negative indices from the last vertex of the file"),
    *each("obj", ("assimp",), {"others": ("line", "point", "both")}, "its Python package gives no mesh that has lines or points"),
    *each("obj", ("pymeshlab", "trimesh"), {"order": ("faces first",)}, "take no vertex that comes behind its face"),
    *each("obj", VTK, {"materials": ("one", "two", "blank in the name", "before vertices", "library of two files")}, "number materials otherwise than they name them", ("array MaterialIds", "uv")),
]

STL = [
    *each("stl", ("assimp",), {"case": ("upper", "capital"), "blank lines": ("first",)}, "wants `solid` in small letters in the first line"),
    *each("stl", ("vtk of PyPI",), {"case": ("upper", "capital")}, "wants small letters"),
    *each("stl", ("assimp",), {"solids": ("empty one",)}, "its Python package gives no scene that has an empty solid"),
    *each("stl", (*VTK, "trimesh", "assimp"), {"blanks": ("no-break",)}, "no-break spaces are no blanks to them"),
    *each("stl", (*VTK, "trimesh", "assimp"), {"lines": ("a word a line", "a facet a line")}, "want the usual lines, which the grammar does not"),
    *each("stl", ("vtk of Debian", "trimesh"), {"line end": ("CR",)}, "a file of CR alone is one line to them"),
    *each("stl", VTK, {"mark": ("yes",)}, "take a file behind a byte-order mark for binary"),
    *each("stl", VTK, {"end": ("end facet",)}, "do not know `end facet`, which older programs write"),
    Explanation(("stl",), ("vtk of PyPI",), {"numbers": ("bare",), "normals": ("exponent",)}, "takes `0E0` for no number"),
]

STL_BINARY = [
    *each("stl_binary", ("assimp",), {"attributes": ("Magics for some", "Magics for none")}, "takes bit 15 of Magics for a color, which is for none", ("colors",)),
    *each("stl_binary", ("assimp",), {"header": ("mark",)}, "takes a binary file whose header begins like text for text"),
    *each("stl_binary", ("assimp",), {"attributes": ("VisCAM for some",)}, "gives gray where ours is white, without a color", ("colors",)),
    *each("stl_binary", ("pymeshlab",), {"attributes": ("Magics", "Magics for some", "Magics for none", "VisCAM", "VisCAM for some")}, "makes 248 of the largest of five bits, takes red of Magics for blue and knows no color for all", ("colors",)),
]

BINARY = ("binary_little_endian", "binary_big_endian")
PLY = [
    *each("ply", (*VTK, "pymeshlab", "assimp"), {"mark": ("yes",)}, "reject a byte-order mark"),
    *each("ply", (*VTK, "pymeshlab", "assimp"), {"element order": ("face first",)}, "take vertices first alone"),
    *each("ply", (*VTK, "trimesh", "pymeshlab"), {"strips": ("one list", "restarts")}, "do not know strips"),
    *each("ply", ("assimp",), {"strips": ("one list", "restarts")}, "takes strips for polygons, or ends their list at the first -1"),
    *each("ply", VTK, {"elements": ("edge first",)}, "take the first bytes of other elements for vertices"),
    *each("ply", (*VTK, "trimesh", "pymeshlab"), {"line end": ("CR",)}, "a header of CR alone is one line to them"),
    *each("ply", (*VTK, "trimesh", "pymeshlab"), {"layout": ("blank lines",)}, "take a blank line for an element"),
    *each("ply", (*VTK, "trimesh", "pymeshlab", "assimp"), {"layout": ("broken lines",)}, "take numbers wherever lines end; ours has an element a line, so that a line that was cut off is found", ("not rejected",)),
    *each("ply", VTK, {"colors": ("float",)}, "take real numbers for bytes", ("colors",)),
    *each("ply", ("pymeshlab",), {"index type": ("char", "uchar", "short", "ushort", "uint"), "count type": ("short", "ushort", "uint")}, "does not read these types in lists of corners, or not always"),
    *each("ply", ("vtk of Debian",), {"last line": ("without end",)}, "does not take a last line without its end"),
    *each("ply", ("vtk of PyPI",), {"numbers": ("plus",)}, "does not take the sign +"),
    *each("ply", ("assimp",), {"shape": ("concave",)}, "does not triangulate all concave polygons", ("rejected", "unreadable: IndexError")),
    Explanation(("ply",), ("pymeshlab",), {"form": ("binary_big_endian",), "coordinates": ("double",)}, "does not turn the bytes of double precision"),
    *each("ply", ("pymeshlab",), {"elements": ("edge first",)}, "checks edges before it has vertices", ("rejected",)),
    Explanation(("ply",), ("pymeshlab",), {"form": BINARY, "extra": ("list",)}, "loses its way behind some lists of vertices", ("rejected",)),
    Explanation(("ply",), ("assimp",), {"form": ("binary_little_endian",), "colors": ("alpha first",)}, "crashes on some of these", ("rejected",)),
    *each("ply", ("trimesh",), {"elements": ("edge", "edge first", "two")}, "takes a surface with edges for a drawing"),
    Explanation(("ply",), ("trimesh",), {"form": BINARY, "shape": ("concave",)}, "takes lists of one length in binary files"),
    Explanation(("ply",), ("trimesh",), {"form": BINARY, "extra": ("list",)}, "takes lists of one length in binary files"),
    Explanation(("ply",), ("trimesh",), {"form": BINARY, "extra of faces": ("list before", "list behind")}, "takes lists of one length in binary files"),
    Explanation(("ply",), ("trimesh",), {"shape": ("concave",), "texture": ("of corners",)}, "takes lists of one length"),
    *each("ply", ("trimesh", "pymeshlab"), {"comments": ("long",)}, "take `end_header` in a comment for the end of the header"),
    Explanation(("ply",), ("trimesh",), {"colors": ("faces",), "shape": ("cube", "concave")}, "gives triangles the colors of other polygons"),
    *each("ply", ("assimp",), {"comments": ("RAS", "LPS")}, "takes numbers in comments for elements"),
    *each("ply", ("assimp",), {"texture": ("of corners",)}, "gives points that are in common the texture of one corner", ("uv",)),
]

LEGACY_VTK = [
    *each("vtk", VTK, {"mark": ("yes",)}, "reject a byte-order mark"),
]

VTP = [
    Explanation(
        ("vtp",), VTK, {"pieces": ("two",), "cells": ("both",)}, "mix up the arrays of polygons and strips of several pieces; ours rejects them", ("not rejected",)
    ),
]

OTHERS_OF_3MF = ("trimesh", "pymeshlab", "assimp")
THREE_MF = [
    *each("3mf", (*OTHERS_OF_3MF, "lib3mf"), {"printable": ("0 of another", "0 and a shared one")}, "read what is marked as not printable"),
    *each("3mf", OTHERS_OF_3MF, {"other objects": ("support", "solidsupport")}, "read objects for supports"),
    *each("3mf", ("assimp",), {"other objects": ("empty",)}, "its Python package gives no scene that has an empty object"),
    *each("3mf", ("assimp",), {"prefix": ("core", "m")}, "does not know prefixes of XML"),
    *each("3mf", ("assimp",), {"part": ("components in another part", "items in another part")}, "does not know production parts"),
    *each("3mf", ("trimesh",), {"part": ("items in another part",)}, "takes parts of components alone"),
    *each("3mf", ("trimesh",), {"entries": ("another name",)}, "does not look for the name of the model"),
    *each("3mf", ("lib3mf", "pymeshlab"), {"target": ("relative",)}, "do not find objects if the target of the package has no leading slash"),
    *each("3mf", ("pymeshlab",), {"component transform": ("mirror",)}, "turns mirrored components inside out", ("faces",)),
]

GLB = [
    *each("glb", VTK, {"texture": ("float", "ubyte", "ushort")}, "leave texture coordinates from the upper left, as glTF has them", ("uv",)),
    *each("glb", VTK, {"node": ("mirror",), "parent": ("mirror",)}, "turn mirrored nodes inside out", ("faces",)),
    *each("glb", (*VTK, "trimesh", "assimp"), {"scene": ("no scenes",)}, "read nothing where there is no scene; ours takes all nodes, as the specification lets it"),
    *each("glb", (*VTK, "trimesh", "assimp"), {"sparse": ("some", "all")}, "do not read, or not always, the values of sparse accessors"),
    *each("glb", ("vtk of PyPI",), {"extensions": ("quantization",)}, "rejects KHR_mesh_quantization"),
    *each("glb", ("trimesh",), {"mode": ("fan",)}, "does not know fans"),
    *each("glb", ("trimesh",), {"material": ("yes",)}, "takes no texture coordinates with some materials", ("uv",)),
    *each("glb", ("assimp",), {"primitives": ("points beside",)}, "its Python package gives no mesh that has points"),
    *each("glb", ("assimp",), {"texture": ("ubyte", "ushort")}, "does not divide texture coordinates of whole numbers", ("uv",)),
]

EXPLAINED = OBJ + STL + STL_BINARY + PLY + LEGACY_VTK + VTP + THREE_MF + GLB


def table():
    """The rows of Documentation/results/formats.md; the same reason is there once."""
    rows = {}
    for e in EXPLAINED:
        rows.setdefault((e.formats, e.readers, e.reason), []).append(" and ".join(f"{n}: {', '.join(map(str, v))}" for n, v in e.when.items()))
    lines = ["| format | readers | variants | what they do |", "|---|---|---|---|"]
    for (formats, readers, reason), conditions in rows.items():
        lines.append(f"| {', '.join(formats)} | {', '.join(readers)} | {'; '.join(conditions)} | {reason} |")
    return "\n".join(lines)


if __name__ == "__main__":
    print(table())
