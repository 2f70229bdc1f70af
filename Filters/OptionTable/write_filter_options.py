#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the classes that declare the options of the filters, from the table of options (bonedecimate-option-table).

    vtkBoneRunOptions       what the search for errors has: the options of every filter that runs a decimation
    vtkBoneGoalOptions      what levels have beside: vtkBoneDecimate and vtkBoneDecimateLevels
    vtkBoneOutputOptions    all others: vtkBoneDecimate
    vtkBoneSmoothOptions    those of vtkBoneSmooth

Which options a filter has follows from the kinds of run of the table.

    write_filter_options.py TABLE.json FOLDER
"""

import json
import pathlib
import re
import sys
import textwrap

# Class: superclass, brief, kind of run that has its options. Each class adds options to its superclass.
CLASSES = {
    "vtkBoneRunOptions": ("vtkBoneDecimateAlgorithm", "options of every filter that runs a decimation", "ErrorSearch"),
    "vtkBoneGoalOptions": ("vtkBoneRunOptions", "options of where a run ends, and of what is measured and proved", "LevelsFilter"),
    "vtkBoneOutputOptions": (
        "vtkBoneGoalOptions", "options of the arrays, of the output and of what is left out of the input", "Whole"),
    "vtkBoneSmoothOptions": ("vtkBoneDecimateAlgorithm", "options of a run that smooths and removes no triangles", "SmoothFilter"),
}
TYPES = {"bool": ("bool", "bool"), "int": ("int", "int"), "choice": ("int", "int"), "double": ("double", "double"),
         "text": ("const std::string&", "std::string")}
# Names of enumerations; others are called by their option. The values of OutputPointsPrecision are those of vtkAlgorithm.
ENUMERATIONS = {"Mode": "Modes", "ErrorPreset": "ErrorPresets", "KeepVoxels": "KeepVoxelsChoices", "OutputPointsPrecision": None}

LICENSE = """// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
"""
HEADER = LICENSE + """/**
 * @class   {name}
 * @brief   {brief}
 *
 * Generated from the table of options. A value outside its range is an error event, and so are NaN and
 * infinity: the option keeps its value, and updates fail until it is set to a valid one.
 *
 * @sa vtkBoneDecimate
 */
#ifndef {name}_h
#define {name}_h

#include "{superclass}.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <string> // for texts

class VTKFILTERSBONEDECIMATE_EXPORT {name} : public {superclass}
{{
public:
  vtkAbstractTypeMacro({name}, {superclass});
  void PrintSelf(ostream& os, vtkIndent indent) override;
  bool HasOption(const std::string& name) const override;
{members}
protected:
  {name}();
  ~{name}() override;

private:
  {name}(const {name}&) = delete;
  void operator=(const {name}&) = delete;
}};

#endif
"""
SOURCE = LICENSE + """// Generated from the table of options.
#include "{name}.h"

#include "RunState.h"

#include <algorithm>
#include <iterator>

namespace
{{
// clang-format off
const char* const {group}Names[] = {{
{names}}};
// clang-format on
}}

{name}::{name}() = default;

{name}::~{name}() = default;
{functions}
//------------------------------------------------------------------------------
void {name}::PrintSelf(ostream& os, vtkIndent indent)
{{
  this->Superclass::PrintSelf(os, indent);
  for (const char* name : {group}Names)
  {{
    this->State->PrintOption(os, indent, name);
  }}
}}

bool {name}::HasOption(const std::string& name) const
{{
  return std::find(std::begin({group}Names), std::end({group}Names), name) != std::end({group}Names) ||
    this->Superclass::HasOption(name);
}}
"""


def constant(option, choice):
    """HALF_VOXEL; NO_PRESET for None, which is a word of Python; KEEP_VOXELS_ON, because ON alone says too little."""
    words = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", choice).upper()
    if option == "KeepVoxels":
        return "KEEP_VOXELS_" + words
    return "NO_" + re.findall("[A-Z][a-z]+", option)[-1].upper() if words == "NONE" else words


def enumeration_of(row):
    """The name of the enumeration of a choice; None if it has none of its own."""
    return ENUMERATIONS.get(row["name"], row["name"] + "Choices") if row["kind"] == "choice" else None


def number(value):
    """As in a sentence: 1e30 for 1e+30."""
    return f"{value:.10g}".replace("e+", "e")


def described(row):
    """The meaning, then range, unit and default."""
    meaning, default, kind = row["sentence"], row["default"], row["kind"]
    if kind == "bool":
        return f"{meaning} Default: {default}."
    if kind == "text":
        return meaning + (f' Default: "{default}".' if default else " Default: none.")
    if enumeration_of(row):
        return f"{meaning} One of {enumeration_of(row)}; default: {constant(row['name'], default)}."
    if kind == "choice":
        return f"{meaning} One of vtkAlgorithm::DesiredOutputPrecision; default: {default.upper()}_PRECISION."
    unit = f" {row['unit']}" if row["unit"] else ""
    return f"{meaning} Range: {number(row['minimum'])} to {number(row['maximum'])}{unit}; default: {default}."


def enumeration(row):
    lines = [f"    {constant(row['name'], choice)} = {i}" for i, choice in enumerate(row["choices"])]
    return f"\n  /// Values of {row['name']}.\n  enum {enumeration_of(row)}\n  {{\n" + ",\n".join(lines) + "\n  };\n"


def member(row):
    name = row["name"]
    argument, result = TYPES[row["kind"]]
    text = enumeration(row) if enumeration_of(row) else ""
    text += "\n  ///@{\n"
    text += textwrap.indent(textwrap.fill(described(row), 94, break_on_hyphens=False), "  /// ") + "\n"
    text += f"  void Set{name}({argument} value);\n  {result} Get{name}() const;\n"
    if name == "Mode":
        for choice in row["choices"]:
            text += f"  void Set{name}To{choice}() {{ this->Set{name}({constant(name, choice)}); }}\n"
    if argument == "bool":
        text += f"  vtkBooleanMacro({name}, bool);\n"
    return text + "  ///@}\n"


def functions(class_name, row):
    name = row["name"]
    argument, result = TYPES[row["kind"]]
    value = f"this->State->Options.{name}"
    if row["kind"] == "choice":
        value = f"static_cast<int>({value})"
    return (f"\nvoid {class_name}::Set{name}({argument} value)\n{{\n  this->State->Set(this, \"{name}\", value);\n}}\n"
            f"\n{result} {class_name}::Get{name}() const\n{{\n  return {value};\n}}\n")


def rows_of_classes(rows):
    """{class: rows that it adds to its superclass}"""
    added, inherited = {}, {"vtkBoneDecimateAlgorithm": []}
    for class_name, (superclass, _, kind) in CLASSES.items():
        added[class_name] = [row for row in rows if kind not in row["unsupported"] and row not in inherited[superclass]]
        inherited[class_name] = inherited[superclass] + added[class_name]
    return added


def write_classes(rows, folder):
    for class_name, own in rows_of_classes(rows).items():
        superclass, brief, _ = CLASSES[class_name]
        values = {"name": class_name, "superclass": superclass, "brief": brief}
        header = HEADER.format(members="".join(map(member, own)), **values)
        bodies = "".join(functions(class_name, row) for row in own)
        names = "".join(f'  "{row["name"]}",\n' for row in own)
        group = class_name[len("vtkBone"):-len("Options")]
        source = SOURCE.format(functions=bodies, names=names, group=group, **values)
        (folder / f"{class_name}.h").write_text(header, encoding="utf-8")
        (folder / f"{class_name}.cxx").write_text(source, encoding="utf-8")


def main(table, folder):
    rows = json.loads(pathlib.Path(table).read_text(encoding="utf-8"))["options"]
    write_classes(rows, pathlib.Path(folder))


if __name__ == "__main__":
    main(*sys.argv[1:])
