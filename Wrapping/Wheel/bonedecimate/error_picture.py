# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""How `mesh.bone.plot_error` draws a surface in the colors of its distances."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from .arrays import Certificate


def plot_settings(certificate: Certificate, limit: float | None, width: int) -> dict[str, Any]:
    """The keywords of PyVista's `plot`.

    @param limit Where the colors end, mm; None: at the proved largest distance.
    @param width Of the window, pixels.
    """
    is_capped = np.abs(certificate.reference_distance).max(initial=0.0) > (limit or math.inf)
    bound = f"{math.ceil(certificate.upper * 1e4) / 1e4:.4f}"  # no less than the proved one
    end = limit or float(bound) or 1.0
    lines = ["distance, mm", "(outside > 0)", "", "at most", f"{bound} mm,", "proved", ""]
    lines += ["colors end", f"at {end:.4g} mm", ""] if is_capped else []
    size = max(10, width // 45)  # of letters, pixels
    # The bar is beside the surface, which would fill the height of the window otherwise.
    bar = {"title": "\n".join(lines), "n_labels": 5, "fmt": "%.3g", "vertical": True, "position_x": 0.82, "position_y": 0.05,
           "width": 0.16, "height": 0.9, "title_font_size": size, "label_font_size": size}
    # Light that falls on all sides alike keeps colors what the scale says.
    return {"clim": (-end, end), "cmap": "coolwarm", "ambient": 0.5, "diffuse": 0.5, "zoom": 0.85, "scalar_bar_args": bar}
