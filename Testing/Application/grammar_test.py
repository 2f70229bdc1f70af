# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The grammar of text formats: whatever a file writes in another way is the same surface, and unknown lines have a number."""

import struct

from application import REJECTED, ApplicationTest, main, read

POINTS = ((0, 0, 0), (10, 0, 0), (0, 10, 0), (0, 0, 10))
FACES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
MARK = "\N{ZERO WIDTH NO-BREAK SPACE}"  # as UTF-8 the byte-order mark
OBJ = "".join("v %g %g %g\n" % p for p in POINTS) + "".join("f %d %d %d\n" % tuple(i + 1 for i in f) for f in FACES)
PLY = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
       "property list uchar int vertex_indices\nend_header\n" + "".join("%g %g %g\n" % p for p in POINTS)
       + "".join("3 %d %d %d\n" % f for f in FACES))
STL = "solid bone\n" + "".join(
    "facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % POINTS[i] for i in f) + "endloop\nendfacet\n" for f in FACES
) + "endsolid bone\n"
VTK = ("# vtk DataFile Version 3.0\nbone\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n" + "".join("%g %g %g\n" % p for p in POINTS)
       + "POLYGONS 4 16\n" + "".join("3 %d %d %d\n" % f for f in FACES))
TEXTS = {"obj": OBJ, "ply": PLY, "stl": STL, "vtk": VTK}
COUNTED = "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n"

LINE_ENDS = {  # of any text format
    "as it is": lambda t: t,
    "CRLF": lambda t: t.replace("\n", "\r\n"),
    "CR": lambda t: t.replace("\n", "\r"),
    "a byte-order mark": lambda t: MARK + t,
    "a byte-order mark and CR": lambda t: MARK + t.replace("\n", "\r"),
    "blanks at the ends of lines": lambda t: t.replace("\n", " \t\n"),
    "no end of the last line": lambda t: t[:-1],
}
OTHERS = {
    "obj": {
        "capitals": str.upper,
        "comments behind numbers": lambda t: t.replace("\n", " # 1 2 3\n"),
        "comments without a blank": lambda t: t.replace("\n", "#c\n"),
        "a comment that ends with a backslash": lambda t: "# C:\\\n" + t,
        "non-breaking spaces": lambda t: t.replace(" ", "\N{NO-BREAK SPACE}"),
        "a non-breaking space before a keyword": lambda t: t.replace("v 10", "\N{NO-BREAK SPACE}v 10"),
        "a byte-order mark in a later line": lambda t: t.replace("v 10", MARK + "v 10"),
        "carriage returns before lines": lambda t: t.replace("\n", "\n\r"),
        "lines that go on": lambda t: t.replace("v 10 0 0", "v 10 \\\n0 \\\r\n0").replace("f 2 3 4", "f\\\n2 3\\\n\\\n4"),
        "indices from the end": lambda t: t[:t.index("f ")] + COUNTED,
        "zero for no normal": lambda t: "vn 0 0 1\n" + t.replace("f 2 3 4", "f 2//0 3//0 4//0"),
        "slashes without indices": lambda t: t.replace("f 2 3 4", "f 2/ 3// 4/"),
        "a weight of 1": lambda t: t.replace("v 10 0 0", "v 10 0 0 1.0"),
        "plus signs and exponents": lambda t: t.replace("v 10 0 0", "v +1.0E+01 0. .0e5"),
        "no material": lambda t: t.replace("f 2 3 4", "usemtl \nf 2 3 4"),
        "names, display and smoothing": lambda t: "o a b\ns off\nmg 1 2\nbevel on\nc_interp off\nlod 3\nshadow_obj x.obj\n" + t,
        "faces before their vertices": lambda t: t[t.index("f "):] + t[:t.index("f ")],
    },
    "ply": {
        "capitals": lambda t: t[:t.index("property")].upper().replace("VERTEX", "vertex") + t[t.index("property"):],
        "capital types": lambda t: t.replace("property float", "PROPERTY Float32").replace("uchar int", "UINT8 INT32"),
        "comments anywhere in the header": lambda t: t.replace("element", "comment a\nobj_info b\nelement"),
        "blank lines between values": lambda t: t.replace("end_header\n", "end_header\n\n\n").replace("3 1 2 3\n", "\n3 1 2 3\n"),
        "vertex_index": lambda t: t.replace("vertex_indices", "vertex_index"),
    },
    "stl": {
        "capitals": str.upper,
        "blank lines anywhere": lambda t: "\n\n" + t.replace("\n", "\n\n  \n"),
        "everything on one line": lambda t: t.split("\n", 1)[0] + "\n" + t.split("\n", 1)[1].replace("\n", " "),
        "two words for an end": lambda t: t.replace("endloop", "end loop").replace("endfacet", "end facet"),
        "no name": lambda t: t.replace(" bone", ""),
        "a name of several words": lambda t: t.replace("bone", "left femur, facet 3"),
        "normals of no number": lambda t: t.replace("normal 0 0 0", "normal -nan(ind) nan inf"),
        "no normals": lambda t: t.replace(" normal 0 0 0", ""),
    },
    "vtk": {
        "small letters": lambda t: t.replace("ASCII", "ascii").replace("POINTS", "points").replace("POLYGONS", "polygons"),
        "numbers on other lines": lambda t: t.replace("\n10 0 0", " 10\n\n0 0"),
    },
}
UNKNOWN = {
    "obj": [("v 10", "vertex 10", 2), ("f 2 3 4", "F2 3 4", 7), ("v 10", "\ufffdv 10", 2)],
    "stl": [("outer loop", "outer ring", 3), ("facet normal", "face normal", 2), ("endloop", "color 1 0 0\nendloop", 7)],
    "ply": [("element face", "elements face", 7), ("property float x", "property half x", 4)],
}


def triangles_of(surface):
    cells = range(surface.GetNumberOfCells())
    return sorted(sorted(surface.GetPoint(surface.GetCell(cell).GetPointId(k)) for k in range(3)) for cell in cells)


class Grammar(ApplicationTest):
    expected = sorted(sorted(tuple(map(float, POINTS[i])) for i in f) for f in FACES)

    def load(self, name):
        said = self.succeed(name, "out.vtp", "--target-reduction", 0, "--measure", "off").stdout
        return read(self.path("out.vtp")), said

    def test_what_is_written_in_another_way_is_the_same_surface(self):
        for extension, text in TEXTS.items():
            for what, change in {**LINE_ENDS, **OTHERS[extension]}.items():
                with self.subTest(extension=extension, what=what):
                    changed = change(text)
                    self.assertTrue(changed != text or what == "as it is")
                    self.path("in." + extension).write_bytes(changed.encode())
                    surface, said = self.load("in." + extension)
                    self.assertEqual(triangles_of(surface), self.expected)
                    self.assertNotIn("not read", said)

    def test_unknown_lines_are_rejected_by_their_number(self):
        for extension, changes in UNKNOWN.items():
            for old, new, line in changes:
                with self.subTest(extension=extension, new=new):
                    self.assertIn(old, TEXTS[extension])
                    self.path("in." + extension).write_bytes(TEXTS[extension].replace(old, new, 1).encode())
                    self.fail_with(REJECTED, "in." + extension, "out.vtp", says=f"line {line}: ")

    def test_text_of_two_bytes_a_letter_is_named(self):
        for extension in ("obj", "ply", "stl"):
            self.path("in." + extension).write_bytes(TEXTS[extension].encode("utf-16"))
            self.fail_with(REJECTED, "in." + extension, "out.vtp", says="it is UTF-16 text; save it as UTF-8")

    def test_binary_ply_begins_behind_any_line_end(self):
        for order, word in (("<", "little"), (">", "big")):
            values = b"".join(struct.pack(order + "3f", *p) for p in POINTS)
            values += b"".join(struct.pack(order + "B3i", 3, *f) for f in FACES)
            for end in ("\n", "\r\n", "\r"):
                for first in (0.0, struct.unpack(order + "f", b"\n\n\n\n")[0]):  # a coordinate of line feeds
                    with self.subTest(word=word, end=end, first=first):
                        header = PLY[:PLY.index("end_header")].replace("ascii", f"binary_{word}_endian") + "end_header\n"
                        data = struct.pack(order + "f", first) + values[4:]
                        self.path("in.ply").write_bytes(header.replace("\n", end).encode() + data)
                        surface, _ = self.load("in.ply")
                        self.assertEqual(min(surface.GetPoint(0)[0], first), first)
                        self.assertEqual(surface.GetNumberOfPolys(), 4)

    def test_strips_of_ply_are_triangles(self):
        text = PLY[:PLY.index("element face")] + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        text += "".join("%g %g %g\n" % p for p in POINTS) + "10 0 2 1 3 0 -1 0 3 2 -1\n"
        self.path("in.ply").write_text(text)
        self.assertEqual(triangles_of(self.load("in.ply")[0]), self.expected)
        self.path("in.ply").write_text(text.replace("0 3 2 -1", "0 4 2 -1"))
        self.fail_with(REJECTED, "in.ply", "out.vtp", says="it announces 1 of 'tristrips' but ends or breaks in number 0")

    def test_an_obj_file_says_which_curves_and_surfaces_it_loses(self):
        self.path("in.obj").write_text(OBJ + "vp 0 0\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nend\n")
        self.assertIn("warning: 5 lines of curves are not read", self.load("in.obj")[1])
        self.path("in.obj").write_text(OBJ + "surf 0 1 0 1 1 2 3 4\n")
        self.fail_with(REJECTED, "in.obj", "out.vtp", says="line 9: 'surf' is a free-form surface, which is not read")

    def test_a_polygon_on_very_many_lines_is_read_at_once(self):
        count = 30000
        self.path("in.obj").write_text(OBJ + "f " + " \\\n".join(str(i % 4 + 1) for i in range(count)) + "\n")
        self.succeed("diagnose", "in.obj", timeout=60)

    def test_a_ply_file_of_very_many_properties_is_rejected_at_once(self):
        properties = "".join(f"property float p{i}\n" for i in range(100000))
        self.path("in.ply").write_text(PLY.replace("element face", properties + "element face"))
        self.fail_with(REJECTED, "in.ply", "out.vtp", says="its header has more than 4096 properties", timeout=60)

    def test_colors_of_obj_vertices_are_an_array(self):
        colors = [(255, 0, 0), (0, 51, 0), (0, 0, 102), (153, 204, 255)]
        lines = OBJ.splitlines()
        for scale, form in ((255, "%.6f"), (1, "%d")):
            text = [f"{line} " + " ".join(form % (c / scale) for c in colors[i]) if i < 4 else line for i, line in enumerate(lines)]
            self.path("in.obj").write_text("\n".join(text) + "\n")
            array = self.load("in.obj")[0].GetPointData().GetArray("RGB")
            self.assertEqual(sorted(array.GetTuple3(i) for i in range(4)), sorted(colors))


if __name__ == "__main__":
    main()
