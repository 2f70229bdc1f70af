# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Polygons of every shape are triangulated; what has no triangle is named wherever something is proved."""

import math

import numpy as np

from application import ApplicationTest, main, read


def box(turn=()):
    """A closed box of 4 x 4 quadrilaterals a side, those of the numbers crossing themselves; text of an OBJ file."""
    points, faces = {}, []

    def number(point):
        return points.setdefault(point, len(points) + 1)

    for axis in range(3):
        for side in (0, 4):
            for i in range(4):
                for j in range(4):
                    corners = []
                    for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        point = [0, 0, 0]
                        point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, a, b
                        corners.append(number(tuple(point)))
                    faces.append(corners if side else corners[::-1])
    for face in turn:
        faces[face][1], faces[face][2] = faces[face][2], faces[face][1]
    lines = ["v %g %g %g" % tuple(5.0 * c for c in point) for point in points]
    return "\n".join(lines + ["f " + " ".join(map(str, face)) for face in faces]) + "\n"


def flat_polygon(radii):
    """A disk with corners at these distances from its center, closed by a pyramid."""
    count = len(radii)
    lines = ["v %r %r 0" % (r * math.cos(2 * math.pi * i / count), r * math.sin(2 * math.pi * i / count))
             for i, r in enumerate(radii.tolist())]
    lines.append("v 0 0 -15")
    lines.append("f " + " ".join(str(i + 1) for i in range(count)))
    lines += [f"f {(i + 1) % count + 1} {i + 1} {count + 1}" for i in range(count)]
    return "\n".join(lines) + "\n"


class Polygons(ApplicationTest):
    def test_polygons_that_cross_themselves_leave_no_hole(self):
        self.path("in.obj").write_text(box(turn=(3, 20, 40)))
        said = self.succeed("in.obj", "out.vtp", "--target-reduction", 0).stdout
        self.assertNotIn("left out", said)
        self.assertEqual(read(self.path("out.vtp")).GetNumberOfPolys(), 192)

    def test_concave_polygons_have_no_overlaps(self):
        radii = np.random.default_rng(5).uniform(4, 20, 301)
        self.path("in.obj").write_text(flat_polygon(radii))
        self.succeed("in.obj", "out.vtp", "--max-error", 0.01, "--report", "report.json")
        report = self.report()
        self.assertEqual(report["input"]["triangles"], 299 + 301)
        self.assertEqual(report["input"]["boundary_edges"], 0)
        angle = 2 * math.pi / len(radii)
        area = 0.5 * math.sin(angle) * float(np.sum(radii * np.roll(radii, 1)))
        self.assertAlmostEqual(report["input"]["volume"], area * 5.0, delta=1e-6 * area)

    def test_a_polygon_of_very_many_corners_is_read_at_once(self):
        self.path("in.obj").write_text(flat_polygon(np.random.default_rng(6).uniform(5, 10, 30000)))
        self.succeed("diagnose", "in.obj", timeout=60)

    def test_what_has_no_triangle_is_named_wherever_something_is_proved(self):
        text = "# vtk DataFile Version 2.0\nbone\nASCII\nDATASET POLYDATA\n"
        lines = box().splitlines()
        points = [line[2:] for line in lines if line.startswith("v ")]
        faces = [[int(c) - 1 for c in line[2:].split()] for line in lines if line.startswith("f ")] + [[0, 1], [0, len(points)]]
        points.append("0 0 90")
        text += f"POINTS {len(points)} float\n" + "\n".join(points)
        text += f"\nPOLYGONS {len(faces)} {sum(len(f) + 1 for f in faces)}\n"
        text += "".join(" ".join(map(str, [len(f), *f])) + "\n" for f in faces)
        self.path("in.vtk").write_text(text)
        sentence = "2 polygons of fewer than three different corners were left out, the first is cell 96"
        entry = r"2 polygons of fewer than three different corners \(the first is cell 96\)"
        said = self.succeed("in.vtk", "out.vtp", "--max-error", 0.1, "--report", "report.json", "--page", "page.html").stdout
        self.assertRegex(said, rf"proved .*, but for {entry}, up to [0-9.]+ mm away\n")
        self.assertIn("warning: " + sentence, said)
        [found] = self.report()["left_out"]
        self.assertEqual((found["kind"], found["count"], found["where"]), ("polygons", 2, "cell 96"))
        self.assertRegex(self.path("page.html").read_text(), "Not proved: " + entry)
        self.assertRegex(self.succeed("diagnose", "in.vtk").stdout, "left out  " + entry)
        certified = self.succeed("certify", "in.vtk", "out.vtp", "--tolerance", 0.1).stdout
        self.assertRegex(certified, r"left out +2 polygons of fewer than three different corners of the reference \(.*\), up to")
        self.assertRegex(certified, "proved <= 0.100000 mm, but for what was left out\n")
        several = self.succeed("certify", "in.vtk", "out.vtp", "out.vtp", "--tolerance", 0.1).stdout
        self.assertRegex(several, r"(?m)^out\.vtp: .* mm, proved, but for what was left out$")


if __name__ == "__main__":
    main()
