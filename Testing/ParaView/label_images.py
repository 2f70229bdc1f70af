# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A small segmentation: two halves of a ball with a plate through both, so that curves where three labels meet cross each other."""

from vtkmodules.vtkCommonCore import VTK_SHORT
from vtkmodules.vtkCommonDataModel import vtkImageData

SIZE = (22, 20, 18)
SPACING = (0.8, 0.8, 0.957)  # mm
LABELS = (2, 5, 9)
ARRAY = "Segments"


def label_at(x, y, z):
    out = ((x - 10.5) / 8) ** 2 + ((y - 9.5) / 7) ** 2 + ((z - 8.5) / 6) ** 2
    if out > 1:
        return 0
    if abs(x + 0.7 * y + 0.4 * z - 20) < 2.2:
        return LABELS[2]
    return LABELS[0] if x + 0.3 * z < 12 else LABELS[1]


def block_at(x, y, z):
    return LABELS[0] if all(4 <= i < n - 4 for i, n in zip((x, y, z), SIZE)) else 0


def image(label=label_at):
    labels = vtkImageData()
    labels.SetDimensions(*SIZE)
    labels.SetSpacing(*SPACING)
    labels.SetOrigin(-5.0, 3.0, 100.0)
    labels.AllocateScalars(VTK_SHORT, 1)
    labels.GetPointData().GetScalars().SetName(ARRAY)
    for z in range(SIZE[2]):
        for y in range(SIZE[1]):
            for x in range(SIZE[0]):
                labels.SetScalarComponentFromDouble(x, y, z, 0, label(x, y, z))
    return labels
