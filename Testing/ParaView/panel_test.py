# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The panels of the plugin, as ParaView reads them."""

import math
import os
import pathlib
import re
import unittest
import xml.etree.ElementTree as ElementTree

from paraview import simple

import specimens
import surfaces

SOURCE = pathlib.Path(os.environ["SOURCE_DIR"])
PANELS = [os.environ["PANEL"], SOURCE / "Applications" / "ParaView" / "Plugin" / "BoneTools.xml"]
TABLE = (SOURCE / "Documentation" / "reference" / "options.md").read_text(encoding="utf-8")


class Panel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        surfaces.load()
        cls.bone = surfaces.source(specimens.torus())

    def test_every_option_of_the_table_is_a_property_with_its_default(self):
        decimate = simple.BoneDecimate(Input=self.bone)
        rows = re.findall(r"^\| `(\w+)` \|[^|]*\| ([^|]+) \| ([^|]*) \| ([^|]*) \|", TABLE, re.MULTILINE)
        self.assertGreater(len(rows), 20)
        for name, values, default, unit in rows:
            with self.subTest(name):
                found = decimate.GetProperty(name)
                self.assertEqual(found.GetDocumentation().GetDescription().strip().startswith("In mm."), unit.strip() == "mm")
                value = str(found.GetData())
                words = {"on": "1", "off": "0"}
                text = default.strip()
                if values == "text":
                    self.assertEqual(value.replace(" (mm)", ""), text)
                elif values[0].isdigit():
                    self.assertEqual(float(value), float(text))
                else:
                    self.assertEqual(value, words.get(text, text))

    def test_eight_properties_come_first_and_all_others_are_in_a_group(self):
        panel = ElementTree.parse(PANELS[0]).find(".//SourceProxy")
        properties = [child for child in panel if child.tag.endswith("VectorProperty")]
        first = [child.get("name") for child in properties if child.get("panel_visibility") == "default"]
        self.assertEqual(first, ["Mode", "MaximumError", "TargetReduction", "AutomaticSmoothing", "LabelArrayName", "KeepVoxels",
                                 "ToleranceArrayName", "NumberOfThreads"])
        grouped = [one.get("name") for group in panel.iter("PropertyGroup") for one in group]
        self.assertEqual(sorted(first + grouped), sorted(child.get("name") for child in properties))

    def test_numbers_with_a_unit_show_it_and_are_called_by_their_names_in_python(self):
        units = {"mm": "mm", "mm2": "mm\u00b2", "mm3": "mm\u00b3", "degrees": "\u00b0"}
        panel = ElementTree.parse(PANELS[0]).find(".//SourceProxy")
        shown = {child.get("name"): component.get("label") for child in panel for component in child.iter("ComponentLabel")}
        rows = re.findall(r"^\| `(\w+)` \|[^|]*\| ([^|]+) \| [^|]* \| ([^|]*) \|", TABLE, re.MULTILINE)
        self.assertEqual(shown.pop("TargetReduction"), "0.9: unset")
        self.assertEqual(shown, {name: units[unit.strip()] for name, _, unit in rows if unit.strip() in units})
        decimate = simple.BoneDecimate(Input=self.bone, PruneArea=2.0)
        self.assertEqual(decimate.PruneArea, 2.0)

    def test_no_property_names_one_that_is_not_there(self):
        for panel in PANELS:
            for proxy in ElementTree.parse(panel).iter("SourceProxy"):
                names = {child.get("name") for child in proxy if child.tag.endswith("Property")}
                decorators = {one.get("property") for one in proxy.iter("PropertyWidgetDecorator")} - {None}
                grouped = {one.get("name") for group in proxy.iter("PropertyGroup") for one in group}
                with self.subTest(proxy.get("name")):
                    self.assertLessEqual(decorators | grouped, names)

    def test_tolerances_are_chosen_from_the_point_arrays_and_none_is_the_default(self):
        surface = specimens.with_arrays(specimens.torus())
        decimate = simple.BoneDecimate(Input=surfaces.source(surface))
        self.assertEqual(decimate.ToleranceArrayName, "")
        offered = decimate.GetProperty("ToleranceArrayName").GetAvailable()
        self.assertIn("Density", offered)
        self.assertIn("", offered)
        self.assertNotIn("Part", offered)

    def test_the_report_is_in_the_information_about_the_field_data(self):
        decimate = simple.BoneDecimate(Input=self.bone, MaximumError=0.2)
        decimate.UpdatePipeline()
        information = decimate.GetDataInformation().GetFieldDataInformation()
        names = [information.GetArrayInformation(i).GetName() for i in range(information.GetNumberOfArrays())]
        self.assertIn("bonedecimate.output.triangles", names)
        proved = information.GetArrayInformation("bonedecimate.proof.if_unchanged.upper").GetComponentRange(0)
        self.assertLessEqual(proved[1], 0.2)
        self.assertGreater(proved[1], 0)

    def test_values_outside_their_range_give_no_output_until_there_is_a_valid_one(self):
        rows = re.findall(r"^\| `(\w+)` \|[^|]*\| ([\d.e]+) to ([\d.e]+) \|", TABLE, re.MULTILINE)
        self.assertGreater(len(rows), 8)
        for name, least, most in rows:
            is_whole = float(most).is_integer() and float(most) > 1 and float(most) < 1e30
            beyond = [-2**31, -1] if is_whole else [float(least) - 1, float(most) * 1.1, math.nan, math.inf, -math.inf]
            decimate = simple.BoneDecimate(Input=self.bone)
            valid = decimate.GetProperty(name).GetData()
            for value in beyond:
                with self.subTest(name, value=value):
                    setattr(decimate, name, value)
                    decimate.UpdatePipeline()
                    self.assertEqual(decimate.GetDataInformation().GetNumberOfPoints(), 0)
                    setattr(decimate, name, valid)
                    decimate.UpdatePipeline()
                    self.assertGreater(decimate.GetDataInformation().GetNumberOfPoints(), 0)

    def test_a_tolerance_of_minus_one_is_none_and_any_other_negative_one_an_error(self):
        compare = simple.BoneSurfaceDistance(Input=self.bone, Result=self.bone)
        for value, is_valid in ((-1, True), (-0.5, False), (0.5, True), (math.nan, False), (-1, True)):
            compare.Tolerance = value
            compare.UpdatePipeline()
            self.assertEqual(compare.GetDataInformation().GetNumberOfPoints() > 0, is_valid, value)

    def test_two_surfaces_give_their_certificate_and_are_colored_by_it(self):
        balls = [simple.Sphere(Radius=radius, ThetaResolution=24, PhiResolution=24) for radius in (10.0, 10.25)]
        compare = simple.BoneSurfaceDistance(Input=balls[0], Result=balls[1], Tolerance=0.3)
        # The same corners 0.25 mm farther out: no point is farther, and the corner at the pole is as far.
        for tolerance, status in ((0.3, "proved"), (0.2, "violated")):
            compare.Tolerance = tolerance
            compare.UpdatePipeline()
            for port in (0, 1):
                information = compare.GetDataInformation(port).GetFieldDataInformation()
                lower, upper = (information.GetArrayInformation(f"bonedecimate.certificate.{name}").GetComponentRange(0)[0]
                                for name in ("lower", "upper"))
                self.assertTrue(lower <= 0.25 + 1e-5 and 0.25 - 1e-5 <= upper <= 0.2501, (lower, upper))
                self.assertEqual(surfaces.report(compare)["bonedecimate.certificate.status"], status)
                self.assertIn("SignedDistance (mm)", simple.OutputPort(compare, port).PointData.keys())
        view = simple.CreateView("RenderView")
        for port in (0, 1):
            shown = simple.Show(simple.OutputPort(compare, port), view)
            self.assertEqual(shown.ColorArrayName[:], ["POINTS", "SignedDistance (mm)"])

    def test_distances_say_their_unit(self):
        decimate = simple.BoneDecimate(Input=self.bone, MaximumError=0.2, MeasureInputDistances=1)
        decimate.UpdatePipeline()
        self.assertIn("Distance (mm)", decimate.PointData.keys())
        self.assertIn("ErrorBound (mm)", decimate.PointData.keys())
        of_input = simple.OutputPort(decimate, 1).PointData.keys()
        self.assertIn("DistanceToResult (mm)", of_input)
        self.assertNotIn("DistanceToResult (mm)", decimate.PointData.keys())


if __name__ == "__main__":
    unittest.main()
