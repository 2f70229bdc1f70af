# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the Python tests need again and again: surfaces, and an ear for what a filter says."""

import math

from vtkmodules.vtkCommonCore import VTK_STRING, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from bonedecimate import vtkBoneDecimate

AROUND = 40
ACROSS = 20
POINTS = AROUND * ACROSS
TRIANGLES = 2 * POINTS


def torus():
    """A closed surface of TRIANGLES triangles and POINTS points without arrays, mm."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    triangles = vtkCellArray()
    for i in range(AROUND):
        for j in range(ACROSS):
            u, v = 2 * math.pi * i / AROUND, 2 * math.pi * j / ACROSS
            out = 10 + 3 * math.cos(v)
            points.InsertNextPoint(out * math.cos(u), out * math.sin(u), 3 * math.sin(v))
            a, b = i * ACROSS + j, (i + 1) % AROUND * ACROSS + j
            c, d = (i + 1) % AROUND * ACROSS + (j + 1) % ACROSS, i * ACROSS + (j + 1) % ACROSS
            for corners in ((a, b, c), (a, c, d)):
                triangles.InsertNextCell(3, corners)
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    return surface


def decimating(surface, **properties):
    """A filter with that input and those properties, not yet updated."""
    decimate = vtkBoneDecimate()
    decimate.SetInputData(surface)
    for name, value in properties.items():
        getattr(decimate, "Set" + name)(value)
    return decimate


class Ear:
    """Collects the texts of an event of an object."""

    def __init__(self, speaker, event):
        self.texts = []

        def listen(_caller, _event, text):
            self.texts.append(text)

        listen.CallDataType = VTK_STRING
        speaker.AddObserver(event, listen)
