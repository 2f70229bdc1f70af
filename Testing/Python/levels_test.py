# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Levels of detail from Python: one run, any level, the log as bytes."""

import unittest

from surfaces import torus
from bonedecimate import vtkBoneDecimate, vtkBoneDecimateLevels
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray


def recorded(log=None):
    levels = vtkBoneDecimateLevels()
    levels.SetInputData(torus())
    levels.SetMode(vtkBoneDecimate.FAST)
    levels.SetTargetNumberOfTriangles(200)
    levels.MeasureDistancesOff()
    levels.SetLog(log)
    return levels


def level(levels, triangles):
    levels.SetNumberOfTriangles(triangles)
    levels.Update()
    surface = levels.GetOutput()
    return [surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())], surface.GetNumberOfPolys()


class Levels(unittest.TestCase):
    def test_has_any_number_of_triangles(self):
        levels = recorded()
        for triangles in (1000, 400, 800):
            self.assertEqual(level(levels, triangles)[1], triangles)

    def test_bytes_of_a_log_stand_for_its_run(self):
        levels = recorded()
        points, triangles = level(levels, 500)
        content = bytes(memoryview(levels.GetLog()))
        self.assertEqual(content[:8], b"BDLEVELS")
        log = vtkUnsignedCharArray()
        log.SetNumberOfValues(len(content))
        memoryview(log).cast("B")[:] = content
        self.assertEqual(level(recorded(log), 500), (points, triangles))


if __name__ == "__main__":
    unittest.main()
