# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages with the interactive view, in Chromium with its software renderer."""

import base64
import json
import os
import pathlib
import re
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOPLY import vtkPLYReader

import browser as chromium
from browser import Browser, drawn
from scenes import Scene, run, write_balls

PROGRAM = os.environ["BONEDECIMATE_PROGRAM"]
PHANTOM = os.environ["PHANTOM"]
RADIUS = 40.0  # mm, of the large ball
STAGE = "#viewer-stage"


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
            ((carried, _),) = Scene(folder / "levels.html").pieces(0)
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
            ("levels", "ball.ply", "--coarsest", 2000, "--page", "measured.html"),
            ("certify", "balls.ply", "ball.ply", "--tolerance", 50, "--page", "certificate.html"),
            ("labels.mha", "bones", "--segments", "all", "--target-reduction", 0.8, "--measure", "off"),
            ("labels.mha", "near", "--segments", "all", "--max-error", 0.4),
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

    def picture(self):
        """All of the stage, wherever a click has scrolled the page to."""
        self.browser.run("document.querySelector('.viewer').scrollIntoView()")
        return self.browser.picture(STAGE)

    def drawn(self):
        """Without the line around the stage, captions, axes and the legend."""
        return drawn(self.picture()[40:-100, 2:-2])

    def count(self):
        return int(self.drawn().sum())

    def change(self, action):
        """How many pixels of the stage an action changes."""
        before = self.picture()
        action()
        return int((np.abs(self.picture() - before).max(axis=2) > 8).sum())

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

    def test_shows_the_whole_after_the_window_has_another_shape(self):
        with Browser(*chromium.SOFTWARE, "--window-size=1280,500") as browser:
            browser.open(self.folder / "balls.html")
            browser.resize(900, 1000)
            browser.run("return new Promise((done) => setTimeout(done, 500))")
            seen = drawn(browser.picture(STAGE)[60:-120, 2:-2])
            self.assertGreater(seen.mean(), 0.05)
            for half in np.array_split(seen, 2, axis=1):
                self.assertFalse(half[:, [0, 1, -2, -1]].any())

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
        columns = np.flatnonzero(self.drawn().any(axis=0))
        pixel = 2.0 * RADIUS / (columns[-1] - columns[0] + 1)
        half = round(0.5 * RADIUS / pixel)
        self.browser.click("#viewer-measure")
        for x in (-half, half):
            self.browser.point(STAGE, [(x, 0), "pointerDown", "pointerUp"])
        self.assertAlmostEqual(float(self.browser.text("#viewer-length").split()[0]), 2 * half * pixel, delta=0.03 * RADIUS)
        self.browser.click("#viewer-measure")

    def colored(self):
        """How many pixels are orange, red or violet, which bone is not."""
        picture = self.picture()[40:-100]
        pixels = picture[drawn(picture)]
        return int((pixels[:, 0] - pixels[:, 1] > 40).sum())

    def test_shows_errors_as_colors_from_a_threshold_on(self):
        self.open("balls.html")
        self.assertTrue(self.browser.is_shown("#viewer-legend"))
        self.assertEqual(self.browser.text("#viewer-ticks").split()[0], "0")
        at_first = self.colored()
        self.assertGreater(at_first, 20)
        scene = Scene(self.folder / "balls.html").scene
        self.assertIn("plain below", self.browser.text("#viewer-legend"))
        self.browser.set("#viewer-threshold", 0)
        self.assertGreater(self.colored(), at_first)
        self.assertNotIn("plain", self.browser.text("#viewer-legend"))
        self.browser.set("#viewer-threshold", 255)
        self.assertLess(self.colored(), at_first)
        self.assertAlmostEqual(float(self.browser.text("#viewer-threshold-text").split()[0]), scene["distances"]["range"], 9)
        self.browser.click("#viewer-distances")
        self.assertFalse(self.browser.is_shown("#viewer-legend"))
        self.assertEqual(self.colored(), 0)

    def test_the_legend_covers_no_bone(self):
        self.open("bones/index.html")
        rect = "return document.querySelector(arguments[0]).getBoundingClientRect().toJSON()"
        legend, stage = (self.browser.run(rect, of) for of in ("#viewer-legend", STAGE))
        self.browser.click("#viewer-distances")
        for mode in ("sides", "after"):
            self.browser.set("#viewer-compare", mode)
            rows = np.flatnonzero(drawn(self.picture()[40:-2, 110:-2]).any(axis=1))
            self.assertLess(rows[-1] + 40, legend["top"] - stage["top"] + 2, mode)
            self.assertGreater(rows[-1] - rows[0], 0.6 * stage["height"], mode)

    def test_colors_the_last_fifth_of_the_distances_and_shows_their_legend_at_once(self):
        scene = Scene(self.folder / "near/index.html").scene["distances"]
        report = json.loads((self.folder / "near/report.json").read_text(encoding="utf-8"))
        farthest = max(report["distance"][way]["point_max"] for way in ("input_to_output", "output_to_input"))
        farthest = min(farthest, scene["range"])
        self.assertTrue(0 <= 0.8 * farthest - scene["threshold"] / 255 * scene["range"] <= scene["range"] / 255)
        below = "return document.getElementById('viewer-legend').getBoundingClientRect().bottom - window.innerHeight"
        with Browser(*chromium.SOFTWARE, "--window-size=1280,800") as browser:
            browser.open(self.folder / "near/index.html")
            self.assertLess(browser.run(below), 0)

    def test_says_the_distance_under_the_mouse(self):
        self.open("balls.html")
        self.assertFalse(self.browser.is_shown("#viewer-value"))
        self.browser.set("#viewer-compare", "before")
        self.browser.point(STAGE, [(-100, -20), (0, 0)])
        self.browser.run("return new Promise((done) => setTimeout(done, 200))")
        said = float(self.browser.text("#viewer-value").split()[0])
        scene = Scene(self.folder / "balls.html")
        toward = np.array(scene.scene["view"]["toViewer"])
        center = np.array(scene.scene["view"]["center"])
        hits = [(np.dot(corners[i].mean(axis=0), toward), distances[i]) for corners, distances in scene.pieces(0)
                for i in np.flatnonzero(self.is_before(corners, center, toward))]
        _, nearest = max(hits, key=lambda hit: hit[0])
        self.assertLessEqual(said, nearest.max() + 0.001)
        self.assertGreaterEqual(said, nearest.min() - 0.001)
        self.browser.point(STAGE, [(-220, -120)])
        self.assertFalse(self.browser.is_shown("#viewer-value"))

    @staticmethod
    def is_before(corners, center, toward):
        """Which triangles a line through the middle of the view meets: their corners turn around it."""
        offsets = corners - center
        turns = [np.einsum("ij,j->i", np.cross(offsets[:, i], offsets[:, (i + 1) % 3]), toward) for i in range(3)]
        return (np.min(turns, axis=0) >= 0) | (np.max(turns, axis=0) <= 0)

    def test_jumps_to_where_the_surfaces_are_farthest_apart(self):
        self.open("near/index.html")
        table = re.search(r"farthest apart</h2>(.*?)</table>", (self.folder / "near/index.html").read_text(encoding="utf-8"), re.DOTALL)[1]
        rows = re.findall(r"<tr><th[^>]*>\d+</th><td>([^<]+)</td><td>([^<]+)</td><td>(?:before|after)</td><td>([^<]+)</td></tr>", table)
        self.assertEqual(len(rows), 10)
        buttons = self.browser.run("return [...document.querySelectorAll('#viewer-farthest button')].map((button) => button.textContent)")
        self.assertEqual(buttons, [f"{distance} at {where}" for distance, where, _ in rows])
        report = json.loads((self.folder / "near/report.json").read_text(encoding="utf-8"))
        farthest = max(report["distance"][way]["max"] for way in ("input_to_output", "output_to_input"))
        self.assertTrue(0 <= farthest - float(rows[0][0]) < 2e-4)
        self.assertTrue({label for row in rows for label in row[2].split(", ")} <= {"1", "2", "3"})
        before = self.picture()[40:-80]
        self.browser.click("#viewer-farthest li:nth-child(3) button")
        circles = self.browser.run("return [...document.querySelectorAll('circle.chosen')].map((c) => [c.cx.baseVal.value, c.cy.baseVal.value])")
        width, height = self.browser.run("const s = document.getElementById('viewer-stage'); return [s.clientWidth, s.clientHeight]")
        for (x, y), middle in zip(circles, (0.25, 0.75), strict=True):
            self.assertAlmostEqual(x, middle * width, delta=2)
            self.assertAlmostEqual(y, 0.5 * (height - 84), delta=2)  # above the legend
        self.browser.click("#viewer-reset")
        self.assertTrue(np.array_equal(self.picture()[40:-80], before))

    def letters(self):
        return set(self.browser.run("return [...document.querySelectorAll('#viewer-overlay text.letter')].map((t) => t.textContent)"))

    def test_names_the_sides_of_the_patient_if_the_frame_is_known(self):
        self.open("near/index.html")
        seen = self.letters()
        self.assertTrue(seen <= set("RLAPIS") and {"I", "S"} <= seen, seen)
        position = "return [...document.querySelectorAll('text.letter')].find((t) => t.textContent === 'S').y.baseVal[0].value"
        height = self.browser.run("return document.getElementById('viewer-stage').clientHeight")
        self.assertLess(self.browser.run(position), height - 60)  # the head is up
        self.open("balls.html")
        self.assertTrue(self.letters() <= set("xyz"))

    def test_divides_before_and_after(self):
        self.open("balls.html")
        self.browser.set("#viewer-compare", "divider")
        self.browser.click("#viewer-triangles")
        pictures = []
        for position in (0, 0.5, 1):
            self.browser.set("#viewer-divider", position)
            pictures.append(self.picture()[40:-60])
        after, both, before = pictures
        middle = both.shape[1] // 2
        self.assertTrue(np.array_equal(both[:, :middle - 4], before[:, :middle - 4]))
        self.assertTrue(np.array_equal(both[:, middle + 4:], after[:, middle + 4:]))
        self.assertFalse(np.array_equal(before, after))
        self.browser.set("#viewer-divider", 0.5)
        self.browser.point("#viewer-divider", [(0, 0), "pointerDown", (150, 0), "pointerUp"])
        self.assertGreater(float(self.browser.run("return document.getElementById('viewer-divider').value")), 0.6)
        self.browser.set("#viewer-divider", 0.5)
        self.assertTrue(np.array_equal(self.picture()[40:-60], both))  # the view has not turned

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

    def test_farthest_points_of_levels_are_those_of_the_finest(self):
        self.open("measured.html")
        text = (self.folder / "measured.html").read_text(encoding="utf-8")
        self.assertIn("Between points, colors are interpolated", text)
        farthest = float(self.browser.text("#viewer-farthest li:first-child button").split()[0])
        largest = float(re.search(r"largest distance ([\d.]+) mm", self.browser.text("#viewer-after"))[1])
        self.assertTrue(0.0 < farthest <= largest, (farthest, largest))
        self.browser.click("#viewer-farthest li:first-child button")
        chosen = "return document.querySelectorAll('circle.chosen').length"
        self.assertEqual(self.browser.run(chosen), 2)
        finest = self.browser.run("return document.getElementById('viewer-level').max")
        for level, is_shown in (("1", False), (finest, True)):
            self.browser.set("#viewer-level", level)
            self.browser.run("return new Promise((done) => setTimeout(done, 100))")
            self.assertEqual(self.browser.is_shown("#viewer-farthest-group"), is_shown)
            self.assertEqual(self.browser.run(chosen), 2 if is_shown else 0)

    def test_prints_the_picture(self):
        self.open("balls.html")
        self.browser.protocol("Emulation.setEmulatedMedia", media="print")
        self.assertTrue(self.browser.is_shown(".picture img"))
        self.assertFalse(self.browser.is_shown(STAGE))
        self.browser.protocol("Emulation.setEmulatedMedia", media="")

    def test_a_certificate_has_its_tolerance_at_the_scale_and_two_pages_of_paper(self):
        self.open("certificate.html")
        self.assertEqual(self.browser.text("#viewer-ticks").split(), ["0", "tolerance", "50", "100"])
        self.assertEqual(self.browser.text("#viewer-threshold-text"), "0.0 mm")
        self.assertIn("reference alone", self.browser.text("#viewer-compare"))
        pdf = base64.b64decode(self.browser.protocol("Page.printToPDF", preferCSSPageSize=True)["data"])
        self.assertEqual(len(re.findall(rb"/Type\s*/Page\b", pdf)), 2)

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
