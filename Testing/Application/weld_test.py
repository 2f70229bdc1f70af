# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""--weld: what joins, what stays apart, and whether the bound holds for the surface as it was read."""

import numpy as np
import vtk

from application import REJECTED, UNMEASURED, ApplicationTest, as_doubles, main, positions_of, read, torus, write

ERROR = 0.2  # mm


def surface_of(points, triangles):
    """With points in double precision."""
    coordinates = vtk.vtkPoints()
    coordinates.SetDataTypeToDouble()
    for point in np.asarray(points, float):
        coordinates.InsertNextPoint(point)
    cells = vtk.vtkCellArray()
    for triangle in triangles:
        cells.InsertNextCell(3, [int(corner) for corner in triangle])
    surface = vtk.vtkPolyData()
    surface.SetPoints(coordinates)
    surface.SetPolys(cells)
    return surface


def triangles_of(surface):
    return np.array([[surface.GetCell(i).GetPointId(k) for k in range(3)] for i in range(surface.GetNumberOfCells())])


def soup(noise, seed=1, order=None):
    """A torus whose triangles have corners of their own, each moved a little."""
    whole = as_doubles(torus(40, 20))
    corners = positions_of(whole)[triangles_of(whole)]
    corners = corners + np.random.default_rng(seed).uniform(-noise, noise, corners.shape)
    corners = corners if order is None else corners[np.random.default_rng(order).permutation(len(corners))]
    return corners


def from_corners(corners):
    return surface_of(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))


def plate(left, right, step=1.0, rows=8):
    """A grid of squares in the plane z = 0, cut in two."""
    columns = np.arange(left, right + 0.5 * step, step)
    points = [[x, step * row, 0.0] for x in columns for row in range(rows)]
    n = rows
    triangles = [t for i in range(len(columns) - 1) for j in range(rows - 1)
                 for t in ([i * n + j, i * n + n + j, i * n + n + j + 1], [i * n + j, i * n + n + j + 1, i * n + j + 1])]
    return np.array(points), np.array(triangles)


def boundary_edges(surface):
    edges = {}
    for triangle in triangles_of(surface):
        for k in range(3):
            edge = frozenset((triangle[k], triangle[(k + 1) % 3]))
            edges[edge] = edges.get(edge, 0) + 1
    return sum(count == 1 for count in edges.values())


def farthest(source, target):
    """How far points spread over the triangles of one surface are from the other, mm: a lower bound of the distance."""
    locator = vtk.vtkCellLocator()
    locator.SetDataSet(target)
    locator.BuildLocator()
    corners = positions_of(source)[triangles_of(source)]
    weights = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1 / 3, 1 / 3, 1 / 3), (0.5, 0.5, 0), (0, 0.5, 0.5), (0.5, 0, 0.5)]
    most = 0.0
    for weight in weights:
        for point in np.einsum("k,nkc->nc", np.array(weight), corners):
            nearest, cell, number, square = [0.0] * 3, vtk.reference(0), vtk.reference(0), vtk.reference(0.0)
            locator.FindClosestPoint(point, nearest, cell, number, square)
            most = max(most, float(square) ** 0.5)
    return most


class Weld(ApplicationTest):
    def decimate(self, surface, weld, *words):
        write(surface, self.path("in.vtp"))
        said = self.succeed("in.vtp", "out.vtp", "--weld", weld, "--report", "report.json", *words, *UNMEASURED).stdout
        return read(self.path("out.vtp")), said

    def test_a_soup_becomes_a_closed_surface_within_the_error_of_what_was_read(self):
        noise = 0.01
        source = from_corners(soup(noise))
        result, said = self.decimate(source, 0.05, "--max-error", ERROR)
        report = self.report()
        self.assertEqual(boundary_edges(result), 0)
        self.assertLess(result.GetNumberOfCells(), 0.8 * source.GetNumberOfCells())
        self.assertIn("points were welded onto others and moved by up to", said)
        self.assertEqual(report["proof"]["tolerance"], ERROR)
        self.assertLessEqual(report["proof"]["upper"], ERROR)
        found = max(farthest(source, result), farthest(result, source))
        self.assertGreater(found, noise)
        self.assertLessEqual(found, report["proof"]["upper"])

    def test_without_weld_a_soup_stays_a_soup_and_a_hint_names_the_option(self):
        write(from_corners(soup(1e-5)), self.path("in.vtp"))
        said = self.succeed("in.vtp", "out.vtp", "--max-error", ERROR, *UNMEASURED).stdout
        self.assertIn("--weld", said)
        result, _ = self.decimate(from_corners(soup(1e-5)), 1e-4, "--max-error", ERROR)
        self.assertEqual(boundary_edges(result), 0)

    def test_points_at_the_distance_join_and_points_beyond_stay(self):
        for gap, joined in ((0.0099, True), (0.0101, False)):
            left, first = plate(0, 4)
            right, second = plate(4 + gap, 8 + gap)
            source = surface_of(np.vstack([left, right]), np.vstack([first, second + len(left)]))
            result, said = self.decimate(source, 0.01, "--target-reduction", 0)
            alone = boundary_edges(surface_of(left, first)) + boundary_edges(surface_of(right, second))
            self.assertEqual(boundary_edges(result), alone - (14 if joined else 0), gap)
            self.assertIn("8 points were welded" if joined else "no point was welded", said)

    def test_closed_fragments_are_not_joined(self):
        first = as_doubles(torus(24, 12))
        points, triangles = positions_of(first), triangles_of(first)
        width = points[:, 0].max() - points[:, 0].min()
        both = surface_of(np.vstack([points, points + [width + 0.001, 0, 0]]), np.vstack([triangles, triangles + len(points)]))
        result, said = self.decimate(both, 0.01, "--target-reduction", 0)
        self.assertIn("no point was welded", said)
        self.assertEqual(result.GetNumberOfPoints(), both.GetNumberOfPoints())

    def test_chains_do_not_add_up_and_triangles_keep_their_corners(self):
        # Strips one after the other, each nearer to the next than the distance; a triangle is narrower than the distance.
        corners = []
        for i in range(20):
            x = 0.008 * i
            corners.append([[x, 0, 0], [x, 1, 0], [x + 0.004, 0.5, 1]])
        result, _ = self.decimate(from_corners(np.array(corners, float)), 0.01, "--target-reduction", 0)
        self.assertLessEqual(farthest(from_corners(np.array(corners, float)), result), 0.01)
        fan = np.array([[[0, 0, 0], [0.005, 0, 0], [0, 0.005, 0]], [[0.0052, 0, 0], [0.0052, 0.005, 0], [0, 0.0052, 0]]], float)
        result, _ = self.decimate(from_corners(fan), 0.01, "--target-reduction", 0)
        self.assertEqual(result.GetNumberOfCells(), 2)

    def test_the_result_depends_neither_on_the_order_of_triangles_nor_on_threads(self):
        found = set()
        for order, threads in ((None, 1), (None, 4), (7, 2)):
            result, _ = self.decimate(from_corners(soup(0.01, order=order)), 0.05, "--target-reduction", 0, "--threads", threads)
            corners = positions_of(result)[triangles_of(result)]
            found.add(tuple(sorted(tuple(sorted(map(tuple, triangle))) for triangle in corners.tolist())))
        self.assertEqual(len(found), 1)

    def test_what_does_not_go_with_it_is_rejected(self):
        write(from_corners(soup(0.01)), self.path("in.vtp"))
        for words, says in ((("--merge-points", "off"), "needs"), (("--max-error", 0.01), "more than half of the largest error"),
                            (("--preset", "quarter-voxel"), "--voxel-size"), (("--max-error", 1, "--reference", "in.vtp"), "reference")):
            self.fail_with(REJECTED, "in.vtp", "out.vtp", "--weld", 0.05, *words, says=says)

    def test_points_of_small_tolerance_stay(self):
        left, first = plate(0, 4)
        right, second = plate(4.005, 8.005)
        source = surface_of(np.vstack([left, right]), np.vstack([first, second + len(left)]))
        _, said = self.decimate(source, 0.01, "--region", "box:-1,9,-1,3.5,-1,1=0", "--region", "rest=0.5")
        self.assertIn("4 points were welded", said)


if __name__ == "__main__":
    main()
