# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What of an input is not in the proved surface is part of the proof's sentence, wherever something is proved."""

import html
import re
import zipfile

import numpy as np
from application import UNMEASURED, ApplicationTest, as_doubles, main, sphere, torus, write
from label_maps import blocks, write_map
from vtk.util.numpy_support import vtk_to_numpy

PLATE = "v 0 0 0\nv 20 0 0\nv 20 20 0\nv 0 20 0\nv 5 0 9\nv 8 0 9\n"


def obj(surface, more):
    points = vtk_to_numpy(surface.GetPoints().GetData())
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3) + 1
    return ("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist()) + more
            + "".join("f {} {} {}\n".format(*corners) for corners in triangles.tolist()))


class WhatIsLeftOut(ApplicationTest):
    def entries(self, path, *words):
        """Of the report, by kind; the line of the summary has what is farther away than the bound, or of unknown distance."""
        said = self.succeed(path, "out.vtp", "--max-error", 0.1, "--report", "report.json", "--page", "page.html", *UNMEASURED, *words)
        report = self.report()
        entries = report.get("left_out", [])
        [proved] = re.findall(r"(?m)^proved +(.*)$", said.stdout)
        self.assertEqual(proved, report["proof"]["sentence"])
        page = html.unescape(self.path("page.html").read_text())
        for entry in entries:
            is_covered = entry.get("distance", np.inf) <= report["proof"]["upper"]
            self.assertEqual(entry["sentence"] in proved, not is_covered, proved)
            self.assertEqual("Not proved: " + entry["sentence"] in page, not is_covered)
        return {entry["kind"]: entry for entry in entries}

    def test_of_an_obj_file(self):
        points = torus().GetNumberOfPoints()
        far = "v 0 0 90\nv 0 0 91\nv 0 0 92\n"
        more = far + f"f {points + 1} {points + 2} {points + 3}\nf 1 {points + 1} 1 1\nl 1 {points + 1}\np 1\n"
        self.path("in.obj").write_text(obj(torus(), more + "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n"))
        found = self.entries("in.obj")
        self.assertEqual(set(found), {"triangles", "polygons", "lines", "vertices", "lines_of_file"})
        self.assertGreater(found["triangles"]["distance"], 80)
        self.assertGreater(found["polygons"]["distance"], 80)
        self.assertGreater(found["lines"]["distance"], 80)
        self.assertLess(found["vertices"]["distance"], 0.1)
        self.assertNotIn("distance", found["lines_of_file"])
        diagnosed = self.succeed("diagnose", "in.obj").stdout
        for kind in ("polygons", "lines", "vertices", "lines_of_file"):
            self.assertIn(f"left out  {found[kind]['count']} {found[kind]['what']}", diagnosed)
        certified = self.succeed("certify", "in.obj", "out.vtp").stdout
        self.assertRegex(certified, r"left out +1 line of the reference \(cell 1\), up to \d+\.\d+ mm away\n")

    def test_distances_are_bounds_of_the_true_ones(self):
        """Of a plate, which stays as it is."""
        self.path("in.obj").write_text(PLATE + "f 1 2 3\nf 1 3 4\nl 5 6\nl 1 2\n")
        found = self.entries("in.obj")
        self.assertEqual(found["lines"]["count"], 2)
        self.assertGreaterEqual(found["lines"]["distance"], 9.0)
        self.assertLess(found["lines"]["distance"], 9.01)

    def test_of_a_ply_file(self):
        write(torus(), self.path("in.ply"), ascii_text=True)
        header, body = self.path("in.ply").read_text().split("end_header\n")
        header += "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n"
        self.path("in.ply").write_text(header + body.rstrip() + "\n0 1\n1 2\n")
        self.assertEqual(self.entries("in.ply")["elements"]["what"], "elements 'edge'")

    def test_of_a_3mf_file(self):
        self.succeed(self.written(torus()), "in.3mf", "--target-reduction", 0, *UNMEASURED)
        with zipfile.ZipFile(self.path("in.3mf")) as package:
            parts = {name: package.read(name) for name in package.namelist()}
        [model] = [name for name in parts if name.endswith(".model")]
        text = parts[model].decode()
        unused = re.search(r"<object .*?</object>", text, re.S).group().replace(' id="2"', ' id="77"', 1)
        self.assertTrue('id="77"' in unused)
        parts[model] = text.replace("</resources>", unused + "</resources>").encode()
        with zipfile.ZipFile(self.path("in.3mf"), "w") as package:
            for name, content in parts.items():
                package.writestr(name, content)
        self.assertEqual(self.entries("in.3mf")["objects"]["sentence"], "1 object of the input that the build does not use")

    def written(self, surface):
        write(surface, self.path("whole.ply"))
        return "whole.ply"

    def test_pruned_components(self):
        speck = vtk_to_numpy(sphere(4).GetPoints().GetData()) * 0.05 + (0, 0, 60)
        triangles = vtk_to_numpy(sphere(4).GetPolys().GetConnectivityArray()).reshape(-1, 3) + 1 + torus().GetNumberOfPoints()
        more = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in speck.tolist())
        self.path("in.obj").write_text(obj(torus(), more + "".join("f {} {} {}\n".format(*c) for c in triangles.tolist())))
        found = self.entries("in.obj", "--prune-size", 3)
        self.assertEqual((found["components"]["count"], found["components"]["what"]), (1, "pruned component"))
        self.assertGreater(found["components"]["distance"], 40)

    def test_segments_that_were_not_chosen(self):
        write_map(blocks(1, 2), self.path("map.vti"))
        self.assertEqual(self.entries("map.vti", "--segments", "1")["segments"]["sentence"], "1 segment that was not chosen (2)")
        self.assertEqual(self.entries("map.vti", "--segments", "all"), {})

    def test_nothing_of_an_input_without_losses(self):
        write(as_doubles(torus()), self.path("in.vtp"))
        self.assertEqual(self.entries("in.vtp"), {})
        self.assertNotIn("but for", self.report()["proof"]["sentence"])


if __name__ == "__main__":
    main()
