# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""DICOM slices whose distances change: on purpose, or because slices are missing. No other reader keeps their positions."""

import dicom_files

CHOICES = {**dicom_files.CHOICES, "slices": list(dicom_files.HEIGHTS), "others": ["none", "report", "text"]}
write = dicom_files.write
