# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What is proved is true of the numbers that stand in the files, however far from the origin they are.

The distances are computed here from the files' own bytes, about a point near the surface so that nothing is rounded that counts,
between points of one surface and the triangles of the other: a lower bound of the true distance, which no proved bound may be
below.
"""

import re
import struct

import numpy as np
from vtk.util.numpy_support import vtk_to_numpy

from application import UNMEASURED, ApplicationTest, as_doubles, main, read, torus, write

FAR = ((1e4, 0.001), (1e7, 0.05))  # from the origin and the largest error, mm
EXTENDED = np.longdouble


def arrays_of(surface):
    """Points and triangles."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    return points, vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def far_torus(center):
    """Points and triangles of a torus of 12 mm in double precision, none of them single numbers."""
    points, triangles = arrays_of(torus(20, 12))
    return points * 0.21 + center + 0.123456789, triangles


def far_surface(center):
    """Points and triangles of a square of 12 mm with waves of .02 mm, as doubles that are no single numbers."""
    side = 14
    positions = np.stack(np.meshgrid(np.arange(side), np.arange(side), indexing="ij"), -1).reshape(-1, 2) * 0.7123456789
    heights = 0.01 * np.sin(positions[:, 0]) * np.cos(1.3 * positions[:, 1])
    corners = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    triangles = np.concatenate([corners[:, None] + (0, side, side + 1), corners[:, None] + (0, side + 1, 1)])
    return np.column_stack([positions, heights]) + center + 0.123456789, triangles


def obj_of(points, triangles):
    lines = ["v %r %r %r" % tuple(map(float, p)) for p in points] + ["f %d %d %d" % tuple(t + 1) for t in triangles]
    return ("\n".join(lines) + "\n").encode()


def ply_header(form, type_of_number, points, triangles):
    axes = "".join(f"property {type_of_number} {axis}\n" for axis in "xyz")
    return (f"ply\nformat {form} 1.0\nelement vertex {len(points)}\n{axes}element face {len(triangles)}\n"
            "property list uchar int vertex_indices\nend_header\n").encode()


def text_ply_of(points, triangles, type_of_number="double"):
    lines = ["%r %r %r" % tuple(map(float, p)) for p in points] + ["3 %d %d %d" % tuple(t) for t in triangles]
    return ply_header("ascii", type_of_number, points, triangles) + ("\n".join(lines) + "\n").encode()


def binary_ply_of(points, triangles, order="<"):
    form = "binary_little_endian" if order == "<" else "binary_big_endian"
    faces = b"".join(struct.pack(order + "B3i", 3, *t) for t in triangles)
    return ply_header(form, "double", points, triangles) + points.astype(order + "f8").tobytes() + faces


def text_stl_of(points, triangles):
    facets = ["facet normal 0 0 0\nouter loop\n" + "".join("vertex %r %r %r\n" % tuple(map(float, points[i])) for i in t)
              + "endloop\nendfacet\n" for t in triangles]
    return ("solid bone\n" + "".join(facets) + "endsolid bone\n").encode()


def cells_text(triangles, form):
    return "".join(form % tuple(t) for t in triangles)


def text_vtk_of(points, triangles):
    return ("# vtk DataFile Version 3.0\nbone\nASCII\nDATASET POLYDATA\n"
            f"POINTS {len(points)} float\n" + "".join("%r %r %r\n" % tuple(map(float, p)) for p in points)
            + f"POLYGONS {len(triangles)} {4 * len(triangles)}\n" + cells_text(triangles, "3 %d %d %d\n")).encode()


def text_vtp_of(points, triangles):
    def array(kind, name, text):
        return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{3 if name == "Points" else 1}" format="ascii">{text}</DataArray>'

    ends = " ".join(str(3 * i + 3) for i in range(len(triangles)))
    return ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>'
            f'<Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(triangles)}"><Points>'
            + array("Float32", "Points", "\n".join("%r %r %r" % tuple(map(float, p)) for p in points)) + "</Points><Polys>"
            + array("Int32", "connectivity", cells_text(triangles, "%d %d %d ")) + array("Int32", "offsets", ends)
            + "</Polys></Piece></PolyData></VTKFile>\n").encode()


FORMS = {
    "text.obj": obj_of,
    "text.ply": text_ply_of,
    "single.ply": lambda points, triangles: text_ply_of(points, triangles, "float"),
    "little.ply": binary_ply_of,
    "big.ply": lambda points, triangles: binary_ply_of(points, triangles, ">"),
    "text.stl": text_stl_of,
    "text.vtk": text_vtk_of,
    "text.vtp": text_vtp_of,
}


def corners_of(path):
    """The corners of all triangles in a file that the program wrote, in extended precision, not by its readers nor VTK's."""
    data = path.read_bytes()
    if path.suffix == ".obj":
        points = [line.split()[1:4] for line in data.decode().splitlines() if line.startswith("v ")]
        faces = [[int(word) - 1 for word in line.split()[1:]] for line in data.decode().splitlines() if line[:2] == "f "]
        return np.array([[EXTENDED(x) for x in p] for p in points])[np.array(faces)]
    if path.suffix == ".stl":
        kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        return np.frombuffer(data, kind, offset=84)["corners"].astype(EXTENDED)
    header, body = data.split(b"end_header\n", 1)
    count = int(re.search(rb"vertex (\d+)", header).group(1))
    wide = b"property double x" in header
    points = np.frombuffer(body, "<f8" if wide else "<f4", 3 * count).reshape(-1, 3).astype(EXTENDED)
    faces = np.frombuffer(body, np.dtype([("n", "u1"), ("corners", "<i4", 3)]), offset=count * (24 if wide else 12))
    return points[faces["corners"]]


def distances(points, triangles):
    """Of each point to the nearest of the triangles: of the foot on the plane if it is inside, else on an edge."""
    a, b, c = (triangles[None, :, i] for i in range(3))
    p = points[:, None]
    normal = np.cross(b - a, c - a)
    inside = np.ones((len(points), len(triangles)), bool)
    best = np.full((len(points), len(triangles)), np.inf)
    for u, v in ((a, b), (b, c), (c, a)):
        inside &= (np.cross(v - u, p - u) * normal).sum(-1) >= 0
        length = ((v - u) ** 2).sum(-1)
        fraction = np.clip(((p - u) * (v - u)).sum(-1) / np.where(length > 0, length, 1), 0, 1)
        best = np.minimum(best, np.linalg.norm(p - u - fraction[..., None] * (v - u), axis=-1))
    area = np.linalg.norm(normal, axis=-1)
    plane = np.abs(((p - a) * normal).sum(-1)) / np.where(area > 0, area, 1)
    return np.where(inside & (area > 0), plane, best).min(1)


def true_distance(first, second):
    """Of two surfaces in both directions, from below: of corners and of the middles of triangles."""
    middle = first[0, 0]
    first, second = (np.asarray(corners - middle, float) for corners in (first, second))

    def samples(corners):
        return np.concatenate([np.unique(corners.reshape(-1, 3), axis=0), corners.mean(1)])

    return max(distances(samples(first), second).max(), distances(samples(second), first).max())


class Precision(ApplicationTest):
    def test_proof_holds_for_the_numbers_of_the_files(self):
        for far, error in FAR:
            points, triangles = far_surface(far)
            exact = points.astype(EXTENDED)[triangles]
            for name, form in FORMS.items():
                with self.subTest(far=far, input=name):
                    self.path(name).write_bytes(form(points, triangles))
                    words = ("--also", "out.obj", "--max-error", error, "--report", "report.json", *UNMEASURED)
                    text = self.succeed(name, "out.ply", *words).stdout
                    printed = float(re.search(r"(?m)^proved +at most (\S+) mm", text).group(1))
                    for output in ("out.ply", "out.obj"):
                        self.assertLessEqual(true_distance(exact, corners_of(self.path(output))), printed)
                    self.assertLess(self.report()["output"]["triangles"], len(triangles))
                    self.assertEqual(set(self.report()["proof"]["files"].values()), {"same_bits"})

    def test_certificate_is_of_the_numbers_of_the_files(self):
        points, triangles = far_torus(1e7)
        moved = points + np.array([0.0, 0.0, 0.03])
        true = true_distance(points.astype(EXTENDED)[triangles], moved.astype(EXTENDED)[triangles])
        for name, form in FORMS.items():
            with self.subTest(name=name):
                for label, positions in (("a." + name, points), ("b." + name, moved)):
                    self.path(label).write_bytes(form(positions, triangles))
                text = self.succeed("certify", "a." + name, "b." + name, "--no-means").stdout
                lower, upper = map(float, re.search(r"(?m)^distance +(\S+) to (\S+) mm", text).groups())
                self.assertLessEqual(true, upper)
                self.assertAlmostEqual(upper, 0.03, 6)
                self.assertAlmostEqual(lower, 0.03, 6)

    def test_stl_that_is_written_is_proved_as_single_precision_reads_it(self):
        points, triangles = far_torus(1e4)
        self.path("in.obj").write_bytes(obj_of(points, triangles))
        text = self.succeed("in.obj", "out.stl", "--max-error", 0.05, *UNMEASURED).stdout
        printed = float(re.search(r"(?m)^proved +at most (\S+) mm", text).group(1))
        exact = points.astype(EXTENDED)[triangles]
        self.assertLessEqual(true_distance(exact, corners_of(self.path("out.stl"))), printed)

    def test_single_numbers_stay_single_whatever_the_format(self):
        """A file of another program that has written single numbers gives the bytes that it always gave."""
        write(torus(20, 12), self.path("in.vtp"))
        self.succeed("in.vtp", "out.ply", "--max-error", 0.3, *UNMEASURED)
        expected = self.path("out.ply").read_bytes()
        points, triangles = arrays_of(torus(20, 12))
        for name, form in FORMS.items():
            if name.endswith(".stl"):
                continue  # has other numbers of points
            self.path(name).write_bytes(form(points, triangles))
            self.succeed(name, "again.ply", "--max-error", 0.3, *UNMEASURED)
            self.assertEqual(self.path("again.ply").read_bytes(), expected, name)

    def test_ply_has_the_bytes_of_vtk_where_it_is_single(self):
        write(torus(), self.path("in.vtp"))
        self.succeed("in.vtp", "out.ply", "--target-reduction", 0.5, *UNMEASURED)
        write(read(self.path("out.ply")), self.path("vtk.ply"))
        self.assertEqual(self.path("out.ply").read_bytes(), self.path("vtk.ply").read_bytes())

    def test_stl_has_the_bytes_of_vtk(self):
        write(as_doubles(torus(center=1.0 / 3.0)), self.path("in.vtp"))
        self.succeed("in.vtp", "out.vtp", "--also", "out.stl", "--target-reduction", 0.5, *UNMEASURED)
        write(read(self.path("out.vtp")), self.path("vtk.stl"))
        self.assertEqual(self.path("out.stl").read_bytes(), self.path("vtk.stl").read_bytes())

    def test_double_coordinates_are_written_in_full_to_every_format_but_stl(self):
        write(as_doubles(torus(center=1e4 + 1.0 / 3.0)), self.path("in.vtp"))
        words = ("--also", "out.ply", "--also", "out.obj", "--also", "out.vtk", "--also", "out.stl")
        text = self.succeed("in.vtp", "out.vtp", *words, "--target-reduction", 0.5, *UNMEASURED).stdout
        self.assertEqual(text.count("single precision"), 1)
        points, triangles = arrays_of(read(self.path("out.vtp")))
        for name in ("out.ply", "out.obj"):
            np.testing.assert_array_equal(corners_of(self.path(name)).astype(float), points[triangles])
        np.testing.assert_array_equal(arrays_of(read(self.path("out.vtk")))[0], points)


if __name__ == "__main__":
    main()
