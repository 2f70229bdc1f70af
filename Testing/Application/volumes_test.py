# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A CT volume instead of a surface."""

import vtk

from application import REFUSED, USAGE, ApplicationTest, main, read


def ball(size=24):
    """A ball of 1000 HU and radius 8 mm in air, its centre at x = 100 mm."""
    image = vtk.vtkImageData()
    image.SetDimensions(size, size, size)
    image.SetOrigin(100.0 - (size - 1) / 2, 0.0, 0.0)
    image.AllocateScalars(vtk.VTK_SHORT, 1)
    middle = (size - 1) / 2
    for z in range(size):
        for y in range(size):
            for x in range(size):
                distance = ((x - middle) ** 2 + (y - middle) ** 2 + (z - middle) ** 2) ** 0.5
                image.SetScalarComponentFromDouble(x, y, z, 0, max(-1000.0, min(1000.0, (8.0 - distance) * 400.0)))
    return image


class Volumes(ApplicationTest):
    def setUp(self):
        super().setUp()
        self.write_ball(self.path("ct.vti"))
        self.write_ball(self.path("ct.mha"))

    def write_ball(self, path):
        writer = vtk.vtkXMLImageDataWriter() if path.suffix == ".vti" else vtk.vtkMetaImageWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(ball())
        writer.Write()

    def test_bone_surface_of_a_volume(self):
        for name in ("ct.vti", "ct.mha"):
            with self.subTest(name=name):
                self.succeed(name, "out.vtp", "--iso", 226, "--target-reduction", 0.2, "--report", "report.json")
                bounds = read(self.path("out.vtp")).GetBounds()
                self.assertAlmostEqual(bounds[0], 92.5, 0)
                self.assertAlmostEqual(bounds[1], 107.5, 0)
                self.assertGreater(self.report()["output"]["volume"], 1000.0)
                self.assertEqual(self.report()["command_line"]["iso"], "226")

    def test_volume_tells_the_voxels_of_a_preset(self):
        words = ("--iso", 226, "--preset", "half-voxel", "--report", "report.json")
        self.succeed("ct.vti", "out.vtp", *words)
        self.assertEqual(self.report()["voxel"]["from"], "given")
        self.assertEqual(self.report()["proof"]["tolerance"], 0.5)
        self.assertEqual(self.report()["proof"]["verdict"], "proved")

    def test_volume_needs_a_value(self):
        self.fail_with(USAGE, "ct.vti", "out.vtp", says="--iso")

    def test_value_beyond_the_volume_is_refused(self):
        self.fail_with(REFUSED, "ct.vti", "out.vtp", "--iso", 5000)

    def test_damaged_volume_is_refused(self):
        for name in ("ct.vti", "ct.mha"):
            whole = self.path(name).read_bytes()
            self.path(name).write_bytes(whole[: len(whole) // 2])
            self.fail_with(REFUSED, name, "out.vtp", "--iso", 226)

    def test_volumes_of_a_batch(self):
        self.path("scans").mkdir()
        self.write_ball(self.path("scans") / "ct.vti")
        self.succeed("scans", "out", "--iso", 226)
        self.assertGreater(read(self.path("out/ct.vtp")).GetNumberOfPolys(), 4)
        self.assertIn("skipped", self.succeed("scans", "out", "--iso", 226).stdout)
        self.assertNotIn("skipped", self.succeed("scans", "out", "--iso", 300).stdout)
        self.fail_with(REFUSED, "scans", "none", says="no surface")


if __name__ == "__main__":
    main()
