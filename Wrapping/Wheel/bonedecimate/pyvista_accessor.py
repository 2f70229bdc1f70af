# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""`mesh.bone` of PyVista, which imports this module by its entry point at the first use."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv
from numpy.typing import ArrayLike

from . import _core
from .arrays import Certificate, certify, check, smoothing_of
from .caps import close_boundaries
from .error_picture import plot_settings
from .images import label_map_of
from .label_arrays import BOUNDARY_LABELS, GRID_POINT, LABEL_VALUES, add_grid
from .label_maps import LabelSurfaces, extract_surfaces
from .label_pieces import PieceChanges, change_pieces
from .levels import Levels, open_levels, record_levels
from .options import number, read, require_keywords, switch, takes_options, unsupported, words
from .polydata import for_vtk, surface_of
from .progress import Aborted, Progress, listener
from .report import Report
from .run import endings, fill_input_copy, fill_output, run, set_report
from .surface_report import report_of
from .surfaces import edge_lengths_from, labels_from, surface_from, tolerances_from, warn
from .voxel_check import NO_GRID, Comparison, VoxelChanges, check_voxels, source_with
from .voxels import pairs_from

if TYPE_CHECKING:
    from typing_extensions import Never, Unpack

    from ._keywords import LevelOptions, MeshOptions
    from .surfaces import SurfaceLike
    from .voxels import LabelMapLike, VoxelGrid

ERROR = "SignedDistance"
SIDE = "Side"
# Of what is given as arrays and not by name.
TOLERANCES = "Tolerances"
EDGE_LENGTHS = "EdgeLengths"
LABELS = "Labels"


class MeshLevels:
    """`bonedecimate.Levels` with meshes instead of arrays; `levels` are those of arrays."""

    def __init__(self, levels: Levels) -> None:
        self.levels = levels

    def __repr__(self) -> str:
        return repr(self.levels)

    @property
    def marks(self) -> np.ndarray:
        """(k, 3), from fine to coarse: triangles, largest and mean distance, mm."""
        return self.levels.marks

    def at(self, *, triangles: int | None = None, error: float | None = None,
           on: SurfaceLike | None = None) -> pv.PolyData:
        """The level of so many triangles, or of so many mm: points and triangles, no arrays. As `bonedecimate.Levels.at`."""
        return pv.PolyData.from_regular_faces(*self.levels.at(triangles=triangles, error=error, on=on))

    @property
    def log(self) -> bytes:
        """For `mesh.bone.open_levels` of the same mesh."""
        return self.levels.log


def _flat(path: str, value: object) -> Iterator[tuple[str, object]]:
    """Each value of a report with the words of its name joined by dots."""
    if not isinstance(value, (dict, list)):
        yield path, value
        return
    for name, below in value.items() if isinstance(value, dict) else enumerate(value):
        yield from _flat(f"{path}.{name}" if path else str(name), below)


def _has_keywords_of(function: Callable):
    """Decorator: the signature shows what **keywords are passed on to."""
    def decorate(method: Callable) -> Callable:
        signature = inspect.signature(method)
        own = [each for each in signature.parameters.values() if each.kind is not inspect.Parameter.VAR_KEYWORD]
        others = [each for each in inspect.signature(function).parameters.values()
                  if each.kind is inspect.Parameter.KEYWORD_ONLY]
        method.__signature__ = signature.replace(parameters=own + others)
        return method
    return decorate


@pv.register_dataset_accessor("bone", pv.PolyData)
class BoneAccessor:
    """A bone surface, mm: triangles, strips or polygons."""

    def __init__(self, mesh: pv.PolyData) -> None:
        self._mesh = mesh

    @takes_options()
    def decimate(
        self,
        *misplaced: Never,
        tolerances: ArrayLike | None = None,
        labels: str | ArrayLike | None = None,
        label_map: LabelMapLike | VoxelGrid | None = None,
        boundary_labels: ArrayLike | None = None,
        edge_lengths: ArrayLike | None = None,
        reference: SurfaceLike | None = None,
        with_input: bool = False,
        progress_bar: bool | Progress = False,
        profile: str | None = None,
        **options: Unpack[MeshOptions],
    ) -> pv.PolyData | tuple[pv.PolyData, pv.PolyData]:
        """A smaller surface with the arrays of this one, its distance to it, and the report as field data. Repairs are warnings.

        Parameters
        ----------
        tolerances : (n_points,) array of float, mm, optional
            How far the surface may move at each point: 0 keeps it unchanged, negative is no limit of its own. The result has them as
            the point array Tolerances. An array that the mesh has is named by ``tolerance_array`` instead.
        labels : str or (n_cells,) array of whole numbers, optional
            Bone, fragment or segment of each cell, as the name of a cell or point array, or as an array that the result has as
            the cell array Labels: the lines between different ones are simplified only along themselves.
        label_map, boundary_labels : optional
            As `bonedecimate.decimate` takes them, pairs of labels for each cell. Meshes of ``image.bone.surfaces()`` know both.
        edge_lengths : (n_points,) array of float, mm, optional
            Of edges at each point, at most ``edge_length``, which must be given. ``edge_length_array`` names an array of the mesh.
        reference : mesh, (points, triangles), or what `bonedecimate.decimate` returned, optional
            The surface that this one was made from: ``max_error``, which must be given, is proved and measured against it.
        with_input : bool
            True returns a pair: the result, and a copy of this mesh with what ``measure_input_distances`` and ``maps`` add to it.
        progress_bar : bool or function
            True shows a bar (tqdm or rich); a function is called with the fraction done, and ends the run by False.
        profile : "planning", "print", "FEM" or "web", optional
            Options for a purpose (Documentation/reference/command-line.md); keywords win.
        **options

        Raises what `bonedecimate.decimate` does.
        """
        require_keywords(misplaced)
        if isinstance(labels, str):
            options, labels = {**options, "labels": labels}, None
        values = read(options, BoneAccessor.decimate, profile, tolerances is not None)
        mesh, voxels = _with_label_map(self._with_arrays(values, tolerances, labels, edge_lengths), label_map, boundary_labels)
        has_input = switch("with_input", with_input)
        if values.get("MeasureInputDistances") and not has_input:
            raise ValueError("measure_input_distances is about the points of the input, which with_input=True returns, too")
        with listener(progress_bar) as heard:
            outcome, surface = run(mesh, values, heard, reference)
        check(outcome, 2)
        differences = [] if voxels is None else voxels.differences(values.get("NumberOfThreads"))
        warn([*endings(outcome), *differences], 2)
        output = pv.PolyData()
        fill_output(outcome, surface, values, mesh, output)
        if not has_input:
            return output
        measured = pv.PolyData()
        fill_input_copy(outcome, values, mesh, measured)
        return output, measured

    def smooth(self, distance: float | None = None, **options) -> pv.PolyData:
        """The surface without the staircase of a segmentation, as `bonedecimate.smooth`: the same triangles, with the arrays of
        this one and the report as field data.

        >>> mesh.bone.smooth().plot()

        Parameters
        ----------
        distance : float, mm, optional
            How far points may move; None: by the voxel grid, which meshes of ``image.bone.surfaces()`` know, and which is found in
            the surface of a binary segmentation.
        **options
            As `decimate` takes them, without those that say how many triangles to remove.
        """
        without = unsupported("Smooth") | {"edge_lengths": unsupported("Smooth")["edge_length"], "profile": "profiles are for runs that remove triangles"}
        for key in options:
            if key in without:
                raise TypeError(f"there is no option '{key}' here: {without[key]}")
        return self.decimate(mode="Fast", target_reduction=0.0, **smoothing_of(distance), **options)

    def _with_arrays(self, values, tolerances: ArrayLike | None, labels: ArrayLike | None,
                     edge_lengths: ArrayLike | None) -> pv.PolyData:
        """The mesh, or a copy with the arrays that were given; the options then name them."""
        given = [array for array in (tolerances, labels, edge_lengths) if array is not None]
        mesh = self._mesh.copy(deep=False) if given else self._mesh
        for array, key, option in ((tolerances, TOLERANCES, "ToleranceArrayName"), (edge_lengths, EDGE_LENGTHS, "EdgeLengthArrayName")):
            if array is None:
                continue
            name = words(key, "_")
            if values.get(option):
                raise ValueError(f"{name} are an array, or {name[:-1]}_array names one: not both")
            is_length = key == EDGE_LENGTHS
            mesh.point_data[key] = (edge_lengths_from(array, mesh.n_points, values) if is_length else tolerances_from(array, mesh.n_points))
            values.set(option, key)
        if labels is not None:
            own = labels_from(labels, mesh.n_cells, "cells")[0]
            mesh.cell_data[LABELS] = own if own.dtype.kind == "b" else for_vtk(own)
            values.set("LabelArrayName", LABELS)
        return mesh

    def cap(self, loops: str = "planes", *, plane_tolerance: float = 0.01) -> pv.PolyData:
        """The surface with its open boundaries closed by triangles, as volume meshers and solvers need it.

        Caps are bone where the scan shows none: no error bound and no certificate includes them, unless the capped surface is what
        is decimated. Points and cells stay as they are; caps follow the polygons, and the cell array BoneCap is 1 for them. Their
        other cell arrays are those of a neighboring cell. Boundaries that stay open are a Python warning.

        >>> closed = mesh.bone.cap()
        >>> small = closed.bone.decimate(max_error=0.5, min_angle=20)

        Parameters
        ----------
        loops : "planes" or "all"
            planes: boundaries at planes where the surface ends, as at the edge of a scan. all: all others, too.
        plane_tolerance : float, mm
            How far points of a boundary may lie from its plane, and points of the surface beyond it. Range: 0 to 1e30.

        Raises
        ------
        TypeError, ValueError
            Values of a wrong type or out of range; triangle strips.
        """
        output = pv.PolyData()
        _, warnings = close_boundaries(self._mesh, loops, plane_tolerance, output)
        warn(warnings, 2)
        return output

    @takes_options("Arrays", "RecordedLevels")
    def levels(self, *, progress_bar: bool | Progress = False, **options: Unpack[LevelOptions]) -> MeshLevels:
        """One run, recorded, and every stage of it at once, as `bonedecimate.record_levels`.

        >>> levels = mesh.bone.levels(target_reduction=0.95)
        >>> levels.at(triangles=20000).plot()

        Parameters
        ----------
        progress_bar : bool or function
            As `decimate` takes it; so are the options, of the coarsest level, and what is raised.
        **options
        """
        read(options, BoneAccessor.levels)
        return MeshLevels(record_levels(self._mesh, progress=progress_bar, **options))

    def open_levels(self, log: bytes, *, threads: int = 0) -> MeshLevels:
        """The levels of a log again, with the very mesh that was recorded, as `bonedecimate.open_levels`."""
        return MeshLevels(open_levels(*self._arrays(), log, threads=threads))

    def _arrays(self) -> tuple[np.ndarray, np.ndarray]:
        surface = surface_of(self._mesh)
        warn(surface.warnings, 3)
        return surface.points.astype(np.float32) if surface.is_single else surface.points, surface.triangles

    @_has_keywords_of(certify)
    def certify(self, other: SurfaceLike, **keywords) -> Certificate:
        """How far this one (the reference) and another are from each other: `bonedecimate.certify` has the keywords."""
        return certify(self._mesh, other, **keywords)

    @_has_keywords_of(check_voxels)
    def check_voxels(self, label_map: LabelMapLike, **keywords) -> VoxelChanges:
        """Counts the voxels to which this surface gives another label than an image does: `bonedecimate.check_voxels` has the
        keywords.

        >>> mesh.bone.check_voxels(image).changed
        """
        return check_voxels(self._mesh, label_map, **keywords)

    @_has_keywords_of(certify)
    def distance_to(self, other: SurfaceLike, **keywords) -> pv.PolyData:
        """A copy with the arrays SignedDistance (mm, negative inside of the other) and Side at each point.

        Field data: the certificate, proved bounds of the largest distance in each direction and of the boundaries.
        """
        certificate = self.certify(other, **keywords)
        if certificate.stopped:
            raise Aborted("the comparison was stopped, and distances of points are missing")
        return self._with_distances(certificate)

    def _with_distances(self, certificate: Certificate) -> pv.PolyData:
        copy = self._mesh.copy()
        copy.point_data[ERROR] = certificate.reference_distance
        copy.point_data[SIDE] = certificate.reference_side
        units = certificate.units
        entries = [(name, units.get(name, ""), value) for name, value in certificate.report.items()]
        set_report({"entries": entries, "json": certificate.report_as_json}, "BoneDecimateCertificate",
                   "bonedecimate.certificate.", _core.certificate_key_figures(), copy)
        return copy

    def plot_error(self, other: SurfaceLike, *, largest: float | None = None, **keywords):
        """Shows this surface colored by its signed distance to the other, mm; keywords are those of ``plot``.

        Parameters
        ----------
        largest : float, mm, optional
            At which the colors end in both directions, 1e-9 to 1e30; by default the proved largest distance, which the picture names.
        """
        limit = None if largest is None else number("largest", largest, 1e-9, 1e30, "mm")
        certificate = self.certify(other)
        width = (keywords.get("window_size") or pv.global_theme.window_size)[0]
        settings = plot_settings(certificate, limit, width)
        return self._with_distances(certificate).plot(**{"scalars": ERROR, **settings, **keywords})

    @property
    def report(self) -> Report:
        """The report of the run that made this surface, by name ("output.triangles"); empty if there was none. Printed, it is a
        table.

        A proof belongs to one surface. If this one is not the one that was proved, because it was smoothed, scaled or clipped
        since, ``proof.sentence`` says so and the other entries of the proof are missing.
        """
        report = report_of(self._mesh)
        units = {name.replace("proof.if_unchanged.", "proof."): unit for name, unit in report.pop("units", {}).items()}
        return Report(dict(_flat("", report)), units)


@pv.register_dataset_accessor("bone", pv.ImageData)
class BoneImageAccessor:
    """A segmentation: an image with a whole number for each of its points."""

    def __init__(self, image: pv.ImageData) -> None:
        self._image = image

    if not TYPE_CHECKING:  # checkers would take any name for one that is there
        def __getattr__(self, name: str) -> Never:
            hint = f": first make its surfaces, image.bone.surfaces().bone.{name}" if hasattr(BoneAccessor, name) else ""
            raise AttributeError(f"an image has no bone.{name}{hint}")

    def surfaces(
        self,
        scalars: str | None = None,
        *,
        labels: Iterable[int] | None = None,
        background: int = 0,
        closed: bool = True,
        model_grid: str | float | Sequence[float] = "auto",
        threads: int = 0,
        progress_bar: bool | Progress = False,
    ) -> pv.PolyData:
        """The surfaces of all labels as one mesh, with walls between labels once; `bonedecimate.extract_surfaces` has the rest.

        The mesh has the cell array BoundaryLabels (the labels on both sides), the point array GridPoint and, as field data,
        LabelValues, VoxelGridOrigin, VoxelGridSpacing, VoxelGridDirection and VoxelGridDimensions. ``bone.decimate`` simplifies it
        with ``labels="BoundaryLabels"``.

        Parameters
        ----------
        scalars : str, optional
            Name of the point array of labels; by default the active scalars.
        labels, background, closed, model_grid, threads, progress_bar
            As `bonedecimate.extract_surfaces` takes them.
        """
        labels_of_voxels = label_map_of(self._image, scalars)
        return _mesh_of(extract_surfaces(labels_of_voxels, labels=labels, background=background, closed=closed,
                                         model_grid=model_grid, threads=threads, progress=progress_bar))

    @_has_keywords_of(change_pieces)
    def change_pieces(self, scalars: str | None = None, **keywords) -> tuple[pv.ImageData, dict[int, PieceChanges]]:
        """A copy without small islands and with small cavities filled, and what changed of each label:
        `bonedecimate.change_pieces` has the keywords.

        >>> cleaned, changes = image.bone.change_pieces(island_volume=50)
        >>> cleaned.bone.surfaces().plot()

        Parameters
        ----------
        scalars : str, optional
            As `surfaces` takes it.
        """
        changed, changes = change_pieces(label_map_of(self._image, scalars), **keywords)
        image = self._image.copy()
        image.point_data[scalars or image.GetPointData().GetScalars().GetName()] = changed.labels.ravel()
        return image, changes


def _mesh_of(found: LabelSurfaces) -> pv.PolyData:
    mesh = pv.PolyData.from_regular_faces(found.points, found.triangles)
    mesh.cell_data[BOUNDARY_LABELS] = found.boundary_labels
    mesh.point_data[GRID_POINT] = found.grid_points
    mesh.field_data[LABEL_VALUES] = found.label_values
    add_grid(found.grid, mesh)
    return mesh


def _with_label_map(mesh: pv.PolyData, label_map: LabelMapLike | VoxelGrid | None,
                    boundary_labels: ArrayLike | None) -> tuple[pv.PolyData, Comparison | None]:
    """The mesh, or a copy with the arrays of a label map, and its comparison with the map if that is given."""
    if label_map is None and boundary_labels is None:
        return mesh, None
    mesh = mesh.copy(deep=False)
    if boundary_labels is not None:
        mesh.cell_data[BOUNDARY_LABELS] = pairs_from(boundary_labels, mesh.n_cells)
        mesh.field_data.pop(LABEL_VALUES, None)
    source, labels = source_with(surface_from(mesh, "mesh", with_source=True), label_map)
    if source is None or source.grid is None:
        raise ValueError(NO_GRID)
    add_grid(source.grid, mesh)
    return mesh, None if labels is None else Comparison(surface_from(mesh, "mesh", with_source=True), labels)
