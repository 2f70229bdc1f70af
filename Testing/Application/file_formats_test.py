# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""GLB and 3MF: what they hold, read by code of its own, and the certificate of what is decoded."""

import json
import struct
import xml.etree.ElementTree
import zipfile

import numpy as np

import label_maps
from application import FORMATS, REJECTED, UNMEASURED, USAGE, ApplicationTest, as_doubles, main, positions_of, read, torus, write

CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
ERROR = 0.2  # mm
NEW = tuple(name for name, row in FORMATS.items() if row["names_unit"])


def document_of(path):
    """The JSON of a GLB file, whose chunks must fill it."""
    data = path.read_bytes()
    magic, version, length, size, kind = struct.unpack("<4s3I4s", data[:20])
    assert (magic, version, length, kind) == (b"glTF", 2, len(data), b"JSON")
    binary, name = struct.unpack("<I4s", data[20 + size:28 + size])
    assert name == b"BIN\0" and 28 + size + binary == len(data)
    return json.loads(data[20:20 + size])


def model_of(path):
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        assert archive.namelist()[0] == "[Content_Types].xml"
        return xml.etree.ElementTree.fromstring(archive.read("3D/3dmodel.model"))


def mesh_of(thing):
    """Points in single precision and triangles of an object of a 3MF model."""
    points = [[np.float32(vertex.get(axis)) for axis in "xyz"] for vertex in thing.iter(CORE + "vertex")]
    corners = [[int(triangle.get(name)) for name in ("v1", "v2", "v3")] for triangle in thing.iter(CORE + "triangle")]
    return np.array(points, float), np.array(corners)


def triangles_of(points, corners):
    """The set of triangles by positions, each from its least corner."""
    found = set()
    for triangle in corners:
        positions = [tuple(points[corner]) for corner in triangle]
        first = positions.index(min(positions))
        found.add(tuple(positions[first:] + positions[:first]))
    return found


def triangles_in(surface):
    corners = [[surface.GetCell(i).GetPointId(k) for k in range(3)] for i in range(surface.GetNumberOfCells())]
    return triangles_of(positions_of(surface), corners)


def is_closed(corners):
    edges = {(t[i], t[(i + 1) % 3]) for t in corners for i in range(3)}
    return len(edges) == 3 * len(corners) and all((b, a) in edges for a, b in edges)


class FileFormats(ApplicationTest):
    def setUp(self):
        super().setUp()
        for extension in NEW:
            if "lacks" in self.run_program("none.ply", "out." + extension).stderr:
                self.skipTest(f"built without {extension}")
        write(as_doubles(torus(24, 12, center=100.0 / 3.0)), self.path("in.vtp"))

    def grid_of(self, name):
        """The step of a file: the largest power of two of which all its coordinates are multiples."""
        document = document_of(self.path(name))
        if "scale" in document["nodes"][1]:
            return document["nodes"][1]["scale"][0]
        data = self.path(name).read_bytes()
        start = data.index(b"BIN\0") + 4
        steps = []
        for mesh in document["meshes"]:
            accessor = document["accessors"][mesh["primitives"][0]["attributes"]["POSITION"]]
            view = document["bufferViews"][accessor["bufferView"]]
            numbers = np.frombuffer(data, "<f4", 3 * accessor["count"], start + view["byteOffset"]).astype(float)
            whole = (numbers * 2.0**40).astype(np.int64)
            steps.append(2.0**-40 * np.bitwise_and(whole, -whole)[whole != 0].min())
        return min(steps)

    def run_and_certify(self, source, target, *words):
        self.succeed(source, target, "--max-error", ERROR, "--report", "report.json", *words, *UNMEASURED)
        self.assertEqual(self.report()["proof"]["files"][target], "same_bits")
        self.assertLessEqual(self.report()["proof"]["upper"], ERROR)

    def test_what_is_decoded_is_certified(self):
        for extension in NEW:
            target = "out." + extension
            self.run_and_certify("in.vtp", target)
            self.succeed("certify", "in.vtp", target, "--tolerance", ERROR, "--no-means", "--quiet")
            self.succeed(target, "back.vtp", "--target-reduction", 0, "--mode", "fast", "--report", "report.json", *UNMEASURED)

    def test_all_files_of_a_run_have_the_points_of_the_grid(self):
        self.run_and_certify("in.vtp", "out.glb", "--also", "out.vtp", "--also", "out.3mf", "--glb-compression", "meshopt")
        node = document_of(self.path("out.glb"))["nodes"][1]
        step = node["scale"][0]
        self.assertEqual(step, 2.0 ** np.round(np.log2(step)))
        expected = read(self.path("out.vtp"))
        whole = (positions_of(expected) - node["translation"]) / step
        self.assertTrue(np.array_equal(whole, np.round(whole)))
        self.assertTrue(0 <= whole.min() and whole.max() <= 65535)
        points, corners = mesh_of(model_of(self.path("out.3mf")))
        self.assertEqual(triangles_of(points, corners), triangles_in(expected))

    def test_compression_of_glb_is_a_choice_that_changes_no_coordinate(self):
        self.run_and_certify("in.vtp", "plain.glb", "--also", "out.vtp")
        self.run_and_certify("in.vtp", "packed.glb", "--glb-compression", "meshopt")
        self.run_and_certify("in.vtp", "none.glb", "--glb-compression", "NONE")
        self.assertEqual(self.path("plain.glb").read_bytes(), self.path("none.glb").read_bytes())
        self.assertLess(self.path("packed.glb").stat().st_size, self.path("plain.glb").stat().st_size)
        for name in ("plain", "packed"):
            self.succeed(name + ".glb", name + ".vtp", "--target-reduction", 0, "--mode", "fast", *UNMEASURED)
            self.assertEqual(triangles_in(read(self.path(name + ".vtp"))), triangles_in(read(self.path("out.vtp"))))
        self.fail_with(USAGE, "in.vtp", "out.3mf", "--glb-compression", "meshopt", says="--glb-compression has no effect")
        self.succeed("levels", "in.vtp", "--output", "level.glb", "--triangles", 300, "--glb-compression", "meshopt")
        self.assertIn("EXT_meshopt_compression", document_of(self.path("level-300.glb"))["extensionsRequired"])

    def test_glb_says_what_it_needs_and_where_it_is(self):
        self.run_and_certify("in.vtp", "plain.glb")
        document = document_of(self.path("plain.glb"))
        self.assertFalse({"extensionsUsed", "extensionsRequired"} & set(document))
        self.assertEqual({view["buffer"] for view in document["bufferViews"]}, {0})
        self.run_and_certify("in.vtp", "out.glb", "--glb-compression", "meshopt")
        document = document_of(self.path("out.glb"))
        self.assertEqual(set(document["extensionsRequired"]), {"KHR_mesh_quantization", "EXT_meshopt_compression"})
        self.assertEqual(document["nodes"][0]["extras"], {"unit": "mm"})
        matrix = np.array(document["nodes"][0]["matrix"]).reshape(4, 4).T
        self.assertTrue(np.allclose(matrix @ [1.0, 2.0, 3.0, 1.0], [0.001, 0.003, -0.002, 1.0]))  # meters, y up
        self.assertEqual(document["accessors"][1]["count"], 3 * self.report()["output"]["triangles"])

    def test_fewer_bits_are_a_coarser_grid_and_fewer_bytes(self):
        sizes = []
        for bits in (16, 12):
            self.run_and_certify("in.vtp", "plain.glb", "--position-bits", bits)
            self.run_and_certify("in.vtp", "out.glb", "--position-bits", bits, "--glb-compression", "meshopt")
            self.assertEqual(self.grid_of("plain.glb"), self.grid_of("out.glb"))
            self.assertLessEqual(56.0, self.grid_of("out.glb") * 2**bits)
            sizes.append(self.path("out.glb").stat().st_size)
        self.assertEqual(sizes, sorted(sizes, reverse=True))
        self.path("out.glb").unlink()
        self.fail_with(REJECTED, "in.vtp", "out.glb", "--position-bits", 8, "--max-error", ERROR, says="more than half of the largest error")
        self.fail_with(USAGE, "in.vtp", "out.vtp", "--position-bits", 12, says="--position-bits has no effect")
        self.fail_with(USAGE, "in.vtp", "out.3mf", "--vertex-colors", "error", says="--vertex-colors has no effect")

    def test_vertex_colors_show_the_error(self):
        self.run_and_certify("in.vtp", "out.glb", "--vertex-colors", "error")
        primitive = document_of(self.path("out.glb"))["meshes"][0]["primitives"][0]
        self.assertIn("COLOR_0", primitive["attributes"])
        self.fail_with(USAGE, "in.vtp", "new.glb", "--vertex-colors", "error", *UNMEASURED, says="needs what --max-error proves")

    def test_labels_are_closed_parts_with_names_colors_and_walls_in_common(self):
        import segments_test
        label_maps.write_map(segments_test.label_map(), self.path("map.vti"))
        words = ("map.vti", "--segments", "all", "--max-error", 0.3, "--report", "report.json", *UNMEASURED)
        self.succeed(words[0], "all.glb", "--also", "all.3mf", "--also", "all.vtp", *words[1:])
        self.assertEqual(set(self.report()["proof"]["files"].values()), {"same_bits"})
        model = model_of(self.path("all.3mf"))
        self.assertEqual(model.get("unit"), "millimeter")
        objects = {int(thing.get("partnumber")): thing for thing in model.iter(CORE + "object")}
        self.assertEqual(set(objects), {1, 2, 7})
        colors = [base.get("displaycolor") for base in model.iter(CORE + "base")]
        expected = read(self.path("all.vtp"))
        sides = expected.GetCellData().GetArray("BoundaryLabels")
        parts = {}
        for label, thing in objects.items():
            points, corners = mesh_of(thing)
            self.assertTrue(is_closed(corners))
            parts[label] = triangles_of(points, corners)
            self.assertEqual(thing.get("type"), "model")
            self.assertEqual(thing.get("name"), segments_test.NAMES[label] or str(label))
            self.assertEqual(colors[int(thing.get("pindex"))], "#%02X%02X%02X" % segments_test.COLORS[label])
            count = sum(label in sides.GetTuple(i) for i in range(sides.GetNumberOfTuples()))
            self.assertEqual(len(parts[label]), count)
        walls = {frozenset(t) for t in parts[1]} & {frozenset(t) for t in parts[2]}
        self.assertGreater(len(walls), 5)
        document = document_of(self.path("all.glb"))
        nodes = document["nodes"][1:]
        self.assertEqual([node["extras"]["label"] for node in nodes], [1, 2, 7])
        self.succeed("all.glb", "back.vtp", "--target-reduction", 0, "--mode", "fast", "--merge-points", "off", *UNMEASURED)
        back = read(self.path("back.vtp"))
        self.assertEqual(triangles_in(back), triangles_in(expected))

    def test_each_segment_in_a_file_of_its_own_is_on_the_same_grid(self):
        import segments_test
        label_maps.write_map(segments_test.label_map(), self.path("map.vti"))
        for extension in NEW:
            self.succeed("map.vti", "bones-" + extension, "--segments", "1,2", "--max-error", 0.3, "--format", extension,
                         "--page", "p.html", "--picture", "p.png", *UNMEASURED)
            folder = self.path("bones-" + extension)
            self.assertEqual(len(list(folder.glob("*." + extension))), 2)
            report = json.loads((folder / "report.json").read_text())
            self.assertEqual(set(report["proof"]["files"].values()), {"same_bits"})
        steps = {self.grid_of(path) for path in self.path("bones-glb").glob("*.glb")}
        self.assertEqual(len(steps), 1)
        objects = [thing for path in self.path("bones-3mf").glob("*.3mf") for thing in model_of(path).iter(CORE + "object")]
        self.assertEqual([thing.get("type") for thing in objects], ["model", "model"])

    def test_files_that_name_their_unit_are_in_it_whatever_unit_is(self):
        write(as_doubles(torus(24, 12)), self.path("mm.vtp"))
        meters = as_doubles(torus(24, 12))
        points = meters.GetPoints()
        for i in range(points.GetNumberOfPoints()):
            points.SetPoint(i, [0.001 * x for x in points.GetPoint(i)])
        write(meters, self.path("m.vtp"))
        for extension in NEW:
            target = "out." + extension
            self.run_and_certify("m.vtp", target, "--unit", "m")
            self.succeed("certify", "mm.vtp", target, "--tolerance", ERROR + 1e-6, "--quiet")
            self.succeed("certify", "m.vtp", target, "--unit", "m", "--tolerance", ERROR, "--quiet")
            self.fail_with(USAGE, target, "back.vtp", "--unit", "m", says="--unit is for files that do not name")
            self.succeed("m.vtp", "out.ply", "--also", target, "--unit", "m", "--max-error", ERROR, *UNMEASURED)

    def test_levels_are_files_on_the_grid(self):
        for extension in NEW:
            self.succeed("levels", "in.vtp", "--output", "level." + extension, "--triangles", 300, "--max-error", 1)
            self.succeed("certify", "in.vtp", "level-300." + extension, "--tolerance", 1, "--quiet")

    def test_memory_and_glb_do_not_go_together(self):
        self.fail_with(USAGE, "ct.mha", "out.glb", "--iso", 226, "--max-error", 1, "--memory", "1G", says="glb")

    def test_the_same_run_gives_the_same_bytes(self):
        for extension in NEW:
            for name in ("a.", "b."):
                self.succeed("in.vtp", name + extension, "--max-error", ERROR, *UNMEASURED)
            self.assertEqual(self.path("a." + extension).read_bytes(), self.path("b." + extension).read_bytes())

    def test_damaged_files_are_rejected(self):
        for extension in NEW:
            self.succeed("in.vtp", "good." + extension, "--max-error", ERROR, *UNMEASURED)
            good = self.path("good." + extension).read_bytes()
            generator = np.random.default_rng(1)
            for length in (0, 3, 11, 27, len(good) // 2, len(good) - 1):
                self.path("bad." + extension).write_bytes(good[:length])
                self.fail_with(REJECTED, "bad." + extension, "out.vtp", says="was rejected")
            for _ in range(5):
                bad = bytearray(good)
                for at in generator.integers(0, len(good), 3):
                    bad[at] = generator.integers(256)
                self.path("bad." + extension).write_bytes(bad)
                completed = self.run_program("bad." + extension, "out.vtp", "--mode", "fast", *UNMEASURED)
                self.assertIn(completed.returncode, (0, REJECTED), completed.stderr)


if __name__ == "__main__":
    main()
