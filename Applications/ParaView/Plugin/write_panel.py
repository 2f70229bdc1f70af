#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the panel of ParaView for vtkBoneDecimate, from the table of options (Filters/OptionTable).

    write_panel.py TABLE.json PANEL.xml
"""

import json
import pathlib
import re
import sys
from xml.sax.saxutils import escape, quoteattr

# The first view, in this order. All others are advanced, by the groups of the table in this order.
FIRST = ("Mode", "MaximumError", "TargetReduction", "AutomaticSmoothing", "LabelArrayName", "KeepVoxels", "ToleranceArrayName", "NumberOfThreads")
GROUPS = {"Targets": "Targets", "Smoothing": "Smoothing", "Proof": "Proof", "Shape": "Triangle shapes", "Input": "Repair and pruning",
          "Output": "Output", "Names": "Names of arrays", "Thesis": "Mode Thesis"}
# As XML writes them; those of counts are in their names.
UNITS = {"mm": "mm", "mm2": "mm&#178;", "mm3": "mm&#179;", "degrees": "&#176;"}
# A panel sets every property, those at their default, too: see vtkPVBoneDecimate. The words are beside the number.
COMMANDS = {"TargetReduction": "SetTargetReductionUnlessDefault"}
WORDS = {"TargetReduction": "0.9: unset"}

HEAD = """<!-- Generated from the table of options. -->
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
        <InputArrayDomain name="arrays" attribute_type="any" number_of_components="1" optional="1"/>
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


def label(name):
    """In words. Without the unit, which is a label beside the number: in ParaView's Python a property is called by its label."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


def text_of(row):
    return (f"In {row['unit']}. " if row["unit"] == "mm" else "") + row["sentence"]


def words_beside(row):
    """What is shown beside the number: its unit, or when it counts."""
    return UNITS.get(row["unit"], "") or WORDS.get(row["name"], "")


def range_attributes(row):
    # A panel shows a slider without the words between two ends: the filter rejects what is beyond the other one.
    maximum = "" if row["unit"] or words_beside(row) else f' max="{row["maximum"]:.10g}"'
    return f'min="{row["minimum"]:.10g}"' + maximum


def kind_of(row):
    """Element, default and domain of a property."""
    kind, default = row["kind"], row["default"]
    if kind == "bool":
        return "IntVectorProperty", str(int(default == "on")), '<BooleanDomain name="bool"/>'
    if kind == "text":
        return text_kind(row)
    if kind == "choice":
        entries = "".join(f'<Entry value="{i}" text="{choice}"/>' for i, choice in enumerate(row["choices"]))
        return ("IntVectorProperty", str(row["choices"].index(default)),
                f'<EnumerationDomain name="enum">{entries}</EnumerationDomain>')
    kind = kind.capitalize()
    return f"{kind}VectorProperty", default, f'<{kind}RangeDomain name="range" {range_attributes(row)}/>'


def text_kind(row):
    if row["names_point_array"] or row["name"] == "LabelArrayName":
        arrays = "point_arrays" if row["names_point_array"] else "arrays"
        domain = (f'<ArrayListDomain name="array_list" attribute_type="Scalars" input_domain_name="{arrays}" none_string="">\n'
                  '          <RequiredProperties><Property name="Input" function="Input"/></RequiredProperties>\n'
                  '        </ArrayListDomain>')
        return "StringVectorProperty", row["default"], domain
    # Arrays of distances say their unit wherever ParaView shows their name: in the legend above all.
    is_length = row["default"] and row["name"] != "PointCountArrayName"
    return "StringVectorProperty", row["default"] + (" (mm)" if is_length else ""), ""


def condition(name, value, has_value):
    return (f'<PropertyWidgetDecorator type="GenericDecorator" mode="enabled_state" property="{name}" value="{value}"'
            + ("" if has_value else ' inverse="1"') + "/>")


def hints(row):
    """The words beside the number, and enabled where one term of each list holds."""
    words = words_beside(row)
    lines = [f'<ShowComponentLabels><ComponentLabel component="0" label="{words}"/></ShowComponentLabels>'] if words else []
    for terms in row["conditions"]:
        parts = [condition(*term) for term in terms]
        lines.append(parts[0] if len(parts) == 1 else '<PropertyWidgetDecorator type="CompositeDecorator"><Expression type="or">'
                     + "".join(parts) + "</Expression></PropertyWidgetDecorator>")
    return ["        <Hints>", *("          " + line for line in lines), "        </Hints>"] if lines else []


def write_property(row):
    name = row["name"]
    element, start, domain = kind_of(row)
    lines = [f'      <{element} name="{name}" label="{label(name)}"',
             f'        command="{COMMANDS.get(name, "Set" + name)}" number_of_elements="1" default_values={quoteattr(start)}',
             f'        panel_visibility="{"default" if name in FIRST else "advanced"}">']
    lines += ["        " + domain] if domain else []
    lines += [f"        <Documentation>{escape(text_of(row))}</Documentation>", *hints(row), f"      </{element}>"]
    return "\n".join(lines) + "\n"


def write_group(title, rows):
    members = "".join(f'        <Property name="{row["name"]}"/>\n' for row in rows)
    return f'      <PropertyGroup label="{title}">\n{members}      </PropertyGroup>\n'


def write_panel(rows):
    first = [row for name in FIRST for row in rows if row["name"] == name]
    grouped = [(title, [row for row in rows if row["group"] == group and row not in first]) for group, title in GROUPS.items()]
    ordered = first + [row for _, members in grouped for row in members]
    return HEAD + "".join(map(write_property, ordered)) + "".join(write_group(*group) for group in grouped) + TAIL


def main(table, panel):
    rows = json.loads(pathlib.Path(table).read_text(encoding="utf-8"))["options"]
    pathlib.Path(panel).write_text(write_panel(rows), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
