#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the classes that declare the options of the filters, from the table in Documentation/options.md.

That page is the core's table of options word for word (a test compares it with the program), so names, ranges, units, defaults
and descriptions are written nowhere else. Each class adds options to its superclass:

    vtkBoneRunOptions       the options of every filter that runs a decimation
    vtkBoneGoalOptions      where a run ends, and what is measured and proved: vtkBoneDecimate and vtkBoneDecimateLevels
    vtkBoneOutputOptions    all others: vtkBoneDecimate
    vtkBoneSmoothOptions    those of vtkBoneSmooth

    write_options.py            write them
    write_options.py --check    fail if they are not what would be written
"""

import pathlib
import re
import sys
import textwrap

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
TABLE = ROOT / "Documentation" / "options.md"

# Class: superclass, brief, options; None: the options that no other class has.
CLASSES = {
    "vtkBoneRunOptions": (
        "vtkBoneDecimateAlgorithm", "options of every filter that runs a decimation",
        ["Mode", "TargetNumberOfTriangles", "Smoothing", "AutomaticSmoothing", "FeatureAngle", "KeepVoxels", "ToleranceArrayName",
         "LabelArrayName", "AllowLargeError", "IntersectionGuard", "RefinementEffort", "MinimumAngle", "EdgeLength", "EdgeLengthArrayName",
         "ChordalError", "MergePoints", "NumberOfThreads"]),
    "vtkBoneGoalOptions": (
        "vtkBoneRunOptions", "options of where a run ends, and of what is measured and proved",
        ["TargetReduction", "MaximumError", "ErrorPreset", "VoxelSize", "NormalTolerance", "AutomaticNormalTolerance",
         "MeasureDistances", "ProveResult"]),
    "vtkBoneOutputOptions": (
        "vtkBoneGoalOptions", "options of the arrays, of the output and of what is left out of the input", None),
    "vtkBoneSmoothOptions": (
        "vtkBoneDecimateAlgorithm", "options of a run that smooths and removes no triangles",
        ["Smoothing", "FeatureAngle", "MaximumError", "ToleranceArrayName", "LabelArrayName", "MergePoints", "MeasureDistances",
         "ProveResult", "PassArrays", "OutputPointsPrecision", "RecomputeNormals", "AllowLargeError", "NumberOfThreads"]),
}
# Classes beside those of vtkBoneDecimate: their options are options of others, too.
BESIDE = {"vtkBoneSmoothOptions"}
# Enumerations of choices; the values of OutputPointsPrecision are those of vtkAlgorithm.
ENUMERATIONS = {"Mode": "Modes", "ErrorPreset": "ErrorPresets", "KeepVoxels": "KeepVoxelsChoices"}
TYPES = {"bool": ("bool", "bool"), "int": ("int", "int"), "double": ("double", "double"),
         "text": ("const std::string&", "std::string")}

LICENSE = """// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
"""
HEADER = LICENSE + """/**
 * @class   {name}
 * @brief   {brief}
 *
 * Written by write_options.py from Documentation/options.md. A value outside its range is an error event, and so are NaN and
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
SOURCE = LICENSE + """// Written by write_options.py from Documentation/options.md.
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


def read_table():
    """Rows {name: (values, default, unit, meaning)} of the page, in its order."""
    rows = {}
    for line in TABLE.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("| `") and len(cells) == 6:
            rows[cells[0].strip("`")] = tuple(cells[2:])
    return rows


def kind_of(values, default):
    if values == "on, off":
        return "bool"
    if values == "text":
        return "text"
    whole = not values[0].isdigit() or re.fullmatch(r"0 to \d{4,}", values)
    return "int" if whole and "." not in default else "double"


def constant(option, choice):
    """HALF_VOXEL; NO_PRESET for None, which is a word of Python; KEEP_VOXELS_ON, because ON alone says too little."""
    words = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", choice).upper()
    if option == "KeepVoxels":
        return "KEEP_VOXELS_" + words
    return "NO_" + re.findall("[A-Z][a-z]+", option)[-1].upper() if words == "NONE" else words


def described(name, values, default, unit, meaning):
    """The meaning, then range, unit and default."""
    of_unit = f" {unit}" if unit else ""
    if values == "on, off":
        return f"{meaning} Default: {default}."
    if values == "text":
        return meaning + (f' Default: "{default}".' if default else " Default: none.")
    if name in ENUMERATIONS:
        return f"{meaning} One of {ENUMERATIONS[name]}; default: {constant(name, default)}."
    if not values[0].isdigit():
        return f"{meaning} One of vtkAlgorithm::DesiredOutputPrecision; default: {default.upper()}_PRECISION."
    return f"{meaning} Range: {values}{of_unit}; default: {default}."


def enumeration(name, values):
    lines = [f"    {constant(name, choice)} = {i}" for i, choice in enumerate(values.split(", "))]
    return f"\n  /// Values of {name}.\n  enum {ENUMERATIONS[name]}\n  {{\n" + ",\n".join(lines) + "\n  };\n"


def member(name, row):
    values, default = row[0], row[1]
    argument, result = TYPES[kind_of(values, default)]
    text = enumeration(name, values) if name in ENUMERATIONS else ""
    text += "\n  ///@{\n"
    text += textwrap.indent(textwrap.fill(described(name, *row), 126, break_on_hyphens=False), "  /// ") + "\n"
    text += f"  void Set{name}({argument} value);\n  {result} Get{name}() const;\n"
    if name == "Mode":
        for choice in values.split(", "):
            text += f"  void Set{name}To{choice}() {{ this->Set{name}({constant(name, choice)}); }}\n"
    if argument == "bool":
        text += f"  vtkBooleanMacro({name}, bool);\n"
    return text + "  ///@}\n"


def functions(class_name, name, row):
    argument, result = TYPES[kind_of(row[0], row[1])]
    value = f"this->State->Options.{name}"
    if not row[0][0].isdigit() and result == "int":
        value = f"static_cast<int>({value})"
    return (f"\nvoid {class_name}::Set{name}({argument} value)\n{{\n  this->State->Set(this, \"{name}\", value);\n}}\n"
            f"\n{result} {class_name}::Get{name}() const\n{{\n  return {value};\n}}\n")


def write_classes():
    """{file name: text}"""
    rows = read_table()
    taken = {name for key, (_, _, names) in CLASSES.items() if key not in BESIDE for name in names or ()}
    texts = {}
    for class_name, (superclass, brief, names) in CLASSES.items():
        names = names or [name for name in rows if name not in taken]
        values = {"name": class_name, "superclass": superclass, "brief": brief}
        members = "".join(member(name, rows[name]) for name in names)
        texts[class_name + ".h"] = HEADER.format(members=members, **values)
        bodies = "".join(functions(class_name, name, rows[name]) for name in names)
        quoted = "".join(f'  "{name}",\n' for name in names)
        group = class_name[len("vtkBone"):-len("Options")]
        texts[class_name + ".cxx"] = SOURCE.format(functions=bodies, names=quoted, group=group, **values)
    return texts


def main(arguments):
    different = 0
    for file, text in write_classes().items():
        path = FOLDER / file
        if arguments != ["--check"]:
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            print(f"{path.relative_to(ROOT)} is not what {TABLE.relative_to(ROOT)} says: run {FOLDER.name}/{pathlib.Path(__file__).name}")
            different = 1
    return different


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
