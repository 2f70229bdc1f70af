#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Plugin/BoneDecimate.xml, the panel of ParaView, from the table in Documentation/options.md.

That page is the core's table of options word for word (a test holds it against the program), so names, ranges, units, defaults
and texts are written nowhere else. Below is what only a panel has: groups, and when an option applies.

    write_server_manager.py            write it
    write_server_manager.py --check    fail if it is not what would be written
"""

import pathlib
import re
import sys
from xml.sax.saxutils import escape, quoteattr

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "Documentation" / "options.md"
PANEL = pathlib.Path(__file__).resolve().parent / "Plugin" / "BoneDecimate.xml"

GROUPS = [
    ("Targets (lengths in mm)", ["Mode", "TargetNumberOfTriangles", "TargetReduction", "MaximumError", "ErrorPreset", "VoxelSize",
                 "ToleranceArrayName", "LabelArrayName"]),
    ("Smoothing (lengths in mm)", ["Smoothing", "AutomaticSmoothing", "FeatureAngle"]),
    ("Proof", ["IntersectionGuard", "RefinementEffort", "MinimumAngle", "EdgeLength", "EdgeLengthArrayName", "ChordalError",
               "KeepVoxels", "ProveResult"]),
    ("Output", ["MeasureDistances", "MeasureInputDistances", "PassArrays", "MakeMaps", "RecomputeNormals",
                        "OutputPointsPrecision", "OutputPointsGrid"]),
]
# Shown by the advanced toggle of the panel.
ADVANCED = {"MergePoints", "NumberOfThreads", "OutputPointsPrecision", "OutputPointsGrid", "MakeMaps"}

THESIS = ("Mode", "0", False)
NOT_THESIS = ("Mode", "0", True)
HAS_LENGTH = ("EdgeLength", "0", True)
HAS_ERROR = [("MaximumError", "0", True), ("ErrorPreset", "0", True), ("ToleranceArrayName", "", True)]
# Enabled where one of each list holds: (property, value, inverted).
APPLIES = {
    "IntersectionGuard": [[NOT_THESIS], HAS_ERROR],
    "RefinementEffort": [[("Mode", "2", False), ("Mode", "3", False)], HAS_ERROR],
    "MinimumAngle": [[NOT_THESIS]],
    "EdgeLength": [[NOT_THESIS]],
    "EdgeLengthArrayName": [[NOT_THESIS], [HAS_LENGTH]],
    "ChordalError": [[NOT_THESIS], [HAS_LENGTH]],
    "ProveResult": [[NOT_THESIS], HAS_ERROR],
    "ErrorBoundArrayName": [[NOT_THESIS], HAS_ERROR, [("ProveResult", "1", False)]],
    "InputErrorBoundArrayName": [[NOT_THESIS], HAS_ERROR, [("ProveResult", "1", False)], [("MeasureInputDistances", "1", False)]],
    "NormalTolerance": [[THESIS], [("AutomaticNormalTolerance", "0", False)]],
    "AutomaticNormalTolerance": [[THESIS]],
    "VoxelSize": [[("ErrorPreset", "0", True)]],
    "AutomaticSmoothing": [[("Smoothing", "0", False)]],
    "FeatureAngle": [[("Smoothing", "0", True), ("AutomaticSmoothing", "1", False)]],
    "DistanceArrayName": [[THESIS, ("MeasureDistances", "1", False)]],
    "RunningErrorArrayName": [[THESIS, ("MeasureDistances", "1", False)]],
    "InputDistanceArrayName": [[("MeasureInputDistances", "1", False)]],
}
# Chosen from a list of the arrays of the input.
ARRAYS_OF_POINTS = ("ToleranceArrayName", "EdgeLengthArrayName")
# A panel sets every property: see vtkPVBoneDecimate.
COMMANDS = {"TargetReduction": "SetTargetReductionUnlessDefault"}

HEAD = """<!-- Written by write_server_manager.py from Documentation/options.md. -->
<ServerManagerConfiguration>
  <ProxyGroup name="filters">
    <SourceProxy name="BoneDecimate" class="vtkPVBoneDecimate" label="Bone Decimate">
      <Documentation short_help="Make a bone surface smaller, keep every fragment, report the error in millimeters.">
        Returns the surface with fewer triangles. Coordinates are millimeters. No component is
        removed or merged with another, open boundaries move only along themselves. With MaximumError no point of either surface
        is farther than that from the other, which is proved. The report is in the field data: BoneDecimateReport as JSON, its main figures as bonedecimate.*.
      </Documentation>
      <InputProperty name="Input" command="SetInputConnection" port_index="0">
        <ProxyGroupDomain name="groups"><Group name="sources"/><Group name="filters"/></ProxyGroupDomain>
        <DataTypeDomain name="input_type"><DataType value="vtkPolyData"/></DataTypeDomain>
        <InputArrayDomain name="point_arrays" attribute_type="point" number_of_components="1" optional="1"/>
        <Documentation>The surface, in mm.</Documentation>
      </InputProperty>
      <InputProperty name="Reference" command="SetInputConnection" port_index="1" null_on_empty="1">
        <ProxyGroupDomain name="groups"><Group name="sources"/><Group name="filters"/></ProxyGroupDomain>
        <DataTypeDomain name="input_type"><DataType value="vtkPolyData"/></DataTypeDomain>
        <Documentation>The original surface, if the input is itself a result: MaximumError is proved against it.</Documentation>
        <Hints><Optional/></Hints>
      </InputProperty>
"""
TAIL = """      <OutputPort name="Result" index="0" id="port0"/>
      <OutputPort name="Input with distances" index="1" id="port1"/>
      <Hints>
        <ShowInMenu category="Bone"/>
        <Visibility replace_input="1"/>
      </Hints>
    </SourceProxy>
  </ProxyGroup>
</ServerManagerConfiguration>
"""


def read_table():
    """Rows (name, values, default, unit, meaning) of the page."""
    rows = []
    for line in TABLE.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("| `") and len(cells) == 6:
            rows.append((cells[0].strip("`"), *cells[2:]))
    return rows


def label(name):
    """In words. Without the unit: in ParaView's Python a property is called by its label without the blanks."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


def text_of(meaning, unit):
    return (f"In {unit}. " if unit == "mm" else "") + meaning


def range_attributes(values):
    least, most = re.fullmatch(r"(\S+) to (\S+)", values).groups()
    # A panel shows a slider between two ends, which is of no use for 1e30 mm: the filter rejects what is beyond.
    return f'min="{least}"' + ("" if most == "1e30" else f' max="{most}"')


def kind_of(name, values, default):
    """Element, default and domain of a property."""
    if values == "on, off":
        return "IntVectorProperty", str(int(default == "on")), '<BooleanDomain name="bool"/>'
    if values == "text":
        return text_kind(name, default)
    if not values[0].isdigit():
        choices = values.split(", ")
        entries = "".join(f'<Entry value="{i}" text="{choice}"/>' for i, choice in enumerate(choices))
        return "IntVectorProperty", str(choices.index(default)), f'<EnumerationDomain name="enum">{entries}</EnumerationDomain>'
    whole = re.fullmatch(r"0 to \d{4,}", values)
    kind = "Int" if whole else "Double"
    return f"{kind}VectorProperty", default, f'<{kind}RangeDomain name="range" {range_attributes(values)}/>'


def text_kind(name, default):
    if name in ARRAYS_OF_POINTS:
        domain = ('<ArrayListDomain name="array_list" attribute_type="Scalars" input_domain_name="point_arrays" none_string="">\n'
                  '          <RequiredProperties><Property name="Input" function="Input"/></RequiredProperties>\n'
                  '        </ArrayListDomain>')
        return "StringVectorProperty", default, domain
    # Arrays of distances say their unit wherever ParaView shows their name: in the legend above all.
    in_mm = name.endswith("ArrayName") and name not in ("PointCountArrayName", "LabelArrayName")
    return "StringVectorProperty", default + (" (mm)" if in_mm else ""), ""


def condition(prop, value, inverted):
    return (f'<PropertyWidgetDecorator type="GenericDecorator" mode="enabled_state" property="{prop}" value="{value}"'
            + (' inverse="1"' if inverted else "") + "/>")


def hints(name):
    lines = []
    for any_of in APPLIES.get(name, []):
        if len(any_of) == 1:
            lines.append(condition(*any_of[0]))
        else:
            parts = "".join(condition(*one) for one in any_of)
            lines.append(f'<PropertyWidgetDecorator type="CompositeDecorator"><Expression type="or">{parts}</Expression>'
                         "</PropertyWidgetDecorator>")
    return ["        <Hints>", *("          " + line for line in lines), "        </Hints>"] if lines else []


def write_property(row):
    name, values, default, unit, meaning = row
    element, start, domain = kind_of(name, values, default)
    advanced = name in ADVANCED or name.endswith("ArrayName") and name not in (*GROUPS[0][1], *ARRAYS_OF_POINTS) or name == "NormalTolerance"
    lines = [f'      <{element} name="{name}" label="{label(name)}"',
             f'        command="{COMMANDS.get(name, "Set" + name)}" number_of_elements="1" default_values={quoteattr(start)}',
             f'        panel_visibility="{"advanced" if advanced else "default"}">']
    lines += ["        " + domain] if domain else []
    lines += [f"        <Documentation>{escape(text_of(meaning, unit))}</Documentation>", *hints(name), f"      </{element}>"]
    return "\n".join(lines) + "\n"


def write_group(title, names):
    members = "".join(f'        <Property name="{name}"/>\n' for name in names)
    return f'      <PropertyGroup label="{title}">\n{members}      </PropertyGroup>\n'


def write_panel():
    properties = "".join(write_property(row) for row in read_table())
    return HEAD + properties + "".join(write_group(*group) for group in GROUPS) + TAIL


def main(arguments):
    text = write_panel()
    if arguments != ["--check"]:
        PANEL.write_text(text, encoding="utf-8")
        return 0
    if PANEL.read_text(encoding="utf-8") != text:
        print(f"{PANEL.relative_to(ROOT)} is not what {TABLE.relative_to(ROOT)} says: run Applications/ParaView/{pathlib.Path(__file__).name}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
