# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Segmentations of 3D Slicer by slicerio, which is pure Python."""

import numpy as np

from readers import LPS, optional
from truth import Reading

slicerio = optional("slicerio")


def slicerio_segments(path, choice):
    data = slicerio.read_segmentation(str(path))
    voxels = data["voxels"]
    layers = voxels if voxels.ndim == 4 else voxels[None]
    segments = data["segments"]
    labels = [int(one["labelValue"]) for one in segments]
    has_layers = len(layers) > 1
    final = list(range(1, len(labels) + 1)) if has_layers and len(set(labels)) < len(labels) else labels
    merged = np.zeros(layers.shape[1:], np.int64)
    for one, label, number in zip(segments, labels, final):
        merged[layers[one.get("layer", 0) if has_layers else 0] == label] = number
    names = [(number, one.get("name", one["id"]), tuple(one["color"]) if "color" in one else None)
             for number, one in zip(final, segments)]
    matrix = data["ijkToLPS"]
    return Reading(merged, matrix[:3, 3], matrix[:3, :3].T, names)
