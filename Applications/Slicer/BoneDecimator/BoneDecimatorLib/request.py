# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A request of the user, and the flags of the program for it. Needs the standard library only."""

from dataclasses import dataclass, field

from . import checks
from .checks import AUTOMATIC, DecimationError

# What messages call the options that have a field here.
NAMES = {"max-error": "The tolerance", "target-triangles": "The number of triangles", "feature-angle": "The angle of kept edges",
         "smooth": f"The smoothing, if it is not {AUTOMATIC!r},"}


@dataclass
class Request:
    """The values of the panel. Lengths are millimeters."""

    tolerance: float = 0.2  # proved; 0: none
    triangles: int = 0  # 0: as few as the tolerance allows
    smoothing: object = 0.0  # the largest displacement of a point before the first edit; "automatic": by voxels and tolerance
    feature_angle: object = None  # degrees: smoothing keeps edges sharper than this; None: the default, which keeps none
    keep_voxels: object = None  # whether edits may change which segment a voxel belongs to, a choice of the table; None: the default
    model_grid: object = "auto"  # of segments: whether those of a network's coarser grid are taken: "off", or its spacing
    mode: object = None  # None: the default
    brush: object = None  # a markups node of points, a ROI node, or the name of a painted point array; None: everywhere
    keeps_brush: bool = False  # the brush says what stays, not what is simplified
    radius: float = 10.0  # round the points of a brush
    feather: float = 2.0  # over which the tolerance goes from one value to the other
    extra: dict = field(default_factory=dict)  # more options of the table: {"edge-length": 2.0, "prove": False}

    @property
    def has_goal(self):
        """Without one, every triangle stays."""
        return self.tolerance > 0.0 or self.triangles > 0 or self.extra.get("edge-length", 0.0) > 0.0 or self.keep_voxels == "On"

    @property
    def is_smooth(self):
        return self.smoothing == AUTOMATIC or self.smoothing > 0.0

    def options(self, table):
        """Flags of the program without dashes, and their values, which differ from the defaults.

        Raises DecimationError with a sentence about the first value that is wrong.
        @param table OptionTable of the engine.
        """
        is_automatic = bool(self.smoothing == AUTOMATIC)  # not numpy's, for a distance of numpy
        may_be_default = {"mode": self.mode, "keep-voxels": self.keep_voxels, "feature-angle": self.feature_angle}
        options = {"max-error": self.tolerance, "target-triangles": self.triangles, "auto-smooth": is_automatic,
                   "smooth": 0.0 if is_automatic else self.smoothing,
                   **{flag: value for flag, value in may_be_default.items() if value is not None}, **self.extra}
        table.check(options, NAMES)
        self._check_goal()
        if not self.has_goal:
            options["target-reduction"] = 0.0
        if not self.is_smooth:
            options.pop("feature-angle", None)
        options = table.changed(options)
        table.check_effects([flag for flag in self.extra if flag in options], options)
        return options

    def _check_goal(self):
        checks.check_length("The radius", self.radius)
        checks.check_length("The feather", self.feather)
        if not self.has_goal and not self.is_smooth:
            raise DecimationError("Give a tolerance, a number of triangles, an edge length or a smoothing.")
        if self.brush is not None and self.tolerance <= 0.0:
            raise DecimationError("A brush needs a tolerance.")
