# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The verifier with surfaces whose distances, topology and intersections are known."""

import json
import math
import os
import subprocess
import unittest

from surface_files import WithFiles, square

PROGRAM = os.environ["VERIFY_PROGRAM"]
TETRAHEDRON = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]


def tetrahedron(shift=0.0):
    return [(shift, 0, 0), (shift + 1, 0, 0), (shift, 1, 0), (shift, 0, 1)], TETRAHEDRON


def together(*surfaces):
    """One list of triangles; every surface keeps points of its own."""
    points, triangles = [], []
    for more_points, more_triangles in surfaces:
        triangles += [tuple(corner + len(points) for corner in corners) for corners in more_triangles]
        points += more_points
    return points, triangles


class Verify(WithFiles):
    def ask(self, *words):
        done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    def shape(self, *surfaces):
        return self.ask("--shape", self.write("shape.ply", together(*surfaces)))

    def compare(self, original, simplified, *words):
        return self.ask(self.write("a.ply", original), self.write("b.ply", simplified), *words)

    def test_parallel_squares_are_as_far_apart_as_they_are(self):
        result = self.compare(square(0), square(0.25))
        for side in ("simplified_to_original", "original_to_simplified"):
            for figure in ("average", "rms", "maximum", "point_average", "point_maximum", "point_second"):
                self.assertAlmostEqual(result[side][figure], 0.25, 12)
            self.assertEqual(set(result[side]["percentiles"]), {0.25})

    def test_what_is_missing_shows_in_one_direction_alone(self):
        result = self.compare(square(0, 20.0), square(0, 10.0))
        self.assertEqual(result["simplified_to_original"]["maximum"], 0.0)
        self.assertAlmostEqual(result["original_to_simplified"]["maximum"], 200 ** 0.5, 6)
        self.assertEqual(result["hausdorff"], result["original_to_simplified"]["maximum"])

    def test_average_over_the_area_of_a_tilted_square(self):
        tilted = [(0, 0, 0), (10, 0, 1), (10, 10, 1), (0, 10, 0)], [(0, 1, 2), (0, 2, 3)]
        there = self.compare(square(0), tilted)["simplified_to_original"]
        self.assertAlmostEqual(there["average"], 0.5, 3)
        self.assertAlmostEqual(there["rms"], (1 / 3) ** 0.5, 3)
        self.assertAlmostEqual(there["percentiles"][50], 0.5, 2)

    def test_smallest_angles_are_counted(self):
        def with_angle(degrees):
            angle = math.radians(degrees)
            return [(0, 0, degrees), (10, 0, degrees), (10 * math.cos(angle), 10 * math.sin(angle), degrees)], [(0, 1, 2)]

        shape = self.shape(*map(with_angle, (5, 9.9, 10.1, 25, 60, 150)))  # 150: two of 15
        self.assertEqual(shape["below_10_20_30_degrees"], [2, 4, 5])

    def test_the_number_of_threads_changes_nothing(self):
        pair = square(0), tetrahedron()
        self.assertEqual(self.compare(*pair, "--threads", 1), self.compare(*pair, "--threads", 5))

    def test_counts_of_closed_and_open_pieces(self):
        shape = self.shape(tetrahedron(), tetrahedron(5.0), square(9))
        self.assertEqual((shape["components"], shape["euler"], shape["boundary_edges"]), (3, 5, 4))
        self.assertEqual((shape["non_manifold_edges"], shape["non_manifold_vertices"]), (0, 0))
        self.assertEqual(shape["self_intersections"], 0)

    def test_points_written_twice_are_one(self):
        points, triangles = square(0)
        twice = [points[corner] for corners in triangles for corner in corners], [(0, 1, 2), (3, 4, 5)]
        self.assertEqual(self.shape(twice)["boundary_edges"], 4)

    def test_pinch_and_fin_are_not_manifold(self):
        mirrored = [(0, 0, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1)], TETRAHEDRON
        pinched = self.shape(tetrahedron(), mirrored)
        self.assertEqual((pinched["non_manifold_edges"], pinched["non_manifold_vertices"]), (0, 1))
        self.assertEqual(pinched["self_intersections"], 0)
        fin = [(0, 0, 0), (1, 0, 0), (0.5, -1, -1)], [(0, 1, 2)]
        finned = self.shape(tetrahedron(), fin)
        self.assertEqual((finned["non_manifold_edges"], finned["non_manifold_vertices"]), (1, 2))

    def test_triangles_that_cut_or_cover_each_other_count_as_pairs(self):
        blade = [(3, 1, -1), (4, 1, -1), (3.5, 1, 1)], [(0, 1, 2)]
        self.assertEqual(self.shape(square(0), blade)["self_intersections"], 1)
        folded = [(0, 0, 0), (1, 0, 0), (0.2, 1, 0), (0.8, 1, 0)], [(0, 1, 2), (1, 0, 3)]
        self.assertEqual(self.shape(folded)["self_intersections"], 1)
        through_a_corner = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (1, 1, 1), (0.2, 0.2, -1)], [(0, 1, 2), (0, 3, 4)]
        self.assertEqual(self.shape(through_a_corner)["self_intersections"], 1)

    def test_quality_of_an_equilateral_triangle_is_one(self):
        shape = self.shape(([(0, 0, 0), (1, 0, 0), (0.5, 0.75 ** 0.5, 0)], [(0, 1, 2)]))
        self.assertAlmostEqual(shape["quality"], 1.0, 6)
        needle = self.shape(([(0, 0, 0), (1, 0, 0), (0.5, 0.01, 0)], [(0, 1, 2)]))
        self.assertEqual(needle["bad_fraction"], 1.0)

    def test_damaged_files_are_rejected(self):
        path = self.write("cut.ply", square(0))
        path.write_bytes(path.read_bytes()[:-3])
        done = subprocess.run([PROGRAM, "--shape", path], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cut.ply", done.stderr)


if __name__ == "__main__":
    unittest.main()
