# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages with the interactive view, in Chromium with its software renderer."""

import base64
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import zlib
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter

import browser as chromium
from browser import Browser, drawn

PROGRAM = os.environ["BONEDECIMATE_PROGRAM"]
PHANTOM = os.environ["PHANTOM"]
RADIUS = 40.0  # mm, of the large ball
STAGE = "#viewer-stage"


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

    def numbers(self, index):
        """All varints of a surface without distances."""
        data = np.frombuffer(self.bytes[index], dtype=np.uint8)
        ends = np.flatnonzero(data < 128) + 1
        return [sum(int(byte & 127) << 7 * i for i, byte in enumerate(data[begin:end])) for begin, end in zip([0, *ends], ends)]

    def surface(self, index):
        """The corners of all triangles, mm, for a surface of one piece."""
        (piece,) = self.scene["surfaces"][index]["pieces"]
        count = piece["points"]
        numbers = self.numbers(index)
        steps = [(n + 1) // -2 if n % 2 else n // 2 for n in numbers[:3 * count]]
        points = np.cumsum(np.reshape(steps, (3, count)), axis=1).T * self.scene["grid"]["step"] + self.scene["grid"]["origin"]
        corners, used = [], 0
        for back in numbers[3 * count:]:
            corners.append(used - back)
            used += back == 0
        return points[np.reshape(corners, (-1, 3))]


class Data(unittest.TestCase):
    def test_is_the_surface_within_the_rounding_that_the_page_says(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_balls(folder / "ball.ply", (RADIUS, 5.0))
            run(PROGRAM, "levels", folder / "ball.ply", "--coarsest", 1000, "--no-errors", "--page", folder / "levels.html")
            text = (folder / "levels.html").read_text(encoding="utf-8")
            if "viewer-scene" not in text:
                self.skipTest("the program was built without the interactive view")
            reader = vtkPLYReader()
            reader.SetFileName(str(folder / "ball.ply"))
            reader.Update()
            original = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
            triangles = vtk_to_numpy(reader.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)
            rounding = float(re.search(r"rounded by up to ([\d.]+) mm", text).group(1))
            carried = Scene(folder / "levels.html").surface(0)
            self.assertEqual(carried.shape, (len(triangles), 3, 3))
            self.assertLessEqual(np.linalg.norm(carried - original[triangles], axis=2).max(), rounding)
            self.assertLess(rounding, 0.002)


@unittest.skipUnless(chromium.CHROMIUM and chromium.DRIVER, chromium.MISSING)
class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="bonedecimate-page-")
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        write_balls(cls.folder / "ball.ply", (RADIUS, 0.0))
        write_balls(cls.folder / "balls.ply", (RADIUS, 0.0), (15.0, 70.0))
        run(PHANTOM, cls.folder / "labels.mha", "--size", "small", "--labels")
        pages = [
            ("balls.ply", "small.vtp", "--target-triangles", 1500, "--page", "balls.html"),
            ("levels", "ball.ply", "--coarsest", 400, "--no-errors", "--page", "levels.html"),
            ("labels.mha", "bones", "--segments", "all", "--target-reduction", 0.8, "--measure", "off"),
        ]
        with ThreadPoolExecutor() as threads:
            list(threads.map(lambda words: run(PROGRAM, *words, folder=cls.folder), pages))
        if "viewer-scene" not in (cls.folder / "balls.html").read_text(encoding="utf-8"):
            raise unittest.SkipTest("the program was built without the interactive view")
        cls.browser = Browser(*chromium.SOFTWARE)
        cls.addClassCleanup(cls.browser.__exit__)

    def open(self, name):
        self.browser.open(self.folder / name)
        self.browser.run("document.querySelector('.viewer').scrollIntoView()")

    def drawn(self):
        """Without the line around the stage."""
        return drawn(self.browser.picture(STAGE)[2:-2, 2:-2])

    def count(self):
        return int(self.drawn().sum())

    def change(self, action):
        """How many pixels of the stage an action changes."""
        before = self.browser.picture(STAGE)
        action()
        return int((np.abs(self.browser.picture(STAGE) - before).max(axis=2) > 8).sum())

    def test_opens_without_a_message_and_without_a_request(self):
        for name in ("balls.html", "bones/index.html", "levels.html"):
            self.browser.messages()
            self.browser.requests()
            self.open(name)
            self.assertEqual(self.browser.messages(), [], name)
            self.assertEqual(self.browser.requests(), [(self.folder / name).resolve().as_uri()])
            self.assertTrue(self.browser.is_shown(STAGE))
            self.assertFalse(self.browser.is_shown(".picture"))

    def test_draws_both_surfaces_side_by_side(self):
        self.open("balls.html")
        seen = self.drawn()
        left, right = np.array_split(seen, 2, axis=1)
        self.assertGreater(left.mean(), 0.1)
        self.assertAlmostEqual(left.mean(), right.mean(), delta=0.1 * left.mean())
        self.assertEqual("Before: 9,120 triangles", self.browser.text("#viewer-before"))
        self.assertEqual(self.browser.text("#viewer-after"), "After: 1,500 triangles")

    def test_turns_moves_and_zooms(self):
        self.open("balls.html")
        self.assertGreater(self.change(lambda: self.browser.point(STAGE, [(0, 0), "pointerDown", (120, 20), "pointerUp"])), 2000)
        self.assertGreater(self.change(lambda: self.browser.point(STAGE, [(0, 0), "pointerDown", (-100, 60), "pointerUp"], "touch")), 2000)
        before = self.count()
        self.browser.scroll(STAGE, -240)
        self.assertNotAlmostEqual(self.count(), before, delta=0.05 * before)
        self.browser.click("#viewer-reset")

    def test_measures_a_chord_of_a_ball(self):
        self.open("levels.html")
        self.browser.set("#viewer-compare", "before")
        columns = np.flatnonzero(self.drawn()[40:-60].any(axis=0))
        pixel = 2.0 * RADIUS / (columns[-1] - columns[0] + 1)
        half = round(0.5 * RADIUS / pixel)
        self.browser.click("#viewer-measure")
        for x in (-half, half):
            self.browser.point(STAGE, [(x, 0), "pointerDown", "pointerUp"])
        self.assertAlmostEqual(float(self.browser.text("#viewer-length").split()[0]), 2 * half * pixel, delta=0.03 * RADIUS)
        self.browser.click("#viewer-measure")

    def test_shows_errors_as_colors_with_a_legend(self):
        self.open("balls.html")
        self.assertFalse(self.browser.is_shown("#viewer-legend"))
        self.browser.click("#viewer-distances")
        self.assertTrue(self.browser.is_shown("#viewer-legend"))
        pixels = self.browser.picture(STAGE)[drawn(self.browser.picture(STAGE))]
        self.assertGreater(int((pixels[:, 0] - pixels[:, 1] > 90).sum()), 500)  # red and violet, which bone has not
        self.assertEqual(self.browser.text("#viewer-ticks").split()[0], "0")

    def test_divides_before_and_after(self):
        self.open("balls.html")
        self.browser.set("#viewer-compare", "divider")
        self.browser.click("#viewer-triangles")
        pictures = []
        for position in (0, 0.5, 1):
            self.browser.set("#viewer-divider", position)
            pictures.append(self.browser.picture(STAGE)[40:-60])
        after, both, before = pictures
        middle = both.shape[1] // 2
        self.assertTrue(np.array_equal(both[:, :middle - 4], before[:, :middle - 4]))
        self.assertTrue(np.array_equal(both[:, middle + 4:], after[:, middle + 4:]))
        self.assertFalse(np.array_equal(before, after))
        self.browser.set("#viewer-divider", 0.5)
        self.browser.point("#viewer-divider", [(0, 0), "pointerDown", (150, 0), "pointerUp"])
        self.assertGreater(float(self.browser.run("return document.getElementById('viewer-divider').value")), 0.6)
        self.browser.set("#viewer-divider", 0.5)
        self.assertTrue(np.array_equal(self.browser.picture(STAGE)[40:-60], both))  # the view has not turned

    def test_cuts_with_a_plane(self):
        self.open("balls.html")
        self.browser.set("#viewer-compare", "after")
        whole = self.count()
        self.browser.set("#viewer-clip", "x")
        self.browser.set("#viewer-clip-at", 0.4)
        part = self.count()
        self.browser.click("#viewer-clip-flip")
        other = self.count()
        self.assertLess(max(part, other), 0.9 * whole)
        self.assertGreater(part + other, 0.95 * whole)
        self.browser.set("#viewer-clip-at", 0)
        self.assertLess(self.count(), 0.02 * whole)

    def test_switches_components_and_labels(self):
        self.open("balls.html")
        whole = self.count()
        boxes = self.browser.run("return document.querySelectorAll('#viewer-parts input').length")
        self.assertEqual(boxes, 2)
        self.browser.click("#viewer-parts label:nth-child(2) input")
        large = self.count()
        self.browser.click("#viewer-none")
        self.assertLess(self.count(), 0.1 * whole)  # words and buttons remain
        self.browser.click("#viewer-parts label:nth-child(2) input")
        small = self.count()
        self.assertAlmostEqual(small / large, (15.0 / RADIUS) ** 2, delta=0.05)
        self.open("bones/index.html")
        self.assertEqual(self.browser.run("return document.querySelectorAll('#viewer-parts input').length"), 3)

    def test_goes_through_levels(self):
        self.open("levels.html")
        counts = []
        for level in range(1, int(self.browser.run("return document.getElementById('viewer-level').max")) + 1):
            self.browser.set("#viewer-level", level)
            self.browser.run("return new Promise((done) => setTimeout(done, 100))")
            counts.append(int(self.browser.text("#viewer-after").split()[1].replace(",", "")))
        self.assertGreater(len(counts), 4)
        self.assertLessEqual(counts[0], 400)
        self.assertTrue(all(1.0 < fine / coarse < 1.6 for coarse, fine in zip(counts, counts[1:])), counts)

    def test_prints_the_picture(self):
        self.open("balls.html")
        self.browser.protocol("Emulation.setEmulatedMedia", media="print")
        self.assertTrue(self.browser.is_shown(".picture img"))
        self.assertFalse(self.browser.is_shown(STAGE))
        self.browser.protocol("Emulation.setEmulatedMedia", media="")

    def test_keeps_the_picture_without_javascript(self):
        self.browser.protocol("Emulation.setScriptExecutionDisabled", value=True)
        self.browser.command("POST", "/url", {"url": (self.folder / "balls.html").as_uri()})
        self.browser.protocol("Emulation.setScriptExecutionDisabled", value=False)
        self.assertTrue(self.browser.is_shown(".picture img"))
        self.assertFalse(self.browser.is_shown(STAGE))

    def test_keeps_the_picture_without_webgl(self):
        with Browser(*chromium.WITHOUT_WEBGL) as browser:
            browser.open(self.folder / "balls.html", "unavailable")
            self.assertTrue(browser.is_shown(".picture img"))
            self.assertFalse(browser.is_shown(STAGE))
            self.assertEqual(browser.messages(), [])


if __name__ == "__main__":
    unittest.main()
