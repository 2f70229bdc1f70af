# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares smoothing methods for surfaces of label maps; Testing/Benchmark/smoothing.sh runs it."""

# Names of methods that the tables mention.
NOT_SMOOTHED, OURS = "not smoothed", "vtkBoneSmooth"
