# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Where a surface may move, and how far: regions chosen by markups, a box or paint become a tolerance in mm at each point."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def points_of(surface):
    """(n, 3), mm."""
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


FEW = 32  # centers for which trying all of them is faster than a search


def distance_to_points(points, centers):
    """mm, of each point to the nearest center."""
    if len(centers) <= FEW:
        return np.min([np.linalg.norm(points - center, axis=1) for center in np.asarray(centers, dtype=float)], axis=0)
    kept = vtk.vtkPoints()
    kept.SetData(numpy_to_vtk(np.ascontiguousarray(centers, dtype=float), deep=True))
    locator = vtk.vtkStaticPointLocator()
    cloud = vtk.vtkPolyData()
    cloud.SetPoints(kept)
    locator.SetDataSet(cloud)
    locator.BuildLocator()
    nearest = [locator.FindClosestPoint(point) for point in points]
    return np.linalg.norm(points - np.asarray(centers, dtype=float)[nearest], axis=1)


def outside_of_markups(points, centers, radius):
    """mm beyond the balls of that radius around the centers; 0 or less inside."""
    return distance_to_points(points, centers) - radius


def outside_of_box(points, world_to_box, half):
    """mm beyond a box; 0 or less inside.

    @param world_to_box (4, 4), to the box's own axes about its center; rigid.
    @param half (3,), half of its sides, mm.
    """
    local = points @ np.asarray(world_to_box)[:3, :3].T + np.asarray(world_to_box)[:3, 3]
    beyond = np.abs(local) - np.asarray(half)
    outside = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
    return np.where(outside > 0.0, outside, beyond.max(axis=1))


def outside_of_paint(points, painted):
    """mm to the nearest painted point (Dynamic Modeler's "Select by points" paints with numbers above 0)."""
    mask = np.asarray(painted) > 0
    if not mask.any():
        return np.full(len(points), np.inf)
    return np.where(mask, 0.0, distance_to_points(points, points[mask]))


def tolerances(outside, inner, outer, feather):
    """mm at each point: `inner` inside, `outer` from `feather` mm on, linear in between."""
    ratio = np.clip(np.asarray(outside) / feather, 0.0, 1.0) if feather > 0.0 else (np.asarray(outside) > 0.0) * 1.0
    return inner + ratio * (outer - inner)
