# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What a generated file is known to hold, what a reader finds in it, and how the two are compared."""

import dataclasses
import itertools

import numpy as np

SIZE = (5, 6, 7)
SPACING = np.array([0.8, 0.9, 1.3])
ORIGIN = np.array([112.5, -53.25, 430.75])
TURN = np.array([[29, 28, 20], [-20, 35, -20], [-28, 4, 29]]) / 45
TURN = np.linalg.qr(TURN)[0]
SHEAR = np.array([[1, 0, 0], [0, 1, 0.28], [0, 0, 0.96]])  # a gantry tilted by 16 degrees

# Columns are the directions of the axes of voxels in LPS.
AXES = {
    "straight": np.eye(3),
    "turned about z": np.diag([-1.0, -1.0, 1.0]),
    "mirrored": np.diag([1.0, 1.0, -1.0]),
    "permuted": np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
    "permuted and mirrored": np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]) @ np.diag([1.0, 1.0, -1.0]),
    "oblique": TURN,
    "oblique and mirrored": TURN * [1, -1, 1],
    "four decimals": np.round(TURN, 4),
    "sheared": TURN @ SHEAR,
}

LARGEST_COSINE = 1e-3  # of axes that count as perpendicular


class NotRead(Exception):
    """A reader does not read a file."""


@dataclasses.dataclass
class Reading:
    """Voxels have the indices x, y, z; steps are rows, from a voxel to its neighbor along x, y and z, mm in LPS."""

    voxels: np.ndarray
    origin: np.ndarray | None = None  # None: the reader does not say it
    steps: np.ndarray | None = None
    segments: list | None = None  # of (label, name, color)
    note: str = ""
    layers: np.ndarray | None = None  # where they lie, in steps; None: at 0, 1, 2 and so on
    labels: dict | None = None  # of ours: the grid of the label map
    is_label_map: bool = False  # its axes are made perpendicular
    is_turned: bool = False  # a mirrored volume has its last layer first
    is_in_units: bool = False  # positions are in the unit of the file, which this reader leaves to its user


@dataclasses.dataclass
class Truth(Reading):
    rejected: str = ""  # a part of the sentence by which ours rejects the file
    notes: tuple = ()  # parts of the note of ours
    spacing: tuple = ()  # to be given on the command line
    unit: float = 1  # of the file, mm


def sentences(*rows):
    """Of (is it so, part of a sentence): a file with several problems is rejected by one of them."""
    return "|".join(sentence for is_so, sentence in rows if is_so)


def position_of(axes, spacing=SPACING, origin=ORIGIN):
    """Origin and steps."""
    return np.array(origin, float), (AXES[axes] * spacing).T


def values_of(dtype, random, size=SIZE):
    """The whole range of a type, with its ends."""
    dtype = np.dtype(dtype)
    if dtype.kind == "f":
        voxels = random.normal(0, 1000, size).astype(dtype)
        voxels.flat[:3] = [0, np.finfo(dtype).max / 2, -np.finfo(dtype).tiny]
        return voxels
    ends = np.iinfo(dtype)
    voxels = random.integers(ends.min, ends.max, size, dtype, endpoint=True)
    voxels.flat[:2] = [ends.min, ends.max]
    return voxels


def reversed_layers(reading):
    """The same volume with the last layer first."""
    reading.origin = reading.origin + (reading.voxels.shape[2] - 1) * reading.steps[2]
    reading.steps = reading.steps * np.array([[1], [1], [-1]])
    reading.voxels = reading.voxels[:, :, ::-1]
    return reading


def corners(reading):
    """The centers of the voxels at the corners."""
    ends = [(0, n - 1) for n in reading.voxels.shape]
    return np.array([reading.origin + np.array(index) @ reading.steps for index in itertools.product(*ends)])


def smallest_step(steps):
    return np.linalg.norm(steps, axis=1).min()


def differences(found, expected):
    """What differs: words for the table."""
    kinds = []
    if found.voxels.shape != expected.voxels.shape:
        return ["size"]
    if found.voxels.tolist() != expected.voxels.tolist():
        kinds.append("voxels")
    if found.origin is not None and expected.origin is not None:
        tolerance = 2e-4 * smallest_step(expected.steps) + 1e-6 * np.abs(expected.origin).max()
        if not (np.abs(corners(found) - corners(expected)) <= tolerance).all():
            kinds.append("positions")
    if found.segments is not None and expected.segments is not None:
        kinds += segment_differences(found.segments, expected.segments)
    return kinds


def segment_differences(found, expected):
    if len(found) != len(expected):
        return ["segments"]
    kinds = []
    for name, part in (("labels", 0), ("names", 1)):
        if [one[part] for one in found] != [one[part] for one in expected]:
            kinds.append(name)
    if any(np.abs(np.subtract(one[2], other[2])).max() > 0.004 for one, other in zip(found, expected)
           if one[2] is not None and other[2] is not None):
        kinds.append("colors")
    return kinds


def largest_cosine(steps):
    units = steps / np.linalg.norm(steps, axis=1)[:, None]
    return max(abs(units[0] @ units[1]), abs(units[1] @ units[2]), abs(units[0] @ units[2]))


def label_differences(found, expected):
    """Of ours: the grid as a label map, whose axes are those of the file, or perpendicular but for rounding."""
    if found.labels is None or expected.steps is None:
        return []
    if expected.layers is not None:
        is_at_layers = found.layers is not None and np.allclose(found.layers, expected.layers, atol=1e-3)
        return [] if is_at_layers else ["positions of layers"]
    moved = np.abs(np.array(found.labels["steps"]) - expected.steps).max()
    return [] if moved <= LARGEST_COSINE * np.linalg.norm(expected.steps, axis=1).max() else ["positions of labels"]