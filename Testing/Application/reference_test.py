# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""--reference: a result goes in again, and the largest error holds against the first original."""

from application import REJECTED, UNMEASURED, USAGE, ApplicationTest, main, torus, write

VIOLATED = 6

ABOVE = ("--region", "box:-99,99,-99,99,0,99=0.15;rest=0")
BELOW = ("--region", "box:-99,99,-99,99,-99,0=0.15;rest=0")
ERROR = ("--max-error", 0.15, *UNMEASURED)


class Reference(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(60, 36), self.path("first.vtp"))

    def again(self, source, target, *words):
        return self.succeed(source, target, "--reference", "first.vtp", "--report", "report.json", *ERROR, *words)

    def test_brush_after_brush_keeps_the_error_against_the_first(self):
        self.succeed("first.vtp", "second.vtp", *ERROR, *ABOVE, "--quiet")
        said = self.again("second.vtp", "third.vtp", *BELOW).stdout
        self.assertIn("to the reference", said)
        report = self.report()
        self.assertEqual(report["proof"]["status"], "proved")
        self.assertEqual(report["reference"]["triangles"], torus(60, 36).GetNumberOfPolys())
        self.assertLess(report["output"]["triangles"], 0.7 * report["input"]["triangles"])
        self.again("third.vtp", "fourth.vtp", *ABOVE)
        self.succeed("certify", "first.vtp", "fourth.vtp", "--tolerance", 0.15, "--no-means", "--quiet")

    def test_without_it_errors_add_up(self):
        source = "first.vtp"
        for run in range(4):
            self.succeed(source, f"{run}.vtp", *ERROR, "--quiet")
            source = f"{run}.vtp"
        completed = self.run_program("certify", "first.vtp", source, "--tolerance", 0.15, "--no-means")
        self.assertEqual(completed.returncode, VIOLATED, completed.stdout)

    def test_is_proved_of_files_of_single_precision(self):
        self.succeed("first.vtp", "second.stl", *ERROR, *ABOVE, "--quiet")
        self.again("second.stl", "third.ply", *BELOW)
        self.succeed("certify", "first.vtp", "third.ply", "--tolerance", 0.15, "--no-means", "--quiet")

    def test_that_cannot_be_used_is_rejected(self):
        write(torus(10, 8), self.path("coarse.vtp"))
        self.fail_with(REJECTED, "coarse.vtp", "out.vtp", "--reference", "first.vtp", *ERROR, says="farther")
        self.fail_with(REJECTED, "first.vtp", "out.vtp", "--reference", "nothing.vtp", *ERROR, says="no such file")
        self.fail_with(USAGE, "first.vtp", "out.vtp", "--reference", "first.vtp", says="--max-error")
        self.fail_with(USAGE, "first.vtp", "out.vtp", "--reference", "out.vtp", *ERROR, says="not overwritten")
        self.fail_with(USAGE, "first.vtp", "folder/", "--reference", "first.vtp", *ERROR, says="one bone")


if __name__ == "__main__":
    main()
