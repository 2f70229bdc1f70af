# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces on several ranks: how they are cut, and what is asked of the filter."""

import specimens

OWNER = {
    "slabs": lambda number, count, ranks: number * ranks // count,
    "crumbs": lambda number, count, ranks: number // 7 % ranks,
    "lopsided": lambda number, count, ranks: 0,  # the other ranks have nothing
}


def cases():
    """By name: surface, how it is cut, properties."""
    ring = specimens.torus(120, 40, bumps=0.4)
    sheet = specimens.sheet(single=True)
    return {
        "reduction": (ring, "slabs", {"TargetReduction": 0.8}),
        "error": (ring, "slabs", {"MaximumError": 0.1}),
        "fast": (ring, "slabs", {"TargetNumberOfTriangles": 1500, "Mode": "Fast"}),
        "crumbs": (ring, "crumbs", {"TargetReduction": 0.5}),
        "lopsided": (specimens.torus(), "lopsided", {"TargetReduction": 0.5}),
        "open": (sheet, "slabs", {"MaximumError": 0.1}),
        "blocks": (ring, "blocks", {"TargetReduction": 0.8}),
    }


def refused():
    """What one part of a surface cannot tell."""
    ring = specimens.torus()
    return {
        "pruned": (ring, "slabs", {"PruneTriangles": 4}),
        "labelled": (ring, "slabs", {"LabelArrayName": "bone"}),
    }
