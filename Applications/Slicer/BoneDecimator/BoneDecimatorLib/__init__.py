# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the module does, without windows: engines run the decimation, places choose where, the logic joins them to a scene."""
