# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A proof belongs to one surface: what the field data of a file say of another one, or of one that was changed afterwards."""

import json

import vtk
from application import UNMEASURED, ApplicationTest, main, read, torus, write

CHANGED = "nothing is proved of this surface: it is not the one that was proved, or was changed afterwards"


def moved(surface, scale=1.0, shift=0.0):
    transform = vtk.vtkTransform()
    transform.Scale(scale, scale, scale)
    transform.Translate(shift, 0, 0)
    filter_ = vtk.vtkTransformPolyDataFilter()
    filter_.SetTransform(transform)
    return updated(filter_, surface)


def updated(filter_, surface):
    filter_.SetInputData(surface)
    filter_.Update()
    return filter_.GetOutput()


def smoothed(surface):
    filter_ = vtk.vtkWindowedSincPolyDataFilter()
    filter_.SetNumberOfIterations(5)
    return updated(filter_, surface)


def reduced(surface):
    filter_ = vtk.vtkQuadricDecimation()
    filter_.SetTargetReduction(0.5)
    return updated(filter_, surface)


def clipped(surface):
    plane = vtk.vtkPlane()
    plane.SetNormal(1, 0, 0)
    filter_ = vtk.vtkClipPolyData()
    filter_.SetClipFunction(plane)
    return updated(filter_, surface)


def turned(surface):
    return updated(vtk.vtkReverseSense(), surface)


def appended(surface):
    filter_ = vtk.vtkAppendPolyData()
    filter_.AddInputData(surface)
    filter_.AddInputData(moved(surface, shift=80.0))
    filter_.Update()
    filter_.GetOutput().GetFieldData().PassData(surface.GetFieldData())
    return filter_.GetOutput()


def one_less(surface):
    copy = vtk.vtkPolyData()
    copy.DeepCopy(surface)
    copy.BuildLinks()
    copy.DeleteCell(0)
    copy.RemoveDeletedCells()
    return copy


CHANGES = {"smoothed": smoothed, "reduced": reduced, "scaled": lambda surface: moved(surface, scale=10.0), "clipped": clipped,
           "turned": turned, "appended": appended, "one triangle less": one_less, "moved": lambda surface: moved(surface, shift=1e-5)}


def in_other_order(surface):
    """The same triangles, and points that are not merged."""
    soup = vtk.vtkPolyData()
    points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
    points.SetDataType(surface.GetPoints().GetDataType())
    for cell in reversed(range(surface.GetNumberOfCells())):
        ids = surface.GetCell(cell).GetPointIds()
        cells.InsertNextCell(3, [points.InsertNextPoint(surface.GetPoint(ids.GetId((corner + 1) % 3))) for corner in range(3)])
    soup.SetPoints(points)
    soup.SetPolys(cells)
    soup.SetFieldData(surface.GetFieldData())
    return soup


class AProof(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.vtp"))
        self.succeed("in.vtp", "out.vtp", "--max-error", 0.2, *UNMEASURED)

    def report_in(self, name):
        said = self.succeed("certify", "in.vtp", name, "--no-means", "--json", "certificate.json").stdout
        found = self.report("certificate.json").get("report_in_file", "")
        self.assertIn("report in the file   " + found, said)
        return found

    def test_comes_with_the_surface_it_was_made_for(self):
        self.assertRegex(self.report_in("out.vtp"), r"^at most 0\.\d+ mm in both directions$")
        write(in_other_order(read(self.path("out.vtp"))), self.path("again.vtp"))
        self.assertRegex(self.report_in("again.vtp"), r"^at most 0\.\d+ mm in both directions$")

    def test_is_replaced_by_a_sentence_with_any_other(self):
        proved = read(self.path("out.vtp"))
        for name, change in CHANGES.items():
            with self.subTest(name):
                write(change(proved), self.path("changed.vtp"))
                self.assertEqual(self.report_in("changed.vtp"), CHANGED)

    def test_says_in_the_field_data_itself_what_it_is_of(self):
        fields = read(self.path("out.vtp")).GetFieldData()
        report = json.loads(fields.GetAbstractArray("BoneDecimateReport").GetValue(0))
        self.assertEqual(set(report["proof"]), {"if_unchanged", "sentence"})
        self.assertRegex(report["output"]["checksum"], "^triangles:[0-9a-f]{16}$")
        self.assertTrue(report["proof"]["sentence"].startswith("only of the surface whose triangles have output.checksum: at most 0."))
        for i in range(fields.GetNumberOfArrays()):
            self.assertFalse(fields.GetArrayName(i) in ("bonedecimate.proof.status", "bonedecimate.proof.upper"))

    def test_holds_for_a_file_in_another_unit(self):
        write(moved(torus(), scale=0.001), self.path("in_m.vtp"))
        self.succeed("in_m.vtp", "out_m.vtp", "--unit", "m", "--max-error", 0.2, *UNMEASURED)
        said = self.succeed("certify", "in_m.vtp", "out_m.vtp", "--unit", "m", "--no-means").stdout
        self.assertRegex(said, r"report in the file   at most 0\.\d+ mm in both directions")


if __name__ == "__main__":
    main()
