#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws pictures of the documentation from the phantoms of Data: gallery.py PROGRAMS [NAME ...]

PROGRAMS is the folder of bonedecimate and bonedecimate-phantom, NAME a picture, all of them by default. It needs VTK, PIL and a
display (Utilities/install_packages.sh pictures). tutorial-pyvista.png is what that tutorial writes, after reduce_colors().

    xvfb-run -a /usr/bin/python3 Utilities/site/gallery.py build/release/bin
"""

import dataclasses
import pathlib
import subprocess
import sys
import tempfile

import vtkmodules.vtkRenderingFreeType
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter

IMAGES = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "images"
BONE = (0.93, 0.88, 0.78)
LABELS = ("sandybrown", "cornflowerblue", "mediumseagreen")
# Where the camera is, seen from the middle of what it looks at: from the front and the side of the leg.
DIRECTION = (-0.55, -1.0, 0.25)


@dataclasses.dataclass
class Panel:
    """One view: the words of the program that make its surfaces, and how they are shown."""

    title: str
    words: str
    edges: bool = False
    array: str = ""  # mm, in colors
    largest: float = 0.0  # mm, at the end of the colors
    flat: bool = False


@dataclasses.dataclass
class Picture:
    """Views side by side with one camera."""

    panels: list
    size: tuple = (900, 430)  # pixels
    zoom: float = 1.0
    focus: tuple = (0.0, 0.0, 0.04)  # from the middle, in diagonals
    direction: tuple = DIRECTION


ALL = "--target-reduction 0"
FRACTURE = "ct.mha {}.vtp --iso 226 "
FAST = FRACTURE + "--mode Fast "
SEGMENTS = "labels.mha {}/ --segments all --format vtp "
TRABECULAE = "trabeculae.mha {}.vtp --iso 127.5 "
PHANTOM = "small.mha {}/ --segments all --format vtp "
SHAFT = {"zoom": 3.2, "focus": (0.0, 0.0, -0.06)}
PICTURES = {
    "gallery-fracture": Picture([
        Panel("before", FRACTURE + ALL),
        Panel("largest error 0.3 mm", FRACTURE + "--max-error 0.3"),
        Panel("0.3 mm, triangles", FRACTURE + "--max-error 0.3", edges=True)]),
    "gallery-segments": Picture([
        Panel("surfaces of the voxels", SEGMENTS + ALL),
        Panel("smoothed, half a voxel", SEGMENTS + "--max-error halfvoxel --smooth auto"),
        Panel("the same, triangles", SEGMENTS + "--max-error halfvoxel --smooth auto", edges=True)]),
    "gallery-proved-error": Picture([
        Panel("measured distance, mm", FRACTURE + "--max-error 0.5", array="Distance", largest=0.5),
        Panel("proved bound, mm", FRACTURE + "--max-error 0.5", array="ErrorBound", largest=0.5)]),
    "gallery-levels": Picture([
        Panel("a tenth", FAST + "--target-reduction 0.9", edges=True),
        Panel("a twentieth", FAST + "--target-reduction 0.95", edges=True),
        Panel("a fiftieth", FAST + "--target-reduction 0.98", edges=True)]),
    "gallery-region": Picture([
        Panel("largest error 1 mm", FAST + "--max-error 1", edges=True),
        Panel("1 mm, near the fracture 0.1 mm", FAST + "--max-error 1 --region box:-100,100,-100,100,-110,-60=0.1", edges=True)]),
    "gallery-angles": Picture([
        Panel("0.3 mm", FAST + "--max-error 0.3", edges=True, flat=True),
        Panel("0.3 mm, angles of 30 degrees", FAST + "--max-error 0.3 --min-angle 30", edges=True, flat=True),
        Panel("0.3 mm, edges of 3 mm", FAST + "--max-error 0.3 --edge-length 3", edges=True, flat=True)], **SHAFT),
    "tutorial-segments": Picture([
        Panel("surfaces of the voxels", PHANTOM + ALL),
        Panel("half a voxel", PHANTOM + "--max-error halfvoxel --smooth auto", edges=True),
        Panel("a voxel", PHANTOM + "--max-error voxel --smooth auto", edges=True)], direction=(-1.0, -0.7, 0.25)),
    "gallery-trabeculae": Picture([
        Panel("before", TRABECULAE + ALL),
        Panel("largest error 0.01 mm, two voxels", TRABECULAE + "--max-error 0.01 --mode Fast")], direction=(-0.6, -1.0, 0.5)),
}


class Runs:
    """Runs the program, each command once, in a temporary folder."""

    def __init__(self, programs, folder):
        self.programs, self.folder, self.done = programs, folder, {}
        for name, words in (("ct", ["--size", "normal"]), ("labels", ["--size", "normal", "--labels"]), ("small", ["--size", "small", "--labels"]),
                            ("trabeculae", ["--trabeculae", "240"])):
            subprocess.run([programs / "bonedecimate-phantom", folder / f"{name}.mha", *words], check=True)

    def surfaces(self, words):
        if words not in self.done:
            name = f"run{len(self.done)}"
            subprocess.run([self.programs / "bonedecimate", *words.format(name).split()], check=True, cwd=self.folder, capture_output=True)
            files = sorted((self.folder / name).glob("*.vtp")) or [self.folder / f"{name}.vtp"]
            self.done[words] = [read(file) for file in files]
        return self.done[words]


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def colors_up_to(largest):
    """Light to dark, as on the pages that the program writes."""
    colors = vtkColorTransferFunction()
    for value, color in ((0.0, (0.98, 0.95, 0.86)), (0.5, (0.94, 0.52, 0.3)), (1.0, (0.3, 0.07, 0.45))):
        colors.AddRGBPoint(value * largest, *color)
    return colors


def actor_of(surface, color, panel):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    if panel.array:
        mapper.ScalarVisibilityOn()
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(panel.array)
        mapper.SetLookupTable(colors_up_to(panel.largest))
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(color)
    look.SetAmbient(0.15)
    look.SetEdgeVisibility(panel.edges)
    look.SetEdgeColor(0.25, 0.25, 0.3)
    if panel.flat or panel.edges:
        look.SetInterpolationToFlat()
    return actor


def text(words, height):
    actor = vtkTextActor()
    actor.SetInput(words)
    actor.GetTextProperty().SetColor(0.1, 0.1, 0.1)
    actor.GetTextProperty().SetFontSize(15)
    actor.GetTextProperty().SetBackgroundColor(1, 1, 1)
    actor.GetTextProperty().SetBackgroundOpacity(0.8)
    actor.SetPosition(12, height)
    return actor


def renderer_of(panel, surfaces, height):
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    named = vtkNamedColors()
    for i, surface in enumerate(surfaces):
        renderer.AddActor(actor_of(surface, BONE if len(surfaces) == 1 else named.GetColor3d(LABELS[i]), panel))
    triangles = f"{sum(surface.GetNumberOfCells() for surface in surfaces):,} triangles"
    renderer.AddActor(text(f"{panel.title}\n{triangles}", height - 45))
    if panel.array:
        bar = vtkScalarBarActor()
        bar.SetLookupTable(colors_up_to(panel.largest))
        bar.SetNumberOfLabels(6)
        bar.SetLabelFormat("%.1f")
        bar.UnconstrainedFontSizeOn()
        bar.GetLabelTextProperty().SetColor(0.1, 0.1, 0.1)
        bar.GetLabelTextProperty().SetFontSize(13)
        bar.SetPosition(0.86, 0.1)
        bar.SetWidth(0.1)
        bar.SetHeight(0.6)
        renderer.AddActor(bar)
    return renderer


def aim(camera, bounds, picture, aspect):
    low, high = bounds[0::2], bounds[1::2]
    diagonal = sum((b - a) ** 2 for a, b in zip(low, high)) ** 0.5
    focus = [(a + b) / 2 + part * diagonal for a, b, part in zip(low, high, picture.focus)]
    length = sum(part * part for part in picture.direction) ** 0.5
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(focus)
    camera.SetPosition([middle + part / length * 3 * diagonal for middle, part in zip(focus, picture.direction)])
    camera.SetViewUp(0, 0, 1)
    camera.SetParallelScale(diagonal / picture.zoom * max(0.48, 0.3 / aspect))


def draw(picture, runs, path):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(picture.size)
    paper = vtkRenderer()
    paper.SetBackground(1, 1, 1)
    window.AddRenderer(paper)
    count, camera = len(picture.panels), None
    for i, panel in enumerate(picture.panels):
        renderer = renderer_of(panel, runs.surfaces(panel.words), picture.size[1])
        renderer.SetViewport(i / count, 0, (i + 0.99) / count, 1)
        window.AddRenderer(renderer)
        if camera is None:
            camera = renderer.GetActiveCamera()
            aim(camera, renderer.ComputeVisiblePropBounds(), picture, picture.size[0] / count / picture.size[1])
        renderer.SetActiveCamera(camera)
        renderer.ResetCameraClippingRange()
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
    reduce_colors(path)


def reduce_colors(path):
    """Makes the file of a picture three times smaller."""
    from PIL import Image  # for drawing alone: tests read the table of pictures without it
    Image.open(path).convert("RGB").quantize(160, dither=Image.Dither.NONE).save(path, optimize=True)


def main():
    programs = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(programs, pathlib.Path(folder))
        for name in sys.argv[2:] or PICTURES:
            draw(PICTURES[name], runs, IMAGES / f"{name}.png")
            print(name)


if __name__ == "__main__":
    main()
