# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""GLB files of other programs: geometry, units, axes, arrays and what is rejected by name."""

import base64
import json
import struct

import numpy as np

from application import REJECTED, UNMEASURED, USAGE, ApplicationTest, main, positions_of, read

TYPES = {"u1": 5121, "i1": 5120, "u2": 5123, "i2": 5122, "u4": 5125, "f4": 5126}
KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}
SAME = ("--target-reduction", 0, "--mode", "fast", *UNMEASURED)


class Glb:
    """A document that grows: buffer views, accessors, meshes, nodes."""

    def __init__(self):
        self.document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                         "accessors": [], "bufferViews": []}
        self.binary = b""

    def view(self, data, **more):
        self.binary += bytes(-len(self.binary) % 4)
        self.document["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data), **more})
        self.binary += data
        return len(self.document["bufferViews"]) - 1

    def accessor(self, values, kind="f4", view=None, offset=0, **more):
        values = np.asarray(values)
        columns = 1 if values.ndim == 1 else values.shape[1]
        view = self.view(values.astype("<" + kind).tobytes()) if view is None else view
        self.document["accessors"].append({"bufferView": view, "byteOffset": offset, "componentType": TYPES[kind],
                                           "count": len(values), "type": KINDS[columns], **more})
        return len(self.document["accessors"]) - 1

    def mesh(self, *primitives, **more):
        self.document["meshes"].append({"primitives": list(primitives), **more})
        return len(self.document["meshes"]) - 1

    def node(self, root=True, **content):
        self.document["nodes"].append(content)
        number = len(self.document["nodes"]) - 1
        if root:
            self.document["scenes"][0]["nodes"].append(number)
        return number

    def write(self, path, behind=b""):
        if self.binary:
            self.document.setdefault("buffers", [{"byteLength": len(self.binary)}])
        text = json.dumps(self.document).encode()
        text += b" " * (-len(text) % 4)
        binary = self.binary + bytes(-len(self.binary) % 4)
        chunk = struct.pack("<I4s", len(binary), b"BIN\0") + binary if binary else b""
        path.write_bytes(struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text) + len(chunk), len(text), b"JSON") + text + chunk + behind)


def box(size=0.03, at=(0.1, -0.05, 0.2)):
    """Points, in meters, exact in single precision, and triangles with the normal outward."""
    points = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) * size + at
    triangles = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4],
                 [1, 5, 7], [1, 7, 3]]
    return points.astype(np.float32).astype(float), np.array(triangles)


def soup(points, triangles):
    """Positions of the triangles' corners, each triangle from its least corner, sorted."""
    corners = np.asarray(points)[np.asarray(triangles)]
    turned = [np.roll(t, -min(range(3), key=lambda k, t=t: tuple(t[k])), axis=0) for t in corners]
    return np.array(sorted(np.round(t, 6).tolist() for t in turned))


class GlbInput(ApplicationTest):
    def setUp(self):
        super().setUp()
        if "lacks" in self.run_program("none.ply", "out.glb").stderr:
            self.skipTest("built without glb")

    def convert(self, glb, *words, behind=b""):
        glb.write(self.path("in.glb"), behind)
        completed = self.succeed("in.glb", "out.vtp", *SAME, *words)
        return read(self.path("out.vtp")), completed.stdout

    def reject(self, glb, says):
        glb.write(self.path("in.glb"))
        self.fail_with(REJECTED, "in.glb", "out.vtp", says=says)

    def same(self, surface, points, triangles):
        """In mm."""
        corners = [[surface.GetCell(i).GetPointId(k) for k in range(3)] for i in range(surface.GetNumberOfCells())]
        found = soup(positions_of(surface), corners)
        expected = soup(1000.0 * np.asarray(points), triangles)
        self.assertEqual(found.shape, expected.shape)
        self.assertTrue(np.allclose(found, expected, atol=1e-5, rtol=0), np.abs(found - expected).max())

    def plain(self, **primitive):
        points, triangles = box()
        glb = Glb()
        glb.mesh({"attributes": {"POSITION": glb.accessor(points)}, "indices": glb.accessor(triangles.ravel(), "u2"), **primitive})
        return glb

    def test_lengths_are_meters_unless_unit_says_otherwise_and_a_note_says_so(self):
        points, triangles = box()
        glb = self.plain()
        glb.node(mesh=0)
        surface, said = self.convert(glb)
        self.same(surface, points, triangles)
        self.assertIn("its lengths are in m, as its format says", said)
        self.assertIn("y up", said)
        surface, said = self.convert(glb, "--unit", "mm")
        self.same(surface, points / 1000.0, triangles)
        self.assertIn("its lengths are in mm", said)
        surface, _ = self.convert(glb, "--unit", "m")
        self.same(surface, points / 1000.0, triangles)  # read and written in m
        self.succeed("in.glb", "in.vtp", *SAME)
        self.succeed("certify", "in.vtp", "in.glb", "--tolerance", 1e-9, "--quiet")

    def test_nodes_move_meshes_by_matrices_and_by_translation_rotation_and_scale(self):
        points, triangles = box()
        glb = self.plain()
        half = np.sqrt(0.5)
        inner = glb.node(root=False, mesh=0, translation=[1, 2, 3], rotation=[0, 0, half, half], scale=[2, 1, -1])
        glb.node(matrix=[0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 0.5, 0, 0, 1], children=[inner], mesh=0)
        surface, _ = self.convert(glb)
        turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
        outer = 2 * points @ turn.T + [0.5, 0, 0]
        own = (points * [2, 1, -1]) @ turn.T + [1, 2, 3]
        both = np.vstack([outer, 2 * own @ turn.T + [0.5, 0, 0]])
        self.same(surface, both, np.vstack([triangles, triangles[:, ::-1] + 8]))  # a mirror turns triangles

    def test_strips_fans_and_meshes_without_indices_become_triangles(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 2, 0]], float) / 16
        for mode, indices, triangles in ((5, None, [[0, 1, 2], [1, 3, 2], [2, 3, 4]]), (6, None, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]),
                                         (5, [1, 3, 0, 2], [[1, 3, 0], [3, 2, 0]]), (4, None, [[0, 1, 2]])):
            glb = Glb()
            primitive = {"attributes": {"POSITION": glb.accessor(points)}, "mode": mode}
            if indices:
                primitive["indices"] = glb.accessor(np.array(indices), "u1")
            glb.node(mesh=glb.mesh(primitive))
            surface, _ = self.convert(glb)
            self.same(surface, points, triangles)

    def test_interleaved_sparse_and_normalized_accessors_are_read(self):
        points, triangles = box(0.5, (0, 0, 0))
        glb = Glb()
        mixed = np.zeros(8, dtype=[("p", "<f4", 3), ("n", "<f4", 3), ("c", "u1", 4)])
        mixed["p"], mixed["n"], mixed["c"] = points, [0, 0, 1], [255, 0, 128, 64]
        view = glb.view(mixed.tobytes(), byteStride=mixed.itemsize)
        shifted = glb.accessor(np.zeros((8, 3)), view=view)
        changes = glb.view(np.array([7], "<u2").tobytes())
        values = glb.view(np.array([[1, 1, 2]], "<f4").tobytes())
        glb.document["accessors"][shifted]["sparse"] = {
            "count": 1, "indices": {"bufferView": changes, "componentType": 5123}, "values": {"bufferView": values}}
        attributes = {"POSITION": shifted, "NORMAL": glb.accessor(np.zeros((8, 3)), view=view, offset=12),
                      "COLOR_0": glb.accessor(np.zeros((8, 4)), "u1", view, 24, normalized=True)}
        glb.node(mesh=glb.mesh({"attributes": attributes, "indices": glb.accessor(triangles.ravel(), "u4")}))
        surface, _ = self.convert(glb)
        expected = points.copy()
        expected[7] = [1, 1, 2]
        self.same(surface, expected, triangles)
        self.assertEqual(surface.GetPointData().GetNormals().GetTuple(0), (0, 0, 1))
        self.assertEqual(surface.GetPointData().GetArray("RGBA").GetTuple(0), (255, 0, 188, 64))  # linear to sRGB
        quantized = Glb()
        quantized.document["extensionsRequired"] = quantized.document["extensionsUsed"] = ["KHR_mesh_quantization"]
        whole = np.zeros((8, 4))
        whole[:, :3] = points / 0.5 * 32767
        view = quantized.view(whole.astype("<i2").tobytes(), byteStride=8)
        primitive = {"attributes": {"POSITION": quantized.accessor(whole[:, :3], "i2", view, normalized=True)},
                     "indices": quantized.accessor(triangles.ravel(), "u1")}
        quantized.node(mesh=quantized.mesh(primitive), scale=[0.5, 0.5, 0.5])
        surface, _ = self.convert(quantized)
        self.same(surface, points, triangles)

    def test_primitives_with_a_common_boundary_are_one_surface_unless_points_stay_apart(self):
        points, triangles = box()
        glb = Glb()
        shared = glb.accessor(points)
        halves = [{"attributes": {"POSITION": shared}, "indices": glb.accessor(half.ravel(), "u2")} for half in np.split(triangles, 2)]
        glb.node(mesh=glb.mesh(*halves))
        surface, _ = self.convert(glb)
        self.same(surface, points, triangles)
        self.assertEqual(surface.GetNumberOfPoints(), 8)
        surface, _ = self.convert(glb, "--merge-points", "off")
        self.assertGreater(surface.GetNumberOfPoints(), 8)

    def test_texture_coordinates_and_attributes_of_applications_are_arrays(self):
        points, triangles = box()
        glb = Glb()
        attributes = {"POSITION": glb.accessor(points), "TEXCOORD_0": glb.accessor(np.tile([0.25, 0.75], (8, 1))),
                      "_DEPTH": glb.accessor(np.full(8, 3.5)), "TANGENT": glb.accessor(np.tile([1, 0, 0, 1], (8, 1)))}
        glb.node(mesh=glb.mesh({"attributes": attributes, "indices": glb.accessor(triangles.ravel(), "u2")}))
        surface, said = self.convert(glb)
        self.assertEqual(surface.GetPointData().GetTCoords().GetTuple(0), (0.25, 0.25))
        self.assertEqual(surface.GetPointData().GetArray("_DEPTH").GetTuple1(0), 3.5)
        self.assertIn("not kept: TANGENT", said)
        self.succeed("in.glb", "back.glb", *SAME)
        self.succeed("back.glb", "back.vtp", *SAME)
        self.assertEqual(read(self.path("back.vtp")).GetPointData().GetTCoords().GetTuple(0), (0.25, 0.25))

    def test_what_is_not_read_is_named(self):
        glb = self.plain()
        glb.mesh({"attributes": {"POSITION": 0}, "indices": 1})
        glb.document["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0}, "mode": 1})
        glb.document["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": 0}]
        glb.document["animations"] = [{}]
        glb.node(mesh=0)
        _, said = self.convert(glb, behind=b"1234")
        for words in ("1 mesh of the input that the scene does not use is not read", "1 primitive of points or lines is not read",
                      "animations of the input", "morph targets of the input", "4 bytes behind"):
            self.assertIn(words, said)
        glb.document["extensionsUsed"] = ["KHR_node_visibility"]
        glb.node(mesh=1, extensions={"KHR_node_visibility": {"visible": False}})
        _, said = self.convert(glb)
        self.assertIn("1 node of the input that is marked as not visible", said)

    def test_what_cannot_be_read_is_rejected_by_its_name(self):
        glb = self.plain()
        glb.node(mesh=0, weights=[0.5])
        self.reject(glb, "morph targets")
        glb = self.plain()
        glb.node(mesh=0, skin=0)
        self.reject(glb, "skeleton (skin)")
        glb = self.plain()
        glb.node(mesh=0)
        glb.document["extensionsRequired"] = ["KHR_draco_mesh_compression"]
        self.reject(glb, "compressed by Draco")
        glb.document["extensionsRequired"] = ["EXT_other"]
        self.reject(glb, "it requires the extension 'EXT_other'")
        del glb.document["extensionsRequired"]
        glb.document["buffers"] = [{"uri": "bone.bin", "byteLength": 400}]
        self.reject(glb, "its points are in the file 'bone.bin'")
        glb = self.plain()
        glb.node(mesh=0, extensions={"EXT_mesh_gpu_instancing": {}})
        self.reject(glb, "EXT_mesh_gpu_instancing")
        glb = self.plain()
        glb.node(mesh=0)
        glb.document["asset"]["version"] = "1.0"
        self.reject(glb, "glTF of version 1.0")

    def test_bytes_in_data_uris_are_read(self):
        points, triangles = box()
        glb = self.plain()
        glb.node(mesh=0)
        glb.document["buffers"] = [{"uri": "data:application/octet-stream;base64," + base64.b64encode(glb.binary).decode(),
                                    "byteLength": len(glb.binary)}]
        glb.binary = b""
        surface, _ = self.convert(glb)
        self.same(surface, points, triangles)

    def test_damaged_and_hostile_documents_are_rejected_with_their_cause(self):
        def changed(says, **changes):
            glb = self.plain()
            glb.node(mesh=0)
            for path, value in changes.items():
                *way, last = path.split("__")
                target = glb.document
                for step in way:
                    target = target[int(step) if step.isdigit() else step]
                target[int(last) if last.isdigit() else last] = value
            self.reject(glb, says)
        changed("reaches beyond its buffer", accessors__0__count=9)
        changed("a triangle has a vertex that is not there", accessors__0__count=7)
        changed("reaches beyond the file", bufferViews__0__byteLength=10**6)
        changed("a node has two parents", scenes__0__nodes=[0] * 10**5)
        changed("its meshes have no number 5", nodes__0__mesh=5)
        changed("more than a gigabyte", accessors__0={"componentType": 5126, "count": 10**9, "type": "VEC3"})
        changed("which is not known", accessors__0__type="MAT9")
        changed("its JSON is damaged", meshes__0__primitives=[{}])
        glb = self.plain()
        glb.document["extras"] = [{}] * 4000000
        self.reject(glb, "its JSON takes more than 500 MB")
        glb = self.plain()
        glb.document["nodes"] = [{"mesh": 0} for _ in range(200000)]
        glb.document["scenes"][0]["nodes"] = list(range(200000))
        glb.document["meshes"][0]["primitives"] *= 1000
        self.reject(glb, "more than a gigabyte")

    def test_unit_has_no_meaning_for_own_files(self):
        self.convert(self.with_node())
        self.succeed("out.vtp", "own.glb", *SAME)
        self.fail_with(USAGE, "own.glb", "back.vtp", "--unit", "cm", says="--unit is for files that do not name their unit")

    def with_node(self):
        glb = self.plain()
        glb.node(mesh=0)
        return glb


if __name__ == "__main__":
    main()
