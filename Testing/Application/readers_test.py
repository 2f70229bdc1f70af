# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""OBJ, PLY and STL as they are read: what VTK's readers make of them arrives, and what those leave out does, too.

--heatmap writes the input as it was read, with all its arrays.
"""

import struct

import vtk

from application import REJECTED, ApplicationTest, array_names, main, read

POINTS = ((0, 0, 0), (10, 0, 0), (0, 10, 0), (0, 0, 10))
FACES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
OBJ_POINTS = "".join("v %g %g %g\n" % p for p in POINTS)
OBJ_TEXTURE = "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n"
OBJ_NORMALS = "vn 0 0 -1\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\n"


def obj_faces(form):
    return "".join("f " + " ".join(form.replace("v", str(i + 1)) for i in face) + "\n" for face in FACES)


OBJS = {
    "plain": OBJ_POINTS + obj_faces("v"),
    "texture": OBJ_POINTS + OBJ_TEXTURE + obj_faces("v/v"),
    "normals": OBJ_POINTS + OBJ_NORMALS + obj_faces("v//v"),
    "both": OBJ_POINTS + OBJ_TEXTURE + OBJ_NORMALS + obj_faces("v/v/v"),
    "normals that no face names": OBJ_POINTS + OBJ_NORMALS + obj_faces("v"),
    "a texture seam": OBJ_POINTS + OBJ_TEXTURE + obj_faces("v/v").replace("1/1", "1/2", 1),
    "a crease": OBJ_POINTS + OBJ_NORMALS + obj_faces("v//v").replace("1//1", "1//2", 1),
    "a crease and texture": OBJ_POINTS + OBJ_TEXTURE + OBJ_NORMALS + obj_faces("v/v/v").replace("1/1/1", "1/2/3", 1),
    "from the end": OBJ_POINTS + "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n",
    "one group": OBJ_POINTS + "g bone\n" + obj_faces("v"),
    "groups": OBJ_POINTS + "g one\nf 1 3 2\nf 1 2 4\ng two\nf 2 3 4\ng three\nf 1 4 3\n",
    "groups after faces": OBJ_POINTS + "f 1 3 2\nf 1 2 4\ng two\nf 2 3 4\ng three\nf 1 4 3\n",
    "materials and texture": OBJ_POINTS + OBJ_TEXTURE
    + "usemtl one\nf 1/1 3/3 2/2\nf 1/1 2/2 4/4\nusemtl two\nf 2/2 3/3 4/1\nf 1/1 4/4 3/3\n",
}

PLY_TEXT = """ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
%selement face 4
property list uchar int vertex_indices
%send_header
"""


def ply(vertex="", values=(), face="", face_values=()):
    """The tetrahedron with more properties: their declarations and the values of each vertex and each face."""
    lines = [" ".join(map(str, p + tuple(values[i] if values else ()))) for i, p in enumerate(POINTS)]
    lines += [" ".join(map(str, (3,) + f + tuple(face_values[i] if face_values else ()))) for i, f in enumerate(FACES)]

    def declare(text):
        return "".join("property " + part.strip() + "\n" for part in text.split(",") if part.strip())

    return PLY_TEXT % (declare(vertex), declare(face)) + "\n".join(lines) + "\n"


COLORS = [(10 * i, 20 + i, 255 - i) for i in range(4)]
PLYS = {
    "plain": ply(),
    "colors": ply("uchar red, uchar green, uchar blue", COLORS),
    "colors with alpha": ply("uchar red, uchar green, uchar blue, uchar alpha", [c + (7,) for c in COLORS]),
    "diffuse colors": ply("uchar diffuse_red, uchar diffuse_green, uchar diffuse_blue", COLORS),
    "normals": ply("float nx, float ny, float nz", [(0, 0, -1), (1, 0, 0), (0, 1, 0), (0, 0.6, 0.8)]),
    "texture": ply("float u, float v", [(0, 0), (1, 0), (0, 1), (0.25, 0.1)]),
    "other texture": ply("float texture_u, float texture_v", [(0, 0), (1, 0), (0, 1), (0.25, 0.1)]),
    "colors of faces": ply(face="uchar red, uchar green, uchar blue", face_values=COLORS),
    "intensity of faces": ply(face="uchar intensity", face_values=[(i,) for i in (1, 2, 3, 200)]),
}


def values_of(data):
    """All arrays that are no distances of the run, by name: type, components and values."""
    found = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        name = array.GetName()
        if not name.startswith("Distance") and "ResultPointIds" != name and not name.startswith(("bonedecimate.", "BoneDecimate")):
            values = [array.GetVariantValue(k).ToString() for k in range(array.GetNumberOfValues())]
            found[name] = array.GetDataTypeAsString(), array.GetNumberOfComponents(), values
    return found


def cells_of(cells):
    ids = vtk.vtkIdList()
    found = []
    for i in range(cells.GetNumberOfCells()):
        cells.GetCellAtId(i, ids)
        found.append([ids.GetId(k) for k in range(ids.GetNumberOfIds())])
    return found


def points_of(surface):
    return [surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())]


class Readers(ApplicationTest):
    def load(self, name, says=""):
        """The surface as the program has read it."""
        words = ("--heatmap", "heat.vtp", "--target-reduction", 0)
        self.assertIn(says, self.succeed(name, "out.vtp", *words).stdout)
        return read(self.path("heat.vtp"))

    def compare(self, name, apart=()):
        """With what VTK's reader makes of the file, apart from some arrays."""
        mine, theirs = self.load(name), read(self.path(name))
        self.assertEqual(points_of(mine), points_of(theirs))
        self.assertEqual(cells_of(mine.GetPolys()), cells_of(theirs.GetPolys()))
        for data in ("GetPointData", "GetCellData", "GetFieldData"):
            found, expected = (
                {k: v for k, v in values_of(getattr(surface, data)()).items() if k not in apart} for surface in (mine, theirs)
            )
            self.assertEqual(found, expected)
        for attribute in ("GetScalars", "GetNormals", "GetTCoords"):
            array, other = (getattr(surface.GetPointData(), attribute)() for surface in (mine, theirs))
            if other and attribute != "GetScalars":
                self.assertIsNotNone(array)

    def test_obj_gives_what_vtk_gives(self):
        for what, text in OBJS.items():
            with self.subTest(what=what):
                self.path("in.obj").write_text(text, encoding="ascii")
                groups = () if "groups" in what else ("GroupIds",)  # VTK has them without groups, too
                self.compare("in.obj", ("MaterialIds", "MaterialNames", *groups))

    def test_ply_gives_what_vtk_gives(self):
        for what, text in PLYS.items():
            with self.subTest(what=what):
                self.path("in.ply").write_text(text, encoding="ascii")
                self.compare("in.ply")

    def test_ply_keeps_the_texture_of_every_corner(self):
        """VTK 9.1 gives some corners that of another."""
        self.path("in.ply").write_text(ply(face="list uchar float texcoord", face_values=[(6, 0, 0, 1, 0, 0, 1)] * 4))
        surface = self.load("in.ply")
        texture = surface.GetPointData().GetTCoords()
        for face, corners in zip(cells_of(surface.GetPolys()), FACES):
            self.assertEqual([surface.GetPoint(i) for i in face], [POINTS[i] for i in corners])
            self.assertEqual([texture.GetTuple(i) for i in face], [(0, 0), (1, 0), (0, 1)])

    def test_obj_numbers_materials_by_their_names(self):
        """VTK 9.1 numbers them otherwise than it names them, 9.3 moves them to other faces where there is texture."""
        for corner in (lambda i: f"{i}", lambda i: f"{i}/{i}"):
            faces = ["f " + " ".join(map(corner, face)) + "\n" for face in ((1, 3, 2), (1, 2, 4), (2, 3, 4), (1, 4, 3))]
            text = OBJ_TEXTURE + "usemtl one\n" + faces[0] + faces[1] + "usemtl two\n" + faces[2] + "usemtl one\n" + faces[3]
            self.path("in.obj").write_text("mtllib a.mtl\n" + OBJ_POINTS + text)
            surface = self.load("in.obj")
            fields = values_of(surface.GetFieldData())
            ids = values_of(surface.GetCellData())["MaterialIds"][2]
            self.assertEqual([fields["MaterialNames"][2][int(i)] for i in ids], ["one", "one", "two", "one"])
            self.assertEqual(fields["MaterialLibraries"][2], ["a.mtl"])

    def test_ply_gives_every_other_property_with_its_type(self):
        types = ("char", "uchar", "short", "ushort", "int", "uint", "float", "double")
        values = [(-1, 255, -300, 65000, -70000, 4000000000, 0.5, 1.0 / 3.0)] * 4
        self.path("in.ply").write_text(ply(", ".join(f"{t} a_{t}" for t in types), values, "int label", [(i,) for i in range(4)]))
        surface = self.load("in.ply")
        for name, value in zip(types, values[0]):
            array = surface.GetPointData().GetArray("a_" + name)
            self.assertEqual([array.GetTuple1(i) for i in range(4)], [value] * 4)
        self.assertEqual(surface.GetPointData().GetArray("a_double").GetDataType(), vtk.VTK_DOUBLE)
        self.assertEqual([surface.GetCellData().GetArray("label").GetTuple1(i) for i in range(4)], [0, 1, 2, 3])

    def test_ply_takes_elements_in_any_order_and_names_those_that_it_leaves_out(self):
        points = b"".join(struct.pack("<3d", *p) for p in POINTS)
        faces = b"".join(struct.pack("<i3I", 3, *f) for f in FACES)
        edges = struct.pack("<2i", 0, 1)
        header = (b"ply\nformat binary_little_endian 1.0\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
                  b"element face 4\nproperty list int uint vertex_index\nelement vertex 4\nproperty double x\n"
                  b"property double y\nproperty double z\nend_header\n")
        self.path("in.ply").write_bytes(header + edges + faces + points)
        surface = self.load("in.ply", says="warning: the 1 elements 'edge' of the input are not read")
        self.assertEqual(cells_of(surface.GetPolys()), [list(f) for f in FACES])
        self.path("in.ply").write_text(ply("list uchar int near", [(1, 2)] * 4))
        self.load("in.ply", says="warning: the lists 'near' of the input's 'vertex' are not read")

    def test_ply_takes_polygons_of_any_length(self):
        count = 1000
        ring = [(10.0 * (i % 250), 10.0 * (i // 250), (i * i) % 7) for i in range(count)]
        header = PLY_TEXT.replace("vertex 4", f"vertex {count}").replace("face 4", "face 2").replace("uchar int", "int int")
        lines = ["%g %g %g" % p for p in ring] + ["%d %s" % (count, " ".join(map(str, range(count)))), "3 0 1 2"]
        self.path("in.ply").write_text(header % ("", "") + "\n".join(lines) + "\n")
        self.assertEqual(self.run_program("diagnose", "in.ply").stderr, "")

    def test_ply_values_that_their_type_cannot_hold_are_rejected(self):
        for value in (256, -1, 0.5, "nan"):
            self.path("in.ply").write_text(ply("uchar red", [(value,)] * 4))
            self.fail_with(REJECTED, "in.ply", "out.vtp", says="ends or breaks in number 0")
        for old, new in (("property float x", "property list uchar float x"), ("uchar int", "float int"),
                         ("element face", "element vertex 0\nelement face")):
            self.path("in.ply").write_text(ply().replace(old, new))
            self.fail_with(REJECTED, "in.ply", "out.vtp", says="header")

    def test_obj_goes_on_in_the_next_line_and_checks_it(self):
        for end in ("\\\n", " \\\n", "\\\r\n"):
            self.path("in.obj").write_bytes((OBJ_POINTS + obj_faces("v").replace("1 3 2", f"1{end} 3 2")).encode())
            self.assertEqual(cells_of(self.load("in.obj").GetPolys()), [list(f) for f in FACES])
        self.path("in.obj").write_text(OBJ_POINTS + obj_faces("v").replace("1 3 2", "1 \\\n3 9"))
        self.fail_with(REJECTED, "in.obj", "out.vtp", says="names vertex 9")
        self.path("in.obj").write_text(OBJ_POINTS + obj_faces("v") + "f 1 2 \\")
        self.fail_with(REJECTED, "in.obj", "out.vtp", says="cut off")

    def test_obj_keeps_lines_and_points_beside_a_seam(self):
        self.path("in.obj").write_text(OBJS["a texture seam"] + "l 1 2\np 4\n")
        surface = self.load("in.obj")
        self.assertEqual([points_of(surface)[i] for i in cells_of(surface.GetLines())[0]], [POINTS[0], POINTS[1]])
        self.assertEqual([points_of(surface)[i] for i in cells_of(surface.GetVerts())[0]], [POINTS[3]])

    def test_obj_keeps_faces_of_which_only_some_have_texture_or_a_material(self):
        self.path("in.obj").write_text(OBJ_POINTS + OBJ_TEXTURE + "f 1 3 2\nusemtl bone\nf 1/2 2/1 4/4\nf 2/2 3/3 4/4\nf 1/1 4/4 3/3\n")
        surface = self.load("in.obj")
        self.assertEqual(surface.GetNumberOfPolys(), 4)
        self.assertEqual(values_of(surface.GetFieldData())["MaterialNames"][2], ["bone", "NO_MATERIAL"])
        self.assertEqual(values_of(surface.GetCellData())["MaterialIds"][2], ["1", "0", "0", "0"])
        self.assertIn("bone", array_names(surface.GetPointData()))

    def test_obj_says_what_it_leaves_out_and_rejects_what_is_no_corner(self):
        self.path("in.obj").write_text(OBJS["plain"].replace("v 10 0 0", "v 10 0 0 0.5"))
        self.load("in.obj", says="warning: the numbers behind x, y and z of 1 vertices")
        self.path("in.obj").write_text(OBJS["plain"].replace("v 10 0 0", "v 10 0 0 1 0.5 0"))
        self.load("in.obj", says="warning: the colors of 1 vertices are not read, because others have none")
        self.path("in.obj").write_text(OBJS["texture"].replace("f 1/1 3/3 2/2", "f 1/1 3 2/2"))
        self.load("in.obj", says="warning: 1 faces have a texture coordinate or a normal at some of their corners alone")
        for old, new, says in (
            ("f 1/1 3/3 2/2", "f 1/1 0/3 2/2", "line 9: '0/3' is not a corner"),
            ("f 1/1 3/3 2/2", "surf 0 1 0 1 1 2 3", "line 9: 'surf' is a free-form surface"),
            ("f 1/1 3/3 2/2", "face 1 3 2", "line 9: 'face' is not a keyword of OBJ files"),
            ("f 1/1 3/3 2/2", "f 1/1 3/3/3/3 2/2", "is not a corner"),
            ("f 1/1 3/3 2/2", "l 1", "a line of fewer than 2 points"),
            ("vt 0 0", "vt", "fewer than 1 numbers"),
        ):
            self.assertIn(old, OBJS["texture"])
            self.path("in.obj").write_text(OBJS["texture"].replace(old, new, 1))
            self.fail_with(REJECTED, "in.obj", "out.vtp", says=says)

    def test_text_stl_in_capitals_of_several_solids(self):
        facets = ["FACET NORMAL 0 0 0\nOUTER LOOP\n" + "".join("VERTEX %g %g %g\n" % POINTS[i] for i in face)
                  + "ENDLOOP\nENDFACET\n" for face in FACES]
        solids = "".join(f"SOLID a\n{facet}ENDSOLID a\n" for facet in facets)
        self.path("in.stl").write_text(solids)
        self.assertEqual(self.load("in.stl").GetNumberOfPolys(), 4)
        for old, new in (("ENDLOOP", "VERTEX 1 1 1\nENDLOOP"), ("VERTEX 0 0 0\n", ""), ("ENDFACET\n", "")):
            self.path("in.stl").write_text(solids.replace(old, new, 1))
            self.fail_with(REJECTED, "in.stl", "out.vtp", says="is out of place: a facet is one loop of three vertices")


if __name__ == "__main__":
    main()
