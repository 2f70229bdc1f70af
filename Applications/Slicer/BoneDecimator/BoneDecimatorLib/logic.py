# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The module's logic on a MRML scene. Needs no window: the values come in a Request, the nodes from the caller."""

import json
from dataclasses import dataclass, field

import numpy as np
import vtk

from . import checks, regions
from .checks import DecimationError
from .engines import find_engine

PRESETS = {"quarter of a voxel": 0.25, "half a voxel": 0.5, "one voxel": 1.0}


@dataclass
class Request:
    """The values of the panel. Lengths are millimeters."""

    tolerance: float = 0.2  # proved; 0: none
    triangles: int = 0  # 0: as few as the tolerance allows
    mode: str = "Balanced"
    intersection_guard: bool = True
    brush: object = None  # a markups node of points, a ROI node, or the name of a painted point array; None: everywhere
    keeps_brush: bool = False  # the brush says what stays, not what is simplified
    radius: float = 10.0  # round the points of a brush
    feather: float = 2.0  # over which the tolerance goes from one value to the other
    extra: dict = field(default_factory=dict)  # more flags of the program

    def check(self):
        """Raises DecimationError with a sentence about the first value that is wrong."""
        checks.check_length("The tolerance", self.tolerance)
        checks.check_whole("The number of triangles", self.triangles, 0, checks.MOST_TRIANGLES)
        checks.check_mode(self.mode)
        checks.check_length("The radius", self.radius)
        checks.check_length("The feather", self.feather)
        if self.tolerance <= 0.0 and self.triangles <= 0:
            raise DecimationError("Give a tolerance or a number of triangles.")
        if self.brush is not None and self.tolerance <= 0.0:
            raise DecimationError("A brush needs a tolerance.")

    def options(self):
        """Flags of the program without dashes."""
        self.check()
        options = {"mode": self.mode}
        if self.tolerance > 0.0:
            options["max-error"] = self.tolerance
            if self.mode != "Thesis":
                options["intersection-guard"] = self.intersection_guard
        if self.triangles > 0:
            options["target-triangles"] = self.triangles
        return {**options, **self.extra}


def presets(spacing):
    """Tolerances, mm, by name, from the scan's voxels: by their smallest side."""
    for side in spacing:
        checks.check_length("The scan's spacing", side)
    return {name: ratio * min(spacing) for name, ratio in PRESETS.items()}


def surface_of(node, segment=None):
    """The polydata of a model node, or of a segment of a segmentation node."""
    if node is None:
        raise DecimationError("Choose a model or a segment.")
    if node.IsA("vtkMRMLSegmentationNode"):
        surface = vtk.vtkPolyData()
        segmentation = node.GetSegmentation()
        if segment is None and segmentation.GetNumberOfSegments() == 1:
            segment = segmentation.GetNthSegmentID(0)
        node.CreateClosedSurfaceRepresentation()
        node.GetClosedSurfaceRepresentation(segment or "", surface)
    else:
        surface = node.GetPolyData()
    if surface is None or surface.GetNumberOfPolys() + surface.GetNumberOfStrips() == 0:
        raise DecimationError("There is no surface in it.")
    return surface


def world_to_node(node):
    """(4, 4): from the world, in which ROI and points are, to the node of the surface."""
    matrix = vtk.vtkMatrix4x4()
    if node.GetParentTransformNode() is not None:
        node.GetParentTransformNode().GetMatrixTransformToWorld(matrix)
        matrix.Invert()
    return _array(matrix)


def brush_distance(brush, surface, to_node, radius):
    """mm of each point beyond what the brush covers."""
    points = regions.points_of(surface)
    if isinstance(brush, str):
        painted = surface.GetPointData().GetArray(brush)
        if painted is None:
            raise DecimationError(f"The surface has no point array {brush!r}.")
        return regions.outside_of_paint(points, regions.vtk_to_numpy(painted))
    if brush.IsA("vtkMRMLMarkupsROINode"):
        to_box = _array(brush.GetObjectToWorldMatrix())
        size = np.array(brush.GetSize())
        node_to_box = np.linalg.inv(to_box) @ np.linalg.inv(to_node)
        return regions.outside_of_box(points, node_to_box, size / 2)
    marks = np.array([brush.GetNthControlPointPositionWorld(i) for i in range(brush.GetNumberOfControlPoints())])
    if len(marks) == 0:
        raise DecimationError("The brush has no points yet.")
    return regions.outside_of_markups(points, marks @ to_node[:3, :3].T + to_node[:3, 3], radius)


def _array(matrix):
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


class BoneDecimatorLogic:
    """Decimates nodes and keeps their former surfaces for undo()."""

    def __init__(self, scene, engine=None):
        self.scene, self._engine = scene, engine
        self._before = []  # (node, polydata) to go back to

    @property
    def engine(self):
        self._engine = self._engine or find_engine()
        return self._engine

    def tolerances(self, request, node, surface):
        """mm at each point, or None without a brush."""
        if request.brush is None:
            return None
        outside = brush_distance(request.brush, surface, world_to_node(node), request.radius)
        inner, outer = (0.0, request.tolerance) if request.keeps_brush else (request.tolerance, 0.0)
        return regions.tolerances(outside, inner, outer, request.feather)

    def decimate(self, source, request, target=None, segment=None, progress=None):
        """A new model node, or the target with what it was kept for undo(). Returns node and statistics."""
        request.check()
        surface = surface_of(source, segment)
        result = self.engine.decimate(surface, request.options(), self.tolerances(request, source, surface), progress)
        if target is None:
            target = self.scene.AddNewNodeByClass("vtkMRMLModelNode", f"{source.GetName()} simplified")
            if source.GetParentTransformNode() is not None:
                target.SetAndObserveTransformNodeID(source.GetTransformNodeID())
        self._put(target, result)
        return target, statistics(result)

    def record_levels(self, source, mode="Fast", ratio=0.05, segment=None):
        """For a slider: bonedecimate.Levels down to that ratio of the triangles."""
        if not self.engine.has_levels:
            raise DecimationError("Levels need the Python package bonedecimate.")
        checks.check_mode(mode)
        checks.check_ratio("The ratio of triangles", ratio)
        return self.engine.record_levels(surface_of(source, segment), {"mode": mode, "target-reduction": 1.0 - ratio})

    def show_level(self, levels, triangles, target):
        """Puts a level into a node; there is no undo, because the slider goes back."""
        checks.check_whole("The number of triangles", triangles, 1, checks.MOST_TRIANGLES)
        points, corners = levels.at(triangles=triangles)
        target.SetAndObservePolyData(_polydata(points, corners))

    def _put(self, node, surface):
        old = vtk.vtkPolyData()
        if node.GetPolyData() is not None:
            old.ShallowCopy(node.GetPolyData())
        self._before.append((node, old))
        node.SetAndObservePolyData(surface)

    def can_undo(self):
        return bool(self._before)

    def undo(self):
        """Restores the surface of the last decimated node; a node that was new is removed."""
        node, surface = self._before.pop()
        if surface.GetNumberOfPoints() == 0:
            self.scene.RemoveNode(node)
            return None
        node.SetAndObservePolyData(surface)
        return node


def _polydata(points, corners):
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    surface = vtk.vtkPolyData()
    positions = vtk.vtkPoints()
    positions.SetData(numpy_to_vtk(points, deep=True))
    cells = vtk.vtkCellArray()
    offsets = np.arange(0, 3 * len(corners) + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(corners.astype(np.int64).ravel(), deep=True))
    surface.SetPoints(positions)
    surface.SetPolys(cells)
    return surface


def report(surface):
    """The report of the run as nested dictionaries, from the field data; empty if there is none."""
    array = surface.GetFieldData().GetAbstractArray("BoneDecimateReport")
    return json.loads(array.GetValue(0)) if array is not None and array.GetNumberOfValues() > 0 else {}


def statistics(surface):
    """The statistics of a run as lines of text."""
    found = report(surface)
    before, after, proof = found["input"], found["output"], found.get("proof", {})
    lines = [f"{before['triangles']:,.0f} -> {after['triangles']:,.0f} triangles",
             f"{before['components']:,.0f} -> {after['components']:,.0f} fragments"]
    if proof.get("status") == "proved":
        # Rounded up, so that the number shown is proved.
        lines.append(f"proved: no point is farther away than {np.ceil(proof['upper'] * 1e4) / 1e4:.4f} mm")
    if "distance" in found:
        lines.append(f"average distance {found['distance']['input_to_output']['mean']:.4f} mm")
    return lines
