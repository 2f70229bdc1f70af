# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""--unit: coordinates of files in another unit than millimeters, everything else in millimeters."""

import numpy as np

from application import REJECTED, SURFACES, UNMEASURED, USAGE, ApplicationTest, main, positions_of, read, surface_of, torus, write

UNITS = {"m": 0.001, "cm": 0.1, "mm": 1.0, "um": 1000.0, "inch": 1 / 25.4}
VIOLATED = 6


def scaled(surface, factor, doubles=False):
    return surface_of(positions_of(surface) * factor, surface.GetPolys(), float if doubles else np.float32)


def positions(surface):
    return [surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())]


class Units(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("mm.ply"))
        for unit, factor in UNITS.items():
            write(scaled(torus(), factor), self.path(unit + ".stl"))
            write(scaled(torus(), factor, doubles=True), self.path(unit + ".vtp"))

    def test_a_run_keeps_its_error_in_millimeters_and_writes_in_the_unit_of_the_input(self):
        self.succeed("mm.vtp", "expected.vtp", "--max-error", 0.2, "--report", "expected.json", "--quiet", *UNMEASURED)
        expected = self.report("expected.json")
        for unit, factor in UNITS.items():
            pairs = ((".stl", "out.stl"), (".stl", "out.vtp"), (".vtp", "out.vtp"), (".vtp", "out.stl"))
            for source, target in pairs if unit == "m" else pairs[1:3]:
                with self.subTest(unit=unit, source=source, target=target):
                    self.succeed(unit + source, target, "--unit", unit, "--max-error", 0.2, "--report", "report.json",
                                 "--also", "also.obj", *UNMEASURED)
                    report = self.report()
                    self.assertEqual(report["files"]["unit"], unit)
                    self.assertEqual(report["proof"]["files"], {target: "same_bits", "also.obj": "same_bits"})
                    self.assertEqual((report["proof"]["status"], report["proof"]["tolerance"]), ("proved", 0.2))
                    self.assertLessEqual(report["proof"]["upper"], 0.2)
                    self.assertLess(abs(report["output"]["triangles"] / expected["output"]["triangles"] - 1), 0.1)
                    self.assertAlmostEqual(report["input"]["area"] / expected["input"]["area"], 1.0, 5)
                    self.assertAlmostEqual(read(self.path(target)).GetBounds()[1] / factor, 28.0, 0)
                    certify = ("certify", unit + source, target, "--unit", unit, "--json", "c.json", "--quiet")
                    self.succeed(*certify, "--tolerance", 0.2, "--no-means")
                    certificate = self.report("c.json")
                    self.assertEqual(certificate["files"]["unit"], unit)
                    self.assertLessEqual(certificate["upper"], report["proof"]["upper"] * (1 + 1e-5))

    def test_meters_are_not_silently_millimeters(self):
        self.succeed("m.stl", "out.stl", "--unit", "m", "--max-error", 0.5, "--quiet", *UNMEASURED)
        self.assertGreater(read(self.path("out.stl")).GetNumberOfPolys(), 100)
        completed = self.run_program("certify", "m.stl", "out.stl", "--unit", "m", "--tolerance", 0.001)
        self.assertEqual(completed.returncode, VIOLATED)

    def test_a_size_that_is_not_in_millimeters_is_warned_of_and_rejected_with_the_way_to_go(self):
        write(scaled(torus(), 1e-3), self.path("bone.ply"))
        said = self.succeed("bone.ply", "out.ply", "--target-triangles", 500, "--report", "r.json", *UNMEASURED).stdout
        self.assertRegex(said, "warning: .*may not be in millimeters, --unit tells their unit")
        self.assertIn("--unit tells their unit", self.report("r.json")["warnings"][0])
        for words in (("bone.ply", "new.ply", "--max-error", 0.5), ("curve", "bone.ply", "--errors", 0.5),
                      ("levels", "bone.ply", "--max-error", 0.5)):
            completed = self.fail_with(REJECTED, *words, says="may not be in millimeters, --unit tells their unit")
            self.assertIn("--allow-large-error on", completed.stderr)
            self.succeed(*words, "--allow-large-error", "on")
            self.succeed(*words, "--unit", "m")
            self.path("new.ply").unlink(missing_ok=True)
        write(torus(), self.path("large.ply"))
        said = self.succeed("large.ply", "out.ply", "--unit", "m", "--target-triangles", 500, *UNMEASURED).stdout
        self.assertIn("may not be in the unit of --unit, m\n", said)
        self.assertNotIn("--unit tells", said)
        self.assertIn("--unit", self.succeed("diagnose", "bone.ply").stdout)
        self.assertNotIn("--unit", self.succeed("diagnose", "bone.ply", "--unit", "m").stdout)
        self.assertNotIn("warning", self.succeed("bone.ply", "out.ply", "--unit", "m", *UNMEASURED).stdout)
        self.fail_with(USAGE, "levels", "bone.ply", "--allow-large-error", "on", says="it needs --max-error")

    def test_every_format_is_read_and_written(self):
        for extension in SURFACES:
            write(scaled(torus(), 0.1), self.path("bone." + extension))
            self.succeed("bone." + extension, "out." + extension, "--unit", "cm", "--target-triangles", 700, "--report", "r.json", *UNMEASURED)
            self.assertAlmostEqual(read(self.path("out." + extension)).GetBounds()[1], 2.8, 1)
            self.assertAlmostEqual(self.report("r.json")["input"]["area"], 6280, -2)

    def test_points_of_tolerance_zero_have_the_same_coordinates_in_the_file(self):
        half = ("--region", "box:0,99,-99,99,-99,99=0;rest=0.2", "--quiet", *UNMEASURED)
        for unit in ("m", "inch"):
            for name in (unit + ".stl", unit + ".vtp"):
                target = "out" + name[-4:]
                self.succeed(name, target, "--unit", unit, *half)
                before = {p for p in positions(read(self.path(name))) if p[0] > 0}
                after = positions(read(self.path(target)))
                self.assertLess(len(after), len(before) * 2)
                self.assertLessEqual(before, set(after), name)
        self.fail_with(REJECTED, "m.vtp", "out2.stl", "--unit", "m", *half, says="double precision")

    def test_pruning_references_and_tolerances_are_in_millimeters(self):
        self.succeed("m.vtp", "a.vtp", "--unit", "m", "--max-error", 0.3, "--region", "box:0,99,-99,99,-99,99=0.05", "--quiet", *UNMEASURED)
        self.succeed("a.vtp", "b.stl", "--unit", "m", "--max-error", 0.3, "--reference", "m.vtp", "--report", "r.json",
                     "--heatmap", "heat.vtp", "--page", "p.html")
        self.succeed("certify", "m.vtp", "b.stl", "--unit", "m", "--tolerance", 0.3, "--quiet")
        self.assertLess(read(self.path("heat.vtp")).GetBounds()[1], 0.03)
        self.fail_with(REJECTED, "m.vtp", "c.vtp", "--unit", "m", "--prune-size", 57, says="smaller")
        self.succeed("m.vtp", "c.vtp", "--unit", "m", "--prune-size", 55, "--quiet", *UNMEASURED)

    def test_an_error_that_rounding_would_use_up_is_rejected(self):
        far = torus(center=4000.0)
        write(scaled(far, 0.001), self.path("far.stl"))
        self.fail_with(REJECTED, "far.stl", "out.stl", "--unit", "m", "--max-error", 0.0005, says="more than half")

    def test_other_commands_take_it(self):
        found = {}
        for unit in ("mm", "m"):
            self.succeed("diagnose", unit + ".vtp", "--unit", unit, "--json", "check.json")
            self.assertEqual(self.report("check.json")["unit"], unit)
            self.succeed("curve", unit + ".vtp", "--unit", unit, "--errors", "0.1,0.5", "--mode", "fast", "--json", "c.json")
            found[unit] = [run["triangles"] for run in self.report("c.json")["runs"]]
        for a, b in zip(found["m"], found["mm"]):
            self.assertLess(abs(a - b), 0.05 * b)
        self.succeed("tolerance", "m.stl", "--unit", "m", "--triangles", 900, "--precision", 0.5, "--mode", "fast",
                     "--json", "t.json")
        self.assertLess(self.report("t.json")["smallest_error_mm"], 1.0)
        self.assertGreater(self.report("t.json")["smallest_error_mm"], 0.01)

    def test_levels_are_written_in_the_unit_and_their_log_belongs_to_it(self):
        run = ("levels", "m.stl", "--unit", "m", "--output", "level.stl", "--triangles", 500)
        said = self.succeed(*run, "--record", "log", "--max-error", 1).stdout
        self.assertNotIn("warning", said)
        self.assertAlmostEqual(read(self.path("level-500.stl")).GetBounds()[1], 0.028, 3)
        self.succeed("certify", "m.stl", "level-500.stl", "--unit", "m", "--tolerance", 1, "--quiet")
        before = self.path("level-500.stl").read_bytes()
        self.succeed(*run, "--log", "log")
        self.assertEqual(self.path("level-500.stl").read_bytes(), before)
        self.fail_with(REJECTED, "levels", "m.stl", "--log", "log", says="another surface")

    def test_a_batch_hands_it_on(self):
        self.path("bones").mkdir()
        for name in ("a.stl", "b.stl"):
            (self.path("bones") / name).write_bytes(self.path("m.stl").read_bytes())
        self.succeed("bones", "out", "--unit", "m", "--max-error", 0.2, *UNMEASURED)
        self.assertEqual(self.report("out/a.json")["files"]["unit"], "m")
        self.assertIn("by an earlier run", self.succeed("bones", "out", "--unit", "m", "--max-error", 0.2, *UNMEASURED).stdout)

    def test_the_form_of_the_thesis_takes_it(self):
        write(scaled(torus(), 0.001), self.path("bone.obj"))
        self.succeed("thesis", "bone.obj", 700, 0.95, 0, "out.obj", "--unit", "m", "--report", "r.json")
        self.assertAlmostEqual(self.report("r.json")["input"]["area"], 6280, -2)

    def test_other_units_are_wrong_usage(self):
        for words in ((), ("certify",), ("diagnose",), ("levels",), ("curve", "--errors", 1), ("tolerance", "--triangles", 5)):
            for unit in ("km", "", "M", "1000", "millimeters"):
                self.fail_with(USAGE, *words, "mm.ply", "out.ply", "--unit", unit, says="--unit takes one of m, cm, mm, um, inch")
        self.fail_with(USAGE, "ct.mha", "out.ply", "--iso", 226, "--unit", "m", says="--unit is for surfaces")


if __name__ == "__main__":
    main()
