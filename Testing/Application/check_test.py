# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""bonedecimate check FILE: findings, JSON and exit codes."""

import json

from application import REFUSED, SURFACES, USAGE, ApplicationTest, as_doubles, main, together, torus, write


class Check(ApplicationTest):
    def test_a_sound_surface_is_one_part_and_can_be_decimated(self):
        for extension in SURFACES:
            write(torus(), self.path("bone." + extension))
            answer = self.succeed("check", "bone." + extension)
            self.assertIn("1 connected parts", answer.stdout)
            self.assertIn("It can be decimated.", answer.stdout)

    def test_json_has_every_finding_with_count_and_first_ids(self):
        write(together(torus(), torus(centre=50.0)), self.path("bone.vtp"))
        self.succeed("check", "bone.vtp", "--json", "found.json", "--quiet")
        with open(self.path("found.json"), encoding="utf-8") as file:
            found = json.load(file)
        self.assertTrue(found["usable"])
        parts = next(finding for finding in found["findings"] if finding["kind"] == "components")
        self.assertEqual((parts["count"], parts["severity"]), (2, "note"))

    def test_what_decimation_refuses_ends_with_its_code(self):
        surface = as_doubles(torus())
        surface.GetPoints().SetPoint(3, float("nan"), 0.0, 0.0)
        write(surface, self.path("bone.vtp"))
        answer = self.run_program("check", "bone.vtp")
        self.assertEqual(answer.returncode, REFUSED)

    def test_needs_a_file_and_never_overwrites_it(self):
        write(torus(), self.path("bone.ply"))
        self.fail_with(USAGE, "check", says="FILE")
        self.fail_with(USAGE, "check", "bone.ply", "--json", "bone.ply", says="not overwritten")
        self.fail_with(REFUSED, "check", "nowhere.ply", says="nowhere.ply")


if __name__ == "__main__":
    main()
