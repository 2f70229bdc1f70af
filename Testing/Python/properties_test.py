# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every property of the filter, from Python."""

import json
import math
import os
import pathlib
import re
import unittest

from surfaces import TRIANGLES, Ear, decimating, torus
from bonedecimate import (
    error_curve, smallest_error, vtkBoneCap, vtkBoneDiagnostics, vtkBoneDecimate, vtkBoneDecimateLevels, vtkBoneErrorSearch, vtkBoneLabelPieces,
    vtkBoneSurfaceDistance, vtkBoneSurfaces, vtkBoneTolerance, vtkBoneVoxelCheck)
from vtkmodules.vtkFiltersCore import vtkCleanPolyData

NO_NUMBERS = (math.nan, math.inf, -math.inf)
with open(os.environ["OPTION_TABLE"], encoding="utf-8") as _file:
    ROWS = json.load(_file)["options"]
SWITCHES = {row["name"]: row["default"] == "on" for row in ROWS if row["kind"] == "bool"}
TEXTS = {row["name"]: row["default"] for row in ROWS if row["kind"] == "text"}


def values_of(row):
    """Default, another value, values outside the range."""
    least, most = row["minimum"], row["maximum"]
    if row["kind"] == "double":
        default = float(row["default"])
        return default, most / 4 if most < 1e30 else default + 0.25, (least - 0.1, most * 1.1, *NO_NUMBERS)
    if row["kind"] == "choice":
        default = row["choices"].index(row["default"])
        return default, 0 if default else 1, (-1, most + 1, -2**31, 2**31 - 1)
    return int(row["default"]), 2, (-1, -2**31) if most == 2**31 - 1 else (-1, most + 1)


NUMBERS = {row["name"]: values_of(row) for row in ROWS if row["kind"] in ("double", "int", "choice")}


def get(decimate, name):
    return getattr(decimate, "Get" + name)()


def put(decimate, name, value):
    getattr(decimate, "Set" + name)(value)


def snake(name):
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


class Properties(unittest.TestCase):
    def test_are_those_of_the_option_table(self):
        decimate = vtkBoneDecimate()
        entries = [decimate.GetReportEntryName(i) for i in range(decimate.GetNumberOfReportEntries())]
        table = {name[len("options.") :] for name in entries if name.startswith("options.")}
        self.assertEqual(table, {*NUMBERS, *SWITCHES, *TEXTS})

    def test_have_their_defaults(self):
        decimate = vtkBoneDecimate()
        for name, values in NUMBERS.items():
            self.assertEqual(get(decimate, name), values[0], name)
        for name, default in {**SWITCHES, **TEXTS}.items():
            self.assertEqual(get(decimate, name), default, name)

    def test_keep_their_values(self):
        decimate = vtkBoneDecimate()
        for name, values in NUMBERS.items():
            put(decimate, name, values[1])
            self.assertEqual(get(decimate, name), values[1], name)
        for name in TEXTS:
            put(decimate, name, "my " + name)
            self.assertEqual(get(decimate, name), "my " + name)

    def test_reject_values_outside_their_range(self):
        decimate = vtkBoneDecimate()
        for name, (_default, other, outside) in NUMBERS.items():
            put(decimate, name, other)
            for value in outside:
                with self.subTest(name, value=value):
                    with self.assertRaisesRegex(ValueError, f"^{name} takes "):
                        put(decimate, name, value)
                    with self.assertRaisesRegex(ValueError, f"^{name} takes "):
                        setattr(decimate, snake(name), value)
                    self.assertEqual(get(decimate, name), other)

    def test_a_rejected_value_fails_every_update_until_there_is_a_valid_one(self):
        decimate = decimating(torus(), TargetReduction=0.5)
        with self.assertRaises(ValueError):
            decimate.maximum_error = math.nan
        errors = Ear(decimate, "ErrorEvent")
        Ear(decimate.GetExecutive(), "ErrorEvent")
        for times in (1, 2):
            decimate.Update()
            self.assertEqual(len(errors.texts), times)
            self.assertIn("MaximumError takes a number from 0 to 1e30 mm, not NaN", errors.texts[-1])
            self.assertEqual(decimate.GetOutput().GetNumberOfPoints(), 0)
        decimate.maximum_error = 0.5
        decimate.Update()
        self.assertEqual(len(errors.texts), 2)
        self.assertGreater(decimate.GetOutput().GetNumberOfPoints(), 0)

    def test_are_attributes_too(self):
        decimate = vtkBoneDecimate(maximum_error=0.5, mode=vtkBoneDecimate.FAST)
        self.assertEqual((decimate.GetMaximumError(), decimate.GetMode()), (0.5, vtkBoneDecimate.FAST))
        for name, (default, other, _outside) in NUMBERS.items():
            setattr(decimate, snake(name), default)
            self.assertEqual(get(decimate, name), default)
            setattr(decimate, snake(name), other)
            self.assertEqual(get(decimate, name), other)
        for name in (*SWITCHES, *TEXTS):
            put(decimate, name, "a name" if name in TEXTS else True)
            self.assertEqual(getattr(decimate, snake(name)), get(decimate, name))

    def test_unknown_attributes_are_errors(self):
        for filter_class in (vtkBoneCap, vtkBoneDiagnostics, vtkBoneDecimate, vtkBoneDecimateLevels, vtkBoneErrorSearch, vtkBoneLabelPieces,
                             vtkBoneSurfaceDistance, vtkBoneSurfaces, vtkBoneTolerance, vtkBoneVoxelCheck):
            with self.subTest(filter_class.__name__):
                for name in ("max_error", "MaximumError", "SetNumberOfThreads", "Update", "GetOutput", "anything"):
                    with self.assertRaises(AttributeError):
                        setattr(filter_class(), name, 0.1)
                with self.assertRaises(AttributeError):
                    filter_class(anything=0.1)

    def test_of_getters_are_read_only(self):
        decimate = decimating(torus(), MaximumError=0.5)
        self.assertTrue(math.isnan(decimate.proved_error))
        self.assertEqual((decimate.stop_reason, decimate.proof_status), (vtkBoneDecimate.NOT_RUN, vtkBoneDecimate.NO_PROOF))
        decimate.Update()
        self.assertLessEqual(decimate.measured_error, decimate.proved_error)
        self.assertLessEqual(decimate.proved_error, 0.5)
        self.assertEqual(decimate.proof_status_as_string, "proved")
        self.assertEqual(decimate.number_of_input_triangles, TRIANGLES)
        self.assertEqual(decimate.number_of_output_triangles, decimate.GetOutput().GetNumberOfPolys())
        self.assertGreaterEqual(decimate.number_of_rejected_edits, decimate.GetNumberOfRejectedEdits("error_bound"))
        with self.assertRaises(AttributeError):
            decimate.proved_error = 0.1

    def test_are_set_by_name_from_text(self):
        decimate = vtkBoneDecimate()
        decimate.SetOptionFromText("MaximumError", "0.25")
        self.assertEqual((decimate.maximum_error, decimate.GetOptionAsText("MaximumError")), (0.25, "0.25"))
        with self.assertRaisesRegex(ValueError, "MaximumError takes "):
            decimate.SetOptionFromText("MaximumError", "-1")
        with self.assertRaises(AttributeError):
            decimate.SetOptionFromText("MaxError", "1")

    def test_have_the_documentation_of_the_table(self):
        page = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "reference" / "options.md"
        rows = [[cell.strip() for cell in line.strip("|\n ").split("|")] for line in page.read_text(encoding="utf-8").splitlines()
                if line.startswith("| `") and line.count("|") == 7]
        self.assertEqual({row[0].strip("`") for row in rows}, {*NUMBERS, *SWITCHES, *TEXTS})
        for option, _flag, values, _default, unit, meaning in rows:
            name = option.strip("`")
            for member in ("Set" + name, snake(name)):
                text = " ".join((getattr(vtkBoneDecimate, member).__doc__ or "").split())
                self.assertIn(meaning, text, member)
                if re.fullmatch(r"\S+ to \S+", values):
                    self.assertIn(f"Range: {values} {unit}".strip() + ";", text, member)

    def test_of_every_other_filter_reject_values_outside_their_range(self):
        outside = {"tolerance": (-1, *NO_NUMBERS), "relative_gap": (0, 2, *NO_NUMBERS), "mean_precision": (0, 2, *NO_NUMBERS),
                   "number_of_threads": (-1, 1025), "choice": (-1, 8), "fold_angle": (-1, 181, *NO_NUMBERS),
                   "feather": (-1, *NO_NUMBERS), "inside_tolerance": NO_NUMBERS, "outside_tolerance": NO_NUMBERS,
                   "island_size": (-1, *NO_NUMBERS), "island_area": (-1, *NO_NUMBERS), "island_volume": (-1, *NO_NUMBERS),
                   "cavity_volume": (-1, *NO_NUMBERS), "mode": (-1, 4), "relative_precision": (0, 0.6, *NO_NUMBERS), "target_number_of_triangles": (-1,), "maximum_error": (-1, *NO_NUMBERS), "number_of_triangles": (-1,),
                   "level_error": (-1, *NO_NUMBERS), "output_points_precision": (-1, 3), "loops": (-1, 2),
                   "plane_tolerance": (-1, *NO_NUMBERS)}
        tried = set()
        for filter_class in (vtkBoneCap, vtkBoneDiagnostics, vtkBoneDecimateLevels, vtkBoneErrorSearch, vtkBoneLabelPieces, vtkBoneSurfaceDistance,
                             vtkBoneSurfaces, vtkBoneTolerance, vtkBoneVoxelCheck):
            one = filter_class()
            for name, values in outside.items():
                for value in values if hasattr(filter_class, name) else ():
                    with self.subTest(filter_class.__name__, name=name, value=value):
                        before = getattr(one, name)
                        with self.assertRaisesRegex(ValueError, " takes "):
                            setattr(one, name, value)
                        self.assertEqual(getattr(one, name), before)
                        tried.add(name)
        self.assertEqual(tried, set(outside))
        for value in (0, -1, *NO_NUMBERS):
            with self.assertRaises(ValueError):
                vtkBoneErrorSearch().AddError(value)

    def test_searches_and_curves_raise_what_is_wrong(self):
        for wrong in (lambda: smallest_error(torus(), 0), lambda: smallest_error(torus(), -1),
                      lambda: smallest_error(torus(), 100, math.nan), lambda: smallest_error(torus(), 100, mode=0),
                      lambda: error_curve(torus(), []), lambda: error_curve(torus(), [0.1, math.nan]),
                      lambda: error_curve(torus(), [0.1, 1e9])):
            with self.assertRaises(ValueError):
                wrong()

    def test_stay_those_of_the_class_behind_a_pipeline(self):
        clean = vtkCleanPolyData()
        decimate = decimating(torus(), MaximumError=0.5)
        clean.SetInputConnection(decimate.GetOutputPort())
        del decimate
        found = clean.GetInputConnection(0, 0).GetProducer()
        self.assertIsInstance(found, vtkBoneDecimate)
        self.assertEqual(found.maximum_error, 0.5)
        with self.assertRaises(AttributeError):
            found.max_error = 0.1

    def test_switches_have_set_on_and_off(self):
        decimate = vtkBoneDecimate()
        for name in SWITCHES:
            for turn, expected in (("Off", False), ("On", True)):
                getattr(decimate, name + turn)()
                self.assertIs(get(decimate, name), expected, name)
                put(decimate, name, not expected)
                self.assertIs(get(decimate, name), not expected, name)

    def test_reject_what_is_no_number(self):
        with self.assertRaises(TypeError):
            vtkBoneDecimate().SetTargetReduction("much")

    def test_stand_in_the_printed_text(self):
        decimate = vtkBoneDecimate()
        for name in (*NUMBERS, *SWITCHES, *TEXTS):
            self.assertIn(name + ": ", str(decimate))

    def test_target_reduction_is_the_fraction_removed(self):
        decimate = decimating(torus(), TargetReduction=0.75)
        decimate.Update()
        self.assertEqual(decimate.GetOutput().GetNumberOfPolys(), TRIANGLES // 4)

    def test_a_number_alone_switches_the_default_reduction_off(self):
        decimate = decimating(torus(), TargetNumberOfTriangles=60)
        decimate.Update()
        self.assertEqual(decimate.GetOutput().GetNumberOfPolys(), 60)


if __name__ == "__main__":
    unittest.main()
