# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark: our modes and other programs on the same bones, measured by one hand. See ../method.md."""
