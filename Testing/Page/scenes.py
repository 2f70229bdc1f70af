# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of pages write and read: balls, runs of the program, and the surfaces in a page."""

import base64
import json
import re
import subprocess
import zlib

import numpy as np
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOPLY import vtkPLYWriter


def run(*words, folder=None):
    done = subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{words}:\n{done.stdout}\n{done.stderr}"


def write_balls(path, *balls):
    """Balls as (radius, x), mm."""
    both = vtkAppendPolyData()
    for radius, x in balls:
        ball = vtkSphereSource()
        ball.SetRadius(radius)
        ball.SetCenter(x, 0.0, 0.0)
        ball.SetThetaResolution(60)
        ball.SetPhiResolution(40)
        both.AddInputConnection(ball.GetOutputPort())
    writer = vtkPLYWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(both.GetOutputPort())
    writer.Write()


class Scene:
    """The surfaces of a page, read as Applications/Picture/README.md describes them."""

    def __init__(self, page):
        text = page.read_text(encoding="utf-8")
        self.scene = json.loads(re.search(r'id="viewer-scene">(.*?)</script>', text, re.DOTALL).group(1))
        self.bytes = [zlib.decompress(base64.b64decode(data)) for data in re.findall(r'class="surface">(.*?)</script>', text)]

    def pieces(self, index):
        """For each piece the corners of its triangles, mm, and their distances, mm, or None."""
        surface = self.scene["surfaces"][index]
        data = iter(self.bytes[index])

        def number():
            value, shift, byte = 0, 0, 128
            while byte & 128:
                byte = next(data)
                value |= (byte & 127) << shift
                shift += 7
            return value

        for piece in surface["pieces"]:
            count = piece["points"]
            numbers = [number() for _ in range(3 * count)]
            steps = [(n + 1) // -2 if n % 2 else n // 2 for n in numbers]
            points = np.cumsum(np.reshape(steps, (3, count)), axis=1).T * self.scene["grid"]["step"] + self.scene["grid"]["origin"]
            corners, used = [], 0
            for _ in range(3 * piece["triangles"]):
                back = number()
                corners.append(used - back)
                used += back == 0
            triangles = np.reshape(corners, (-1, 3))
            distances = None
            if surface["hasDistances"]:
                distances = np.array([next(data) for _ in range(count)])[triangles] * self.scene["distances"]["range"] / 255
            yield points[triangles], distances
