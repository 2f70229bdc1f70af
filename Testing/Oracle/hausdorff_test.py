# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The certificate against CGAL's bounded-error Hausdorff distance, on small pairs and a large one."""

import json
import math
import os
import random
import subprocess
import unittest

from surface_files import WithFiles, square

PROGRAM = os.environ["HAUSDORFF_PROGRAM"]


def torus(around, across, bumps=0.0, seed=1):
    """A closed surface of 2 around across triangles; every point displaced at random."""
    chance = random.Random(seed)
    points, triangles = [], []
    for i in range(around):
        for j in range(across):
            u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
            out = 10 + 3 * math.cos(v)
            position = (out * math.cos(u), out * math.sin(u), 3 * math.sin(v))
            points.append(tuple(x + chance.uniform(-bumps, bumps) for x in position))
            a, b = i * across + j, (i + 1) % around * across + j
            c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
            triangles += [(a, b, c), (a, c, d)]
    return points, triangles


class Hausdorff(WithFiles):
    def assert_agree(self, one, two, error):
        words = [PROGRAM, self.write("a.ply", one), self.write("b.ply", two), str(error)]
        result = json.loads(subprocess.run(words, capture_output=True, text=True, check=True).stdout)
        for way in ("reference_to_result", "result_to_reference"):
            lower, upper = result["ours"][way]
            self.assertLessEqual(lower, result["cgal"][way] + error)
            self.assertGreaterEqual(upper, result["cgal"][way] - error)

    def test_squares_of_two_sizes(self):
        self.assert_agree(square(0.0, 20.0), square(1.0, 10.0), 1e-4)

    def test_shaken_surfaces(self):
        for seed in range(8):
            self.assert_agree(torus(16, 8), torus(16, 8, 0.4, seed), 1e-4)

    def test_surfaces_of_other_triangles(self):
        for around, across in ((7, 5), (12, 9), (25, 6)):
            self.assert_agree(torus(30, 16, 0.1), torus(around, across), 1e-4)

    def test_a_large_pair(self):
        self.assert_agree(torus(300, 150, 0.01), torus(90, 40), 1e-3)


if __name__ == "__main__":
    unittest.main()
