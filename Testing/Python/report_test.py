# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The reports of real runs have the form that their schemas describe."""

import json
import os
import pathlib
import unittest

from bonedecimate import vtkBoneDecimate, vtkBoneDecimateLevels, vtkBoneErrorSearch, vtkBoneSurfaceDistance, vtkBoneSurfaces
from jsonschema import Draft202012Validator
from surfaces import decimating, torus
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkImagingSources import vtkImageEllipsoidSource

FOLDER = pathlib.Path(os.environ.get("SCHEMAS", pathlib.Path(__file__).resolve().parents[2] / "Documentation"))
REPORT, CERTIFICATE = (json.loads((FOLDER / f"{name}.schema.json").read_text(encoding="utf-8")) for name in ("report", "certificate"))


def problems(value, schema):
    """What is wrong with a value, a sentence each."""
    return [f"{error.json_path}: {error.message}" for error in Draft202012Validator(schema).iter_errors(value)]


def plate():
    source = vtkPlaneSource()
    source.SetResolution(20, 20)
    source.Update()
    return source.GetOutput()


def with_line():
    """Far from the plate."""
    surface = plate()
    lines = vtkCellArray()
    lines.InsertNextCell(2, [0, surface.GetPoints().InsertNextPoint(0.0, 0.0, 9.0)])
    surface.SetLines(lines)
    surface.GetPointData().Initialize()
    return surface


def marked(surface, kind, name, data, value):
    array = kind()
    array.SetName(name)
    for i in range(surface.GetNumberOfPoints() if data == surface.GetPointData() else surface.GetNumberOfCells()):
        array.InsertNextValue(value(i))
    data.AddArray(array)
    return surface


def labeled():
    surface = torus()
    return marked(surface, vtkIntArray, "Bone", surface.GetCellData(), lambda i: i % 500 // 250)


def tolerant():
    surface = torus()
    return marked(surface, vtkDoubleArray, "Tolerance", surface.GetPointData(), lambda i: i % 3 / 2)


def segmented():
    ellipsoid = vtkImageEllipsoidSource()
    ellipsoid.SetWholeExtent(0, 30, 0, 30, 0, 30)
    ellipsoid.SetCenter(15.2, 14.9, 15.1)
    ellipsoid.SetRadius(11, 9, 12)
    ellipsoid.SetInValue(1)
    ellipsoid.SetOutValue(0)
    surfaces = vtkBoneSurfaces()
    surfaces.SetInputConnection(ellipsoid.GetOutputPort())
    surfaces.Update()
    return surfaces.GetOutput()


# Surface and options of each run.
RUNS = {
    "reduction": (torus, {"TargetReduction": 0.5}),
    "error": (torus, {"MaximumError": 0.5}),
    "refined": (torus, {"MaximumError": 0.5, "Mode": vtkBoneDecimate.ACCURATE}),
    "angles": (torus, {"MaximumError": 0.5, "MinimumAngle": 20.0}),
    "edges": (torus, {"MaximumError": 0.5, "EdgeLength": 2.0}),
    "local edges": (torus, {"MaximumError": 0.5, "EdgeLength": 3.0, "ChordalError": 0.1}),
    "boundaries": (plate, {"MaximumError": 0.1}),
    "thesis": (torus, {"Mode": vtkBoneDecimate.THESIS, "TargetNumberOfTriangles": 100}),
    "unmeasured": (torus, {"TargetReduction": 0.5, "MeasureDistances": False}),
    "labels": (labeled, {"LabelArrayName": "Bone"}),
    "tolerances": (tolerant, {"ToleranceArrayName": "Tolerance"}),
    "voxels": (torus, {"ErrorPreset": vtkBoneDecimate.ONE_VOXEL, "VoxelSize": 0.5}),
    "diagnostics": (plate, {"DiagnoseInput": True}),
    "line": (with_line, {"MaximumError": 0.1}),
    "welded": (plate, {"MaximumError": 0.1, "WeldDistance": 1e-4}),
    "pruned": (torus, {"PruneTriangles": 3}),
    "tunnels": (torus, {"TunnelSize": 15.0}),
    "smoothed": (segmented, {"AutomaticSmoothing": True, "MaximumError": 0.5}),
    "voxels-changed": (segmented, {"KeepVoxels": vtkBoneDecimate.KEEP_VOXELS_OFF, "TargetReduction": 0.98}),
}


class Report(unittest.TestCase):
    def test_of_real_runs_has_the_form_of_its_schema(self):
        parts = set()
        for name, (make, options) in RUNS.items():
            decimate = decimating(make(), **options)
            decimate.Update()
            report = json.loads(decimate.GetOutput().GetFieldData().GetAbstractArray("BoneDecimateReport").GetValue(0))
            parts |= set(report)
            with self.subTest(name):
                self.assertEqual(problems(report, REPORT), [])
        reference = decimating(torus(), MaximumError=0.5)
        reference.SetReferenceData(torus())
        reference.Update()
        report = json.loads(reference.report_as_json)
        self.assertEqual(problems(report, REPORT), [])
        of_program = {"changed_before", "command_line", "files", "model_grid", "segments", "settings", "slabs", "specks", "warnings", "notes"}
        self.assertEqual(set(REPORT["properties"]) - parts - set(report) - of_program - {"fragment_gap"}, set(), "shown by no run")

    def test_before_a_run_has_the_form_of_its_schema(self):
        for kind in (vtkBoneDecimate, vtkBoneDecimateLevels, vtkBoneErrorSearch):
            self.assertEqual(problems(json.loads(kind().report_as_json), REPORT), [], kind.__name__)

    def test_of_an_aborted_run_has_the_form_of_its_schema(self):
        decimate = decimating(torus(), MaximumError=0.5)
        decimate.AddObserver("ProgressEvent", lambda *_: decimate.SetAbortExecute(decimate.GetProgress() > 0.3))
        decimate.Update()
        carried = json.loads(decimate.GetOutput().GetFieldData().GetAbstractArray("BoneDecimateReport").GetValue(0))
        for report, status in ((json.loads(decimate.report_as_json), lambda proof: proof["status"]),
                               (carried, lambda proof: proof["if_unchanged"]["status"])):
            self.assertEqual((problems(report, REPORT), status(report["proof"])), ([], "aborted"))

    def test_names_every_option(self):
        options = json.loads(vtkBoneDecimate().report_as_json)["options"]
        self.assertTrue(all(vtkBoneDecimate().HasOption(name) for name in options))

    def test_certificates_have_the_form_of_their_schema(self):
        for make, tolerance in ((torus, None), (plate, 0.1)):
            compare = vtkBoneSurfaceDistance()
            compare.SetInputData(0, make())
            compare.SetInputData(1, make())
            if tolerance:
                compare.tolerance = tolerance
            compare.Update()
            text = compare.GetOutput().GetFieldData().GetAbstractArray("BoneDecimateCertificate").GetValue(0)
            self.assertEqual(text, compare.report_as_json)
            self.assertEqual(problems(json.loads(text), CERTIFICATE), [])

    def test_another_form_is_found(self):
        report = json.loads(vtkBoneDecimate().report_as_json)
        for change in ({"version": 1}, {"stop_reason": "tired"}, {"collapses": -1}, {"new": 0}, {"input": {}}):
            self.assertNotEqual(problems({**report, **change}, REPORT), [], change)


if __name__ == "__main__":
    unittest.main()
