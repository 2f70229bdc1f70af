# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""bonedecimate certify with files that are not plain: other axes, triangles without area, folders that are inputs, names in any bytes."""

import os

import vtk

from application import NOT_WRITTEN, USAGE, ApplicationTest, main, sphere, torus, write
from certify_test import VIOLATED, in_frame, square, turned, with_tolerance
from label_maps import blocks, surface_of, write_map


class CertifyFrames(ApplicationTest):
    def test_voxels_are_compared_in_the_axes_of_the_label_map(self):
        write_map(blocks(5), self.path("map.mha"))
        bone = surface_of(blocks(5), 5)
        write(in_frame(bone, "LPS"), self.path("lps.vtp"))
        write(in_frame(turned(bone), "RAS"), self.path("ras.vtp"))
        for reference, result in (("ras.vtp", "lps.vtp"), ("ras.vtp", "ras.vtp"), ("lps.vtp", "ras.vtp")):
            completed = self.succeed("certify", reference, result, "--labels", "map.mha", "--tolerance", 0.001, "--no-means")
            self.assertIn("voxels               0 of 2,744 have another label", completed.stdout)
        completed = self.succeed("certify", "ras.vtp", "--labels", "map.mha")
        self.assertIn("the axes of 'ras.vtp' are RAS, those of the label map LPS: the result was turned to the label map", completed.stdout)


class CertifyShapes(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(square(0.0), self.path("a.ply"))
        write(square(0.25), self.path("b.ply"))

    def test_triangles_without_area_are_left_out(self):
        corners = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 40 0 0\nv 40 1 0\n"
        self.path("spike.obj").write_text(corners + "f 1 2 3\nf 1 4 5\n", encoding="utf-8")
        self.path("flat.obj").write_text(corners + "f 1 2 3\nf 1 4 4\n", encoding="utf-8")
        completed = self.run_program("certify", "spike.obj", "flat.obj", "--tolerance", 0.5, "--json", "c.json", "--page", "c.html")
        self.assertEqual(completed.returncode, VIOLATED)
        self.assertIn("left out             1 triangle without area of the result, up to 0.000000 mm away\n", completed.stdout)
        self.assertGreater(self.report("c.json")["lower"], 31.0)
        self.assertIn("1 triangle without area of the result", self.path("c.html").read_text(encoding="utf-8"))
        self.path("plain.obj").write_text(corners + "f 1 2 3\n", encoding="utf-8")
        completed = self.succeed("certify", "flat.obj", "plain.obj", "--tolerance", 0.5)
        self.assertIn("tolerance            proved <= 0.500000 mm, but for what was left out\n", completed.stdout)

    def test_the_tolerance_is_printed_as_it_was_written(self):
        for tolerance, code, says in ((0.2500001, 0, "proved <= 0.2500001 mm\n"), (0.2499999, VIOLATED, "violated, not <= 0.2499999 mm\n"),
                                      (0.3, 0, "proved <= 0.300000 mm\n")):
            completed = self.run_program("certify", "a.ply", "b.ply", "--tolerance", tolerance, "--no-means")
            self.assertEqual(completed.returncode, code)
            self.assertIn(says, completed.stdout)

    def test_a_violation_is_where_a_point_exceeds_its_own_tolerance(self):
        bone, moved = square(0.0), square(0.0)
        for point, height in enumerate((5.0, 0.25, 0.25, 5.0)):
            x, y, _ = moved.GetPoint(point)
            moved.GetPoints().SetPoint(point, x, y, height)
        with_tolerance(bone, 0.125)
        for point in (0, 3):  # where it moves farthest, everything is allowed
            bone.GetPointData().GetArray("allowed").SetTuple1(point, -1.0)
        write(bone, self.path("bone.vtp"))
        write(moved, self.path("moved.ply"))
        completed = self.run_program("certify", "bone.vtp", "moved.ply", "--tolerance-array", "allowed", "--page", "c.html", "--no-means")
        self.assertEqual(completed.returncode, VIOLATED)
        self.assertRegex(completed.stdout, r"beyond the tolerance of a point 0\.1\d+ to 0\.1\d+ mm at \(1\.0000, ")
        page = self.path("c.html").read_text(encoding="utf-8")
        head = page[page.index("headline open"):][:400]
        self.assertRegex(head, r"4\.8749 mm .* too far.*A point of the result at 0\.0, 0\.0, 5\.0 mm is that far beyond its tolerance")

    def test_says_which_open_boundary_violates_the_tolerance(self):
        write(sphere(), self.path("closed.ply"))
        holed = sphere()
        holed.BuildCells()
        holed.DeleteCell(200)
        holed.RemoveDeletedCells()
        write(holed, self.path("holed.ply"))
        completed = self.run_program("certify", "closed.ply", "holed.ply", "closed.ply", "--tolerance", 5, "--no-means")
        self.assertRegex(completed.stdout, r"(?m)^holed\.ply: .* mm, only the result has open boundaries, violated$")


class CertifyOutputs(ApplicationTest):
    def setUp(self):
        super().setUp()
        for folder in ("before", "after", "slices"):
            self.path(folder).mkdir()
        for name in ("a", "b"):
            write(torus(), self.path(f"before/{name}.obj"))
            write(torus(), self.path(f"after/{name}.ply"))

    def write_slice(self, name):
        image = vtk.vtkImageData()
        image.SetDimensions(8, 8, 1)
        image.AllocateScalars(vtk.VTK_UNSIGNED_SHORT, 1)
        writer = vtk.vtkTIFFWriter()
        writer.SetFileName(str(self.path(name)))
        writer.SetInputData(image)
        writer.Write()

    def test_an_input_within_a_folder_is_not_overwritten(self):
        for name in ("before/a.obj", "after/b.ply"):
            kept = self.path(name).read_bytes()
            self.fail_with(USAGE, "certify", "before", "after", "--json", name, says="is an input; it is not overwritten")
            self.assertEqual(self.path(name).read_bytes(), kept)
        for number in range(3):
            self.write_slice(f"slices/s{number}.tif")
        kept = self.path("slices/s0.tif").read_bytes()
        self.fail_with(USAGE, "certify", "slices", "after/a.ply", "--iso", 300, "--spacing", "1,1,1", "--json", "slices/s0.tif", says="not overwritten")
        self.assertEqual(self.path("slices/s0.tif").read_bytes(), kept)
        self.succeed("certify", "before", "after", "--json", "after/c.json", "--no-means")
        self.succeed("certify", "before", "after", "--json", "after/c.json", "--no-means")  # its own

    def test_hidden_files_are_no_surfaces(self):
        for folder in ("before", "after"):
            write(torus(), self.path(f"{folder}/.hidden.ply"))
        self.path("after/._a.ply").write_bytes(b"of a Mac")
        self.assertIn("2 pairs: 2 compared\n", self.succeed("certify", "before", "after", "--no-means").stdout)

    def test_names_may_have_any_bytes(self):
        name = b"bad\xff.ply"
        os.rename(self.path("after/b.ply"), os.path.join(os.fsencode(self.folder), b"after", name))
        completed = self.run_program("certify", "before/a.obj", "after/a.ply", os.fsdecode(b"after/" + name), "--json", "c.json", "--no-means")
        self.assertEqual((completed.returncode, completed.stderr), (0, ""))
        self.assertEqual([row["exit_code"] for row in self.report("c.json")], [0, 0])

    def test_no_output_is_left_if_another_cannot_be_written(self):
        self.fail_with(NOT_WRITTEN, "certify", "before/a.obj", "after/a.ply", "--page", "p.html", "--json", "nowhere/c.json")
        self.fail_with(NOT_WRITTEN, "certify", "before", "after", "--json", "nowhere/c.json")


if __name__ == "__main__":
    main()
