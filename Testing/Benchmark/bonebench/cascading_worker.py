# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Bounds of the two-sided distance by cascading-upper-bounds (Sacht and Jacobson 2024): cascading_worker.py A.ply B.ply MM

Both directions, to the difference in mm of their bounds. Prints JSON; processor seconds are those of both calls.
"""

from __future__ import annotations

import json
import sys
import time

import numpy as np
from cascading_upper_bounds import pompeiu_hausdorff
from peer_worker import read_ply


def main(first: str, second: str, gap: float) -> None:
    """Computes and prints."""
    one, two = ((points.astype(np.float64), corners.astype(np.int32)) for points, corners in map(read_ply, (first, second)))
    start = time.process_time()
    ways = [pompeiu_hausdorff(*a, *b, tol=gap, max_factor=1e6, normalize=False) for a, b in ((one, two), (two, one))]
    print("\n" + json.dumps({"lower": max(way[0] for way in ways), "upper": max(way[1] for way in ways),
                             "cpu_seconds": time.process_time() - start}))


if __name__ == "__main__":
    main(*sys.argv[1:3], float(sys.argv[3]))
