# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What certify() of the wheel guarantees. Needs no VTK."""

import re
import unittest
import warnings

import numpy as np
from arrays_test import POINTS, TRIANGLES
from bonedecimate import certify, decimate


class Certify(unittest.TestCase):
    def test_bounds_the_distance_of_concentric_balls(self):
        certificate = certify((POINTS, TRIANGLES), (1.1 * POINTS, TRIANGLES), tolerance=1.2)
        self.assertLessEqual(certificate.lower, 1.0 + 1e-9)
        self.assertAlmostEqual(certificate.upper, 1.0, delta=0.02)
        self.assertEqual(certificate.status, "proved")
        self.assertEqual(certify((POINTS, TRIANGLES), (1.1 * POINTS, TRIANGLES), tolerance=0.9).status, "violated")

    def test_prints_bounds_rounded_outwards(self):
        for radius in (1.01234567891, 1.0212345678912, 1.09876543219):
            certificate = certify((POINTS, TRIANGLES), (radius * POINTS, TRIANGLES))
            printed = [float(bound) for bound in re.search(r"([\d.e-]+) to ([\d.e-]+) mm", repr(certificate)).groups()]
            rows = [float(re.search(rf"(?m)^{name} +([\d.e-]+) mm$", str(certificate.report))[1]) for name in ("lower", "upper")]
            for lower, upper in (printed, rows):
                self.assertLessEqual(lower, certificate.lower)
                self.assertGreaterEqual(upper, certificate.upper)
                self.assertAlmostEqual(lower, upper, delta=3e-6)

    def test_signs_distances(self):
        certificate = certify((POINTS, TRIANGLES), (1.1 * POINTS, TRIANGLES))
        self.assertTrue((certificate.reference_distance < -0.9).all())
        self.assertTrue((certificate.result_distance > 0.9).all())
        self.assertEqual((certificate.reference_side.max(), certificate.result_side.min()), (-1, 1))

    def test_agrees_with_the_proof_of_the_run(self):
        result = decimate(POINTS, TRIANGLES, max_error=0.2)
        certificate = certify((POINTS, TRIANGLES), result)
        self.assertLessEqual(certificate.lower, result.report["proof.upper"])
        self.assertLessEqual(certificate.upper, 0.2)

    def test_describes_both_surfaces(self):
        points, triangles = np.vstack([POINTS, POINTS + [3.0, 0, 0]]), np.vstack([TRIANGLES, TRIANGLES + len(POINTS)])
        report = certify((POINTS, TRIANGLES), (points, triangles), surfaces=True).report
        corners = POINTS[TRIANGLES]
        volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
        for side, count in (("reference", 1), ("result", 2)):
            self.assertEqual(report[f"{side}.triangles"], count * len(TRIANGLES))
            self.assertEqual(report[f"{side}.components"], count)
            self.assertEqual(report[f"{side}.boundary_edges"], 0)
            self.assertAlmostEqual(report[f"{side}.volume"], count * volume, delta=1e-9 * volume)
        self.assertEqual(report["reference.intersecting_pairs"], 0)
        self.assertGreater(report["result.intersecting_pairs"], 50)  # along a circle
        self.assertNotIn("result.triangles", certify((POINTS, TRIANGLES), (points, triangles)).report)
        stopped = certify((POINTS, TRIANGLES), (points, triangles), surfaces=True, progress=lambda fraction: fraction < 0.8)
        self.assertTrue(stopped.stopped)
        self.assertNotIn("result.triangles", stopped.report)

    def test_warns_of_units_and_of_missing_components(self):
        with self.assertWarnsRegex(UserWarning, "^the diagonal of the result is 0.001 times that of the reference: the surfaces may have different units$"):
            certify((POINTS, TRIANGLES), (0.001 * POINTS, TRIANGLES))
        with self.assertWarnsRegex(UserWarning, "^the tolerance of 12 mm is more than a quarter of the diagonal of the reference's bounding box, .* mm; the coordinates may"):
            certify((POINTS, TRIANGLES), (1.1 * POINTS, TRIANGLES), tolerance=12)
        two = np.vstack([POINTS, POINTS + [50.0, 0, 0]]), np.vstack([TRIANGLES, TRIANGLES + len(POINTS)])
        with self.assertWarnsRegex(UserWarning, "^1 of 2 components of the reference is missing in the result: .* at .50, 0, 0.$"):
            report = certify(two, (1.01 * POINTS, TRIANGLES), surfaces=True).report
        self.assertEqual((report["missing.0.triangles"], report["missing.0.x"]), (len(TRIANGLES), 50.0))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            certify((POINTS, TRIANGLES), (1.1 * POINTS, TRIANGLES))

    def test_tolerances_of_points(self):
        shifted = POINTS + np.where(POINTS[:, 2:] > 5, [[0, 0, 0.5]], 0)
        loose = np.where(POINTS[:, 2] > 0, 0.6, 0.1)
        self.assertEqual(certify((POINTS, TRIANGLES), (shifted, TRIANGLES), tolerances=loose).status, "proved")
        self.assertEqual(certify((POINTS, TRIANGLES), (shifted, TRIANGLES), tolerances=0.1 + 0 * loose).status, "violated")

    def test_rejects_what_cannot_be_compared(self):
        for other in ((POINTS, TRIANGLES[:0]), (POINTS * np.nan, TRIANGLES), (POINTS, TRIANGLES + 9999)):
            with self.assertRaises(ValueError):
                certify((POINTS, TRIANGLES), other)
        with self.assertRaises(ValueError):
            certify((POINTS, TRIANGLES), (POINTS, TRIANGLES), tolerance=-1.0)


if __name__ == "__main__":
    unittest.main()
