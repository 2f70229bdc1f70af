# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences between what a file holds and what a reader makes of it, by their kinds."""

import collections

import numpy as np

ATTRIBUTES = ("uv", "normals", "colors")


class Difference(Exception):
    """Of a kind that ends the comparison."""


def turned(face):
    """The same polygon, however it begins."""
    at = face.index(min(face))
    return face[at:] + face[:at]


class Comparison:
    """tolerance: of coordinates, relative to the largest. is_exact: every order and every array."""

    def __init__(self, truth, reading, tolerance, is_exact):
        self.truth, self.reading, self.tolerance, self.is_exact = truth, reading, tolerance, is_exact

    def kinds(self):
        try:
            self.vertex_of = self.match_points()
            self.face_of = self.match_faces()
        except Difference as difference:
            return [str(difference)]
        kinds = [name for name in ATTRIBUTES if not self.has_same_corners(name)]
        kinds += self.array_kinds()
        if self.is_exact:
            kinds += self.other_kinds()
        return kinds

    def match_points(self):
        """The vertex that each point is; faces do not name others."""
        truth = np.asarray(self.truth.points, float)
        first = {}
        self.canonical = [first.setdefault(point, number) for number, point in enumerate(self.truth.points)]
        self.faces = [tuple(self.canonical[v] for v in face) for face in self.truth.faces]
        found = np.asarray(self.reading.points, float).reshape(-1, 3)
        if not len(found) or not np.isfinite(found).all():
            raise Difference("points")
        apart = np.abs(truth[None, :, :] - found[:, None, :]).max(-1)
        nearest = apart.argmin(1)
        far = apart[np.arange(len(found)), nearest] > self.tolerance * np.abs(truth).max()
        used = sorted({v for face in self.reading.faces for v in face})
        if used and (used[0] < 0 or used[-1] >= len(found)):
            raise Difference("indices")
        if far[used].any() or (self.is_exact and far.any()):
            raise Difference("points")
        return nearest

    def match_faces(self):
        """The face that each polygon or triangle that was read is of."""
        found = [tuple(int(self.vertex_of[v]) for v in face) for face in self.reading.faces]
        if self.is_exact:
            if found != self.faces:
                raise Difference("faces")
            return list(range(len(found)))
        numbers = collections.defaultdict(list)
        for number, face in enumerate(self.faces):
            numbers[turned(face)].append(number)
        result, pieces = [None] * len(found), []
        for i, face in enumerate(found):
            if len(set(face)) < 3:
                raise Difference("faces")
            if numbers[turned(face)]:
                result[i] = numbers[turned(face)].pop(0)
            else:
                pieces.append(i)
        self.match_pieces(found, pieces, [number for left in numbers.values() for number in left], result)
        return result

    def match_pieces(self, found, pieces, left, result):
        """Triangles whose edges add up to those of a polygon."""
        for number in left:
            corners = set(self.faces[number])
            of_face = [i for i in pieces if set(found[i]) <= corners]
            edges = collections.Counter()
            for i in of_face:
                for a, b in zip(found[i], found[i][1:] + found[i][:1]):
                    edges[min(a, b), max(a, b)] += 1 if a < b else -1
            face = self.faces[number]
            for a, b in zip(face, face[1:] + face[:1]):
                edges[min(a, b), max(a, b)] -= 1 if a < b else -1
            if any(edges.values()) or len(of_face) != len(face) - 2:
                raise Difference("faces")
            for i in of_face:
                result[i] = number
            pieces = [i for i in pieces if i not in of_face]
        if pieces:
            raise Difference("faces")

    def expected_at(self, values, i):
        """Of the corners of the face that was read, in its order."""
        number = self.face_of[i]
        corner_of = {v: k for k, v in enumerate(self.faces[number])}
        return [values[number][corner_of[int(self.vertex_of[v])]] for v in self.reading.faces[i]]

    def is_near(self, expected, found, step):
        """step: the largest difference in a reader of less precision."""
        if expected is None:
            return True
        if not self.is_exact:
            size = min(len(expected), len(found))
            return np.allclose(expected[:size], found[:size], rtol=0.0, atol=step)
        found = tuple(map(float, found))
        if self.tolerance > 0:
            return len(found) == len(expected) and np.allclose(expected, found, rtol=2e-7, atol=2e-7)
        return found == tuple(map(float, expected)) or found == tuple(map(float, np.float32(expected)))

    def has_same_corners(self, name):
        expected, found = self.truth.corners.get(name), self.reading.corners.get(name)
        if expected is None or found is None:
            return expected is None and found is None or not self.is_exact
        step = 1.01 if name == "colors" else 1e-6
        return len(found) == len(self.reading.faces) and all(
            self.is_near(wanted, given, step)
            for i, face in enumerate(found)
            for wanted, given in zip(self.expected_at(expected, i), face)
        )

    def array_kinds(self):
        kinds = []
        for name, values in self.truth.point_arrays.items():
            found = self.reading.point_arrays.get(name)
            of_corners = [[values[v] for v in face] for face in self.truth.faces]
            same = found is not None and all(
                self.same_value(wanted, found[v])
                for i, face in enumerate(self.reading.faces)
                for wanted, v in zip(self.expected_at(of_corners, i), face)
            )
            kinds += [] if same or (found is None and not self.is_exact) else ["array " + name]
        for name, values in self.truth.cell_arrays.items():
            found = self.reading.cell_arrays.get(name)
            same = found is not None and all(self.same_value(values[n], found[i]) for i, n in enumerate(self.face_of))
            kinds += [] if same or (found is None and not self.is_exact) else ["array " + name]
        return kinds

    def same_value(self, expected, found):
        if not self.is_exact and not any(isinstance(x, str) for x in expected):
            return len(expected) == len(found) and np.allclose(expected, found, rtol=1e-6)
        return tuple(expected) == tuple(found)

    def other_kinds(self):
        """What only ours is held to."""
        truth, reading = self.truth, self.reading
        kinds = []

        def cells(read):
            return [tuple(int(self.vertex_of[v]) for v in cell) for cell in read]

        def cells_of_truth(written):
            return [tuple(self.canonical[v] for v in cell) for cell in written]

        kinds += ["lines"] if cells(reading.lines) != cells_of_truth(truth.lines) else []
        kinds += ["vertices"] if cells(reading.vertices) != cells_of_truth(truth.vertices) else []
        kinds += ["frame"] if reading.frame != truth.frame else []
        for name, values in truth.field_arrays.items():
            kinds += ["field " + name] if list(reading.field_arrays.get(name, [])) != list(values) else []
        known = {"TCoords", "Normals", "RGB", "RGBA", "DistanceToResult", *reading.field_arrays.get("MaterialNames", [])}
        for given, expected in ((reading.point_arrays, truth.point_arrays), (reading.cell_arrays, truth.cell_arrays)):
            kinds += ["another array " + name for name in sorted(set(given) - set(expected) - known)]
        return kinds + self.type_kinds()

    def type_kinds(self):
        types = getattr(self.truth, "types", {})
        return ["type of " + name for name, kind in types.items() if self.reading.types.get(name, kind) != kind]


def differences(truth, reading, tolerance, is_exact):
    return Comparison(truth, reading, tolerance, is_exact).kinds()
