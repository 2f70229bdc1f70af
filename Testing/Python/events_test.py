# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress, abort, warnings and errors as a Python observer meets them."""

import math
import unittest

from surfaces import TRIANGLES, Ear, decimating, torus
from bonedecimate import vtkBoneDecimate


def run_with(decimate, on_progress):
    decimate.AddObserver("ProgressEvent", lambda caller, _event: on_progress(caller.GetProgress()))
    decimate.Update()


class Progress(unittest.TestCase):
    def test_reaches_an_observer_and_goes_up_to_one(self):
        heard = []
        run_with(decimating(torus()), heard.append)
        self.assertEqual(heard, sorted(heard))
        self.assertEqual(heard[-1], 1.0)
        self.assertGreater(len(heard), 50)


class Abort(unittest.TestCase):
    def abort_at(self, fraction):
        decimate = decimating(torus())

        def stop(progress):
            if progress >= fraction:
                decimate.AbortExecuteOn()

        run_with(decimate, stop)
        return decimate

    def test_from_the_observer_leaves_a_larger_closed_surface_and_says_so(self):
        decimate = self.abort_at(0.3)
        self.assertEqual(decimate.GetStopReason(), vtkBoneDecimate.ABORTED)
        self.assertGreater(decimate.GetOutput().GetNumberOfPolys(), TRIANGLES // 10)
        self.assertLess(decimate.GetOutput().GetNumberOfPolys(), TRIANGLES)
        self.assertEqual(decimate.GetReportValue("output.boundary_edges"), 0)
        self.assertEqual(decimate.GetReportValue("output.euler_number"), 0)

    def test_while_measuring_leaves_the_whole_result(self):
        decimate = self.abort_at(0.8)
        self.assertEqual(decimate.GetStopReason(), vtkBoneDecimate.ABORTED)
        self.assertEqual(decimate.GetOutput().GetNumberOfPolys(), TRIANGLES // 10)


class Messages(unittest.TestCase):
    def test_of_a_point_that_is_not_a_number_is_an_error_with_count_and_first(self):
        surface = torus()
        for point in (11, 12, 700):
            surface.GetPoints().SetPoint(point, 0.0, math.nan, 0.0)
        decimate = decimating(surface)
        errors = Ear(decimate, "ErrorEvent")
        Ear(decimate.GetExecutive(), "ErrorEvent")  # VTK's own remark that the filter failed
        decimate.Update()
        self.assertEqual(len(errors.texts), 1)
        self.assertIn("3 points", errors.texts[0])
        self.assertIn("point 11", errors.texts[0])
        self.assertEqual(decimate.GetOutput().GetNumberOfPoints(), 0)

    def test_there_are_none_about_arrays_that_come_along(self):
        first = decimating(torus())
        first.Update()
        second = decimating(first.GetOutput())
        warnings = Ear(second, "WarningEvent")
        second.Update()
        self.assertEqual(warnings.texts, [])


if __name__ == "__main__":
    unittest.main()
