# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The thesis's own command line: INPUT.obj numbFaces tolerance errorThreshold."""

from application import REJECTED, USAGE, ApplicationTest, main, read, torus, write


class ThesisForm(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("bone.obj"))

    def test_default_output_lies_beside_the_input(self):
        self.path("below").mkdir()
        write(torus(), self.path("below") / "bone.obj")
        self.succeed("thesis", "below/bone.obj", 700, 0.95, 0)
        self.assertEqual(read(self.path("below") / "bone_simplified.obj").GetNumberOfPolys(), 700)

    def test_writes_to_the_output_that_is_named(self):
        self.succeed("thesis", "bone.obj", 700, 0.95, 0, "small.obj")
        self.assertEqual(self.names(), ["bone.obj", "small.obj"])

    def test_is_the_same_as_the_options(self):
        self.succeed("thesis", "bone.obj", 700, 0.9, 0, "a.obj")
        self.succeed("bone.obj", "b.obj", "--mode", "thesis", "--target-triangles", 700, "--normal-tolerance", 0.9)
        self.assertEqual(self.path("a.obj").read_bytes(), self.path("b.obj").read_bytes())

    def test_tolerance_reaches_the_cost(self):
        self.succeed("thesis", "bone.obj", 700, 0.95, 0, "a.obj")
        self.succeed("thesis", "bone.obj", 700, 0.2, 0, "b.obj")
        self.assertNotEqual(self.path("a.obj").read_bytes(), self.path("b.obj").read_bytes())

    def test_error_goes_on_below_the_number(self):
        self.succeed("thesis", "bone.obj", 1900, 0.95, 0.5, "--report", "report.json")
        report = self.report()
        self.assertEqual(report["stop_reason"], "error_reached")
        self.assertLess(report["output"]["triangles"], 1900)

    def test_takes_the_other_flags(self):
        completed = self.succeed("thesis", "bone.obj", 700, 0.95, 0, "--quiet", "--also", "b.stl", "--threads", 1)
        self.assertEqual(completed.stdout, "")
        self.assertEqual(self.names(), ["b.stl", "bone.obj", "bone_simplified.obj"])

    def test_wrong_words_are_wrong_usage(self):
        for words, says in (
            (("bone.obj", 700, 0.95), "3 words"),
            (("bone.obj", "many", 0.95, 0), "numbFaces"),
            (("bone.obj", 700, 1.5, 0), "tolerance"),
            (("bone.obj", 700, 0.95, -1), "errorThreshold"),
            (("bone.obj", 0, 0.95, 0), "nothing would end"),
        ):
            self.fail_with(USAGE, "thesis", *words, says=says)

    def test_missing_input_is_rejected(self):
        self.fail_with(REJECTED, "thesis", "nothing.obj", 700, 0.95, 0, says="no such file")


if __name__ == "__main__":
    main()
