# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The figures that H. Brandao's thesis (Groningen 2018) prints, on a Core i7-4510U and its own two meshes.

Requested triangles or mm -> triangles, largest, largest but one, average and RMS distance of the simplified surface's
points to the original in mm, seconds; None was not printed there.
"""

from __future__ import annotations

Row = tuple[int, float, float | None, float, float, float | None]

INPUT = {"maxilla": 105002, "frontal": 78640}
BY_COUNT: dict[str, dict[int, Row]] = {
    "maxilla": {
        65000: (65000, 0.2341, None, 0.00445, 0.01323, 4.72),
        40000: (40000, 0.7644, None, 0.01824, 0.0346, 7.09),
        10000: (10000, 0.6109, None, 0.0796, 0.1088, 9.44),
        1000: (1000, 1.7012, None, 0.3427, 0.4578, 10.14)},
    "frontal": {
        65000: (65000, 0.1555, None, 0.00078, 0.00405, 1.54),
        40000: (40000, 0.2494, None, 0.00727, 0.01855, 3.90),
        10000: (10000, 0.5583, None, 0.0574, 0.0822, 6.29),
        1000: (1000, 1.4873, None, 0.2648, 0.3481, 6.86)},
}
# What it prints for MeshLab's quadric: largest, average and RMS distance in mm.
MESHLAB: dict[str, dict[int, tuple[float, float, float]]] = {
    "maxilla": {65000: (1.664, 0.00332, 0.01468), 40000: (3.749, 0.01394, 0.04291), 10000: (4.411, 0.06859, 0.10482)},
}
BY_ERROR: dict[str, dict[float, Row]] = {
    "maxilla": {
        0.1: (94698, 0.1188, 0.0784, 0.00037, 0.0023, None),
        0.5: (53864, 0.5935, 0.2342, 0.0088, 0.0209, None),
        1.0: (6578, 1.7066, 0.7481, 0.1084, 0.1500, None)},
    "frontal": {
        0.1: (68502, 0.1538, 0.0845, 0.0005, 0.0029, None),
        0.5: (12558, 0.5583, 0.4644, 0.0470, 0.0696, None),
        1.0: (4814, 1.5474, 0.6953, 0.0980, 0.1372, None)},
}
