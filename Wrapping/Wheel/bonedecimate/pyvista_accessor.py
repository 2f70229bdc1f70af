# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""`mesh.bone` of PyVista, which finds this module by its entry point when somebody first asks for it."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .arrays import Certificate, certify, check
from .levels import Levels, record_levels
from .options import read
from .polydata import surface_of
from .progress import Progress, listener
from .run import add_entries, fill_output, run

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import AllOptions, ArrayOptions

ERROR = "SignedDistance"
SIDE = "Side"


class MeshLevels:
    """`bonedecimate.Levels` with meshes in place of arrays; `levels` is what is behind it."""

    def __init__(self, levels: Levels) -> None:
        self.levels = levels

    @property
    def marks(self) -> np.ndarray:
        """(k, 3), from fine to coarse: triangles, largest and mean distance, mm."""
        return self.levels.marks

    def at(self, *, triangles: int | None = None, error: float | None = None) -> pv.PolyData:
        """The level of so many triangles, or of so many mm: points and triangles, no arrays."""
        return pv.PolyData.from_regular_faces(*self.levels.at(triangles=triangles, error=error))


@pv.register_dataset_accessor("bone", pv.PolyData)
class BoneAccessor:
    """A bone surface, mm: triangles, strips or polygons."""

    def __init__(self, mesh: pv.PolyData) -> None:
        self._mesh = mesh

    def decimate(self, *, progress_bar: bool | Progress = False, **options: Unpack[AllOptions]) -> pv.PolyData:
        """A smaller surface with the arrays of this one, its distance to this one, and the report as field data.

        Parameters
        ----------
        progress_bar : bool or function
            True shows a bar (tqdm or rich); a function is called with the fraction done, and ends the run by False.
        **options
            Documentation/options.md as keywords: ``max_error=0.2`` (mm, proved), ``target_reduction=0.9``,
            ``mode="Accurate"``, ``tolerance_array="Tolerance"``, ``maps=True``, ...

        Raises
        ------
        TypeError, ValueError
            An option that is none or out of range, an input that is no surface.
        RuntimeError
            The certificate contradicts what was promised: a defect of this software.
        KeyboardInterrupt
            By Ctrl-C, at once.
        """
        values = read(options)
        with listener(progress_bar) as heard:
            answer, surface = run(self._mesh, values, heard)
        check(answer)
        for warning in answer["warnings"]:
            warnings.warn(warning, stacklevel=2)
        output = pv.PolyData()
        fill_output(answer, surface, values, self._mesh, output)
        return output

    def levels(self, *, progress_bar: bool | Progress = False, **options: Unpack[ArrayOptions]) -> MeshLevels:
        """One run, recorded, and every stage of it at once: `bonedecimate.record_levels` has the keywords.

        >>> levels = mesh.bone.levels(target_reduction=0.95)
        >>> levels.at(triangles=20000).plot()
        """
        surface = surface_of(self._mesh)
        points = surface.points.astype(np.float32) if surface.is_single else surface.points
        return MeshLevels(record_levels(points, surface.triangles, progress=progress_bar, **options))

    def certify(self, other: pv.PolyData, **keywords) -> Certificate:
        """How far this one (the reference) and another are from each other: `bonedecimate.certify` has the keywords."""
        one, two = surface_of(self._mesh), surface_of(other)
        return certify((one.points, one.triangles), (two.points, two.triangles), **keywords)

    def distance_to(self, other: pv.PolyData, **keywords) -> pv.PolyData:
        """A copy with the arrays SignedDistance (mm, negative inside of the other) and Side at each point.

        Field data: the certificate, proved bounds of the largest distance in each direction and of the borders.
        """
        certificate = self.certify(other, **keywords)
        copy = self._mesh.copy()
        copy.point_data[ERROR] = certificate.reference_distance
        copy.point_data[SIDE] = certificate.reference_side
        units = certificate.units
        entries = [(name, units.get(name, ""), value) for name, value in certificate.report.items()]
        add_entries(entries, "bonedecimate.certificate.", copy)
        return copy

    def plot_error(self, other: pv.PolyData, *, largest: float | None = None, **keywords):
        """Shows this surface coloured by its signed distance to the other, mm; keywords are those of ``plot``.

        Parameters
        ----------
        largest : float, mm, optional
            At which the colours end in both directions; the largest that there is by default.
        """
        measured = self.distance_to(other)
        end = largest or float(np.nanmax(np.abs(measured[ERROR]), initial=0.0)) or 1.0
        settings = {"scalars": ERROR, "clim": (-end, end), "cmap": "coolwarm",
                    "scalar_bar_args": {"title": "distance, mm"}}
        return measured.plot(**{**settings, **keywords})

    @property
    def report(self) -> dict[str, int | float | str]:
        """What the run that made this surface says of itself, by name; empty if none did."""
        found = {}
        for key in self._mesh.field_data.keys():
            name = key.removeprefix("bonedecimate.")
            if name != key and not name.startswith("certificate."):
                value = self._mesh.field_data[key]
                found[name] = value if isinstance(value, str) else value[0]
        return found
