# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every property of the filter, from Python."""

import unittest

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from surfaces import TRIANGLES, decimating, torus
from vtkbonedecimate import vtkBoneDecimate

# Name: default, another value, what is beyond the range, what that becomes.
NUMBERS = {
    "Mode": (vtkBoneDecimate.BALANCED, vtkBoneDecimate.FAST, 99, vtkBoneDecimate.ACCURATE),
    "TargetNumberOfTriangles": (0, 500, -1, 0),
    "TargetReduction": (0.9, 0.5, 1.5, 1.0),
    "MaximumError": (0.0, 0.25, -1.0, 0.0),
    "NormalTolerance": (0.95, 0.5, 2.0, 1.0),
    "NumberOfThreads": (0, 2, 5000, 1024),
    "ErrorPreset": (vtkBoneDecimate.NO_PRESET, vtkBoneDecimate.HALF_VOXEL, 9, vtkBoneDecimate.ONE_VOXEL),
    "VoxelSize": (0.0, 0.5, -1.0, 0.0),
    "PruneSize": (0.0, 2.0, -1.0, 0.0),
    "PruneArea": (0.0, 20.0, -1.0, 0.0),
    "PruneVolume": (0.0, 8.0, -1.0, 0.0),
    "PruneTriangles": (0, 100, -1, 0),
    "OutputPointsPrecision": (vtkAlgorithm.DEFAULT_PRECISION, vtkAlgorithm.SINGLE_PRECISION, 7, 2),
}
SWITCHES = {"MergePoints": True, "AllowLargeError": False, "KeepClearance": True, "MeasureDistances": True, "MeasureInputDistances": False,
            "ProveResult": True, "PassArrays": True, "MakeMaps": False, "RecomputeNormals": False,
            "AutomaticNormalTolerance": False, "ExamineInput": False}
TEXTS = {
    "DistanceArrayName": "Distance",
    "RunningErrorArrayName": "RunningError",
    "PointCountArrayName": "InputPointCount",
    "InputDistanceArrayName": "DistanceToResult",
    "ErrorBoundArrayName": "ErrorBound",
    "InputErrorBoundArrayName": "ErrorBoundToResult",
    "ToleranceArrayName": "",
    "LabelArrayName": "",
}


def get(decimate, name):
    return getattr(decimate, "Get" + name)()


def put(decimate, name, value):
    getattr(decimate, "Set" + name)(value)


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

    def test_keep_what_they_are_given(self):
        decimate = vtkBoneDecimate()
        for name, values in NUMBERS.items():
            put(decimate, name, values[1])
            self.assertEqual(get(decimate, name), values[1], name)
        for name in TEXTS:
            put(decimate, name, "my " + name)
            self.assertEqual(get(decimate, name), "my " + name)

    def test_are_held_within_their_range(self):
        decimate = vtkBoneDecimate()
        for name, (_default, _other, beyond, held) in NUMBERS.items():
            put(decimate, name, beyond)
            self.assertEqual(get(decimate, name), held, name)

    def test_switches_have_set_on_and_off(self):
        decimate = vtkBoneDecimate()
        for name in SWITCHES:
            for turn, expected in (("Off", False), ("On", True)):
                getattr(decimate, name + turn)()
                self.assertIs(get(decimate, name), expected, name)
                put(decimate, name, not expected)
                self.assertIs(get(decimate, name), not expected, name)

    def test_refuse_what_is_no_number(self):
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
