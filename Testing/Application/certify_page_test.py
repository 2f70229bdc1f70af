# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of bonedecimate certify: its head, colors, words, date and picture."""

import base64
import datetime
import json
import os
import re
import tempfile
import zlib

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from application import ApplicationTest, main, read, sphere, together, torus, write
from certify_test import square, without_a_triangle
from combinations_inputs import scaled

VIOLET = (79, 18, 123)  # the last color of distances
BLUE = (18, 87, 176)  # of the ring


def are_like(pixels, color):
    return np.abs(pixels - color).max(axis=2) < 40


class CertifyPage(ApplicationTest):
    def page(self, reference, result, *words, **keywords):
        write(reference, self.path("reference.ply"))
        write(result, self.path("result.ply"))
        self.run_program("certify", "reference.ply", "result.ply", *words, "--page", "c.html", "--quiet", **keywords)
        return self.path("c.html").read_text(encoding="utf-8")

    def scene(self, page):
        if "viewer-scene" not in page:
            self.skipTest("the program was built without the interactive view")
        return json.loads(re.search(r'id="viewer-scene">(.*?)</script>', page, re.DOTALL)[1])["distances"]

    def pixels(self, page):
        """Those of the picture, the lowest row first."""
        png = re.search(r'image/png;base64,([^"]+)', page)
        if not png:
            self.skipTest("the program was built without pictures")
        with tempfile.NamedTemporaryFile(suffix=".png") as file:
            file.write(base64.b64decode(png[1]))
            file.flush()
            reader = vtkPNGReader()
            reader.SetFileName(file.name)
            reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)

    def close_ups(self, page):
        """The pixels of the lower row of the picture, a close-up of each column."""
        pixels = self.pixels(page)
        return np.array_split(pixels[int(0.11 * len(pixels)):int(0.4 * len(pixels))], 3, axis=1)

    def test_the_head_has_both_bounds_the_tolerance_and_the_position(self):
        page = self.page(square(0.0), square(0.25), "--tolerance", 0.2)
        self.assertRegex(page, r"<strong>0\.2(499|500) mm <small>\(proved: 0\.2(49999|50000) to 0\.25000[01]\)</small></strong>"
                               r"<em>The tolerance of 0\.2 mm is violated\.</em>")
        self.assertRegex(page, r"A point of the re\w+ at -?[\d.]+, -?[\d.]+, 0\.[023] mm is that far from the re\w+\.")

    def test_no_rounding_of_the_head_reaches_the_other_side_of_the_tolerance(self):
        page = self.page(square(0.0), square(0.25), "--tolerance", 0.24999)
        shown = re.search(r"<strong>([\d.]+) mm <small>\(proved: ([\d.]+) to", page)
        self.assertTrue(0.24999 < float(shown[1]) <= 0.25 and 0.24999 < float(shown[2]) <= 0.25, shown[0])
        page = self.page(square(0.0), square(0.25), "--tolerance", 0.25001)
        self.assertIn("<strong>at most 0.25001 mm</strong><em>The tolerance of 0.25001 mm is proved.</em>", page)

    def test_the_picture_has_no_figure_of_the_run_that_made_the_result(self):
        write(torus(), self.path("in.ply"))
        write(sphere(), self.path("other.ply"))
        for folder in ("kept", "removed"):
            self.path(folder).mkdir()
        self.succeed("in.ply", "kept/result.vtp", "--max-error", 0.3)
        surface = read(self.path("kept/result.vtp"))
        surface.GetFieldData().Initialize()
        write(surface, self.path("removed/result.vtp"))
        for reference in ("other.ply", "kept/result.vtp"):
            captions, tables = [], []
            for folder in ("kept", "removed"):
                self.succeed("certify", reference, f"{folder}/result.vtp", "--page", "c.html")
                page = self.path("c.html").read_text(encoding="utf-8")
                pixels = self.pixels(page)
                captions.append(pixels[int(0.91 * len(pixels)):])
                tables.append(re.findall(r"(?s)are farthest apart.*?</table>", page))
            self.assertEqual(*tables)
            np.testing.assert_array_equal(*captions)

    def test_the_head_names_an_open_boundary_that_alone_violates_the_tolerance(self):
        page = self.page(torus(), without_a_triangle(torus()), "--tolerance", 5)
        head = page[page.index('<div class="headline'):page.index('<div class="stage"' if "viewer-stage\">" in page else "<img ")]
        self.assertIn("<strong>open boundary</strong><em>The tolerance of 5 mm is violated.</em>", head)
        self.assertRegex(head, "Only the result has open boundaries, one at .* Apart from that, no point of either surface is farther than")
        self.assertNotIn("at least", head)
        self.assertNotIn("Exceptions", head)

    def test_colors_change_at_the_tolerance(self):
        for tolerance, is_within in ((0.25, True), (0.2499, False), (1, True), (0.1, False)):
            page = self.page(square(0.0), square(0.25), "--tolerance", tolerance)
            scale = self.scene(page)
            self.assertEqual((scale["tolerance"], scale["threshold"]), (tolerance, 0))
            self.assertAlmostEqual(scale["range"] / tolerance, 255 / 128, 12)
            colors = np.array(scale["colors"])
            self.assertTrue((np.abs(colors[128:] - VIOLET) < 2).all())
            self.assertGreater(colors[:128].sum(axis=1).min(), 400)
            for surface in re.findall(r'class="surface">(.*?)</script>', page):
                steps = list(zlib.decompress(base64.b64decode(surface))[-4:])
                self.assertEqual({step < 128 for step in steps}, {is_within}, (tolerance, steps))
        self.assertNotIn("tolerance", self.scene(self.page(square(0.0), square(0.25))))

    def test_without_a_tolerance_colors_begin_below_the_largest_distance(self):
        self.assertTrue(100 < self.scene(self.page(torus(), scaled(torus(), 0.99)))["threshold"] < 250)

    def test_the_close_up_shows_a_lost_fragment_even_inside_of_the_bone(self):
        for x in (0.0, 15.0):
            fragment = scaled(sphere(center=x / 0.05), 0.05)
            page = self.page(together(sphere(), fragment), sphere(), "--tolerance", 0.5)
            reference, result, distance = self.close_ups(page)
            for close_up in (reference, result, distance):
                self.assertGreater(are_like(close_up, BLUE).sum(), 100)
            rows, columns = np.nonzero(are_like(distance, VIOLET))
            self.assertGreater(len(rows), 300)
            height, width, _ = distance.shape
            middle = distance[height // 2 - 40:height // 2 + 40, width // 2 - 40:width // 2 + 40]
            self.assertGreater(are_like(middle, VIOLET).sum(), 100)

    def test_the_close_up_shows_what_only_the_result_has(self):
        _, _, distance = self.close_ups(self.page(sphere(), together(sphere(), scaled(sphere(center=300.0), 0.05)), "--tolerance", 0.5))
        self.assertGreater(are_like(distance, VIOLET).sum(), 300)

    def test_says_reference_and_result_everywhere(self):
        page = self.page(torus(), scaled(torus(), 0.99), "--tolerance", 0.5)
        shown = re.sub(r"<script.*?</script>|<style>.*?</style>|<[^>]*>", " ", page, flags=re.DOTALL)
        self.assertNotRegex(shown, r"(?i)\b(before|after)\b(?! equal points)")
        self.assertNotIn("before and after", page)
        for words in ("The reference and the result, and", "reference alone", "Divider between reference and result"):
            self.assertTrue(words in page or "viewer-stage" not in page, words)

    def test_has_the_date(self):
        surfaces = (square(0.0), square(0.25))
        begin = datetime.datetime.now(datetime.timezone.utc).replace(second=0, microsecond=0)
        environment = {name: value for name, value in os.environ.items() if name != "SOURCE_DATE_EPOCH"}
        found = re.search(r"Date: (\d{4}-\d\d-\d\d \d\d:\d\d) UTC\.", self.page(*surfaces, env=environment))[1]
        moment = datetime.datetime.strptime(found + "+0000", "%Y-%m-%d %H:%M%z")
        self.assertTrue(begin <= moment <= datetime.datetime.now(datetime.timezone.utc), found)
        pages = [self.page(*surfaces, env={**environment, "SOURCE_DATE_EPOCH": "86400"}) for _ in range(2)]
        self.assertIn("Date: 1970-01-02 00:00 UTC.", pages[0])
        self.assertEqual(*pages)


if __name__ == "__main__":
    main()
