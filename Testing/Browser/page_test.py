#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page that decimates in the browser, opened as a file in Chromium: page_test.py PAGE [PROGRAM]

With the program bonedecimate what the page saves is compared with what the program writes.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "Page"))
import browser as chromium
from browser import Browser, drawn

PAGE = pathlib.Path(sys.argv.pop(1)).resolve()
PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None
FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])


def bumpy_ball(rings):
    """The corners of the triangles of a closed surface, mm."""
    around = 2 * rings
    u = np.linspace(0.0, np.pi, rings + 1)[:, None]
    v = np.arange(around + 1)[None, :] % around * (2.0 * np.pi / around)
    radius = 30.0 + np.sin(9 * u) * np.cos(7 * v) * np.sin(u)
    grid = np.stack([radius * np.sin(u) * np.cos(v), radius * np.sin(u) * np.sin(v), radius * np.cos(u) + 0.0 * v], axis=-1)
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, :-1], grid[1:, 1:]
    grid[0], grid[-1] = grid[0, 0], grid[-1, 0]
    upper = np.stack([a, c, b], axis=2).reshape(-1, 3, 3)[around:]
    lower = np.stack([b, c, d], axis=2).reshape(-1, 3, 3)[:-around]
    return np.concatenate([upper, lower]).astype(np.float32)


def write_stl(path, corners):
    facets = np.zeros(len(corners), FACET)
    facets["corners"] = corners
    path.write_bytes(bytes(80) + np.uint32(len(corners)).tobytes() + facets.tobytes())


def read_stl(path):
    data = path.read_bytes()
    return np.frombuffer(data, FACET, offset=84)["corners"].copy()


def canonical(corners):
    """Triangles in an order of their own, each from its least corner on."""
    rows = []
    for triangle in np.asarray(corners, np.float32) + np.float32(0):
        turns = [np.roll(triangle, -i, axis=0).ravel().tolist() for i in range(3)]
        rows.append(min(turns))
    return sorted(rows)


def flat_square(height):
    """Two triangles in a plane z = height."""
    a, b, c, d = (np.array([x, y, height]) for x, y in ((0, 0), (8, 0), (8, 8), (0, 8)))
    return np.array([[a, b, c], [a, c, d]], np.float32)


def write_ply(path, corners):
    lines = [f"{x:.9g} {y:.9g} {z:.9g}" for x, y, z in corners.reshape(-1, 3)]
    faces = [f"3 {3 * i} {3 * i + 1} {3 * i + 2}" for i in range(len(corners))]
    header = ["ply", "format ascii 1.0", f"element vertex {len(lines)}", "property float x", "property float y", "property float z",
              f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    path.write_text("\n".join(header + lines + faces) + "\n", encoding="ascii")


def write_nifti(path, labels, spacing):
    """The header of NIfTI-1 with a unit direction."""
    header = np.zeros(348, np.uint8)
    header[:4] = np.frombuffer(np.int32(348).tobytes(), np.uint8)
    header[40:56] = np.frombuffer(np.array([3, *labels.shape[::-1], 1, 1, 1, 1], "<i2").tobytes(), np.uint8)
    header[70:74] = np.frombuffer(np.array([512, 16], "<i2").tobytes(), np.uint8)
    header[76:108] = np.frombuffer(np.array([1, *spacing, 1, 1, 1, 1], "<f4").tobytes(), np.uint8)
    header[108:112] = np.frombuffer(np.float32(352).tobytes(), np.uint8)
    header[112:116] = np.frombuffer(np.float32(1).tobytes(), np.uint8)
    header[123] = 2
    header[252:256] = np.frombuffer(np.array([0, 1], "<i2").tobytes(), np.uint8)
    rows = np.diag(spacing).astype("<f4")
    header[280:328] = np.frombuffer(np.hstack([rows, np.zeros((3, 1), "<f4")]).astype("<f4").tobytes(), np.uint8)
    header[344:348] = np.frombuffer(b"n+1\0", np.uint8)
    path.write_bytes(header.tobytes() + bytes(4) + labels.astype("<u2").tobytes())


def two_labels():
    z, y, x = np.mgrid[:30, :30, :30] - 14.5
    inside = x * x + y * y + 0.7 * z * z < 120.0
    return np.where(inside, np.where(x < 0, 3, 9), 0)


@unittest.skipUnless(chromium.CHROMIUM and chromium.DRIVER, chromium.MISSING)
class BrowserPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="bonedecimate-browser-")
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        cls.corners = bumpy_ball(120)
        write_stl(cls.folder / "ball.stl", cls.corners)
        cls.browser = Browser(*chromium.SOFTWARE, "--window-size=1200,1300")
        cls.addClassCleanup(cls.browser.__exit__)
        cls.browser.command("POST", "/goog/cdp/execute", {"cmd": "Browser.setDownloadBehavior",
                            "params": {"behavior": "allow", "downloadPath": str(cls.folder / "saved")}})

    def setUp(self):
        self.browser.messages()
        self.browser.requests()
        self.browser.protocol("Network.enable")
        self.browser.protocol("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=0, uploadThroughput=0)
        self.browser.open(PAGE)

    def tearDown(self):
        self.assertEqual(self.browser.messages(), [])
        self.assertEqual(self.browser.requests(), [PAGE.as_uri()])

    def state(self):
        return self.browser.run("return document.documentElement.dataset.state")

    def wait(self, *states, seconds=120):
        end = time.monotonic() + seconds
        self.browser.run("return new Promise((done) => requestAnimationFrame(() => setTimeout(done, 50)))")  # what was clicked begins
        while self.state() == "busy":
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)
        self.assertIn(self.state(), states, self.text("#problem"))

    def text(self, selector):
        return self.browser.run("return document.querySelector(arguments[0]).textContent", selector)

    def texts(self, selector):
        return self.browser.run("return [...document.querySelectorAll(arguments[0])].map((one) => one.textContent)", selector)

    def count(self, selector):
        return len(self.texts(selector))

    def rows(self):
        """Of the table of the certificate."""
        return dict(zip(self.texts("#certificate td:first-child"), self.texts("#certificate td:last-child")))

    def prove(self, tolerance):
        """The sentence about a tolerance."""
        self.browser.set("#tolerance", tolerance)
        self.browser.click("#certify")
        self.wait("done")
        return self.rows()["Tolerance"]

    def drop(self, *paths):
        """As a person drops files from another window."""
        x, y = self.browser.run("const b = document.querySelector('#drop').getBoundingClientRect();"
                                "return [b.x + b.width / 2, b.y + b.height / 2]")
        data = {"items": [], "files": [str(path) for path in paths], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.browser.protocol("Input.dispatchDragEvent", type=kind, x=x, y=y, data=data)
        end = time.monotonic() + 10
        while self.state() is None and time.monotonic() < end:
            time.sleep(0.02)

    def choose(self, *paths):
        text = "\n".join(str(path) for path in paths)
        self.browser.command("POST", f"/element/{self.browser.find('#choose')}/value", {"text": text})

    def set(self, **options):
        for name, value in options.items():
            self.browser.set(f"#option-{name}", value)

    def saved(self, button, name):
        self.browser.click(button)
        path = self.folder / "saved" / name
        end = time.monotonic() + 20
        while not path.exists() and time.monotonic() < end:
            time.sleep(0.05)
        return path

    def test_decimates_a_dropped_file_and_saves_what_the_program_writes(self):
        self.drop(self.folder / "ball.stl")
        self.wait("done")
        self.assertIn("57,120 triangles", self.text("#file"))
        self.set(maxError="0.1")
        self.browser.click("#run")
        self.wait("done")
        self.assertLessEqual(float(self.text("#upper").split()[0]), 0.1)
        self.assertIn("no point of either surface is farther than", self.text("#certificate"))
        after = int(self.text("#second-count").replace(",", ""))
        self.assertLess(after, 20000)
        self.browser.run("document.querySelector('#view').scrollIntoView()")
        left, right = np.array_split(drawn(self.browser.picture("#viewer-stage")[2:-2, 2:-2]), 2, axis=1)
        self.assertGreater(left.mean(), 0.1)
        self.assertAlmostEqual(left.mean(), right.mean(), delta=0.1 * left.mean())
        self.assertEqual(self.count("#viewer-farthest button"), 10)
        corners = read_stl(self.saved("#save-stl", "ball-decimated.stl"))
        self.assertEqual(len(corners), after)
        self.assertGreater(self.saved("#save-ply", "ball-decimated.ply").stat().st_size, 12 * after)
        if PROGRAM:
            subprocess.run([PROGRAM, self.folder / "ball.stl", self.folder / "native.stl", "--max-error", "0.1"],
                           check=True, capture_output=True)
            self.assertEqual(canonical(corners), canonical(read_stl(self.folder / "native.stl")))

    def test_a_number_of_triangles_gets_a_certificate_too(self):
        write_ply(self.folder / "ball.ply", bumpy_ball(30))
        self.choose(self.folder / "ball.ply")
        self.wait("done")
        self.set(maxError="", targetTriangles="1000")
        self.browser.click("#run")
        self.wait("done")
        self.assertEqual(self.text("#second-count"), "1,000")
        self.assertGreater(float(self.text("#upper").split()[0]), 0.0)
        self.assertIn("after the run", self.text("#certificate"))

    def test_extracts_and_smooths_a_label_map(self):
        write_nifti(self.folder / "labels.nii", two_labels(), (0.8, 0.8, 1.2))
        self.drop(self.folder / "labels.nii")
        self.wait("done")
        self.assertIn("2 labels", self.text("#file"))
        self.set(maxError="0.6", smooth="0.4")
        self.browser.click("#run")
        self.wait("done")
        before, after = (int(self.text(name).replace(",", "")) for name in ("#first-count", "#second-count"))
        self.assertLess(after, 0.4 * before)
        self.assertLessEqual(set(self.texts("#viewer-overlay .letter")), set("RLAPIS"))
        if PROGRAM:
            words = ["--segments", "all", "--max-error", "0.6", "--smooth", "0.4", "--report", self.folder / "report.json"]
            subprocess.run([PROGRAM, self.folder / "labels.nii", self.folder / "native.vtp", *words], check=True, capture_output=True)
            report = json.loads((self.folder / "report.json").read_text(encoding="utf-8"))
            self.assertEqual([report[side]["triangles"] for side in ("input", "output")], [before, after])

    def test_cancels_and_runs_again(self):
        write_stl(self.folder / "large.stl", bumpy_ball(350))
        self.choose(self.folder / "large.stl")
        self.wait("done")
        self.set(maxError="0.01")
        self.browser.click("#run")
        end = time.monotonic() + 60
        while self.browser.run("return document.querySelector('#bar').value") < 0.02 and time.monotonic() < end:
            time.sleep(0.02)
        self.assertTrue(self.browser.is_shown("#cancel"))
        self.browser.click("#cancel")
        self.wait("canceled", seconds=2)
        self.assertIn("Canceled", self.text("#problem"))
        self.assertFalse(self.browser.is_shown("#results"))
        self.set(maxError="", targetReduction="0.9", mode="Fast")
        self.browser.click("#run")
        self.wait("done")

    def test_says_what_is_wrong_with_a_file_or_an_option(self):
        whole = (self.folder / "ball.stl").read_bytes()
        nifti = self.folder / "short.nii"
        write_nifti(nifti, two_labels(), (1.0, 1.0, 1.0))
        nifti.write_bytes(nifti.read_bytes()[:9000])
        bad = {"truncated.stl": (whole[:5000], "damaged"), "noise.ply": (b"\x07" * 999, "no PLY header"),
               "cut.ply": (b"ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float x\nproperty float y\n"
                           b"property float z\nelement face 3\nproperty list uchar int vertex_indices\nend_header\nab", "."),
               "short.nii": (nifti.read_bytes(), "ends early"), "photo.jpg": (b"\xff\xd8", "STL, PLY and NIfTI"),
               "empty.stl": (b"", "damaged")}
        for name, (data, pattern) in bad.items():
            (self.folder / name).write_bytes(data)
            self.choose(self.folder / name)
            self.wait("failed")
            self.assertIn(pattern, self.text("#problem"), name)
            self.assertFalse(self.browser.run("return !document.querySelector('#run').disabled"), name)
        self.choose(self.folder / "ball.stl")
        self.wait("done")
        self.set(maxError="-1")
        self.browser.click("#run")
        self.wait("failed")
        self.assertIn("0 to 1e30 mm", self.text("#problem"))

    def test_two_dropped_files_are_compared(self):
        # The point of the largest x is farther than the shift from all of the other surface, and no point is farther.
        corners = bumpy_ball(40)
        shift = 0.25
        write_stl(self.folder / "first.stl", corners)
        write_ply(self.folder / "second.ply", corners + np.float32([shift, 0, 0]))
        self.drop(self.folder / "first.stl", self.folder / "second.ply")
        self.wait("done")
        self.assertEqual([self.text("#reference"), self.text("#result")],
                         [f"{name}: 6,240 triangles" for name in ("first.stl", "second.ply")])
        self.assertFalse(any(self.browser.is_shown(each) for each in ("#options", "#run", "#save-stl")))
        rows = self.rows()
        self.assertIn("no tolerance", rows["Tolerance"])
        bounds = re.fullmatch(r"([\d.]+) mm to ([\d.]+) mm", rows["Largest distance, both directions"])
        lower, upper = (float(bound) for bound in bounds.groups())
        self.assertTrue(lower <= shift + 1e-5 and shift - 1e-5 <= upper <= 1.002 * shift, (lower, upper))
        for row in ("Reference to result", "Result to reference"):
            mean, rms = (float(number) for number in re.search(r"mean ([\d.]+) .*RMS ([\d.]+)", rows[row]).groups())
            self.assertTrue(0.3 * shift < mean < rms < shift, rows[row])
        self.assertEqual(rows["Components"], "1 of the reference, 1 of the result")
        self.assert_both_are_drawn_and_the_farthest_is_shown(shift)
        self.assertIn("Proved: no point of either surface is farther than 0.3 mm", self.prove("0.3"))
        self.assertRegex(self.prove("0.2"), r"Violated: .* the point -?[\d.]+, -?[\d.]+, -?[\d.]+ is at least 0\.2[45]\d* mm away")
        self.browser.click("#swap")
        self.wait("done")
        self.assertIn("second.ply", self.text("#reference"))
        self.assertIn("Violated", self.rows()["Tolerance"])
        self.assert_certificate_is_that_of_the_program(self.saved("#save-json", "first-certificate.json"))

    def assert_both_are_drawn_and_the_farthest_is_shown(self, distance):
        self.browser.run("document.querySelector('#view').scrollIntoView()")
        left, right = np.array_split(drawn(self.browser.picture("#viewer-stage")[2:-2, 2:-2]), 2, axis=1)
        self.assertGreater(left.mean(), 0.1)
        self.assertAlmostEqual(left.mean(), right.mean(), delta=0.1 * left.mean())
        self.assertTrue(self.browser.is_shown("#viewer-legend"))
        self.assertEqual(self.texts("#viewer-compare option")[2:], ["reference alone", "result alone"])
        points = self.texts("#viewer-farthest button")
        self.assertEqual(len(points), 10)
        lengths = [float(point.split()[0]) for point in points]
        self.assertEqual(lengths, sorted(lengths, reverse=True))
        self.assertAlmostEqual(lengths[0], distance, delta=2e-4)
        self.browser.click("#viewer-farthest button")
        self.assertEqual(self.count("#viewer-overlay circle.chosen"), 2)
        self.assertEqual(set(self.texts("#viewer-overlay text:not(.letter)")), {f"{points[0].split()[0]} mm"})

    def assert_certificate_is_that_of_the_program(self, path):
        """Of second.ply and first.stl with 0.2 mm."""
        found = json.loads(path.read_text(encoding="utf-8"))
        self.assertEqual((found["status"], found["tolerance"]), ("violated", 0.2))
        self.assertEqual((found["files"]["reference"], found["files"]["result"]), ("second.ply", "first.stl"))
        if PROGRAM:
            files = [self.folder / name for name in ("second.ply", "first.stl", "native.json")]
            words = [*files[:2], "--tolerance", "0.2", "--json", files[2]]
            self.assertEqual(subprocess.run([PROGRAM, "certify", *words], check=False, capture_output=True).returncode, 6)
            native = json.loads(files[2].read_text(encoding="utf-8"))
            self.assertLessEqual(found.keys(), native.keys())
            for key in ("reference_to_result", "result_to_reference"):
                self.assertLessEqual(found[key]["lower"], native[key]["upper"])
                self.assertLessEqual(native[key]["lower"], found[key]["upper"])
                self.assertLess(found[key]["upper"] - found[key]["lower"], 2e-3 * found[key]["upper"])

    def test_a_tolerance_may_be_undecided_and_open_boundaries_count(self):
        write_stl(self.folder / "low.stl", flat_square(0.0))
        write_stl(self.folder / "high.stl", np.concatenate([flat_square(0.75), flat_square(0.75) + np.float32([20, 0, 0])]))
        write_stl(self.folder / "flat.stl", flat_square(0.75))
        self.choose(self.folder / "low.stl", self.folder / "flat.stl")
        self.wait("done")
        self.assertIn("Undecided", self.prove("0.75"))
        self.assertIn("Open boundaries, reference to result", self.rows())
        self.choose(self.folder / "low.stl", self.folder / "high.stl")
        self.wait("done")
        self.assertEqual(self.rows()["Components"], "1 of the reference, 2 of the result")
        self.assertNotIn("Warning", self.rows())
        self.choose(self.folder / "high.stl", self.folder / "flat.stl")
        self.wait("done")
        self.assertIn("1 of 2 components of the reference is missing in the result", self.rows()["Warning"])
        missing = json.loads(self.saved("#save-json", "flat-certificate.json").read_text(encoding="utf-8"))["missing"]
        self.assertEqual(len(missing), 1)
        self.assertGreater(missing[0]["x"], 20.0)
        write_stl(self.folder / "whole.stl", bumpy_ball(12))
        write_stl(self.folder / "open.stl", bumpy_ball(12)[1:])
        self.choose(self.folder / "whole.stl", self.folder / "open.stl")
        self.wait("done")
        self.assertIn("only the result has some", self.prove("20"))

    def test_a_label_map_is_compared_by_its_surfaces(self):
        write_nifti(self.folder / "map.nii", two_labels(), (0.8, 0.8, 1.2))
        self.drop(self.folder / "map.nii", self.folder / "ball.stl")
        self.wait("done")
        self.assertIn("surfaces of 2 labels", self.text("#reference"))
        self.assertGreater(float(self.text("#upper").split()[0]), 10.0)
        self.assertRegex(self.text("#viewer-farthest"), r"at [RL] [\d.]+, [AP] [\d.]+, [IS] [\d.]+")

    def test_says_what_is_wrong_with_a_pair(self):
        (self.folder / "noise.ply").write_bytes(b"\x07" * 999)
        small = self.folder / "small.stl"
        write_stl(small, bumpy_ball(12))
        for files, pattern in (([small, self.folder / "noise.ply"], "noise.ply: the file is damaged"),
                               ([self.folder / "noise.ply", small], "noise.ply: the file is damaged"),
                               ([small] * 3, "3 files")):
            self.drop(*files)
            self.wait("failed")
            self.assertIn(pattern, self.text("#problem"))
            self.assertFalse(self.browser.is_shown("#results"))
            self.assertTrue(self.browser.run("return document.querySelector('#certify').disabled"))
        self.drop(small, small)
        self.wait("done")
        for wrong in ("-1", "half", "1e31"):
            self.browser.set("#tolerance", wrong)
            self.browser.click("#certify")
            self.wait("failed")
            self.assertIn("from 0 to 1e30", self.text("#problem"))
        self.assertIn("Proved", self.prove("0.001"))
        self.choose(small)
        self.wait("done")
        self.assertTrue(self.browser.is_shown("#run"))
        self.assertFalse(self.browser.is_shown("#certify"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[1:]])
