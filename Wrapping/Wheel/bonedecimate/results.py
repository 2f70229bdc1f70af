# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What `decimate`, `smooth` and `certify` return."""

from __future__ import annotations

import math
import os
import pathlib
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from . import _core, files
from .label_maps import extract_label
from .report import Report, rounded_text
from .voxel_check import VoxelChanges
from .voxels import SurfaceSource, VoxelGrid

if TYPE_CHECKING:
    import pyvista


class Result:
    """What a run made of a surface. Lengths are millimeters, n points and m triangles are those of the result.

    Unpacks into its points and triangles: ``points, triangles = decimate(...)``.
    """

    points: NDArray  #: (n, 3), read-only, float32 or float64 as `precision` says
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
        for array in (self.points, self.triangles):
            array.flags.writeable = False  # what is proved of them stays true
        self.stop_reason = outcome["stop"]
        self.report = _named(outcome["entries"])
        self.units = self.report.units
        self.report_as_json = outcome["json"]
        self.report_of_surface = outcome["entries_of_surface"], outcome["json_of_surface"]  # as meshes carry it
        self.grid = source and source.grid
        self.label_values = source.label_values.copy() if source else np.empty(0, np.int64)
        self.boundary_labels = source.values_of(outcome["boundary_labels"]) if source else np.empty((0, 2), np.int64)

    def label(self, value: int) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Points and triangles of the closed surface of one label, as `extract_label` gives them. Needs boundary labels.
        Raises ValueError if there is none."""
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
        """Whether the largest error is proved: "proved", "violated", "undecided", "aborted" or "no_proof"."""
        return self.report.get("proof.status", "no_proof")

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
    stopped: bool  #: the progress function returned False: bounds and status are those proved until then, the rest may be missing
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
        self.stopped = "stopped" in self.report
        for which in ("reference", "result"):
            side = outcome[which + "_side"]
            distance = outcome[which + "_distance"]
            setattr(self, which + "_side", side)
            setattr(self, which + "_distance", np.where(side < 0, -distance, distance))

    def __bool__(self) -> bool:
        raise TypeError('a certificate is neither true nor false: compare certificate.status == "proved", or certificate.upper')

    def __repr__(self) -> str:
        status = "proved; no tolerance to compare with" if self.status == "not_requested" else self.status
        bounds = f"{rounded_text(self.lower, 'lower')} to {rounded_text(self.upper, 'upper')} mm"
        return f"<bonedecimate.Certificate: {bounds}, {status}{', stopped' * self.stopped}>"


def _named(entries: list[tuple[str, str, int | float | str]]) -> Report:
    return Report({name: value for name, _, value in entries}, {name: unit for name, unit, _ in entries if unit})
