# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkBoneLabelPieces against flood fills in plain Python: every voxel of label maps of noise."""

import itertools
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataConnectivityFilter

from bonedecimate import vtkBoneLabelPieces, vtkBoneSurfaces

SHAPE = (7, 8, 9)  # z, y, x
SPACING = (0.5, 0.7, 1.3)  # x, y, z
VOXEL = 0.5 * 0.7 * 1.3  # mm3
FACES = (0.5 * 0.7, 0.5 * 1.3, 0.7 * 1.3)  # mm2, of faces across z, y, x
TO_NEIGHBORS = [step for step in itertools.product((-1, 0, 1), repeat=3) if 1 <= sum(map(abs, step)) <= 2]
ACROSS_FACES = [step for step in TO_NEIGHBORS if sum(map(abs, step)) == 1]


def noise(seed, background=0):
    """Labels 2, 5 and 9 in patches, a few voxels of any label, and background."""
    random = np.random.default_rng(seed)
    labels = np.kron(random.choice([0, 2, 5, 9, 5], (4, 4, 3)), np.ones((2, 2, 3), int))[:SHAPE[0], :SHAPE[1], :SHAPE[2]]
    labels = np.where(random.random(SHAPE) < 0.25, random.choice([0, 2, 5, 9], SHAPE), labels)
    return np.where(labels == 0, background, np.where(labels == background, 0, labels)).astype(np.int16)


def next_to(voxel, steps):
    return [tuple(np.add(voxel, step)) for step in steps]


def is_in(voxel):
    return all(0 <= index < size for index, size in zip(voxel, SHAPE))


def pieces(labels, label, steps):
    """Sets of voxels."""
    left = {tuple(voxel) for voxel in np.argwhere(labels == label).tolist()}
    while left:
        found = front = {left.pop()}
        while front:
            front = {other for voxel in front for other in next_to(voxel, steps)} & left
            left -= front
            found = found | front
        yield found


def faces(piece):
    """Of a piece: the voxels on the other sides and the areas, mm2."""
    for voxel in piece:
        for step in ACROSS_FACES:
            other = tuple(np.add(voxel, step))
            if other not in piece:
                yield other, FACES[np.argmax(np.abs(step))]


def is_below(piece, size, area, volume):
    low, high = (extreme(list(piece), axis=0) for extreme in (np.min, np.max))
    return (max((high - low + 1) * SPACING[::-1]) < size - 1e-9 or sum(each for _, each in faces(piece)) < area - 1e-9
            or len(piece) * VOXEL < volume - 1e-9)


def without_islands(labels, chosen, background, limits):
    """The map without them, and by label how many pieces and voxels they are."""
    islands, counts = [], {}
    for label in chosen:
        all_pieces = sorted(pieces(labels, label, ACROSS_FACES), key=lambda piece: (-len(piece), min(piece)))
        small = [piece for piece in all_pieces[1:] if is_below(piece, *limits)]
        islands += small
        counts[label] = (len(small), sum(map(len, small)))
    inside = set().union(*islands)
    changed = labels.copy()
    while islands:  # those that touch others alone wait for these
        known = []
        for island in islands:
            areas = {}
            for voxel, area in faces(island):
                if voxel not in inside:
                    label = int(changed[voxel]) if is_in(voxel) else background
                    areas[label] = areas.get(label, 0.0) + area
            if areas:
                most = max(areas.values())
                known.append((island, min((label for label, area in areas.items() if area > most - 1e-9),
                                          key=lambda label: (label != background, label))))
        for island, label in known:
            for voxel in island:
                changed[voxel] = label
            inside -= island
        islands = [island for island in islands if island & inside]
    return changed, counts


def without_cavities(labels, chosen, background, volume):
    changed, counts = labels.copy(), {label: (0, 0) for label in chosen}
    for piece in pieces(labels, background, TO_NEIGHBORS):
        around = {int(labels[voxel]) if is_in(voxel) else None for voxel, _ in faces(piece)}
        if len(around) == 1 and around <= set(chosen) and len(piece) * VOXEL <= volume + 1e-9:
            for voxel in piece:
                changed[voxel] = min(around)
            count, voxels = counts[min(around)]
            counts[min(around)] = (count + 1, voxels + len(piece))
    return changed, counts


def image_of(labels):
    image = vtkImageData()
    image.SetDimensions(labels.shape[::-1])
    image.SetSpacing(SPACING)
    image.GetPointData().SetScalars(numpy_to_vtk(labels.ravel(), deep=True))
    return image


def components(labels, label):
    """Of the surface of a label."""
    surfaces, single = vtkBoneSurfaces(), vtkPolyData()
    surfaces.SetInputData(image_of(labels))
    surfaces.Update()
    vtkBoneSurfaces.ExtractLabel(surfaces.GetOutput(), label, single)
    connected = vtkPolyDataConnectivityFilter()
    connected.SetInputData(single)
    connected.SetExtractionModeToAllRegions()
    connected.Update()
    return connected.GetNumberOfExtractedRegions()


def run(labels, chosen=(), background=0, islands=(0, 0, 0), cavity=0):
    filled = vtkBoneLabelPieces(background_label=background, cavity_volume=cavity)
    filled.island_size, filled.island_area, filled.island_volume = islands
    for label in chosen:
        filled.AddLabel(label)
    filled.SetInputData(image_of(labels))
    filled.Update()
    return vtk_to_numpy(filled.GetOutput().GetPointData().GetScalars()).reshape(SHAPE), filled


class LabelPieces(unittest.TestCase):
    def check(self, labels, chosen, background, limits, volume):
        """How many islands and cavities there are."""
        removed, islands = without_islands(labels, chosen, background, limits) if any(limits) else (labels, {})
        expected, cavities = without_cavities(removed, chosen, background, volume) if volume else (removed, {})
        found, counts = run(labels, chosen, background, limits, volume)
        np.testing.assert_array_equal(found, expected)
        for label in chosen:
            self.assertEqual((counts.GetNumberOfIslands(label), counts.GetNumberOfIslandVoxels(label)), islands.get(label, (0, 0)))
            self.assertEqual((counts.GetNumberOfCavities(label), counts.GetNumberOfCavityVoxels(label)), cavities.get(label, (0, 0)))
        return np.array([sum(count for count, _ in each.values()) for each in (islands, cavities)])

    def test_are_those_of_flood_fills(self):
        for limits, volume in (((1.4, 0, 0), 0), ((0, 4.0, 0), 0), ((0, 0, 3.5 * VOXEL), 0), ((0.8, 2.5, 2 * VOXEL), 3 * VOXEL)):
            total = sum(self.check(noise(seed), chosen, 0, limits, volume) for seed in (1, 2) for chosen in ([2, 5, 9], [5]))
            self.assertGreater(total[0], 20)

    def test_cavities_are_those_of_flood_fills(self):
        total = 0
        for seed in range(6):
            random = np.random.default_rng(seed)
            labels = np.where(random.random(SHAPE) < 0.06, 0, np.where(np.arange(SHAPE[2]) < 5, 2, 5)).astype(np.int16)
            for volume in (VOXEL, 100.0):
                total += self.check(labels, [2, 5], 0, (0, 0, 0), volume)[1] + self.check(labels, [5], 0, (0, 0, 0), volume)[1]
        self.assertGreater(total, 15)

    def test_are_the_components_of_surfaces(self):
        for seed in range(4):
            labels = (np.random.default_rng(seed).random(SHAPE) < 0.3 + 0.2 * seed).astype(np.int16)
            inside = len(list(pieces(labels, 1, ACROSS_FACES)))
            outside = len(list(pieces(np.pad(labels, 1), 0, TO_NEIGHBORS)))
            self.assertEqual(components(labels, 1), inside + outside - 1)
            solid, _ = run(labels, islands=(0, 0, 1e9), cavity=1e9)
            self.assertEqual(components(solid, 1), 1)

    def test_any_label_may_be_the_background(self):
        self.assertGreater(self.check(noise(3, background=5), [2, 9, 0], 5, (0, 0, 2.5 * VOXEL), 2 * VOXEL)[0], 10)

    def test_a_second_run_changes_nothing(self):
        limits = {"islands": (0, 0, 2.5 * VOXEL), "cavity": 2 * VOXEL}
        once, _ = run(noise(4), **limits)
        self.assertGreater(np.count_nonzero(once != noise(4)), 20)
        np.testing.assert_array_equal(run(once, **limits)[0], once)


if __name__ == "__main__":
    unittest.main()
