# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripted module's logic rejects values outside their range before it runs anything. Needs VTK, but no Slicer."""

import math
import pathlib
import sys
import types
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Applications" / "Slicer" / "BoneDecimator"))
from BoneDecimatorLib.checks import DecimationError  # noqa: E402
from BoneDecimatorLib.engines import WheelEngine, _set_option  # noqa: E402
from BoneDecimatorLib.logic import BoneDecimatorLogic, Request, presets  # noqa: E402

NO_NUMBERS = (math.nan, math.inf, -math.inf, "0.1", None, True)


class Engine:
    """Fails the test at any use."""

    has_levels = True

    def decimate(self, *_arguments):
        raise AssertionError("it was run")

    record_levels = decimate


class Requests(unittest.TestCase):
    def rejects(self, says, **request):
        with self.subTest(**request):
            with self.assertRaisesRegex(DecimationError, says):
                Request(**request).options()
            with self.assertRaisesRegex(DecimationError, says):
                BoneDecimatorLogic(None, Engine()).decimate(None, Request(**request))

    def test_outside_their_range_are_rejected_with_a_sentence(self):
        for value in (-1, -1e-300, 1.1e30, *NO_NUMBERS):
            self.rejects("^The tolerance takes a number from 0 to 1e30 mm, not ", tolerance=value, triangles=100)
            self.rejects("^The radius takes a number from 0 to 1e30 mm, not ", radius=value)
            self.rejects("^The feather takes a number from 0 to 1e30 mm, not ", feather=value)
        for value in (-1, 0.5, 2**31, *NO_NUMBERS):
            self.rejects("^The number of triangles takes a whole number from 0 to 2147483647, not ", triangles=value)
        for value in ("", "balanced", "Nonsense", None, 2):
            self.rejects("^Mode takes one of Thesis, Fast, Balanced, Accurate", mode=value)

    def test_without_any_goal_are_rejected(self):
        self.rejects("^Give a tolerance or a number of triangles", tolerance=0.0, triangles=0)
        self.rejects("^A brush needs a tolerance", tolerance=0.0, triangles=100, brush="Paint")

    def test_within_their_range_become_flags(self):
        wanted = Request(tolerance=0.25, triangles=100, mode="Fast", intersection_guard=False).options()
        self.assertEqual(wanted, {"mode": "Fast", "intersection-guard": False, "max-error": 0.25, "target-triangles": 100})

    def test_of_levels_are_rejected(self):
        logic = BoneDecimatorLogic(None, Engine())
        for value in (0, -0.1, 1.1, *NO_NUMBERS):
            with self.subTest(value=value), self.assertRaisesRegex(DecimationError, "^The ratio of triangles takes"):
                logic.record_levels(None, ratio=value)
        with self.assertRaisesRegex(DecimationError, "^Mode takes"):
            logic.record_levels(None, mode="Nonsense")
        for value in (0, -1, 0.5, *NO_NUMBERS):
            with self.subTest(value=value), self.assertRaisesRegex(DecimationError, "^The number of triangles takes"):
                logic.show_level(None, value, None)

    def test_of_presets_are_rejected(self):
        for value in (-1.0, *NO_NUMBERS):
            with self.subTest(value=value), self.assertRaisesRegex(DecimationError, "^The scan's spacing takes"):
                presets((0.5, 0.5, value))
        self.assertEqual(presets((0.5, 1.0))["one voxel"], 0.5)

    def test_more_flags_that_do_not_fit_are_rejected(self):
        class Decimate:
            def SetMaximumError(self, value):
                raise ValueError(f"MaximumError takes a number from 0 to 1e30 mm, not {value}")

        rows = {"max-error": types.SimpleNamespace(name="MaximumError", choices=[]),
                "mode": types.SimpleNamespace(name="Mode", choices=["Thesis", "Fast"])}
        for flag, value, says in (("max-error", -1, "MaximumError takes"), ("mode", "Best", "Mode takes one of"),
                                  ("nothing", 1, "There is no option --nothing")):
            with self.assertRaisesRegex(DecimationError, says):
                _set_option(Decimate(), rows, flag, value)
        self.assertTrue(WheelEngine.has_levels)


if __name__ == "__main__":
    unittest.main()
