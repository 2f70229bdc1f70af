# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The module's logic on a MRML scene. Needs no window: the values come in a Request, the nodes from the caller."""

from dataclasses import replace

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from . import checks, preview, regions, segmentation
from .checks import AUTOMATIC, DecimationError
from .comparison import comparison_lines
from .engines import find_engine
from .surfaces import COLORS, polydata_of, report_of, set_colors, set_distance, set_report

PRESETS = {"quarter of a voxel": 0.25, "half a voxel": 0.5, "one voxel": 1.0}
NO_SMOOTHING, OWN_DISTANCE = "none", "own distance"
CAPS = ("boundaries at the edge of the scan", "all boundaries")
SMOOTHINGS = (NO_SMOOTHING, AUTOMATIC, *PRESETS, OWN_DISTANCE)


def presets(spacing):
    """Tolerances, mm, by name, from the scan's voxels: by their smallest side."""
    for side in spacing:
        checks.check_length("The scan's spacing", side)
    return {name: ratio * min(spacing) for name, ratio in PRESETS.items()}


def smoothing_of(choice, spacing, own=0.0):
    """What a Request takes, for one of SMOOTHINGS.

    @param spacing mm, of the voxels; only presets need it.
    @param own mm, for OWN_DISTANCE.
    """
    if choice in PRESETS:
        return presets(spacing)[choice]
    return {NO_SMOOTHING: 0.0, AUTOMATIC: AUTOMATIC, OWN_DISTANCE: own}[choice]


def spacing_of(source, volume=None):
    """mm, of the voxels of a segmentation, else of the scan."""
    if segmentation.has_label_map(source):
        return segmentation.spacing_of(source)
    if volume is None:
        raise DecimationError("Choose the scan first: its voxels say how large the presets are.")
    return volume.GetSpacing()


def surface_of(node, segment=None):
    """The polydata of a model node, or of a segment of a segmentation node that was imported from surfaces."""
    if node is None:
        raise DecimationError("Choose a model or a segmentation.")
    if segmentation.has_label_map(node):
        raise DecimationError("This segmentation has voxels: simplify its segments with decimate_segments(), then take their models.")
    if node.IsA("vtkMRMLSegmentationNode"):
        surface = vtk.vtkPolyData()
        segments = node.GetSegmentation()
        if segment is None and segments.GetNumberOfSegments() == 1:
            segment = segments.GetNthSegmentID(0)
        if segment is None:
            raise DecimationError("Choose one segment: this segmentation was imported from surfaces, which have no walls in common.")
        node.CreateClosedSurfaceRepresentation()
        node.GetClosedSurfaceRepresentation(segment, surface)
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


def paint_distance(name, surface):
    """mm of each point beyond the painted points."""
    painted = surface.GetPointData().GetArray(name)
    if painted is None:
        raise DecimationError(f"The surface has no point array {name!r}.")
    return regions.outside_of_paint(regions.points_of(surface), regions.vtk_to_numpy(painted))


def brush_distance(brush, points, to_node, radius):
    """mm of each point beyond what a region of interest or a list of points covers."""
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
    """Decimates nodes, and remembers how to undo it."""

    def __init__(self, scene, engine=None):
        self.scene, self._engine = scene, engine
        self._undo_steps = []  # functions that return the node that is there afterwards, or None
        self._preview_id = None

    @property
    def engine(self):
        self._engine = self._engine or find_engine()
        return self._engine

    def tolerances(self, request, node, surface):
        """mm at each point, or None without a brush."""
        if not isinstance(request.brush, str):
            at = self._tolerances_at(request, node)
            return None if at is None else at(regions.points_of(surface))
        return _by_distance(paint_distance(request.brush, surface), request)

    @staticmethod
    def _tolerances_at(request, node):
        """The same as a function of points (n, 3), for surfaces that are not there yet."""
        if request.brush is None:
            return None
        if isinstance(request.brush, str):
            raise DecimationError("Segments have no painted points: choose points or a region of interest.")
        to_node = world_to_node(node)
        return lambda points: _by_distance(brush_distance(request.brush, points, to_node, request.radius), request)

    def decimate(self, source, request, target=None, segment=None, progress=None):
        """A new model node, or the target with what it was kept for undo(). Returns node and statistics."""
        options = request.options(self.engine.table)
        surface = surface_of(source, segment)
        result = self.engine.decimate(surface, options, self.tolerances(request, source, surface), progress)
        target = self._node_for(source, target, "simplified")
        self._put(target, result)
        return target, statistics(report_of(result))

    def _node_for(self, source, target, what):
        """The target, or a new model node beside the source."""
        if target is None:
            target = self.scene.AddNewNodeByClass("vtkMRMLModelNode", f"{source.GetName()} {what}")
            if source.GetParentTransformNode() is not None:
                target.SetAndObserveTransformNodeID(source.GetTransformNodeID())
        return target

    def cap(self, source, loops=CAPS[0], target=None, segment=None):
        """A new model node, or the target, with the open boundaries of the source closed. Returns node and lines of text.

        @param loops One of CAPS.
        """
        if loops not in CAPS:
            raise DecimationError(f"Caps takes one of {', '.join(CAPS)}, not {loops!r}.")
        closed, notes = self.engine.cap(surface_of(source, segment), "all" if loops == CAPS[1] else "planes")
        is_cap = vtk_to_numpy(closed.GetCellData().GetArray("BoneCap"))
        target = self._node_for(source, target, "closed")
        self._put(target, closed)
        return target, [f"{int(is_cap.sum()):,} triangles of caps; they are outside of every tolerance", *notes]

    def compare(self, reference, result, tolerance=None, progress=None):
        """Proves how far two model nodes are from each other. Both get the distance of each point, if the engine measures it.

        @param tolerance mm; None: none.
        @return The nodes that have distances now, and lines of text.
        """
        nodes = (reference, result)
        surfaces = [surface_of(node) for node in nodes]
        if reference is result:
            raise DecimationError("Choose two models: this is one.")
        if reference.GetTransformNodeID() != result.GetTransformNodeID():
            raise DecimationError("The models are under different transforms: harden the transforms first.")
        if tolerance is not None:
            checks.check_length("The tolerance", tolerance)
        found = self.engine.compare(*surfaces, tolerance, progress)
        if found.distances is None:
            return [], comparison_lines(found.report, tolerance)
        for node, surface, distance in zip(nodes, surfaces, found.distances):
            measured = vtk.vtkPolyData()
            measured.ShallowCopy(surface)
            set_distance(measured, distance)
            node.SetAndObservePolyData(measured)
        return list(nodes), comparison_lines(found.report, tolerance)

    def renew_engine(self):
        """Looks for the engine again, after one was installed."""
        self._engine = None

    def decimate_segments(self, source, request, segments=None, as_models=True, progress=None):
        """Segments of a segmentation node, extracted from their voxels with walls in common and simplified together.

        @param segments IDs; None: those that are visible.
        @param as_models Makes a model of each segment, in a folder. False: the surfaces become the closed surface
               representation of the segmentation, until its voxels change.
        @return The model nodes, or the segmentation alone, and the statistics as lines of text.
        """
        options = request.options(self.engine.table)
        found = segmentation.label_maps_of(source, segments)
        surfaces, lines = [], list(found.notes)
        for label_map in found.maps:
            run = self.engine.decimate_segments(
                label_map, options, self._tolerances_at(request, source), progress, request.model_grid)
            names = [segment.name for segment in label_map.segments]
            if len(found.maps) > 1:
                lines.append(", ".join(names) + ":")
            lines += run.warnings + statistics(run.report, names)
            surfaces += [(segment, _segment_surface(run, value)) for value, segment in enumerate(label_map.segments, 1)]
        nodes = [source]
        if as_models:
            nodes, undo = segmentation.add_models(self.scene, source, surfaces)
        else:
            undo = segmentation.put_closed_surfaces(source, surfaces)
        self._undo_steps.append(undo)
        return nodes, lines

    def preview(self, source, request, segments=None, center=None, progress=None):
        """Shows the result for the whole bone, or for a part of a large one, as a temporary model.

        @param center mm in the coordinates of the source, of the part; None: chosen.
        @return Lines of text. The tolerance is not proved, and nothing is measured.
        """
        request.options(self.engine.table)  # raises before the scene is read
        if not segmentation.has_label_map(source):
            part, ratio = preview.part_of_surface(surface_of(source, (segments or [None])[0]), center=center)
            options = _preview_options(request, ratio, self.engine.table)
            result = self.engine.decimate(part, options, self.tolerances(request, source, part), progress, keep=False)
            lines = statistics(report_of(result))
        else:
            found = segmentation.label_maps_of(source, segments)
            part, ratio = preview.part_of_label_map(found.maps[0], center=center)  # of those that overlap, the first
            options = _preview_options(request, ratio, self.engine.table)
            run = self.engine.decimate_segments(
                part, options, self._tolerances_at(request, source), progress, request.model_grid)
            result = polydata_of(run.points, run.triangles)
            set_colors(result, np.array([segment.color for segment in part.segments])[run.sides[:, 0] - 1])
            lines = found.notes + run.warnings + statistics(run.report, [segment.name for segment in part.segments])
        self._show_preview(source, result)
        return [f"Preview of {100.0 * ratio:.0f} % of the surface:" if ratio < 1.0 else "Preview:", *lines]

    def _show_preview(self, source, surface):
        node = self.scene.GetNodeByID(self._preview_id) if self._preview_id else None
        if node is None:
            node = self.scene.AddNewNodeByClass("vtkMRMLModelNode", "Bone Decimator preview")
            node.SaveWithSceneOff()
            node.CreateDefaultDisplayNodes()
            node.GetDisplayNode().SaveWithSceneOff()
            self._preview_id = node.GetID()
        node.SetAndObserveTransformNodeID(source.GetTransformNodeID())
        node.SetAndObservePolyData(surface)
        display, has_colors = node.GetDisplayNode(), surface.GetCellData().HasArray(COLORS)
        if has_colors:
            display.SetActiveScalar(COLORS, vtk.vtkAssignAttribute.CELL_DATA)
            display.SetScalarRangeFlag(display.UseDirectMapping)
        display.SetScalarVisibility(bool(has_colors))

    def remove_preview(self):
        node = self.scene.GetNodeByID(self._preview_id) if self._preview_id else None
        if node is not None:
            self.scene.RemoveNode(node.GetDisplayNode())
            self.scene.RemoveNode(node)
        self._preview_id = None

    def record_levels(self, source, mode="Fast", ratio=0.05, segment=None):
        """For a slider: bonedecimate.Levels down to that ratio of the triangles."""
        if not self.engine.has_levels:
            raise DecimationError("Levels need the Python package bonedecimate.")
        checks.check_value("Mode", mode, self.engine.table.rows["Mode"])
        checks.check_ratio("The ratio of triangles", ratio)
        return self.engine.record_levels(surface_of(source, segment), {"mode": mode, "target-reduction": 1.0 - ratio})

    def show_level(self, levels, triangles, target):
        """Puts a level into a node; there is no undo, because the slider goes back."""
        checks.check_whole("The number of triangles", triangles, 1, checks.MOST_TRIANGLES)
        points, corners = levels.at(triangles=triangles)
        target.SetAndObservePolyData(polydata_of(points, corners))

    def _put(self, node, surface):
        old = vtk.vtkPolyData()
        if node.GetPolyData() is not None:
            old.ShallowCopy(node.GetPolyData())

        def restore():
            if old.GetNumberOfPoints() == 0:
                self.scene.RemoveNode(node)
                return None
            node.SetAndObservePolyData(old)
            return node

        self._undo_steps.append(restore)
        node.SetAndObservePolyData(surface)

    def release_memory(self):
        """Frees what was kept for further strokes of a brush; the next one takes as long as the first."""
        if self._engine is not None:
            self._engine.release()

    def can_undo(self):
        return bool(self._undo_steps)

    def undo(self):
        """Takes the last result back. Returns the node of the former surface; None if the nodes were new and are removed."""
        return self._undo_steps.pop()()


def _by_distance(outside, request):
    inner, outer = (0.0, request.tolerance) if request.keeps_brush else (request.tolerance, 0.0)
    return regions.tolerances(outside, inner, outer, request.feather)


def _preview_options(request, ratio, table):
    """For that ratio of the surface: the tolerance is not proved, and nothing is measured."""
    part = replace(request, triangles=max(4, int(ratio * request.triangles)) if request.triangles else 0)
    options = {**part.options(table), "measure": False}
    if table.has_effect(table.rows["ProveResult"], options):
        options["prove"] = False
    return options


def _segment_surface(run, value):
    points, triangles, origins = run.segment(value)
    surface = polydata_of(points, triangles)
    if len(run.distance):
        set_distance(surface, run.distance[origins])
    set_report(surface, run.report)
    return surface


def statistics(found, names=()):
    """The statistics of a run as lines of text.

    @param found Its report.
    @param names Of the segments with the values 1, 2, ... of the label map.
    """
    before, after, proof = found["input"], found["output"], found.get("proof", {})
    lines = [f"{before['triangles']:,.0f} -> {after['triangles']:,.0f} triangles",
             f"{before['components'] + found.get('pruned', {}).get('components', 0):,.0f} -> {after['components']:,.0f} fragments"]
    if "largest_displacement" in found.get("smoothing", {}):
        moved = found["smoothing"]
        lines.append(f"smoothing moved points by {moved['largest_displacement']:.4f} mm at most, {moved['rms_displacement']:.4f} mm RMS")
        if moved.get("sharp_points", 0) > 0:
            lines.append(f"{moved['sharp_points']:,.0f} points on edges that were kept sharp")
    if "sentence" in proof:
        lines.append(("proved " if proof.get("status") == "proved" else "") + proof["sentence"])
    if "distance" in found:
        lines.append(f"average distance {found['distance']['input_to_output']['mean']:.4f} mm")
    return lines + _voxel_lines(found.get("voxels"), names)


def _voxel_lines(voxels, names):
    if voxels is None:
        return []
    counts = [(name, voxels[f"of_{value}"]) for value, name in enumerate(names, 1) if f"of_{value}" in voxels]
    return [f"{voxels['changed']:,} voxels changed (voxels {'kept' if voxels['guard'] == 'on' else 'not kept'})",
            *(f"{name}: {of['lost']:,} voxels lost, {of['gained']:,} gained, of {of['voxels']:,}" for name, of in counts)]
