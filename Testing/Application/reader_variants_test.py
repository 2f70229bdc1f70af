# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Spellings of surface files in which the comparison with other readers (Testing/Formats) found faults."""

import vtk

from application import REJECTED, ApplicationTest, main, read

POINTS = ((0.1, 0, 0), (10, 0, 0), (0, 10, 0), (0, 0, 10))
FACES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
CORNERS = " ".join(str(i) for face in FACES for i in face)
VTP = f"""<VTKFile header_type="UInt32" version="1.0" byte_order="LittleEndian" type="PolyData"><PolyData>
<Piece NumberOfPoints="4" NumberOfPolys="4"><Points>
<DataArray type="Float32" NumberOfComponents="3" format="ascii">{" ".join(map(str, sum(POINTS, ())))}</DataArray>
</Points><Polys><DataArray type="Int64" Name="connectivity" format="ascii">{CORNERS}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3 6 9 12</DataArray></Polys></Piece></PolyData></VTKFile>
"""
VTK = (
    "# vtk DataFile Version 3.0\nmade for a test\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nSPACE 1 1 string\nRAS\nPOINTS 4 double\n"
    + "".join("%r %r %r\n" % p for p in POINTS)
    + "POLYGONS 4 16\n"
    + "".join("3 %d %d %d\n" % f for f in FACES)
)
PLY = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n%selement face 4\nproperty list uchar int vertex_indices\nend_header\n"


def ply(names, rows):
    header = PLY % "".join(f"property float {name}\n" for name in names)
    lines = [" ".join(map(str, p + row)) for p, row in zip(POINTS, rows)] + ["3 %d %d %d" % f for f in FACES]
    return header + "\n".join(lines) + "\n"


class ReaderVariants(ApplicationTest):
    def load(self, name):
        """The surface as the program has read it."""
        self.succeed(name, "out.vtp", "--heatmap", "heat.vtp", "--target-reduction", 0)
        return read(self.path("heat.vtp"))

    def test_vtp_attributes_in_any_order_with_blanks_and_either_kind_of_quotes(self):
        for old, new in (("", ""), ('"', "'"), ("=", " = "), ("=", "=\n")):
            self.path("in.vtp").write_text(VTP.replace(old, new) if old else VTP)
            surface = self.load("in.vtp")
            self.assertEqual([surface.GetPoint(i) for i in range(4)], [tuple(map(float, p)) for p in POINTS])

    def test_vtp_names_of_arrays_with_characters_of_xml_come_back(self):
        surface = vtk.vtkPLYReader()
        self.path("in.ply").write_text(ply((), [()] * 4))
        surface.SetFileName(str(self.path("in.ply")))
        surface.Update()
        names = ["a <b> & c", 'the "best"', "it's"]
        for name in names:
            array = vtk.vtkFloatArray()
            array.SetName(name)
            array.SetNumberOfTuples(4)
            array.Fill(1.5)
            surface.GetOutput().GetPointData().AddArray(array)
        writer = vtk.vtkPolyDataWriter()
        writer.SetInputData(surface.GetOutput())
        writer.SetFileName(str(self.path("in.vtk")))
        writer.Write()
        found = self.load("in.vtk").GetPointData()
        for name in names:
            self.assertEqual([found.GetArray(name).GetTuple1(i) for i in range(4)], [1.5] * 4)
        self.assertIsNotNone(read(self.path("out.vtp")).GetPointData().GetArray(names[0]))

    def test_vtp_arrays_of_polygons_and_strips_in_two_pieces_are_rejected(self):
        array = '<CellData><DataArray type="Float32" Name="a" format="ascii">1 2</DataArray></CellData>'
        piece = VTP[VTP.index("<Piece") : VTP.index("<Polys>")].replace('NumberOfPolys="4"', 'NumberOfPolys="1" NumberOfStrips="1"')
        cells = "".join(
            f'<{group}><DataArray type="Int64" Name="connectivity" format="ascii">{corners}</DataArray>'
            f'<DataArray type="Int64" Name="offsets" format="ascii">3</DataArray></{group}>'
            for group, corners in (("Polys", "0 2 1"), ("Strips", "0 1 3"))
        )
        head = VTP[: VTP.index("<Piece")]
        for data, is_good in (("", True), (array, False)):
            self.path("in.vtp").write_text(head + 2 * (piece + data + cells + "</Piece>") + "</PolyData></VTKFile>")
            if is_good:
                self.load("in.vtp")
            else:
                self.fail_with(REJECTED, "in.vtp", "out.vtp", says="in several pieces, which VTK mixes up; save it in one piece")

    def test_vtk_text_with_line_ends_of_every_system_and_a_byte_order_mark_keeps_its_axes(self):
        for end in ("\n", "\r\n", "\r"):
            for mark in ("", "\ufeff"):
                self.path("in.vtk").write_bytes((mark + VTK.replace("\n", end)).encode())
                surface = self.load("in.vtk")
                self.assertEqual(surface.GetFieldData().GetAbstractArray("SPACE").GetValue(0), "RAS")
                self.assertEqual([surface.GetPoint(i) for i in range(4)], [tuple(map(float, p)) for p in POINTS])

    def test_ply_texture_coordinates_s_and_t(self):
        values = [(0.0, 0.5), (1.0, 0.0), (0.0, 1.0), (0.25, 0.125)]
        self.path("in.ply").write_text(ply(("s", "t"), values))
        texture = self.load("in.ply").GetPointData().GetTCoords()
        self.assertEqual([texture.GetTuple(i) for i in range(4)], values)

    def test_ply_colors_of_real_numbers(self):
        self.path("in.ply").write_text(ply(("red", "green", "blue"), [(1, 0.5, 0), (0, 1, 0), (0.2, 0.4, 2), (-1, 0, 1)]))
        colors = self.load("in.ply").GetPointData().GetArray("RGB")
        self.assertEqual(colors.GetDataType(), vtk.VTK_UNSIGNED_CHAR)
        self.assertEqual([colors.GetTuple(i) for i in range(4)], [(255, 128, 0), (0, 255, 0), (51, 102, 255), (0, 0, 255)])


if __name__ == "__main__":
    main()
