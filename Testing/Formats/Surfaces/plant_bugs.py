#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plants bugs in a copy of the readers and tells whether the comparison finds them.

    plant_bugs.py FOLDER [CMAKE_ARGUMENT...]    FOLDER gets the copy and its build

All bugs are compiled in at once; the environment variable PLANTED chooses one. Ends with 1 if one is not found, or if there is a
difference without one.
"""

import os
import pathlib
import subprocess
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
SOURCE = FOLDER.parents[2]
FORMATS = "Applications/CommandLine/Formats/"
HEADER = """#pragma once
#include <cstdlib>
inline bool IsPlanted(int number)
{
  static const char* const chosen = std::getenv("PLANTED");
  static const int planted = chosen != nullptr ? std::atoi(chosen) : 0;
  return planted == number;
}
"""
# What breaks, format that shows it, source, a piece of it and what replaces it, where BUG is whether this one is planted.
BUGS = [
    ("indices from 0", "obj", "ReadObj.cxx", ": index - 1;", ": BUG ? index % count : index - 1;"),
    ("negative indices", "obj", "ReadObj.cxx", "? count + index :", "? (BUG ? (count + index) / 2 : count + index) :"),
    ("lines that go on", "obj", "LineReader.cxx", "whole += hasNext ?", "whole += hasNext && !BUG ?"),
    ("range of colors", "obj", "ObjCells.cxx", "> 1.0F ? 1.0F", "> 1.0F || BUG ? 1.0F"),
    ("big-endian bytes", "ply", "PlyElementReader.cxx", "IsBigEndian ?", "IsBigEndian && !BUG ?"),
    ("signed bytes", "ply", "PlyElementReader.cxx", "static_cast<std::int8_t>(bits)", "static_cast<std::int8_t>(BUG ? bits & 127 : bits)"),
    ("alpha", "ply", "PlyArrays.cxx", 'emplace_back("alpha")', 'emplace_back(BUG ? "alfa" : "alpha")'),
    ("axes", "stl", "FileFrame.cxx", 'name == "LPS";', '(name == "LPS" && !BUG);'),
    ("red and blue", "stl_binary", "StlColors.cxx", "? Color{ channel(0)", "!= BUG ? Color{ channel(0)"),
    ("second arrays", "vtk", "VtkFormat.cxx", "reader->ReadAllScalarsOn();", "reader->SetReadAllScalars(!BUG);"),
    ("digits of text", "vtp", "CheckVtp.cxx", "points.Add(*number);", "points.Add(BUG ? static_cast<float>(*number) : *number);"),
    ("unit", "3mf", "ThreeMfModel.cxx", '"inch", 25.4', '"inch", BUG ? 25.0 : 25.4'),
    ("order of transforms", "3mf", "ReadThreeMf.cxx", "insert(transforms.begin(),", "insert(BUG ? transforms.end() : transforms.begin(),"),
    ("mirrors", "3mf", "ReadThreeMf.cxx", "mirrors % 2 == 1", "!BUG && mirrors % 2 == 1"),
    ("objects not to be printed", "3mf", "ThreeMfModel.cxx", 'printable != "0"', '(BUG || printable != "0")'),
    ("parity of strips", "glb", "ReadGlb.cxx", "mode == strip ? i % 2", "mode == strip && !BUG ? i % 2"),
    ("stride", "glb", "GltfDocument.cxx", "stride = stride == 0 ?", "stride = BUG || stride == 0 ?"),
    ("sparse values", "glb", "GltfDocument.cxx", 'if (accessor.contains("sparse"))', 'if (!BUG && accessor.contains("sparse"))'),
    ("parents of nodes", "glb", "GltfScene.cxx", "around.After(TransformOf(node))", "BUG ? TransformOf(node).After(around) : around.After(TransformOf(node))"),
    ("normalized numbers", "glb", "GltfDocument.cxx", "number / row.Most", "number / (BUG ? 256.0 : row.Most)"),
]


def plant(copy):
    (copy / FORMATS / "Planted.h").write_text(HEADER, encoding="utf-8")
    for number, (_, _, file, old, new) in enumerate(BUGS, 1):
        path = copy / FORMATS / file
        text = path.read_text(encoding="utf-8")
        if text.count(old) != 1:
            sys.exit(f"{file} has '{old}' {text.count(old)} times, not once")
        head = '#include "Planted.h"\n'
        path.write_text(head + text.replace(head, "").replace(old, new.replace("BUG", f"IsPlanted({number})")), encoding="utf-8")


def main(folder, *cmake):
    copy = folder / "copy"
    subprocess.run(["git", "clone", "--quiet", "--shared", SOURCE, copy], check=True)
    plant(copy)
    subprocess.run(["cmake", "--preset", "release", *cmake], cwd=copy, stdout=subprocess.DEVNULL, check=True)
    targets = ["--target", "bonedecimate-read-surfaces"]
    subprocess.run(["cmake", "--build", "build/release", *targets], cwd=copy, stdout=subprocess.DEVNULL, check=True)
    command = [sys.executable, "-B", FOLDER.parent / "compare_surfaces.py", "--own", "--by-program", "0", "--variants", "0"]
    command += ["--program", copy / "build/release/bin/bonedecimate"]
    missed = 0
    for number, (name, extension, file, *_) in enumerate([("none", "obj", "-"), *BUGS]):
        done = subprocess.run(
            [*command, "--format", extension], env={**os.environ, "PLANTED": str(number)}, stdout=subprocess.PIPE, encoding="utf-8", check=False
        )
        faults = done.stdout.splitlines()[-1].split("|")[4].strip() if done.returncode < 2 else "?"
        is_right = (done.returncode != 0) == (number > 0)
        missed += not is_right
        print(f"| {number} | {name} | {extension} | {file} | {faults} | {'found' if done.returncode else 'not found'} |", flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), *sys.argv[2:]))
