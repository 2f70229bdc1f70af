# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Adds one violation of each rule to a copy of the tree's skeleton: each must be found, and nothing else."""
import tempfile
from pathlib import Path

import modules

PAGE = Path(__file__).resolve().parents[2] / "ARCHITECTURE.md"

# file, line to add, and what the finding must say; None: this include is allowed
CASES = [
    ("Filters/Core/Geometry/A.h", "#include <vtkPolyData.h>", "may not include VTK"),
    ("Filters/Core/Mesh/A.h", "#include <iostream>", "may not include streams"),
    ("Filters/Core/Mesh/A.cxx", "#  include <fstream>", "may not include streams"),
    ("Filters/Core/Run/Decimate.cxx", "#include <unistd.h>", "may not include system"),
    ("Filters/Core/Geometry/A.cxx", '#include "Mesh/HalfEdgeMesh.h"', "may not include Filters/Core/Mesh"),
    ("Filters/Core/Geometry/B.cxx", '#include "Run/Report/Report.h"', "may not include Filters/Core/Run/Report"),
    ("Filters/Core/Mesh/B.cxx", '#include "Decimate/Cost/Cost.h"', "may not include Filters/Core/Decimate/Cost"),
    ("Filters/Core/Decimate/Edit/A.cxx", '#include "Proof/Measure/Measure.h"', "may not include Filters/Core/Proof/Measure"),
    ("Filters/Core/Decimate/Edit/B.cxx", '#include "Run/Decimate.h"', "may not include Filters/Core/Run"),
    ("Filters/BoneDecimate/A.cxx", '#include "Mesh/HalfEdgeMesh.h"', "may not include Filters/Core/Mesh"),
    ("Filters/BoneDecimate/B.cxx", "#include <CGAL/AABB_tree.h>", "may not include CGAL"),
    ("Filters/BoneDecimateParallel/A.cxx", '#include "Run/Decimate.h"', "may not include Filters/Core/Run"),
    ("Applications/CommandLine/A.cxx", '#include "Decimate/Edit/Editor.h"', "may not include Filters/Core/Decimate/Edit"),
    ("Applications/Volume/A.cxx", '#include "Run/Decimate.h"', "may not include Filters/Core/Run"),
    ("Applications/Picture/A.cxx", "#include <CGAL/Origin.h>", "may not include CGAL"),
    ("Other/A.cxx", "#include <vector>", None),
    ("Applications/Unlisted/A.cxx", "#include <vector>", "no module of ARCHITECTURE.md"),
    ("Filters/Core/Unlisted/A.cxx", "#include <vector>", "no module of ARCHITECTURE.md"),
    ("Applications/CommandLine/Folder/A.cxx", '#include "Mesh/HalfEdgeMesh.h"', "may not include Filters/Core/Mesh"),
    ("Applications/CommandLine/Folder/B.cxx", '#include "Run/Decimate.h"', None),
    ("Filters/Core/Mesh/C.cxx", '#include "Run/Report/Report.h"', "may not include Filters/Core/Run/Report"),
    ("Filters/Core/Decimate/Edit/C.cxx", '#include "Mesh/HalfEdgeMesh.h"', None),
    ("Filters/Core/Geometry/C.cxx", "#include <Eigen/Core>", None),
    ("Applications/CommandLine/C.cxx", '#include "Run/Decimate.h"', None),
    ("Applications/CommandLine/D.cxx", "#include <CLI/CLI.hpp>", None),
    ("Filters/BoneDecimate/C.cxx", "#include <vtkPolyData.h>", None),
    ("Filters/Core/Geometry/D.h", "std::uint64_t Count();", "std::uint64_t without <cstdint>"),
    ("Filters/Core/Geometry/E.h", "#include <cstdint>\nstd::int64_t Count();", None),
    ("Testing/Unit/A.cxx", '#include "Decimate/Edit/Editor.h"', None),
]
SKELETON = ["Filters/Core/Run/Decimate.h", "Filters/Core/Run/Report/Report.h", "Filters/Core/Mesh/HalfEdgeMesh.h",
         "Filters/Core/Decimate/Cost/Cost.h", "Filters/Core/Proof/Measure/Measure.h", "Filters/Core/Decimate/Edit/Editor.h"]


def found_with(file, line):
    """What the check finds in a tree with the skeleton and one added line, on line 2."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        page = PAGE.read_text(encoding="utf-8")
        (root / "ARCHITECTURE.md").write_text(page, encoding="utf-8")
        for module in modules.read_modules(page)[0]:
            (root / module).mkdir(parents=True, exist_ok=True)
        for name in SKELETON:
            (root / name).touch()
        (root / file).parent.mkdir(parents=True, exist_ok=True)
        (root / file).write_text(f"// added\n{line}\n", encoding="utf-8")
        return modules.check_tree(root)


def complaint(file, line, expected):
    """Why an added line has another result than expected, or None."""
    found = found_with(file, line)
    if expected is None:
        return None if not found else f"{file}: {line} is allowed, but: {found}"
    is_found = len(found) == 1 and expected in found[0] and found[0].startswith(f"{file}:")
    if is_found and "no module" not in expected:
        is_found = found[0].startswith(f"{file}:2:")
    return None if is_found else f"{file}: {line} should give '{expected}', but: {found}"


def run():
    complaints = [text for text in (complaint(*case) for case in CASES) if text]
    if not modules.read_modules("## Modules\n| `Filters/Core/A/` | job | moon |\n")[1]:
        complaints.append("an unknown word in the table was not found")
    circle = "## Modules\n| `Filters/Core/A/` | job | B |\n| `Filters/Core/B/` | job | A |\n"
    if "Filters/Core/B is not above it" not in "".join(modules.read_modules(circle)[1]):
        complaints.append("a cycle in the table was not found")
    for text in complaints:
        print(text)
    print(f"{len(CASES) + 2} cases, {len(complaints)} with a wrong result")
    return 1 if complaints else 0
