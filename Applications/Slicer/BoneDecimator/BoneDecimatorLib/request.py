# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A request of the user, and the flags of the program for it. Needs the standard library only."""

from dataclasses import dataclass, field

from . import checks
from .checks import AUTOMATIC, DecimationError


@dataclass
class Request:
    """The values of the panel. Lengths are millimeters."""

    tolerance: float = 0.2  # proved; 0: none
    triangles: int = 0  # 0: as few as the tolerance allows
    smoothing: object = 0.0  # the largest displacement of a point before the first edit; "automatic": by voxels and tolerance
    feature_angle: float = 180.0  # degrees: smoothing keeps edges sharper than this; 180: none
    keep_voxels: str = "Auto"  # or On or Off: whether edits may change which segment a voxel belongs to
    mode: str = "Balanced"
    minimum_angle: float = 0.0  # degrees, of the triangles; 0: off
    edge_length: float = 0.0  # of the triangles, the largest with a chordal error; 0: off
    chordal_error: float = 0.0  # how far triangles may lie below curved surfaces, which shortens edges there; 0: off
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
        checks.check_keep_voxels(self.keep_voxels)
        checks.check_smoothing(self.smoothing)
        checks.check_number("The angle of kept edges", self.feature_angle, 0, 180, "degrees")
        checks.check_number("The smallest angle", self.minimum_angle, 0, 40, "degrees")
        checks.check_length("The edge length", self.edge_length)
        checks.check_length("The chordal error", self.chordal_error)
        checks.check_length("The radius", self.radius)
        checks.check_length("The feather", self.feather)
        if not self.has_goal and not self.is_smooth:
            raise DecimationError("Give a tolerance, a number of triangles, an edge length or a smoothing.")
        if self.chordal_error > 0.0 and self.edge_length <= 0.0:
            raise DecimationError("A chordal error needs an edge length.")
        if self.brush is not None and self.tolerance <= 0.0:
            raise DecimationError("A brush needs a tolerance.")

    @property
    def has_goal(self):
        """Without one, every triangle stays."""
        return self.tolerance > 0.0 or self.triangles > 0 or self.edge_length > 0.0 or self.keep_voxels == "On"

    @property
    def is_smooth(self):
        return self.smoothing == AUTOMATIC or self.smoothing > 0.0

    def options(self):
        """Flags of the program without dashes."""
        self.check()
        options = {"mode": self.mode}
        if self.smoothing == AUTOMATIC:
            options["auto-smooth"] = True
        elif self.is_smooth:
            options["smooth"] = self.smoothing
        if self.is_smooth and self.feature_angle < 180.0:
            options["feature-angle"] = self.feature_angle
        if self.keep_voxels != "Auto":
            options["keep-voxels"] = self.keep_voxels
        if not self.has_goal:
            options["target-reduction"] = 0.0
        if self.tolerance > 0.0:
            options["max-error"] = self.tolerance
            if self.mode != "Thesis":
                options["intersection-guard"] = self.intersection_guard
        if self.triangles > 0:
            options["target-triangles"] = self.triangles
        shapes = {"min-angle": self.minimum_angle, "edge-length": self.edge_length, "chordal-error": self.chordal_error}
        options.update((flag, value) for flag, value in shapes.items() if value > 0.0)
        return {**options, **self.extra}
