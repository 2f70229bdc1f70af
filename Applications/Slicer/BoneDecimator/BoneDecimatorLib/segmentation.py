# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Segmentation nodes: the label maps of their segments as arrays, and surfaces back into the scene."""

from dataclasses import dataclass, field

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from .checks import DecimationError

LABEL_MAP, CLOSED_SURFACE = "Binary labelmap", "Closed surface"  # Slicer's names of representations
MOST_DIFFERENCE = 1e-3  # voxels, between grids that are the same but for rounding


@dataclass(frozen=True)
class Segment:
    id: str
    name: str
    color: tuple


@dataclass
class LabelMap:
    """Segments that do not overlap, on one voxel grid."""

    voxels: np.ndarray  # (nz, ny, nx); 0 is the background, i + 1 is segments[i]
    segments: list
    to_node: np.ndarray  # (4, 4), from the voxel x, y, z to mm in the coordinates of the segmentation node

    @property
    def spacing(self):
        return np.linalg.norm(self.to_node[:3, :3], axis=0)

    @property
    def direction(self):
        return self.to_node[:3, :3] / self.spacing

    @property
    def origin(self):
        return self.to_node[:3, 3]

    def part(self, first, last):
        """The voxels from `first` up to but without `last`, both x, y, z."""
        slices = tuple(slice(a, b) for a, b in zip(first[::-1], last[::-1]))
        return LabelMap(self.voxels[slices], self.segments, _shifted(self.to_node, first))


@dataclass
class LabelMaps:
    """The chosen segments in as few label maps as their overlaps allow, and what the user should know of it."""

    maps: list = field(default_factory=list)
    notes: list = field(default_factory=list)


def has_label_map(node):
    """Whether segments of the node were drawn on voxels, and not imported as surfaces."""
    return (node is not None and node.IsA("vtkMRMLSegmentationNode")
            and node.GetSegmentation().GetSourceRepresentationName() == LABEL_MAP)


def chosen_ids(node, ids=None):
    """Of the segments in the order of the node; without a choice, those that are visible."""
    segmentation, display = node.GetSegmentation(), node.GetDisplayNode()
    all_ids = [segmentation.GetNthSegmentID(i) for i in range(segmentation.GetNumberOfSegments())]
    unknown = set(ids or ()) - set(all_ids)
    if unknown:
        raise DecimationError(f"The segmentation has no segment {min(unknown)!r}.")
    found = [each for each in all_ids if (each in ids if ids else display is None or display.GetSegmentVisibility(each))]
    if not found:
        raise DecimationError("Choose at least one segment: none is visible.")
    return found


def spacing_of(node):
    """mm along the axes of the voxels."""
    for each in chosen_ids(node):
        image = node.GetSegmentation().GetSegment(each).GetRepresentation(LABEL_MAP)
        if image is not None:
            return image.GetSpacing()
    raise DecimationError("The segments have no voxels.")


def label_maps_of(node, ids=None):
    """The label maps of the segments. Segments that overlap are in different maps, so they have no walls in common.

    @param ids Of segments; None: those that are visible.
    """
    found = LabelMaps()
    masks = []
    for each in chosen_ids(node, ids):
        mask = _Mask(each, node.GetSegmentation().GetSegment(each))
        if mask.is_empty:
            found.notes.append(f"{mask.segment.name} has no voxels.")
        else:
            masks.append(mask)
    if not masks:
        raise DecimationError("The chosen segments have no voxels.")
    for mask in masks[1:]:
        mask.move_to_grid_of(masks[0])
    first = np.min([mask.first for mask in masks], axis=0)
    last = np.max([mask.last for mask in masks], axis=0)
    for mask in masks:
        _add(mask, first, last, found)
    return found


class _Mask:
    """The voxels of a segment, cut to their bounding box."""

    def __init__(self, segment_id, segment):
        self.segment = Segment(segment_id, segment.GetName(), segment.GetColor())
        image = segment.GetRepresentation(LABEL_MAP)
        scalars = image.GetPointData().GetScalars() if image is not None else None
        self.is_empty = scalars is None or scalars.GetNumberOfTuples() == 0
        if self.is_empty:
            return
        mask = vtk_to_numpy(scalars).reshape(image.GetDimensions()[::-1]) == segment.GetLabelValue()
        inside = [np.flatnonzero(mask.any(axis=axes)) for axes in ((0, 1), (0, 2), (1, 2))]  # x, y, z
        self.is_empty = not mask.any()
        if self.is_empty:
            return
        low, high = (np.array([each[end] for each in inside]) for end in (0, -1))
        self.voxels = mask[low[2]:high[2] + 1, low[1]:high[1] + 1, low[0]:high[0] + 1]
        start = np.array(image.GetExtent()[::2])
        self.first, self.last = start + low, start + high + 1
        matrix = vtk.vtkMatrix4x4()
        image.GetImageToWorldMatrix(matrix)
        self.to_node = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])

    def move_to_grid_of(self, other):
        """Counts voxels as the other segment does."""
        between = np.linalg.inv(other.to_node) @ self.to_node
        shift = np.rint(between[:3, 3]).astype(int)
        # Axes that differ by little differ by more at the far end.
        reach = max(1, np.abs([self.first, self.last]).max())
        if (np.abs(between[:3, :3] - np.eye(3)).max() * reach > MOST_DIFFERENCE
                or np.abs(between[:3, 3] - shift).max() > MOST_DIFFERENCE):
            raise DecimationError(f"{self.segment.name} has another voxel grid than {other.segment.name}: give the segmentation "
                                  "one geometry in the Segment Editor, or run the segments one by one.")
        self.first, self.last, self.to_node = self.first + shift, self.last + shift, other.to_node


def _add(mask, first, last, found):
    """Puts a segment into the first label map where its voxels are free."""
    low, high = (mask.first - first)[::-1], (mask.last - first)[::-1]
    box = tuple(slice(a, b) for a, b in zip(low, high))
    target = None
    for each in found.maps:
        taken = each.voxels[box][mask.voxels]
        counts = np.bincount(taken[taken > 0], minlength=len(each.segments) + 1)
        for value in np.flatnonzero(counts):
            found.notes.append(f"{mask.segment.name} and {each.segments[value - 1].name} overlap in {counts[value]:,} voxels: "
                               "they have no wall in common and may intersect.")
        if target is None and not counts.any():
            target = each
    if target is None:
        target = LabelMap(np.zeros((last - first)[::-1], np.uint16), [], _shifted(mask.to_node, first))
        found.maps.append(target)
    target.segments.append(mask.segment)
    target.voxels[box][mask.voxels] = len(target.segments)


def _shifted(to_node, first):
    moved = to_node.copy()
    moved[:3, 3] += to_node[:3, :3] @ first
    return moved


def add_models(scene, node, surfaces):
    """A model of each segment, with its name and color, in a folder of the subject hierarchy.

    @param surfaces Pairs of Segment and vtkPolyData.
    @return The model nodes, and a function that removes them and the folder.
    """
    tree = scene.GetSubjectHierarchyNode()
    folder = tree.CreateFolderItem(tree.GetSceneItemID(), f"{node.GetName()} simplified")
    models = []
    for segment, surface in surfaces:
        model = scene.AddNewNodeByClass("vtkMRMLModelNode", segment.name)
        model.SetAndObservePolyData(surface)
        model.CreateDefaultDisplayNodes()
        model.GetDisplayNode().SetColor(*segment.color)
        model.SetAndObserveTransformNodeID(node.GetTransformNodeID())
        tree.SetItemParent(tree.GetItemByDataNode(model) or tree.CreateItem(folder, model), folder)
        models.append(model)

    def remove():
        for model in models:
            scene.RemoveNode(model.GetDisplayNode())
            scene.RemoveNode(model)
        tree.RemoveItem(folder)

    return models, remove


def put_closed_surfaces(node, surfaces):
    """The surfaces become the closed surface representation, which Slicer shows in 3D and exports.

    @return A function that puts the former ones back.
    """
    segmentation = node.GetSegmentation()
    if len(surfaces) < segmentation.GetNumberOfSegments() and not node.CreateClosedSurfaceRepresentation():
        raise DecimationError("Slicer could not make the closed surfaces of the other segments.")
    before = []
    for segment, surface in surfaces:
        owner = segmentation.GetSegment(segment.id)
        before.append((owner, owner.GetRepresentation(CLOSED_SURFACE)))
        owner.AddRepresentation(CLOSED_SURFACE, surface)
    node.Modified()

    def restore():
        for owner, surface in before:
            if surface is None:
                owner.RemoveRepresentation(CLOSED_SURFACE)
            else:
                owner.AddRepresentation(CLOSED_SURFACE, surface)
        node.Modified()

    return restore
