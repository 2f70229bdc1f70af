# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""bonedecimate demo: a first result without a file, and the command that does the same."""

import json

from application import NOT_WRITTEN, ApplicationTest, main

FILES = ["bone.stl", "bone.vtp", "ct.mha", "labels.mha", "report.html", "report.json"]


class Demo(ApplicationTest):
    def test_a_first_result_is_proved_and_its_command_gives_the_same(self):
        said = self.succeed("demo").stdout
        made = self.path("bonedecimate-demo")
        self.assertEqual(sorted(file.name for file in made.iterdir()), FILES)
        report = json.loads((made / "report.json").read_text(encoding="utf-8"))
        self.assertLessEqual(report["proof"]["upper"], 0.5)
        self.assertGreater(report["input"]["triangles"], 10 * report["output"]["triangles"])
        lines = said.splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["bonedecimate", "triangles", "components", "proved", "A", "Open"])
        first = (made / "bone.stl").read_bytes()
        self.succeed(*lines[0].split()[1:])
        self.assertEqual((made / "bone.stl").read_bytes(), first)

    def test_it_writes_where_it_is_told_or_says_that_it_cannot(self):
        self.succeed("demo", "first/result")
        self.assertEqual(sorted(file.name for file in self.path("first/result").iterdir()), FILES)
        self.path("taken").write_text("a file", encoding="utf-8")
        self.fail_with(NOT_WRITTEN, "demo", "taken", says="could not write 'taken/labels.mha'")


if __name__ == "__main__":
    main()
