# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel's filter against the C++ filter: same members, same defaults, same bytes."""

import json
import os
import unittest

from vtkmodules.vtkCommonCore import vtkVersion

import specimens
from bonedecimate import vtkBoneDecimate

with open(os.environ["REFERENCE"], encoding="utf-8") as _file:
    REFERENCE = json.load(_file)
SAME_VTK = REFERENCE["vtk"] == vtkVersion.GetVTKVersion()
# Of VTK's own machinery around every C++ class.
MACHINERY = {"AddInputData", "GetClassName", "GetInputData", "IsA", "IsTypeOf", "NewInstance", "SafeDownCast",
             "GetNumberOfGenerationsFromBase", "GetNumberOfGenerationsFromBaseType", "ErrorCodes", "ErrorPresets", "InputArrays", "KeepVoxelsChoices", "Modes", "ProofStatuses", "StopReasons"}


class Sameness(unittest.TestCase):
    maxDiff = 2000

    def test_members_are_those_of_the_cxx_class(self):
        for name in set(REFERENCE["members"]) - MACHINERY:
            self.assertTrue(hasattr(vtkBoneDecimate, name), name)

    def test_constants_are_those_of_the_cxx_class(self):
        for name, value in REFERENCE["constants"].items():
            self.assertEqual(getattr(vtkBoneDecimate, name), value, name)

    def test_defaults_are_those_of_the_cxx_class(self):
        decimate = vtkBoneDecimate()
        for name, value in REFERENCE["defaults"].items():
            self.assertEqual(getattr(decimate, "Get" + name)(), value, name)

    def test_outputs_report_and_words_are_the_same(self):
        compared = 0
        for name, case in specimens.cases().items():
            if name in specimens.DEPENDS_ON_VTK and not SAME_VTK:
                continue
            with self.subTest(name):
                found, wanted = specimens.run(vtkBoneDecimate, *case), REFERENCE["runs"][name]
                for part in wanted:
                    self.assertEqual(json.loads(json.dumps(found[part])), wanted[part], part)
                compared += 1
        print(f"VTK {vtkVersion.GetVTKVersion()}: {compared} runs as those of the C++ filter with VTK {REFERENCE['vtk']}")


if __name__ == "__main__":
    unittest.main()
