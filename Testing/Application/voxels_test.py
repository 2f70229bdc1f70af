# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""--label-map, --keep-voxels and --smooth for surfaces that another program extracted from a label map."""

from application import REJECTED, USAGE, ApplicationTest, main, write
from label_maps import ball, blocks, smoothed, surface_of, write_map

VIOLATED = 6


class Voxels(ApplicationTest):
    def setUp(self):
        super().setUp()
        write_map(ball(), self.path("map.mha"))
        write(surface_of(ball(), 1), self.path("bone.stl"))

    def run_with_map(self, *words):
        return self.succeed("bone.stl", "out.stl", "--label-map", "map.mha", "--measure", "off", "--report", "report.json", *words)

    def certify(self, name="out.stl"):
        return self.run_program("certify", name, "--labels", "map.mha", "--quiet").returncode

    def test_every_voxel_is_kept(self):
        self.run_with_map("--keep-voxels", "On", "--page", "page.html")
        voxels = self.report()["voxels"]
        self.assertEqual((voxels["guard"], voxels["changed"]), ("on", 0))
        self.assertGreater(voxels["of_1"]["voxels"], 100)
        self.assertEqual(self.certify(), 0)
        page = self.path("page.html").read_text(encoding="utf-8")
        self.assertIn("0 of 2,744 voxels have another label in this surface. No edit was allowed to change a voxel.", page)
        self.assertNotIn("voxel_label", page)
        self.run_with_map("--keep-voxels", "Off", "--target-reduction", 0.9)
        self.assertGreater(self.report()["voxels"]["changed"], 0)
        self.assertEqual(self.certify(), VIOLATED)

    def test_the_grid_is_found_in_the_points_too(self):
        self.succeed("bone.stl", "out.stl", "--keep-voxels", "On", "--measure", "off")
        self.assertEqual(self.certify(), 0)
        write(smoothed(surface_of(ball(), 1)), self.path("s.stl"))
        self.fail_with(REJECTED, "s.stl", "out.stl", "--keep-voxels", "On", says="give its label map")

    def test_smoothing_keeps_every_voxel(self):
        completed = self.succeed("smooth", "bone.stl", "out.stl", "--label-map", "map.mha", "--report", "report.json")
        self.assertIn("voxels          0 of 2,744 have another label", completed.stdout)
        report = self.report()
        self.assertEqual(report["smoothing"]["surface"], "label_map")
        self.assertGreater(report["smoothing"]["largest_displacement"], 0.1)
        self.assertEqual(self.certify(), 0)

    def test_levels_and_curves_tell_the_voxels(self):
        words = ("--label-map", "map.mha", "--keep-voxels", "On")
        completed = self.succeed("levels", "bone.stl", *words, "--triangles", 150, "--output", "level.stl", "--no-errors")
        for line in completed.stdout.splitlines():
            if " triangles" in line:
                self.assertIn("0 voxels have another label", line)
        level = next(name for name in self.names() if name.startswith("level-"))
        self.assertEqual(self.certify(level), 0)
        completed = self.succeed("curve", "bone.stl", *words, "--errors", "0.5", "--json", "curve.json")
        self.assertIn("0 voxels have another label", completed.stdout)
        self.assertEqual(self.report("curve.json")["runs"][0]["changed_voxels"], 0)

    def test_contradictions_are_rejected(self):
        self.fail_with(USAGE, "bone.stl", "out.stl", "--label", 5, says="--label-map")
        self.fail_with(USAGE, "bone.stl", "map.mha.stl", "--label-map", "map.mha", "--report", "map.mha", says="'map.mha' is an input")
        self.fail_with(USAGE, "bone.stl", "bone.stl", "small/", "--label-map", "map.mha", says="one bone")
        self.fail_with(REJECTED, "bone.stl", "out.stl", "--label-map", "map.mha", "--label", 5, says="label 5")
        self.fail_with(REJECTED, "bone.stl", "out.stl", "--label-map", "none.mha", says="none.mha")
        write_map(blocks(1), self.path("other.mha"))
        completed = self.succeed("bone.stl", "out.stl", "--label-map", "other.mha", "--measure", "off")
        self.assertIn("warning: the input itself gives", completed.stdout)


if __name__ == "__main__":
    main()
