# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of a few points as files, for the tests of the programs beside this."""

import pathlib
import struct
import tempfile
import unittest


def square(z, size=10.0):
    """Two triangles over the square from 0 to size at height z."""
    return [(0, 0, z), (size, 0, z), (size, size, z), (0, size, z)], [(0, 1, 2), (0, 2, 3)]


class WithFiles(unittest.TestCase):
    """Each test has a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, surface):
        points, triangles = surface
        axes = "".join(f"property double {axis}\n" for axis in "xyz")
        head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n{axes}"
                f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
        body = b"".join(struct.pack("<3d", *point) for point in points)
        body += b"".join(struct.pack("<B3i", 3, *corners) for corners in triangles)
        (self.folder / name).write_bytes(head.encode() + body)
        return self.folder / name
