# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter through ParaView's proxies against the filter of the system's VTK: same bytes."""

import json
import os
import pathlib
import unittest

from paraview import simple
from vtkmodules.vtkCommonCore import vtkLogger

import specimens
import surfaces

REFERENCE = json.loads((pathlib.Path(os.environ["FOLDER"]) / "reference.json").read_text())["runs"]
# ParaView says the unit in the names of arrays of millimeters; the filter does not.
NAMES = {"DistanceArrayName": "Distance", "RunningErrorArrayName": "RunningError", "InputDistanceArrayName": "DistanceToResult",
         "ErrorBoundArrayName": "ErrorBound", "InputErrorBoundArrayName": "ErrorBoundToResult"}
REJECTED = {"ReferenceTooFar", "NotANumber", "WrongIndex", "NoSuchEdgeLengths", "NoSuchTolerances", "BadTolerances"}


def filtered(surface, properties):
    wanted = {**NAMES, **properties}
    reference = wanted.pop("ReferenceData", None)
    decimate = simple.BoneDecimate(Input=surfaces.source(surface))
    if reference:
        decimate.Reference = surfaces.source(reference)
    for name, value in wanted.items():
        setattr(decimate, name, value)
    return decimate


def without_scalars(portrait):
    """With the names of the active scalars apart from the arrays."""
    scalars, others = 0, -1  # roles
    arrays = [[*array[:5], others if array[5] == scalars else array[5], array[6]] for array in portrait["point data"]]
    return {**portrait, "point data": arrays, "scalars": [array[0] for array in portrait["point data"] if array[5] == scalars]}


class Sameness(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        surfaces.load()

    def test_every_specimen_comes_out_with_the_same_bytes(self):
        for name, (surface, properties) in specimens.cases().items():
            if name in REJECTED or name in specimens.DEPENDS_ON_VTK:
                continue
            with self.subTest(name):
                decimate = filtered(surface, properties)
                for port in (0, 1):
                    portrait = json.loads(json.dumps(specimens.portrait(surfaces.output(decimate, port))))
                    reference = REFERENCE[name][f"output {port}"]
                    distance = str(decimate.DistanceArrayName)
                    if port == 0 and any(array[0] == distance for array in portrait["point data"]):
                        portrait, reference = map(without_scalars, (portrait, reference))
                        self.assertEqual(portrait.pop("scalars"), [distance])  # by which ParaView colors
                        reference.pop("scalars")
                    self.assertEqual(portrait, reference)

    def test_what_the_filter_rejects_is_empty(self):
        for name in REJECTED:
            with self.subTest(name):
                decimate = filtered(*specimens.cases()[name])
                self.assertEqual(surfaces.output(decimate).GetNumberOfCells(), 0)

    def test_the_default_reduction_steps_back_and_another_one_does_not(self):
        surface = specimens.torus(120, 60, bumps=0.4)
        by_error = surfaces.output(filtered(surface, {"MaximumError": 0.001})).GetNumberOfCells()
        self.assertGreater(by_error, 0.1 * 14400)
        both = filtered(surface, {"MaximumError": 1.0, "TargetReduction": 0.3})
        self.assertEqual(surfaces.output(both).GetNumberOfCells(), 10080)
        both.TargetReduction = 0.9
        self.assertLess(surfaces.output(both).GetNumberOfCells(), 1440)


if __name__ == "__main__":
    unittest.main()
