# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the phantom of Data/: flat shading, which shows the staircase, and the displacement as colors."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from vtkmodules import vtkRenderingFreeType, vtkRenderingOpenGL2  # noqa: F401  (they register themselves)
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkVersion
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor,
                                         vtkWindowToImageFilter)

from . import NOT_SMOOTHED, OURS, cases, measures
from .methods import all_methods
from .surfaces import Surface, polydata_of

SHOWN = (NOT_SMOOTHED, OURS, "windowed sinc 0.5", "vtkSurfaceNets3D")
SIZE, STRIP, GAP = 520, 44, 4  # pixels of a panel, of its caption and at its sides
BONE = (0.93, 0.89, 0.80)
VIRIDIS = ((0.27, 0.00, 0.33), (0.23, 0.32, 0.55), (0.13, 0.57, 0.55), (0.37, 0.79, 0.38), (0.99, 0.91, 0.15))
BEYOND = (0.84, 0.19, 0.15)


def colors_up_to(bound: float) -> vtkLookupTable:
    """Viridis up to the bound, red from there to twice the bound."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetTableRange(0.0, 2.0 * bound)
    for i in range(256):
        part = np.clip(i / 127.0, 0.0, 1.0) * (len(VIRIDIS) - 1)
        color = [np.interp(part, range(len(VIRIDIS)), channel) for channel in zip(*VIRIDIS)] if i < 128 else BEYOND
        table.SetTableValue(i, *color, 1.0)
    return table


def actor_of(surface: Surface, values: np.ndarray | None, table: vtkLookupTable | None) -> vtkActor:
    polydata, mapper, actor = polydata_of(surface), vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(polydata)
    if values is None:
        mapper.ScalarVisibilityOff()
    else:
        polydata.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetColor(*BONE)
    actor.GetProperty().SetDiffuse(0.9)
    actor.GetProperty().SetAmbient(0.15)
    return actor


def dark(text: object, size: int) -> None:
    text.SetColor(0.1, 0.1, 0.1)
    text.SetFontSize(size)
    text.ShadowOff()
    text.ItalicOff()
    text.BoldOff()


def caption(text: str) -> vtkTextActor:
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.SetPosition(12, 12)
    dark(actor.GetTextProperty(), 20)
    return actor


def scale_of(table: vtkLookupTable) -> vtkScalarBarActor:
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("{:.2f} mm" if vtkVersion.GetVTKMajorVersion() * 100 + vtkVersion.GetVTKMinorVersion() > 905 else "%.2f mm")
    bar.UnconstrainedFontSizeOn()
    dark(bar.GetLabelTextProperty(), 18)
    bar.SetPosition(0.2, 0.05)
    bar.SetWidth(0.6)
    bar.SetHeight(0.9)
    return bar


def look_at(renderer: vtkRenderer, zoom: float) -> None:
    """From the side, a little from above."""
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(1.0, -1.6, 0.5)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()


def add_renderer(window: vtkRenderWindow, part: tuple[float, float, float, float], prop: object) -> vtkRenderer:
    """In a part of the window, pixels from the lower left: left, bottom, right, top."""
    renderer, (width, height) = vtkRenderer(), window.GetSize()
    renderer.SetBackground(1, 1, 1)
    renderer.SetViewport(part[0] / width, part[1] / height, part[2] / width, part[3] / height)
    renderer.AddViewProp(prop)
    window.AddRenderer(renderer)
    return renderer


def render(panels: list[tuple[str, vtkActor]], table: vtkLookupTable | None, zoom: float, path: Path) -> None:
    """Panels with captions below, two rows if there are four; the scale of the colors below all of them."""
    columns = 2 if len(panels) == 4 else len(panels)
    rows, below = -(-len(panels) // columns), 60 if table else 0
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(columns * SIZE, rows * (SIZE + STRIP) + below)
    add_renderer(window, (0, 0, *window.GetSize()), vtkTextActor())  # white where there is no panel
    for index, (text, actor) in enumerate(panels):
        left, bottom = index % columns * SIZE, below + (rows - 1 - index // columns) * (SIZE + STRIP)
        add_renderer(window, (left, bottom, left + SIZE, bottom + STRIP), caption(text))
        look_at(add_renderer(window, (left + GAP, bottom + STRIP, left + SIZE - GAP, bottom + STRIP + SIZE), actor), zoom)
    if table:
        add_renderer(window, (0, 0, columns * SIZE, below), scale_of(table))
    window.Render()
    save(window, path)


def save(window: vtkRenderWindow, path: Path) -> None:
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


def write(folder: Path, python: str, phantom: Path) -> None:
    case = cases.phantom_case(phantom)
    methods = all_methods(python, with_meshlib=False)
    surfaces = {name: methods[name](case).surfaces[1] for name in SHOWN if name in methods}
    render([(name, actor_of(surface, None, None)) for name, surface in surfaces.items()], None, 2.2, folder / "smoothing-phantom.png")
    bound = 0.5 * float(case.spacing.min())
    table, before = colors_up_to(bound), measures.Locator(surfaces.pop(NOT_SMOOTHED))
    moved = {name: before.nearest(surface.points)[0] for name, surface in surfaces.items()}
    render([(f"{name}: at most {moved[name].max():.2f} mm", actor_of(surface, moved[name], table))
            for name, surface in surfaces.items()], table, 1.2, folder / "smoothing-displacement.png")
