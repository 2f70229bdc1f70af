# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""bonedecimate certify REFERENCE RESULT: bounds, status and exit codes; certify RESULT --labels MAP: voxels."""

import vtk

from application import NOT_WRITTEN, REJECTED, SURFACES, UNMEASURED, USAGE, ApplicationTest, main, read, torus, write
from combinations_inputs import scaled
from label_maps import blocks, bounded, smoothed, surface_of, write_map

VIOLATED, UNDECIDED = 6, 7


def square(height):
    """Two triangles over the unit square at that height, which single precision holds exactly."""
    points = vtk.vtkPoints()
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        points.InsertNextPoint(x, y, height)
    triangles = vtk.vtkCellArray()
    for corners in ((0, 1, 2), (0, 2, 3)):
        triangles.InsertNextCell(3, corners)
    surface = vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    return surface


def without_a_triangle(surface, triangle=0):
    surface.BuildCells()
    surface.DeleteCell(triangle)
    surface.RemoveDeletedCells()
    return surface


def with_tolerance(surface, tolerance):
    array = vtk.vtkDoubleArray()
    array.SetName("allowed")
    for _ in range(surface.GetNumberOfPoints()):
        array.InsertNextValue(tolerance)
    surface.GetPointData().AddArray(array)
    return surface


def turned(surface):
    """Half a turn about z."""
    turn = vtk.vtkTransform()
    turn.Scale(-1, -1, 1)
    moved = vtk.vtkTransformPolyDataFilter()
    moved.SetTransform(turn)
    moved.SetInputData(surface)
    moved.Update()
    return moved.GetOutput()


def in_frame(surface, frame):
    """The surface itself, of which the field data says what its axes are."""
    axes = vtk.vtkStringArray()
    axes.SetName("SPACE")
    axes.InsertNextValue(frame)
    surface.GetFieldData().AddArray(axes)
    return surface


class Certify(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(square(0.0), self.path("a.ply"))
        write(square(0.25), self.path("b.ply"))

    def certify(self, *words):
        completed = self.run_program("certify", "a.ply", "b.ply", *words)
        self.assertEqual(completed.stderr, "")
        return completed

    def test_without_a_tolerance_is_done_when_it_knows_the_bounds(self):
        completed = self.succeed("certify", "a.ply", "b.ply")
        self.assertIn("0.249999999 to 0.250000001 mm", completed.stdout)
        self.assertRegex(completed.stdout, r"(?m)^boundary ref -> res  \d")
        self.assertRegex(completed.stdout, r"(?m)^boundary res -> ref  \d")

    def test_ends_with_a_code_for_each_status(self):
        for tolerance, code, word in ((0.26, 0, "proved <= 0.260000 mm\n"), (0.24, VIOLATED, "violated, not <= 0.240000 mm\n"),
                                      (0.25, UNDECIDED, "undecided whether <= 0.250000 mm\n")):
            completed = self.certify("--tolerance", tolerance)
            self.assertEqual(completed.returncode, code)
            self.assertIn(word, completed.stdout)
            self.assertEqual(self.certify("--tolerance", tolerance, "--first-proof").returncode, code)

    def test_reads_every_format(self):
        for extension in SURFACES:
            write(square(0.25), self.path("b." + extension))
            self.succeed("certify", "a.ply", "b." + extension, "--tolerance", 0.26, "--quiet")

    def test_writes_all_it_found_as_json(self):
        self.succeed("certify", "a.ply", "b.ply", "--tolerance", 0.3, "--json", "c.json")
        found = self.report("c.json")
        self.assertEqual((found["status"], found["boundaries"]), ("proved", "both"))
        for direction in ("reference_to_result", "boundary_result_to_reference"):
            self.assertLessEqual(found[direction]["lower"], 0.25)
            self.assertGreaterEqual(found[direction]["upper"], 0.25)
        self.assertAlmostEqual(found["reference_to_result"]["mean"], 0.25, 6)
        self.assertEqual(found["units"]["upper"], "mm")
        self.assertEqual(found["files"], {"reference": "a.ply", "result": "b.ply", "unit": "mm"})

    def test_the_sentence_has_the_bound_of_open_boundaries_or_says_what_is_not_known(self):
        def sentence(reference, result, *words):
            self.run_program("certify", reference, result, "--json", "c.json", "--quiet", *words)
            return self.report("c.json")["sentence"]
        bound = r"^at most 0\.\d{6} mm in both directions"
        self.assertRegex(sentence("a.ply", "b.ply"), bound + ", open boundaries too$")
        self.assertRegex(sentence("a.ply", "b.ply", "--no-boundaries"), bound + ", but for open boundaries$")
        self.assertEqual(self.report("c.json")["boundaries"], "not_compared")
        write(torus(), self.path("whole.ply"))
        write(without_a_triangle(torus()), self.path("torn.ply"))
        self.assertRegex(sentence("whole.ply", "whole.ply"), bound + "$")
        self.assertRegex(sentence("whole.ply", "torn.ply", "--tolerance", 5), bound + ", but only the result has open boundaries$")
        write(without_a_triangle(torus(), 40), self.path("other.ply"))
        self.assertRegex(sentence("torn.ply", "other.ply"), bound + r", open boundaries at most [1-9]\d*\.\d{6} mm$")
        said = self.certify("--tolerance", 0.3, "--no-boundaries").stdout
        self.assertIn("proved <= 0.300000 mm, but for open boundaries\n", said)

    def test_describes_both_surfaces_in_json_and_page(self):
        crossed = vtk.vtkAppendPolyData()
        crossed.AddInputData(torus())
        crossed.AddInputData(torus(center=10.0))
        crossed.Update()
        write(torus(), self.path("whole.ply"))
        write(crossed.GetOutput(), self.path("crossed.ply"))
        self.succeed("certify", "whole.ply", "crossed.ply", "--json", "c.json", "--page", "c.html", "--quiet")
        found = self.report("c.json")
        measured = vtk.vtkMassProperties()
        measured.SetInputData(read(self.path("whole.ply")))
        for which, components in (("reference", 1), ("result", 2)):
            self.assertEqual((found[which]["components"], found[which]["boundary_edges"]), (components, 0))
        self.assertEqual(found["reference"]["intersecting_pairs"], 0)
        self.assertGreater(found["result"]["intersecting_pairs"], 10)
        self.assertEqual(found["result"]["triangles"], 2 * found["reference"]["triangles"])
        self.assertAlmostEqual(found["reference"]["area"] / measured.GetSurfaceArea(), 1, 5)
        self.assertAlmostEqual(found["reference"]["volume"] / measured.GetVolume(), 1, 2)
        self.assertEqual(found["units"]["reference.volume"], "mm3")
        page = self.path("c.html").read_text(encoding="utf-8")
        self.assertIn("<div><strong>2 instead of 1</strong>components (separate pieces) in the result</div>", page)
        said = self.succeed("certify", "crossed.ply", "whole.ply", "--page", "lost.html").stdout
        self.assertIn("components           1, the reference has 2\n", said)
        self.assertIn("warning: 1 of 2 components of the reference is missing in the result: ", said)
        flat = "v 0 0 0\nv 9 0 0\nv 20 0 0\nf 1 2 3\n"
        self.path("flat.obj").write_text(flat, encoding="ascii")
        self.fail_with(REJECTED, "certify", "flat.obj", "whole.ply", says="the reference has no triangle with an area")
        lost = self.path("lost.html").read_text(encoding="utf-8")
        self.assertIn("<div class=\"lost\"><strong>1 of 2</strong>components (separate pieces) in the result; missing: ", lost)
        self.assertIn("<div class=\"headline\"><strong>at most ", lost)
        for words in ("Intersecting pairs of triangles", "Where the two surfaces are farthest apart", "&plusmn;", "@media print"):
            self.assertIn(words, page)
        self.assertTrue("<script type=\"application/octet-stream\"" in page or "viewer-stage" not in page)
        self.assertTrue("\"caption\":\"Reference: " in page or "viewer-stage" not in page)

    def test_takes_a_tolerance_for_each_point(self):
        write(with_tolerance(square(0.0), 0.3), self.path("a.vtp"))
        self.succeed("certify", "a.vtp", "b.ply", "--tolerance-array", "allowed")
        capped = self.run_program("certify", "a.vtp", "b.ply", "--tolerance-array", "allowed", "--tolerance", 0.1)
        self.assertEqual(capped.returncode, VIOLATED)
        self.fail_with(REJECTED, "certify", "a.vtp", "b.ply", "--tolerance-array", "other", says="other")

    def test_holds_a_decimation_to_its_report(self):
        write(torus(), self.path("bone.ply"))
        self.succeed("bone.ply", "small.ply", "--target-triangles", 500, "--report", "report.json", "--quiet")
        self.succeed("certify", "bone.ply", "small.ply", "--json", "c.json", "--quiet")
        sampled = self.report()["distance"]["input_to_output"]["max"]
        proved = self.report("c.json")["reference_to_result"]["upper"]
        self.assertLessEqual(sampled, proved + 1e-5)  # the file is in single precision
        self.assertEqual(self.report("c.json")["result"]["checksum"], self.report()["output"]["checksum"])

    def test_says_nothing_with_quiet(self):
        self.assertEqual(self.certify("--quiet").stdout, "")

    def test_rejects_what_it_cannot_read_or_write(self):
        for words in (("a.ply",), ("a.ply", "b.ply", "b.ply", "--labels", "m.mha"), ("a.ply", "b.ply", "--tolerance", -1)):
            self.fail_with(USAGE, "certify", *words)
        self.fail_with(USAGE, "certify", "a.ply", "b.ply", "--json", "b.ply", says="not overwritten")
        self.fail_with(USAGE, "certify", "a.ply", "b.ply", "--json", "./c", "--page", "c", says="written twice")
        self.fail_with(REJECTED, "certify", "a.ply", "nothing.ply", says="no such file")
        self.fail_with(NOT_WRITTEN, "certify", "a.ply", "b.ply", "--json", "nowhere/c.json")

    def test_says_which_tolerance_it_has_compared_with(self):
        write(with_tolerance(square(0.0), 2.5), self.path("t.vtp"))
        for words, says, keys in (
                ((), "No tolerance was given.", (None, None)),
                (("--tolerance", 1), "The tolerance of 1 mm is proved.", (1, None)),
                (("--tolerance-array", "allowed"), "The tolerance of each point (allowed) is proved.", (None, "allowed")),
                (("--tolerance-array", "allowed", "--tolerance", 0.125),
                 "The tolerance of each point (allowed), at most 0.125 mm, is proved.", (0.125, "allowed"))):
            self.succeed("certify", "t.vtp", "t.vtp", *words, "--page", "c.html", "--json", "c.json")
            self.assertIn(says, self.path("c.html").read_text(encoding="utf-8"))
            found = self.report("c.json")
            self.assertEqual((found.get("tolerance"), found.get("tolerance_array")), keys)


class CertifyScan(ApplicationTest):
    """A CT of a ball as the reference, and the surface of it that the program extracts, or that of another value."""

    def setUp(self):
        super().setUp()
        self.write_scan()
        self.succeed("ct.mha", "bone.ply", "--iso", 300, "--target-reduction", 0, *UNMEASURED)

    def write_scan(self):
        image = vtk.vtkImageData()
        image.SetDimensions(24, 24, 24)
        image.SetSpacing(0.5, 0.5, 0.75)
        image.SetOrigin(30.0, -20.0, 100.0)
        image.AllocateScalars(vtk.VTK_SHORT, 1)
        for k in range(24):
            for j in range(24):
                for i in range(24):
                    away = ((0.5 * i - 6) ** 2 + (0.5 * j - 6) ** 2 + (0.75 * k - 9) ** 2) ** 0.5
                    image.SetScalarComponentFromDouble(i, j, k, 0, round(1000 - 250 * away))
        write_map(image, self.path("ct.mha"))

    def test_compares_with_the_surface_of_the_value(self):
        text = self.succeed("certify", "ct.mha", "bone.ply", "--iso", 300, "--tolerance", 1e-5, "--json", "c.json", "--page", "c.html").stdout
        self.assertIn("ct.mha at 300 HU", self.path("c.html").read_text(encoding="utf-8"))
        self.assertIn("proved <= 0.000010 mm", text)
        self.assertEqual(self.report("c.json")["files"], {"reference": "ct.mha", "result": "bone.ply", "iso": 300, "unit": "mm"})
        other = self.run_program("certify", "ct.mha", "bone.ply", "--iso", 425, "--tolerance", 0.45)  # half a millimeter inward
        self.assertEqual(other.returncode, VIOLATED)
        self.succeed("certify", "ct.mha", "bone.ply", "--iso", 425, "--tolerance", 0.55)

    def test_a_result_in_the_other_axes_is_turned(self):
        surface = turned(read(self.path("bone.ply")))
        write(surface, self.path("unknown.vtp"))
        write(in_frame(surface, "RAS"), self.path("ras.vtp"))
        completed = self.succeed("certify", "ct.mha", "ras.vtp", "--iso", 300, "--tolerance", 1e-5)
        self.assertIn("the axes of 'ras.vtp' are RAS, those of the reference LPS", completed.stdout + completed.stderr)
        self.assertEqual(self.run_program("certify", "ct.mha", "unknown.vtp", "--iso", 300, "--tolerance", 1e-5).returncode, VIOLATED)

    def test_a_volume_and_a_value_belong_together(self):
        self.fail_with(USAGE, "certify", "ct.mha", "bone.ply", says="'ct.mha' is a volume: --iso takes its bone surface")
        self.fail_with(USAGE, "certify", "bone.ply", "bone.ply", "--iso", 300, says="--iso has no effect")
        self.fail_with(USAGE, "certify", "ct.mha", "bone.ply", "--iso", 300, "--tolerance-array", "t", says="the reference is a volume")


class CertifyUnits(ApplicationTest):
    def test_sizes_of_different_units_are_a_warning(self):
        write(torus(), self.path("bone.ply"))
        write(scaled(torus(), 0.001), self.path("m.ply"))
        completed = self.succeed("certify", "bone.ply", "m.ply")
        self.assertIn("warning: the diagonal of the result is 0.001 times that of the reference: the surfaces may have different units", completed.stdout)
        write(scaled(torus(), 0.2), self.path("smaller.ply"))
        self.assertNotIn("units", self.succeed("certify", "bone.ply", "smaller.ply").stdout)


class CertifySeveral(ApplicationTest):
    def test_several_results_have_one_reference(self):
        for name, height in (("flat", 0), ("near", 0.25), ("far", 0.5)):
            write(square(height), self.path(f"{name}.ply"))
        completed = self.run_program("certify", "flat.ply", "near.ply", "far.ply", "missing.ply", "--tolerance", 0.3, "--json", "c.json")
        self.assertEqual(completed.returncode, VIOLATED)
        self.assertRegex(completed.stdout, r"(?m)^near\.ply: 0\.249999 to 0\.25000\d mm, proved$")
        self.assertRegex(completed.stdout, r"(?m)^far\.ply: .* violated\n  warning: the diagonal of the reference's bounding box is 1\.41421 mm, which is not")
        self.assertIn("3 pairs: 1 proved, 1 violated, 1 not compared\n", completed.stdout)
        lines = self.run_program("certify", "flat.ply", "near.ply", "far.ply", "--tolerance", 0.3, "--no-boundaries").stdout
        self.assertRegex(lines, r"(?m)^near\.ply: .* mm, proved, but for open boundaries$")
        self.assertRegex(lines, r"(?m)^far\.ply: .* mm, violated$")
        self.assertEqual([row["name"] for row in self.report("c.json")], ["near.ply", "far.ply", "missing.ply"])
        self.fail_with(USAGE, "certify", "flat.ply", "near.ply", "far.ply", "--page", "p.html", says="--page is for one result; several take --json")


class CertifyFolders(ApplicationTest):
    def setUp(self):
        super().setUp()
        for folder in ("before/left", "after/left"):
            self.path(folder).mkdir(parents=True)
        for name, height in (("a", 0.25), ("left/b", 0.125)):
            write(square(0.0), self.path(f"before/{name}.ply"))
            write(square(height), self.path(f"after/{name}.stl"))

    def test_pairs_have_the_same_names(self):
        write(square(1.0), self.path("before/only_here.ply"))
        completed = self.run_program("certify", "before", "after", "--tolerance", 0.3, "--json", "c.json")
        self.assertEqual(completed.returncode, REJECTED)
        self.assertRegex(completed.stdout, r"(?m)^a: 0\.249999 to 0\.25000\d mm, proved$")
        self.assertIn("only_here: 'after' has no surface of this name\n", completed.stdout)
        self.assertIn("3 pairs: 2 proved, 1 not compared\n", completed.stdout)
        rows = self.report("c.json")
        self.assertEqual([(row["name"], row["exit_code"]) for row in rows], [("a", 0), ("left/b", 0), ("only_here", REJECTED)])
        self.path("before/only_here.ply").unlink()
        self.succeed("certify", "before", "after", "--tolerance", 0.3)
        self.assertAlmostEqual(rows[1]["certificate"]["upper"], 0.125, 6)

    def test_names_are_those_of_a_batch(self):
        write(square(0.0), self.path("before/a.obj"))
        self.path("after/a.stl").rename(self.path("after/a_ply.stl"))
        write(square(0.0), self.path("after/a_obj.ply"))
        completed = self.succeed("certify", "before", "after", "--tolerance", 0.3)
        self.assertIn("a_obj: 0.000000 to ", completed.stdout)
        self.assertIn("3 pairs: 3 proved\n", completed.stdout)
        self.assertIn("3 pairs: 3 compared\n", self.succeed("certify", "before", "after").stdout)

    def test_quiet_prints_what_is_not_proved(self):
        completed = self.run_program("certify", "before", "after", "--tolerance", 0.2, "--quiet")
        self.assertEqual((completed.returncode, completed.stdout), (VIOLATED, ""))
        self.assertRegex(completed.stderr, r"^a: .* violated\n$")

    def test_ends_with_the_worst_code(self):
        self.assertEqual(self.run_program("certify", "before", "after", "--tolerance", 0.2).returncode, VIOLATED)
        self.path("after/a.stl").write_bytes(b"solid nothing\nendsolid\n")
        completed = self.run_program("certify", "before", "after", "--tolerance", 0.2, "--json", "c.json")
        self.assertEqual(completed.returncode, REJECTED)
        self.assertIn("left/b: ", completed.stdout)
        self.assertIn("problem", self.report("c.json")[0])

    def test_files_of_equal_names_are_rejected_with_their_folders(self):
        write(square(0.0), self.path("before/a.stl"))
        write(square(float("nan")), self.path("after/a.stl"))
        self.path("before/a.ply").unlink()
        completed = self.run_program("certify", "before", "after")
        self.assertIn("a: 'before/a.stl' and 'after/a.stl' were rejected: the result has a triangle with a point that is ", completed.stdout)

    def test_a_result_without_its_reference_is_rejected(self):
        write(square(1.0), self.path("after/c.ply"))
        completed = self.run_program("certify", "before", "after")
        self.assertEqual(completed.returncode, REJECTED)
        self.assertIn("c: 'before' has no surface of this name\n", completed.stdout)
        self.assertIn("3 pairs: 2 compared, 1 not compared\n", completed.stdout)
        self.path("after/c.ply").unlink()
        write(square(1.0), self.path("after/a.ply"))
        completed = self.run_program("certify", "before", "after")
        self.assertEqual(completed.returncode, REJECTED)
        self.assertIn("a: 'after' has several surfaces of this name\n", completed.stdout)
        self.path("empty").mkdir()
        self.fail_with(REJECTED, "certify", "before", "empty", says="no surface is in it")
        self.fail_with(USAGE, "certify", "before", "after", "--page", "c.html", says="--page is for one result")


class CertifyVoxels(ApplicationTest):
    """A block of label 5, alone or with two voxels of label 7."""

    def setUp(self):
        super().setUp()
        write_map(blocks(5), self.path("one.mha"))
        write_map(blocks(5, 7), self.path("two.mha"))
        write(surface_of(blocks(5), 5), self.path("a.stl"))
        write(smoothed(surface_of(blocks(5), 5)), self.path("s.stl"))

    def test_tells_that_no_voxel_changed(self):
        for extension in ("vti", "mha", "mhd", "nrrd"):
            write_map(blocks(5), self.path("map." + extension))
            completed = self.succeed("certify", "a.stl", "--labels", "map." + extension, "--json", "c.json")
            self.assertIn("0 of 2,744 have another label", completed.stdout)
            found = self.report("c.json")
            self.assertEqual(found["status"], "not_requested")
            self.assertEqual(found["voxels"]["of_5"], {"voxels": 216, "lost": 0, "gained": 0})
            self.assertEqual(found["files"], {"result": "a.stl", "label_map": "map." + extension, "unit": "mm"})

    def test_counts_voxels_that_changed(self):
        completed = self.run_program(
            "certify", "s.stl", "--labels", "one.mha", "--json", "c.json", "--page", "c.html")
        self.assertEqual((completed.returncode, completed.stderr), (VIOLATED, ""))
        voxels = self.report("c.json")["voxels"]
        self.assertGreater(voxels["changed"], 0)
        self.assertEqual(voxels["changed"], voxels["of_5"]["lost"] + voxels["of_5"]["gained"])
        self.assertEqual(len(voxels["first_changed"]), 3)
        self.assertIn(f"{voxels['changed']} of 2,744 have another label", completed.stdout)
        page = self.path("c.html").read_text(encoding="utf-8")
        self.assertIn(f"{voxels['changed']} of 2,744 voxels have another label", page)
        self.assertIn("0 (background)", page)

    def test_compares_with_a_reference_and_a_map_in_one_run(self):
        self.succeed("certify", "a.stl", "a.stl", "--labels", "one.mha", "--tolerance", 0.1, "--json", "c.json")
        found = self.report("c.json")
        self.assertEqual((found["status"], found["voxels"]["changed"]), ("proved", 0))
        completed = self.run_program("certify", "a.stl", "s.stl", "--labels", "one.mha", "--tolerance", 9, "--page", "c.html")
        self.assertEqual(completed.returncode, VIOLATED)
        page = self.path("c.html").read_text(encoding="utf-8")
        self.assertIn("The tolerance of 9 mm is proved.", page)

    def test_has_to_know_which_label_a_surface_encloses(self):
        self.fail_with(REJECTED, "certify", "a.stl", "--labels", "two.mha", says="5, 7")
        self.fail_with(REJECTED, "certify", "a.stl", "--labels", "two.mha", "--label", 6, says="label 6")
        completed = self.succeed("certify", "a.stl", "--labels", "two.mha", "--label", 5)
        self.assertIn("warning: labels of the map that the surface does not have count as background: 7", completed.stdout)
        write(bounded(surface_of(blocks(5), 5), 5), self.path("b.vtp"))
        self.succeed("certify", "b.vtp", "--labels", "two.mha", "--quiet")
        self.fail_with(REJECTED, "certify", "b.vtp", "--labels", "two.mha", "--label", 5, says="BoundaryLabels")
        self.fail_with(USAGE, "certify", "a.stl", "--labels", "two.mha", "--label", 0, says="--label 0 is the background")

    def test_rejects_what_cannot_be_compared(self):
        self.fail_with(USAGE, "certify", "a.stl", says="--labels MAP")
        self.fail_with(USAGE, "certify", "a.stl", "--labels", "one.mha", "--tolerance", 1, says="--tolerance has no effect")
        self.fail_with(USAGE, "certify", "a.stl", "a.stl", "--label", 5, says="--labels FILE")
        self.fail_with(USAGE, "certify", "a.stl", "--labels", "one.mha", "--json", "one.mha", says="one.mha")
        self.fail_with(REJECTED, "certify", "a.stl", "--labels", "none.mha", says="'none.mha' was rejected: there is no such file")
        self.fail_with(REJECTED, "certify", "a.stl", "--labels", "Bone", says="'Bone' was rejected: there is no such file")
        self.fail_with(REJECTED, "certify", "a.stl", "--labels", "a.stl", says="no volume")


if __name__ == "__main__":
    main()
