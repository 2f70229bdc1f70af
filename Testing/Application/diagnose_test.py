# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""bonedecimate diagnose FILE: diagnostics, JSON and exit codes."""

import json

from application import REJECTED, SURFACES, USAGE, ApplicationTest, as_doubles, main, together, torus, write


class Diagnose(ApplicationTest):
    def test_a_sound_surface_is_one_part_and_can_be_decimated(self):
        for extension in SURFACES:
            write(torus(), self.path("bone." + extension))
            completed = self.succeed("diagnose", "bone." + extension)
            self.assertIn("1 connected part\n", completed.stdout)
            self.assertIn("It can be decimated.", completed.stdout)

    def test_json_has_every_diagnostic_with_count_and_first_ids(self):
        write(together(torus(), torus(center=50.0)), self.path("bone.vtp"))
        self.succeed("diagnose", "bone.vtp", "--json", "found.json", "--quiet")
        with open(self.path("found.json"), encoding="utf-8") as file:
            found = json.load(file)
        self.assertTrue(found["usable"])
        parts = next(one for one in found["diagnostics"] if one["kind"] == "components")
        self.assertEqual((parts["count"], parts["severity"]), (2, "note"))

    def test_what_decimation_rejects_ends_with_its_code(self):
        surface = as_doubles(torus())
        surface.GetPoints().SetPoint(3, float("nan"), 0.0, 0.0)
        write(surface, self.path("bone.vtp"))
        completed = self.run_program("diagnose", "bone.vtp")
        self.assertEqual(completed.returncode, REJECTED)

    def test_needs_a_file_and_never_overwrites_it(self):
        write(torus(), self.path("bone.ply"))
        self.fail_with(USAGE, "diagnose", says="FILE")
        self.fail_with(USAGE, "diagnose", "bone.ply", "--json", "bone.ply", says="not overwritten")
        self.fail_with(REJECTED, "diagnose", "nowhere.ply", says="nowhere.ply")


if __name__ == "__main__":
    main()
