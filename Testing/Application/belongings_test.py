# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What belongs to a surface beside its triangles is in the result, or named with the file that lacks it."""

import re
import struct

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from application import ApplicationTest, array_names, main, read, sphere, torus, write

ERROR = ("--max-error", 0.3)
RED, BLUE = (255, 0, 0), (0, 0, 255)


def with_array(surface, name, values, cells=False):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    (surface.GetCellData() if cells else surface.GetPointData()).AddArray(array)
    return surface


def halves(surface):
    """Red where x is negative, of points and of cells."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    for x, cells in ((points[:, 0], False), (points[corners].mean(axis=1)[:, 0], True)):
        with_array(surface, "RGB", np.where(x[:, None] < 0, RED, BLUE).astype(np.uint8), cells)
    return surface


def corners_of(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData())
    return points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]


class Belongings(ApplicationTest):
    def test_colors_of_ply_files_stay_where_they_are(self):
        write(halves(sphere()), self.path("in.vtp"))
        self.succeed("in.vtp", "in.ply", "--target-reduction", 0)
        said = self.succeed("in.ply", "out.ply", *ERROR).stdout
        self.assertNotIn("RGB", said)
        surface = read(self.path("out.ply"))
        middle = corners_of(surface).mean(axis=1)[:, 0]
        colors = vtk_to_numpy(surface.GetCellData().GetArray("RGB"))
        far = np.abs(middle) > 3
        np.testing.assert_array_equal(colors[far], np.where(middle[:, None] < 0, RED, BLUE)[far])
        header = self.path("out.ply").read_bytes()[:800]
        self.assertEqual(header.count(b"property uchar red"), 2)

    def test_scalars_and_normals_of_ply_files_are_kept(self):
        surface = torus()
        values = np.arange(surface.GetNumberOfPoints()) % 7 / 8
        with_array(surface, "wall thickness, mm", values.astype(np.float32))
        with_array(surface, "two", np.stack([values, -values], -1))
        with_array(surface, "part", (np.arange(surface.GetNumberOfPolys()) % 3).astype(np.int16), cells=True)
        normals = numpy_to_vtk(np.ones((len(values), 3), np.float32), deep=True)
        surface.GetPointData().SetNormals(normals)
        write(surface, self.path("in.vtp"))
        said = self.succeed("in.vtp", "out.ply", "--target-reduction", 0).stdout
        self.assertNotIn("thickness", said)
        written = self.path("out.ply").read_bytes().split(b"end_header")[0].decode()
        for line in ("property float nx", "property float wall_thickness__mm", "property double two_0", "property double two_1",
                     "property short part"):
            self.assertIn(line + "\n", written)
        self.succeed("out.ply", "back.vtp", "--target-reduction", 0)
        back = read(self.path("back.vtp"))
        self.assertLessEqual({"wall_thickness__mm", "two_0", "Normals"}, array_names(back.GetPointData()))
        self.assertLessEqual({"part"}, array_names(back.GetCellData()))

    def test_colors_of_binary_stl_files_are_an_array(self):
        faces = corners_of(sphere(8)).astype("<f4")
        for header, attributes, expected in (
            (b"", (0x8000 | 31 << 10, 0x8000 | 31, 0), [RED, BLUE, (255, 255, 255)]),  # VisCAM
            (b"COLOR=" + bytes((1, 2, 3, 255)), (31, 31 << 10, 0x8000), [RED, BLUE, (1, 2, 3)]),  # Magics
        ):
            body = b"".join(struct.pack("<12x36sH", f.tobytes(), attributes[i % 3]) for i, f in enumerate(faces))
            self.path("in.stl").write_bytes(header.ljust(80) + struct.pack("<I", len(faces)) + body)
            self.succeed("in.stl", "out.vtp", "--heatmap", "heat.vtp", "--target-reduction", 0)
            array = read(self.path("heat.vtp")).GetCellData().GetArray("RGB")
            self.assertEqual([array.GetTuple3(i) for i in range(3)], expected)
            note = self.succeed("in.stl", "out.stl", *ERROR).stdout
            self.assertRegex(note, r"note: stl cannot hold arrays \(.*RGB.*\); vtp and vtk can")

    def test_every_array_of_a_legacy_file_is_read(self):
        self.path("in.vtk").write_text(
            "# vtk DataFile Version 3.0\nbone\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 9 0 0 0 9 0 0 0 9\nPOLYGONS 4 16\n"
            "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\nPOINT_DATA 4\nSCALARS one float 1\nLOOKUP_TABLE default\n1 2 3 4\n"
            "SCALARS two int 1\nLOOKUP_TABLE default\n1 2 3 4\nVECTORS v float\n1 0 0 0 1 0 0 0 1 1 1 1\n"
            "VECTORS w float\n1 0 0 0 1 0 0 0 1 1 1 1\nNORMALS n float\n1 0 0 0 1 0 0 0 1 1 0 0\nFIELD f 1\nx 1 4 double\n1 2 3 4\n"
            "CELL_DATA 4\nSCALARS a int 1\nLOOKUP_TABLE default\n1 2 3 4\nSCALARS b int 1\nLOOKUP_TABLE default\n1 2 3 4\n")
        self.succeed("in.vtk", "out.vtp", "--target-reduction", 0)
        surface = read(self.path("out.vtp"))
        self.assertLessEqual({"one", "two", "v", "w", "n", "x"}, array_names(surface.GetPointData()))
        self.assertLessEqual({"a", "b"}, array_names(surface.GetCellData()))

    def test_an_array_named_like_one_of_the_run_is_kept_under_another_name(self):
        surface = with_array(sphere(), "Distance", np.arange(sphere().GetNumberOfPoints(), dtype=float))
        write(surface, self.path("in.vtp"))
        said = self.succeed("in.vtp", "out.vtp", "--heatmap", "heat.vtp", "--target-reduction", 0).stdout
        self.assertIn("warning: the input's point array 'Distance' is 'Distance.input' in the result, whose own array has that name", said)
        for name, array in (("out.vtp", "Distance.input"), ("heat.vtp", "Distance")):
            kept = read(self.path(name)).GetPointData().GetArray(array)
            self.assertEqual({kept.GetValue(i) for i in range(kept.GetNumberOfValues())}, set(range(surface.GetNumberOfPoints())))
        again = self.succeed("out.vtp", "again.vtp", "--target-reduction", 0).stdout
        self.assertNotIn("own array", again, "arrays of an earlier run are replaced")
        self.assertNotIn("Distance.input.input", array_names(read(self.path("again.vtp")).GetPointData()))

    def test_an_array_named_like_one_of_the_heat_map_is_kept_in_it(self):
        write(with_array(sphere(), "DistanceToResult", np.full(sphere().GetNumberOfPoints(), 7.0)), self.path("in.vtp"))
        self.succeed("in.vtp", "out.vtp", "--heatmap", "heat.vtp", "--target-reduction", 0)
        data = read(self.path("heat.vtp")).GetPointData()
        own = [name for name in array_names(data) if name.endswith(".input")]
        kept = data.GetArray(own[0] if own else "DistanceToResult")
        self.assertEqual({kept.GetValue(i) for i in range(kept.GetNumberOfValues())}, {7.0})

    def test_axes_of_3d_slicer_are_kept_in_every_format_or_named(self):
        write(sphere(), self.path("plain.obj"))
        self.path("in.obj").write_bytes(b"# 3D Slicer output. SPACE=RAS\n" + self.path("plain.obj").read_bytes())
        for extension in ("stl", "ply", "obj", "vtk", "vtp"):
            said = self.succeed("in.obj", "first." + extension, *ERROR, "--report", "report.json").stdout
            self.assertIn("coordinates     RAS (x to the right", said)
            self.assertEqual(self.report()["files"]["coordinate_system"], "RAS")
            self.succeed("first." + extension, "second." + extension, "--target-reduction", 0)
            start = self.path("second." + extension).read_bytes()
            if extension == "vtp":
                self.assertEqual(read(self.path("second.vtp")).GetFieldData().GetAbstractArray("SPACE").GetValue(0), "RAS")
            else:
                self.assertIn(b"SPACE=RAS", start[:300])
        for extension in ("glb", "3mf"):
            said = self.succeed("in.obj", "out." + extension, *ERROR).stdout
            self.assertIn("so the file does not say that its axes are RAS", said)

    def test_materials_of_obj_files_with_blanks_in_their_names_are_kept(self):
        write(sphere(), self.path("plain.obj"))
        lines = self.path("plain.obj").read_text().splitlines()
        faces = [i for i, line in enumerate(lines) if line.startswith("f ")]
        lines.insert(faces[len(faces) // 2], "usemtl titanium, grade 5")
        lines.insert(faces[0], "usemtl cortical bone")
        self.path("in.obj").write_text("mtllib my materials.mtl\n" + "\n".join(lines) + "\n")
        self.succeed("in.obj", "out.obj", *ERROR)
        text = self.path("out.obj").read_text()
        self.assertIn("mtllib my materials.mtl\n", text)
        self.assertEqual(re.findall("usemtl (.*)", text), ["cortical bone", "titanium, grade 5"])
        self.succeed("certify", "in.obj", "out.obj", "--tolerance", 0.3)

    def test_texture_across_a_seam_is_left_out_aloud_and_without_one_it_is_kept(self):
        source = vtk.vtkTextureMapToSphere()
        source.SetInputData(sphere())
        source.PreventSeamOn()
        source.Update()
        write(source.GetOutput(), self.path("whole.vtp"))
        said = self.succeed("whole.vtp", "out.vtp", *ERROR).stdout
        self.assertNotIn("texture", said)
        self.assertIsNotNone(read(self.path("out.vtp")).GetPointData().GetTCoords())
        points = "".join(f"v {x} {y} {z}\n" for x in (0, 9) for y in (0, 9) for z in (0, 9))
        faces = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
        text = points + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        text += "".join("f " + " ".join(f"{v}/{t + 1}" for t, v in enumerate(face)) + "\n" for face in faces)
        self.path("box.obj").write_text(text)
        for output in ("out.obj", "out.ply", "out.vtp"):
            said = self.succeed("box.obj", output, "--target-reduction", 0).stdout
            self.assertIn("warning: texture coordinates are left out: at seams of the texture", said)
        self.assertNotIn("vt ", self.path("out.obj").read_text())
        self.succeed("box.obj", "kept.obj", "--target-reduction", 0, "--merge-points", "off")
        self.assertIn("vt ", self.path("kept.obj").read_text())

    def test_lines_and_vertices_that_a_format_lacks_are_named(self):
        surface = sphere()
        lines, vertices = vtk.vtkCellArray(), vtk.vtkCellArray()
        lines.InsertNextCell(2, (0, 1))
        vertices.InsertNextCell(1, (3,))
        surface.SetLines(lines)
        surface.SetVerts(vertices)
        write(surface, self.path("in.vtp"))
        for extension, loses in (("stl", True), ("ply", True), ("obj", False), ("vtk", False)):
            said = self.succeed("in.vtp", "out." + extension, *ERROR).stdout
            self.assertEqual("cannot hold the 1 lines and 1 vertices of the surface" in said, loses, extension)
            self.assertIn("warning: 1 vertex cell of the input is no part of the surface", said)

    def test_surfaces_that_cannot_be_simplified_say_why_and_what_helps(self):
        faces = corners_of(sphere())
        rng = np.random.default_rng(1)
        cases = {
            "the surface is double-sided": np.concatenate([faces, faces[:, ::-1]]),
            "joins such points, and its movement is part of the largest error": faces + rng.uniform(-1e-5, 1e-5, faces.shape),
            "inside out": faces[:, ::-1],
        }
        for sentence, corners in cases.items():
            body = b"".join(struct.pack("<12x36sH", f.astype("<f4").tobytes(), 0) for f in corners)
            self.path("in.stl").write_bytes(bytes(80) + struct.pack("<I", len(corners)) + body)
            self.assertIn(sentence, self.succeed("in.stl", "out.stl", *ERROR).stdout)


if __name__ == "__main__":
    main()
