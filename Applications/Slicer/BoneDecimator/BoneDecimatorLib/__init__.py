# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The module without its window: engines run the decimation, regions choose where, the logic connects them to a scene."""
