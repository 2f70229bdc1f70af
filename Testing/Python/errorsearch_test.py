# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The smallest proved error for a number of triangles, and the curve, from Python."""

import math
import unittest

from surfaces import TRIANGLES, Ear, decimating, torus
from bonedecimate import error_curve, smallest_error, vtkBoneDecimate, vtkBoneErrorSearch, vtkBoneSurfaceDistance


class ErrorSearch(unittest.TestCase):
    def test_finds_a_surface_that_the_certificate_confirms(self):
        error, surface = smallest_error(torus(), 400, 0.1, vtkBoneDecimate.FAST)
        self.assertLessEqual(surface.GetNumberOfPolys(), 400)
        comparison = vtkBoneSurfaceDistance()
        comparison.SetInputData(0, torus())
        comparison.SetInputData(1, surface)
        comparison.Update()
        self.assertLessEqual(comparison.GetLowerBound(), error)
        self.assertEqual(surface.GetFieldData().GetArray("bonedecimate.proof.if_unchanged.upper").GetValue(0), error)

    def test_takes_the_name_of_a_mode(self):
        for mode in ("Fast", "fast"):
            self.assertEqual(smallest_error(torus(), 400, 0.1, mode)[0], smallest_error(torus(), 400, 0.1, vtkBoneDecimate.FAST)[0])
            self.assertEqual(error_curve(torus(), [0.5], mode), error_curve(torus(), [0.5], vtkBoneDecimate.FAST))
        for mode in ("Quick", "Thesis"):
            with self.assertRaisesRegex(ValueError, "Mode"):
                smallest_error(torus(), 400, 0.1, mode)

    def test_knows_when_there_is_none(self):
        self.assertIsNone(smallest_error(torus(), 3)[0])
        search = vtkBoneErrorSearch()
        warnings = Ear(search, "WarningEvent")
        search.SetInputData(torus())
        search.SetTargetNumberOfTriangles(3)
        search.Update()
        self.assertIn("no run kept its limits with 3 triangles or fewer; the output is that of the last run", "".join(warnings.texts))

    def test_forgets_the_error_of_a_search_before_one_that_fails(self):
        search = vtkBoneErrorSearch()
        Ear(search, "ErrorEvent")
        search.SetInputData(torus())
        search.SetTargetNumberOfTriangles(400)
        search.SetRelativePrecision(0.5)
        search.Update()
        self.assertGreater(search.GetSmallestError(), 0)
        search.SetLabelArrayName("Nothing")
        search.Update()
        self.assertTrue(math.isnan(search.GetSmallestError()))

    def test_has_a_curve(self):
        curve = error_curve(torus(), [0.05, 0.5], vtkBoneDecimate.FAST)
        self.assertEqual([row[0] for row in curve], [0.05, 0.5])
        for error, triangles, proved in curve:
            self.assertLessEqual(proved, error)
            run = decimating(torus(), MaximumError=error, Mode=vtkBoneDecimate.FAST)
            run.Update()
            self.assertEqual(run.GetOutput().GetNumberOfPolys(), triangles)
        self.assertLess(curve[1][1], curve[0][1])
        self.assertLess(curve[0][1], TRIANGLES)


if __name__ == "__main__":
    unittest.main()
