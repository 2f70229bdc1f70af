# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""numpy arrays in, numpy arrays out."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy.typing import ArrayLike

from . import _core
from .options import number, read, spell_sentences, switch, takes_options, thread_count
from .progress import Progress, listener
from .results import Certificate, Result
from .surfaces import Surface, edge_lengths_from, input_from, labels_from, surface_from, tolerances_from, warn
from .voxel_check import Comparison, with_label_map
from .voxels import VoxelGrid

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import ArrayOptions, SmoothOptions
    from .surfaces import SurfaceLike
    from .voxels import LabelMapLike


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
    values = read(options, decimate, profile, tolerances is not None)
    return run_on_arrays(input_from(points, triangles), values, tolerances, labels, label_map, boundary_labels, reference, progress,
                         prepared, edge_lengths)


def run_on_arrays(surface: Surface, values: _core.Options, tolerances: ArrayLike | None = None, labels: ArrayLike | None = None,
                  label_map: LabelMapLike | VoxelGrid | None = None, boundary_labels: ArrayLike | None = None,
                  reference: SurfaceLike | None = None, progress: bool | Progress | None = None,
                  prepared: _core.PreparedSurface | None = None, edge_lengths: ArrayLike | None = None) -> Result:
    """The warnings name the caller of the caller."""
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
    spell_sentences(outcome)
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
    read(options, smooth, removes_nothing=True)  # max_error=0 is no mistake
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
    surfaces: bool = False,
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
    surfaces : bool
        The report also has the triangles, components, boundary edges, area, volume and intersecting pairs of triangles of each,
        and ``missing.*``: components of the reference that the result lacks. Warnings name these and what else bounds do not tell.
    threads, progress
        As `decimate` takes them.

    Raises
    ------
    TypeError
        Something that is no surface, values of a wrong type.
    ValueError
        Shapes, values out of range, surfaces without triangles, points that are not finite, indices out of range.

    If the progress function returns False, the certificate has the bounds proved until then, and its ``stopped`` is True.
    """
    first, second = surface_from(reference, "reference"), surface_from(result, "result", label_map is not None)
    warn(first.warnings + second.warnings, 2)
    options = _with_tolerances(tolerance, tolerances, len(first.points), thread_count(threads))
    options.with_boundaries, options.relative_gap = switch("boundaries", boundaries), number("relative_gap", relative_gap, 1e-12, 1)
    _set_precision(options, tight_bounds, tolerance is not None or tolerances is not None, means, mean_precision)
    has_figures = switch("surfaces", surfaces)
    voxels = None if label_map is None else Comparison(second, label_map).changes(options.threads)
    with listener(progress) as heard:
        outcome = _core.certify(*first[:2], *second[:2], options, has_figures, heard, list(first.left_out), list(second.left_out))
    _raise_comparison_problems(outcome)
    warn(outcome["warnings"], 2)
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
    if outcome["status"] not in (_core.CertificateStatus.Good, _core.CertificateStatus.Aborted):
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
