# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""numpy arrays in, numpy arrays out."""

from __future__ import annotations

import math
import os
import pathlib
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core, files
from .options import keyword, number, read, spell_sentences, switch, takes_options, thread_count
from .label_maps import extract_label
from .progress import Aborted, Progress, listener
from .report import Report
from .surfaces import Surface, edge_lengths_from, input_from, labels_from, surface_from, tolerances_from, warn
from .voxel_check import Comparison, VoxelChanges, with_label_map
from .voxels import SurfaceSource, VoxelGrid

if TYPE_CHECKING:
    import pyvista
    from typing_extensions import Unpack

    from ._keywords import ArrayOptions, SmoothOptions
    from .surfaces import SurfaceLike
    from .voxels import LabelMapLike


class Result:
    """What a run made of a surface. Lengths are millimeters, n points and m triangles are those of the result.

    Unpacks into its points and triangles: ``points, triangles = decimate(...)``.
    """

    points: NDArray  #: (n, 3), float32 or float64 as `precision` says
    triangles: NDArray[np.int32]  #: (m, 3), counter-clockwise seen from outside
    distance: NDArray[np.float64]  #: (n,), of each point to the input surface; empty without `measure`
    running_error: NDArray[np.float64]  #: (n,), mm, the largest distance recorded along the collapses into it
    point_count: NDArray[np.int32]  #: (n,), how many input points it represents
    error_bound: NDArray[np.float64]  #: (n,), proved around each point; empty without a proof
    input_distance: NDArray[np.float64]  #: of each input point to the result, with `measure_input_distances`
    input_error_bound: NDArray[np.float64]  #: the same of what is proved
    nearest_point: NDArray[np.int32]  #: (n,), input point nearest to each point; empty without `maps`
    nearest_triangle: NDArray[np.int32]  #: (n,), input triangle nearest to each point; empty without `maps`
    barycentric: NDArray[np.float64]  #: (n, 3), of the nearest position in that triangle; empty without `maps`
    triangle_at_centroid: NDArray[np.int32]  #: (m,), input triangle nearest to each centroid; empty without `maps`
    output_point: NDArray[np.int32]  #: of each input point: the point it became part of, or -1; empty without `maps`
    labels: NDArray  #: (m,), of each triangle, of the type of those given; empty without `labels`
    boundary_labels: NDArray[np.int64]  #: (m, 2), as of `LabelSurfaces`; empty if the input had none
    label_values: NDArray[np.int64]  #: those of boundary labels, ascending, and at the end the background; empty without
    grid: VoxelGrid | None  #: of the label map; None if it is not known
    stop_reason: _core.StopReason  #: why the run ended
    warnings: list[str]  #: defects of the input that were repaired, a sentence each
    report: Report  #: the report by name, "distance.output_to_input.max"; printed, it is a table
    units: dict[str, str]  #: of each entry of the report that has one
    report_as_json: str  #: the report as one text, as `Documentation/report.schema.json` describes it
    rejected_edits: int  #: how many edits were rejected, for all reasons together

    def __init__(self, outcome: dict, single: bool, source: SurfaceSource | None = None) -> None:
        for name in ("distance", "running_error", "point_count", "error_bound", "input_distance", "input_error_bound",
                     "nearest_point", "nearest_triangle", "barycentric", "triangle_at_centroid", "output_point",
                     "triangles", "warnings", "rejected_edits"):
            setattr(self, name, outcome[name])
        self.labels = np.empty(0, np.int64)
        self.points = outcome["points"].astype(np.float32) if single else outcome["points"]
        self.stop_reason = outcome["stop"]
        self.report = _named(outcome["entries"])
        self.units = self.report.units
        self.report_as_json = outcome["json"]
        self.report_of_surface = outcome["entries_of_surface"], outcome["json_of_surface"]  # as meshes carry it
        self.grid = source and source.grid
        self.label_values = source.label_values if source else np.empty(0, np.int64)
        self.boundary_labels = source.values_of(outcome["boundary_labels"]) if source else np.empty((0, 2), np.int64)

    def label(self, value: int) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Points and triangles of the closed surface of one label, as `extract_label` gives them. Needs boundary labels."""
        return extract_label(self.points, self.triangles, self.boundary_labels, value)

    def to_pyvista(self) -> pyvista.PolyData:
        """A mesh with the arrays of the result and its report, as `mesh.bone.decimate` returns it. `pyvista.wrap` takes no other
        types than its own; ``pyvista.PolyData.from_regular_faces(*result)`` is the surface alone."""
        import pyvista

        from .result_mesh import mesh_of
        return pyvista.wrap(mesh_of(self))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the surface: .vtp and .vtk with arrays and report, .stl, .ply and .obj without, as VTK writes them. Without VTK
        those of meshio, or binary STL.

        Raises OSError for an ending that is none of them, and if the file could not be written; ValueError if the format would
        round the points (give ``precision="Single"`` to the run).
        """
        target = pathlib.Path(path)
        if target.suffix.lower() in files.SINGLE and not np.array_equal(self.points, self.points.astype(np.float32)):
            raise ValueError(f"{target.suffix} holds single precision, and the points are double: run with precision=\"Single\"")
        if files.has("vtkmodules.vtkIOGeometry"):
            from .result_mesh import mesh_of
            files.write_vtk(mesh_of(self), target)
        else:
            files.write((self.points, self.triangles), target)

    @property
    def proved_error(self) -> float:
        """Proved upper bound of the distance to the input (or the reference), both directions and boundaries, mm; NaN without a
        proof."""
        return self.report.get("proof.upper", math.nan)

    @property
    def measured_error(self) -> float:
        """Largest distance by samples, both directions, mm: a lower bound of the true one; NaN without `measure`."""
        return max(self.report.get(f"distance.{direction}.max", math.nan) for direction in ("output_to_input", "input_to_output"))

    @property
    def proof_status(self) -> str:
        """Whether the largest error is proved: "not_requested", "proved", "violated", "undecided" or "aborted"."""
        return self.report.get("proof.status", "not_requested")

    def __iter__(self) -> Iterator[NDArray]:
        return iter((self.points, self.triangles))

    def __repr__(self) -> str:
        return (f"<bonedecimate.Result: {len(self.triangles)} of {self.report['input.triangles']} triangles, "
                f"{self.stop_reason.name}>")


class Certificate:
    """How far two surfaces are from each other, proved. Lengths are millimeters.

    Bounds are of the largest distance of both directions, without boundaries, which are in `report`.
    """

    status: str  #: "not_requested", "proved", "violated" or "undecided"
    lower: float  #: no less far apart than that
    upper: float  #: no farther apart than that
    reference_distance: NDArray[np.float64]  #: of each point of the reference, negative inside of the other surface
    result_distance: NDArray[np.float64]  #: of each point of the other surface, negative inside of the reference
    reference_side: NDArray[np.int8]  #: 1 outside, -1 inside, 0 on it or undecided
    result_side: NDArray[np.int8]
    report: Report  #: by name, "reference_to_result.upper"; printed, it is a table
    units: dict[str, str]
    report_as_json: str  #: the same as one text, as `Documentation/certificate.schema.json` describes it
    voxels: VoxelChanges | None  #: voxels of the label map to which the other surface gives another label; None without `label_map`

    def __init__(self, outcome: dict, voxels: VoxelChanges | None = None) -> None:
        self.voxels = voxels
        entries = outcome["entries"] + (voxels.entries() if voxels else [])
        self.report = _named(entries)
        self.units = self.report.units
        self.report_as_json = _core.report_json(entries)
        self.status, self.lower, self.upper = (self.report[name] for name in ("status", "lower", "upper"))
        for which in ("reference", "result"):
            side = outcome[which + "_side"]
            distance = outcome[which + "_distance"]
            setattr(self, which + "_side", side)
            setattr(self, which + "_distance", np.where(side < 0, -distance, distance))

    def __repr__(self) -> str:
        return f"<bonedecimate.Certificate: {self.lower:.6g} to {self.upper:.6g} mm, {self.status}>"


@takes_options("Arrays")
def decimate(
    points: ArrayLike | SurfaceLike,
    triangles: ArrayLike | None = None,
    *,
    tolerances: ArrayLike | None = None,
    labels: ArrayLike | None = None,
    label_map: LabelMapLike | VoxelGrid | None = None,
    boundary_labels: ArrayLike | None = None,
    reference: SurfaceLike | None = None,
    edge_lengths: ArrayLike | None = None,
    prepared: _core.PreparedSurface | None = None,
    progress: bool | Progress | None = None,
    profile: str | None = None,
    **options: Unpack[ArrayOptions],
) -> Result:
    """A surface with fewer triangles, and what that cost in millimeters. Repaired defects of the input are Python warnings.

    Parameters
    ----------
    points : (n, 3) array of float, mm; or a surface
        float32 points give float32 points (`precision`); everything is computed in float64. A surface, instead of points and
        triangles, is what `extract_surfaces`, `decimate` or `smooth` returned, a mesh, or a pair (points, triangles).
    triangles : (m, 3) array of int
        Counter-clockwise seen from outside the bone.
    tolerances : (n,) array of float, mm, optional
        How far the surface may move at each point: 0 keeps it unchanged, negative is no limit of its own.
    labels : (m,) array of whole numbers, optional
        Bone, fragment or segment of each triangle, kept by the result's: lines between them are simplified along themselves.
    label_map : `LabelMap`, image of VTK, SimpleITK or nibabel, `VoxelGrid`, or (nz, ny, nx) array of whole numbers, optional
        The segmentation of the surface, or its grid, which surfaces of `extract_surfaces` know: for `keep_voxels`, and to count
        changed voxels in the report. A warning says in how many voxels a map differs from the surface.
    boundary_labels : (m, 2) array of whole numbers, optional
        The labels on both sides of each triangle, the normal points to the second; 0 is the background. Needs a grid.
    reference : mesh, (points, triangles), or what `decimate` returned, optional
        What this surface was made from; ``max_error``, which must be given, is proved against it.
    edge_lengths : (n,) array of float, mm, optional
        The length that edges are to have at each point, at most ``edge_length``, which must be given.
    prepared : `PreparedSurface`, optional
        Keeps what runs with tolerances of 0 prepare, so that the next ones on the same surface run only regions that are new.
    progress : bool or function, optional
        True shows a bar (tqdm or rich). A function is called with the fraction done; False ends the run with the surface so far.
    profile : "planning", "print", "FEM" or "web", optional
        Options for a purpose (Documentation/reference/command-line.md); keywords win.
    **options

    Raises
    ------
    TypeError, ValueError
        An unknown option, values and arrays of a wrong type; arrays of a wrong shape, options out of range,
        surfaces that cannot be used: without triangles (an empty one, too), points that are not finite, indices out of range.
    RuntimeError
        The certificate contradicts the largest error: a defect of this software.
    KeyboardInterrupt
        Ctrl-C in the main thread ends the run.

    The bytes of the result are those of the C++ filter, for any number of threads. Other Python threads run meanwhile.
    """
    values = read(options, decimate, profile)
    return run_on_arrays(input_from(points, triangles), values, tolerances, labels, label_map, boundary_labels, reference, progress,
                         prepared, edge_lengths)


def run_on_arrays(surface: Surface, values: _core.Options, tolerances: ArrayLike | None = None, labels: ArrayLike | None = None,
                  label_map: LabelMapLike | VoxelGrid | None = None, boundary_labels: ArrayLike | None = None,
                  reference: SurfaceLike | None = None, progress: bool | Progress | None = None,
                  prepared: _core.PreparedSurface | None = None, edge_lengths: ArrayLike | None = None,
                  spell: Callable[[_core.OptionInfo], str] = keyword) -> Result:
    """The warnings name the caller of the caller.

    @param spell Of an option, as sentences call it.
    """
    if prepared is not None and not isinstance(prepared, _core.PreparedSurface):
        raise TypeError(f"prepared takes a PreparedSurface, not {type(prepared).__name__}")
    surface, voxels = with_label_map(surface, boundary_labels, label_map)
    source = surface.source
    given, named = labels_from(labels, len(surface.triangles))
    first = None if reference is None else surface_from(reference, "reference")
    withOrigins = bool(values.get("MakeMaps")) or named is not None
    limits = tolerances_from(tolerances, len(surface.points))
    lengths = edge_lengths_from(edge_lengths, len(surface.points), values)
    with listener(progress) as heard:
        outcome = _core.decimate(*surface[:2], values, surface.is_single, withOrigins, limits, None, first and first[:2], heard,
                                 named, source and source.to_core(), prepared, lengths,
                                 list((surface if first is None else first).left_out))
    spell_sentences(outcome, spell)
    outcome["warnings"] = surface.warnings + (first.warnings if first else []) + outcome["warnings"]
    raise_problems(outcome)
    if voxels is not None:
        outcome["warnings"] += voxels.differences(values.get("NumberOfThreads"))
    warn(outcome["warnings"], 3)
    result = Result(outcome, gives_single(values, surface.is_single), source)
    if given is not None:
        result.labels = given[result.triangle_at_centroid]
    return result


@takes_options("Arrays", "Smooth")
def smooth(
    points: ArrayLike | SurfaceLike,
    triangles: ArrayLike | None = None,
    distance: float | None = None,
    *,
    tolerances: ArrayLike | None = None,
    labels: ArrayLike | None = None,
    label_map: LabelMapLike | VoxelGrid | None = None,
    boundary_labels: ArrayLike | None = None,
    reference: SurfaceLike | None = None,
    progress: bool | Progress | None = None,
    **options: Unpack[SmoothOptions],
) -> Result:
    """The surface without the staircase of a segmentation: the same triangles, no point moved farther than a proved distance.

    Parameters
    ----------
    points, triangles, tolerances, labels, label_map, boundary_labels, reference, progress
        As `decimate` takes them.
    distance : float, mm, optional
        How far points may move. None: half of the smallest voxel spacing, which surfaces of `extract_surfaces` know, and which is
        found in the surface of a binary segmentation, or a third of a smaller ``max_error``; any other surface is left as it is,
        with a warning.
    **options

    Raises
    ------
    TypeError, ValueError, RuntimeError, KeyboardInterrupt
        As `decimate` does.
    """
    read(options, smooth)
    values = read({"mode": "Fast", "target_reduction": 0.0, **smoothing_of(distance), **options}, decimate)
    return run_on_arrays(input_from(points, triangles), values, tolerances, labels, label_map, boundary_labels, reference, progress)


def smoothing_of(distance: float | None) -> dict[str, float | bool]:
    """The options of smoothing for a distance, mm; None: automatic."""
    if distance is None:
        return {"auto_smooth": True}
    return {"smooth": number("distance", distance, 0, 1e30, "mm")}


def certify(
    reference: SurfaceLike,
    result: SurfaceLike,
    *,
    tolerance: float | None = None,
    tolerances: ArrayLike | None = None,
    label_map: LabelMapLike | None = None,
    tight_bounds: bool = True,
    relative_gap: float = 1e-6,
    boundaries: bool = True,
    means: bool = True,
    mean_precision: float = 5e-3,
    threads: int = 0,
    progress: bool | Progress | None = None,
) -> Certificate:
    """How far two surfaces are from each other, proved for every point of both and not sampled.

    Parameters
    ----------
    reference, result : mesh, (points, triangles), or what `decimate` or `extract_surfaces` returned
        Meshes are vtkPolyData or pyvista.PolyData; arrays are of shapes (n, 3), mm, and (m, 3), as `decimate` takes them.
    tolerance : float, mm, optional
        How far any point of one may be from the other, 0 to 1e30; ``status`` says whether that is proved.
    tolerances : (n,) array of float, mm, optional
        The same for each point of the reference, linear on its triangles; negative: no limit of its own.
    label_map : optional
        As `check_voxels` takes it: the result is voxelized and compared with it, ``voxels`` and the report have the counts.
    tight_bounds, relative_gap : bool, float
        Narrow the bounds even where the tolerance is proved (False needs a tolerance), to that largest difference as a ratio to the
        upper one, 1e-12 to 1.
    boundaries, means : bool
        Compare open boundaries curve to curve; estimate average and root mean square to the ratio `mean_precision`, 1e-4 to 1.
    threads, progress
        As `decimate` takes them.

    Raises
    ------
    TypeError
        Something that is no surface, values of a wrong type.
    ValueError
        Shapes, values out of range, surfaces without triangles, points that are not finite, indices out of range.
    Aborted
        The progress function returned False.
    """
    first, second = surface_from(reference, "reference"), surface_from(result, "result", label_map is not None)
    warn(first.warnings + second.warnings, 2)
    options = _with_tolerances(tolerance, tolerances, len(first.points), thread_count(threads))
    options.with_boundaries, options.relative_gap = switch("boundaries", boundaries), number("relative_gap", relative_gap, 1e-12, 1)
    _set_precision(options, tight_bounds, tolerance is not None or tolerances is not None, means, mean_precision)
    voxels = None if label_map is None else Comparison(second, label_map).changes(options.threads)
    with listener(progress) as heard:
        outcome = _core.certify(*first[:2], *second[:2], options, heard, list(first.left_out), list(second.left_out))
    _raise_comparison_problems(outcome)
    return Certificate(outcome, voxels)


def _set_precision(options: _core.CertificateOptions, tight_bounds: bool, has_tolerance: bool, means: bool,
                   mean_precision: float) -> None:
    """Raises ValueError for what has no effect."""
    options.tight_bounds, options.with_means = switch("tight_bounds", tight_bounds), switch("means", means)
    options.mean_precision = number("mean_precision", mean_precision, 1e-4, 1)
    if not options.tight_bounds and not has_tolerance:
        raise ValueError("tight_bounds=False has no effect; it needs tolerance or tolerances")
    if not options.with_means and options.mean_precision != certify.__kwdefaults__["mean_precision"]:
        raise ValueError("mean_precision has no effect with means=False")


def _raise_comparison_problems(outcome: dict) -> None:
    if outcome["status"] == _core.CertificateStatus.Aborted:
        raise Aborted("the comparison was stopped")
    if outcome["status"] != _core.CertificateStatus.Good:
        raise ValueError(outcome["problem"])


def _with_tolerances(tolerance: float | None, tolerances: ArrayLike | None, count: int,
                     threads: int) -> _core.CertificateOptions:
    """Options of a certificate with the tolerance of all points and those of each of the `count` points of the reference."""
    options = _core.CertificateOptions()
    options.threads, options.with_point_distances = threads, True
    if tolerance is not None:
        options.tolerance = number("tolerance", tolerance, 0, 1e30, "mm")
    if tolerances is not None:
        options.set_tolerances(tolerances_from(tolerances, count))
    return options


def gives_single(values: _core.Options, isSingle: bool) -> bool:
    """Whether the points of the result are single precision, as those of the input are or are not."""
    precision = values.text("OutputPointsPrecision")
    return precision == "Single" or (precision == "Default" and isSingle)


def check(outcome: dict, stacklevel: int) -> None:
    """Raises an error for a rejected input and for a contradicted result; emits all warnings. Sentences have keywords.

    @param stacklevel As of warnings.warn in the calling function: 2 is its caller.
    """
    spell_sentences(outcome)
    raise_problems(outcome)
    warn(outcome["warnings"], stacklevel + 1)


def raise_problems(outcome: dict) -> None:
    if outcome["status"] != _core.InputStatus.Good:
        raise ValueError(outcome["problem"])
    if outcome["contradiction"]:
        raise RuntimeError(outcome["contradiction"])


def _named(entries: list[tuple[str, str, int | float | str]]) -> Report:
    return Report({name: value for name, _, value in entries}, {name: unit for name, unit, _ in entries if unit})
