# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""--explain: what it says is what the run then does, and it does nothing itself."""

import re

from application import DONE, REJECTED, UNMEASURED, USAGE, ApplicationTest, main, torus, write
from combinations_inputs import write_inputs


class Explain(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.vtp"))

    def explain(self, *words, code=DONE):
        """The lines by heading. No file is written."""
        before = self.names()
        done = self.run_program(*words, "--explain")
        self.assertEqual((done.returncode, done.stderr), (code, ""), done.stdout)
        self.assertEqual(self.names(), before)
        lines, heading = {}, ""
        for line in done.stdout.splitlines():
            heading = line[:12].strip() or heading
            lines.setdefault(heading, []).append(line[12:])
        return lines

    def test_the_bound_is_that_of_the_certificate(self):
        for words in (("--max-error", 0.3), ("--preset", "HalfVoxel", "--voxel-size", 0.6), ("--preset", "HalfVoxel"),
                      ("--preset", "HalfVoxel", "--max-error", 0.2)):
            bound = float(self.explain("in.vtp", "out.vtp", *words)["bound"][-1].split(" mm")[0])
            self.succeed("in.vtp", "out.vtp", *words, *UNMEASURED, "--report", "report.json", "--quiet")
            self.assertAlmostEqual(self.report()["proof"]["tolerance"], bound, 5)
            for name in ("out.vtp", "report.json"):
                self.path(name).unlink()

    def test_each_point_has_its_bound(self):
        said = self.explain("in.vtp", "out.vtp", "--max-error", 0.3, "--region", "sphere:28,0,0,9=0;rest=0.2")["bound"]
        self.assertEqual(len(said), 3)
        unchanged, rest = (re.match(r"(\d+) points: (.*)", line) for line in said[1:])
        self.assertEqual((unchanged[2], rest[2]), ("does not change", "0.2 mm, linear on each triangle"))
        self.assertEqual(int(unchanged[1]) + int(rest[1]), 960)
        said = self.explain("in.vtp", "out.vtp", "--max-error", 0.1, "--region", "rest=0.2")["bound"]
        self.assertEqual(said[1], "every point: 0.1 mm, the largest error")

    def test_the_end_is_that_of_the_run(self):
        for words in ((), ("--target-reduction", 0.7), ("--target-triangles", 500)):
            end = self.explain("in.vtp", "out.vtp", *words)["ends at"][0]
            self.succeed("in.vtp", "out.vtp", *words, *UNMEASURED, "--report", "report.json", "--quiet")
            self.assertEqual(self.report()["output"]["triangles"], int(end.split(" ")[0]))
            for name in ("out.vtp", "report.json"):
                self.path(name).unlink()

    def test_an_edge_length_is_a_stage_and_an_end(self):
        said = self.explain("in.vtp", "out.vtp", "--edge-length", 8)
        self.assertEqual(said["ends at"], ["the last edit that is valid"])
        self.assertEqual(said["stages"], ["clean, collapse, refine, bring edges to --edge-length, measure distances, write"])
        self.succeed("in.vtp", "out.vtp", "--edge-length", 8, *UNMEASURED, "--report", "report.json", "--quiet")
        self.assertEqual(self.report()["stop_reason"], "nothing_left")

    def test_a_missing_array_of_edge_lengths_is_rejected_as_by_the_run(self):
        for words in (("--explain",), ()):
            self.fail_with(REJECTED, "in.vtp", "out.vtp", "--edge-length", 8, "--edge-length-array", "none", *words, says="point array 'none'")

    def test_what_the_run_rejects_after_reading_is_rejected_in_its_sentence(self):
        write(torus(), self.path("in.ply"))
        for words in (("--max-error", 200), ("--max-error", 1e-5), ("--labels", "foo"), ("--region", "rest=50"),
                      ("--max-error", 1e-5, "--unit", "cm")):
            with self.subTest(words):
                run = self.fail_with(REJECTED, "in.ply", "out.vtp", *words)
                explained = self.fail_with(REJECTED, "in.ply", "out.vtp", *words, "--explain")
                self.assertEqual(explained.stderr, run.stderr)

    def test_folders_that_are_not_there_and_what_is_not_checked(self):
        said = self.explain("in.vtp", "no/out.vtp", "--report", "none/r.json", code=USAGE)["rejected"]
        self.assertEqual(said, ["could not write 'no/out.vtp': there is no folder 'no'", "could not write 'none/r.json': there is no folder 'none'"])
        self.assertEqual(self.explain("in.vtp", "out.vtp")["not checked"], ["whether the files can be written, and the memory"])
        said = self.explain("in.vtp", "out.vtp", "--prune-size", 1, "--max-error", 0.1, "--reference", "in.vtp")["not checked"]
        self.assertEqual(said[:2], ["the distance of the input to --reference", "whether anything is left after pruning"])
        write(torus(), self.path("bones.stl"))
        said = self.explain("in.vtp", "bones.stl", "small/")
        self.assertTrue(said["not checked"][0].startswith("the surface: its size against the largest error"))

    def test_stages_follow_the_options(self):
        plain = self.explain("in.vtp", "out.vtp", "--mode", "Fast")["stages"]
        self.assertEqual(plain, ["clean, collapse, measure distances, write"])
        full = self.explain("in.vtp", "out.vtp", "--max-error", 0.3, "--smooth", 0.1, "--prune-size", 1, "--min-angle", 20, "--measure", "off")
        self.assertEqual(full["stages"], ["clean, prune, smooth, draft, collapse, refine, improve triangles below --min-angle, "
                                          "prove the result, write, prove what was written"])
        self.assertEqual(full["smoothing"], ["no point moves by more than 0.1 mm, which the largest error includes: --smooth"])

    def test_a_unit_takes_its_part_of_the_bound(self):
        said = self.explain("in.vtp", "out.obj", "--unit", "cm", "--max-error", 0.3)["bound"]
        self.assertIn("because coordinates in the unit of the file are rounded", said[1])
        self.assertIn("glb, whole multiples of a step", self.explain("in.vtp", "out.glb", "--max-error", 0.3)["writes"][0])

    def test_options_say_where_they_are_from(self):
        said = self.explain("in.vtp", "out.stl", "--profile", "print", "--max-error", 0.2)
        self.assertIn("--prune-size 2, from profile 'print'", said["options"])
        self.assertIn("--max-error 0.2", said["options"])
        self.assertIn("--max-error of profile 'print' gives way to the command line", said["options"])
        self.assertEqual(said["writes"], ["'out.stl': stl, single precision, no arrays"])

    def test_all_options_without_effect_are_listed(self):
        said = self.explain("in.vtp", "out.vtp", "--voxel-size", 0.5, "--feature-angle", 30, "--position-bits", 12, code=USAGE)
        self.assertEqual(said["rejected"], ["--feature-angle has no effect; it needs --smooth or --auto-smooth",
                                            "--voxel-size has no effect; it needs --preset"])
        self.fail_with(USAGE, "in.vtp", "out.vtp", "--voxel-size", 0.5, says=said["rejected"][1])
        said = self.explain("in.vtp", "out.vtp", "--position-bits", 12, code=USAGE)
        self.assertEqual(said["rejected"], ["--position-bits has no effect; it needs an output in glb"])

    def test_batches_name_each_surface(self):
        write(torus(), self.path("bones.stl"))
        said = self.explain("in.vtp", "bones.stl", "small/", "--max-error", 0.3)
        self.assertEqual(said["run"], ["'in.vtp' -> 'small/in.vtp'", "'bones.stl' -> 'small/bones.stl'"])

    def test_volumes_are_known_by_their_header(self):
        write_inputs(self.folder)
        said = self.explain("bone.mha", "out.stl", "--iso", "bone", "--preset", "HalfVoxel")
        self.assertIn(" voxels of ", said["input"][0])
        self.assertIn("the smallest voxel spacing, of the volume", said["bound"][0])
        coarser = "larger if a neural network made the labels on a coarser grid"
        for choice, is_there in (("auto", True), ("off", False)):
            said = self.explain("bone_map.mha", "segments", "--segments", "all", "--preset", "HalfVoxel", "--model-grid", choice)
            self.assertIn("the smallest voxel spacing, of the volume", said["bound"][0])
            self.assertEqual(said["bound"][1:], [coarser] if is_there else [])
        said = self.explain("bone_map.mha", "segments", "--segments", "all", "--preset", "HalfVoxel", "--model-grid", 2)
        self.assertEqual(said["bound"], ["HalfVoxel of the smallest voxel spacing of the neural network's grid"])
        said = self.explain("bone_map.mha", "segments", "--segments", "all")
        self.assertIn("'segments': a surface for each segment, vtp", said["writes"][0])

    def test_other_commands_and_inputs_that_are_not_there(self):
        self.assertIn("stages", self.explain("smooth", "in.vtp", "out.vtp", "--smooth", 0.1))
        write(torus(), self.path("in.obj"))
        self.assertEqual(self.explain("thesis", "in.obj", 300, 0.95, 0)["ends at"], ["300 triangles: --target-triangles"])
        self.fail_with(USAGE, "levels", "in.vtp", "--explain", says="--explain")
        self.fail_with(USAGE, "in.vtp", "out.vtp", "--explain", "--quiet", says="--explain prints what --quiet would hide")
        self.fail_with(REJECTED, "no.vtp", "out.vtp", "--explain", says="no.vtp")


if __name__ == "__main__":
    main()
