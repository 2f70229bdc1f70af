# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that were cut off, corrupted or never were surfaces: rejected in one line, never a crash."""

import random
import re

from application import DONE, REJECTED, SURFACES, ApplicationTest, main, torus, write

TETRAHEDRON_OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
TETRAHEDRON_PLY = """ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 4
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 1 2 3
3 0 3 2
"""
TETRAHEDRON_VTK = """# vtk DataFile Version 3.0
bone
ASCII
DATASET POLYDATA
POINTS 4 float
0 0 0 1 0 0 0 1 0 0 0 1
POLYGONS 4 16
3 0 2 1
3 0 1 3
3 1 2 3
3 0 3 2
"""
TETRAHEDRON_VTP = """<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">
<PolyData><Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="4">
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 2 1 0 1 3 1 2 3 0 3 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3 6 9 12</DataArray></Polys>
</Piece></PolyData></VTKFile>
"""
TETRAHEDRON_STL = "solid bone\n" + "".join(
    "facet normal 0 0 0\nouter loop\n" + "".join("vertex %s\n" % v for v in face) + "endloop\nendfacet\n"
    for face in (
        ("0 0 0", "0 1 0", "1 0 0"),
        ("0 0 0", "1 0 0", "0 0 1"),
        ("1 0 0", "0 1 0", "0 0 1"),
        ("0 0 0", "0 0 1", "0 1 0"),
    )
) + "endsolid bone\n"
TEXTS = {
    "obj": TETRAHEDRON_OBJ,
    "ply": TETRAHEDRON_PLY,
    "vtk": TETRAHEDRON_VTK,
    "vtp": TETRAHEDRON_VTP,
    "stl": TETRAHEDRON_STL,
}


class DamagedFiles(ApplicationTest):
    def write_text(self, extension, *changes):
        """The tetrahedron with some of its text replaced; the text must be there."""
        text = TEXTS[extension]
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new, 1)
        self.path("in." + extension).write_text(text, encoding="ascii")
        return "in." + extension

    def reject(self, name, says="", **keywords):
        self.fail_with(REJECTED, name, "out.vtp", says=says, **keywords)

    def test_the_whole_files_are_accepted(self):
        for extension in TEXTS:
            self.succeed(self.write_text(extension), "out.vtp", "--quiet")

    def test_cut_off_anywhere(self):
        for extension in SURFACES:
            for text in (False, True):
                path = write(torus(20, 16), self.path("in." + extension), ascii_text=text)
                whole = path.read_bytes()
                for part in (0.02, 0.3, 0.7, 0.99):
                    with self.subTest(extension=extension, text=text, part=part):
                        # An OBJ file announces nothing: one without its last faces is an OBJ file.
                        cut = int(len(whole) * (min(part, 0.5) if extension == "obj" else part))
                        path.write_bytes(whole[:cut])
                        self.reject(path.name)

    def test_obj_file_that_ends_within_a_line(self):
        self.write_text("obj", ("4 3\n", "4 3"))
        self.assertIn("may be cut off", self.succeed("in.obj", "out.vtp").stdout)
        self.reject(self.write_text("obj", ("1 4 3\n", "1 4")), says="cut off")
        self.reject(self.write_text("obj", ("0 0 1\n", "0 0\n")), says="line 4")

    def test_text_in_place_of_numbers(self):
        for extension, old, says in (
            ("obj", "v 1 0 0", "line 2"),
            ("obj", "f 1 3 2", "line 5"),
            ("stl", "vertex 1 0 0", "three numbers"),
            ("ply", "1 0 0", "'vertex'"),
            ("ply", "3 0 2 1", "'face'"),
            ("vtk", "1 0 0", ""),
            ("vtk", "3 0 2 1", "line 8"),
            ("vtk", "POINTS 4", "line 5"),
            ("vtp", "1 0 0", ""),
            ("vtp", "0 2 1", ""),
        ):
            with self.subTest(extension=extension, old=old):
                wrong = old[:-1] + "x"
                self.reject(self.write_text(extension, (old, wrong)), says=says)

    def test_numbers_that_are_not_finite(self):
        for extension, old in (("obj", "v 1 0 0"), ("stl", "vertex 1 0 0"), ("ply", "1 0 0"), ("vtp", "1 0 0")):
            for word in ("nan", "inf"):
                with self.subTest(extension=extension, word=word):
                    self.reject(self.write_text(extension, (old, old[:-1] + word)))

    def test_indices_of_points_that_are_not_there(self):
        for extension, old, new in (
            ("obj", "f 1 3 2", "f 1 3 9"),
            ("obj", "f 1 3 2", "f 1 3 -9"),
            ("obj", "f 1 3 2", "f 1/1 3/1 2/1"),
            ("obj", "f 1 3 2", "f 1//7 3//7 2//7"),
            ("ply", "3 0 2 1", "3 0 2 9"),
            ("ply", "3 0 2 1", "3 0 2 -1"),
            ("vtk", "3 0 2 1", "3 0 2 9"),
            ("vtk", "3 0 2 1", "9 0 2 1"),
            ("vtk", "3 0 2 1", "-3 0 2 1"),
            ("vtp", ">0 2 1", ">0 2 9"),
            ("vtp", ">0 2 1", ">0 2 -9"),
        ):
            with self.subTest(extension=extension, new=new):
                self.reject(self.write_text(extension, (old, new)))

    def test_cells_that_run_out_of_their_arrays(self):
        for new in ("3 6 9 99", "9 6 3 12", "-3 6 9 12", "3 6 9"):
            with self.subTest(offsets=new):
                self.reject(self.write_text("vtp", ("3 6 9 12", new)))

    def test_binary_stl_of_another_size_than_announced(self):
        whole = write(torus(20, 16), self.path("in.stl")).read_bytes()
        for bytes_of_file in (whole + b"x", whole[:-1], whole[:-50], whole[:80] + b"\xff\xff\xff\x7f" + whole[84:]):
            self.path("in.stl").write_bytes(bytes_of_file)
            self.reject("in.stl", says="announces")

    def test_binary_ply_that_holds_more_than_announced(self):
        whole = write(torus(20, 16), self.path("in.ply")).read_bytes()
        self.path("in.ply").write_bytes(whole + b"0123456789")
        self.reject("in.ply", says="more than")

    def test_elements_of_a_ply_file_without_a_property(self):
        """They have no bytes that the size of the file could be compared with."""
        self.reject(self.write_text("ply", ("element face", "element x 9000000000000000000\nelement face")), says="without a property")

    def test_numbers_of_corners_that_no_file_has(self):
        self.reject(self.write_text("vtk", ("3 0 2 1", "9223372036854775807 0 2 1")))

    def test_other_kinds_of_data_under_the_name(self):
        for extension, old, new, says in (
            ("vtk", "DATASET POLYDATA", "DATASET STRUCTURED_POINTS", "POLYDATA"),
            ("vtp", 'type="PolyData"', 'type="UnstructuredGrid"', "PolyData"),
            ("ply", "vertex_indices", "other_indices", "vertex_indices"),
        ):
            with self.subTest(extension=extension):
                self.reject(self.write_text(extension, (old, new)), says=says)
        for extension in SURFACES:
            self.path("in." + extension).write_text("<html><body>not found</body></html>\n")
            self.reject("in." + extension)

    def test_surface_without_triangles(self):
        for extension, pattern in (("obj", r"(?m)^f .*\n"), ("vtk", r"(?s)POLYGONS.*")):
            self.path("in." + extension).write_text(re.sub(pattern, "", TEXTS[extension]))
            self.reject("in." + extension, says="no triangle")
        self.path("in.obj").write_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
        self.reject("in.obj", says="no triangle")

    def test_noise_never_crashes(self):
        generator = random.Random(1)
        for extension in SURFACES:
            for text in (False, True):
                path = write(torus(20, 16), self.path("in." + extension), ascii_text=text)
                whole = path.read_bytes()
                for _ in range(5):  # Testing/Fuzz tries many
                    damaged = bytearray(whole)
                    for _ in range(generator.choice((1, 3, 20))):
                        damaged[generator.randrange(len(damaged))] = generator.randrange(256)
                    path.write_bytes(damaged)
                    completed = self.run_program(path.name, "out.vtp", "--measure", "off", "--quiet")
                    self.assertIn(completed.returncode, (DONE, REJECTED), completed.stderr)
                    self.assertLessEqual(completed.stderr.count("\n"), 1)


if __name__ == "__main__":
    main()
