# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Options that cannot have an effect are rejected, or warned of where that depends on the data."""

from application import REJECTED, UNMEASURED, USAGE, ApplicationTest, main, read, torus, write


class IneffectiveOptions(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.ply"))

    def test_of_a_run_name_what_they_need(self):
        error = ("--max-error", 0.3)
        thesis = ("--mode", "Thesis")
        number = ("--target-triangles", 900)
        for words, says in (
            (("--voxel-size", 0.5), "--voxel-size has no effect; it needs --preset"),
            (("--voxel-size", 0.5, *error), "--voxel-size has no effect"),
            (("--auto-normal-tolerance", "on"), "--auto-normal-tolerance has no effect; it needs --mode Thesis and"),
            (("--auto-normal-tolerance", "on", *thesis, *error), "--auto-normal-tolerance has no effect"),
            (("--normal-tolerance", 0.5), "--normal-tolerance has no effect; it needs --mode Thesis"),
            (("--normal-tolerance", 0.5, *thesis, "--auto-normal-tolerance", "on"), "--auto-normal-tolerance off"),
            (("--intersection-guard", "off"), "--intersection-guard has no effect; it needs --max-error or --preset"),
            (("--intersection-guard", "off", "--region", "rest=0.2"), "--intersection-guard has no effect"),
            (("--intersection-guard", "on", *thesis, *error, *number), "another --mode than Thesis"),
            (("--refinement-effort", 2), "--refinement-effort has no effect; it needs --max-error, --preset or --tolerance-array"),
            (("--refinement-effort", 2, "--mode", "Fast", *error), "and --mode Balanced, Accurate"),
            (("--feature-angle", 45), "--feature-angle has no effect; it needs --smooth or --auto-smooth"),
            (("--prove", "on"), "--prove has no effect; it needs --max-error, --preset or --tolerance-array"),
            (("--prove", "on", *thesis, *number), "--prove has no effect"),
            (("--allow-large-error", "on"), "--allow-large-error has no effect"),
            (("--iso", 226), "--iso is for volumes"),
            (("--jobs", 2), "--jobs"),
            (("--force",), "--force"),
            (("--format", "stl"), "--format"),
            (("--also", "also.stl", "--precision", "double", *error), "--precision Double has no effect"),
        ):
            with self.subTest(words=words):
                self.fail_with(USAGE, "in.ply", "out.vtp", *words, says=says)
                if words[0] not in ("--jobs", "--force", "--format", "--also"):
                    self.fail_with(USAGE, "in.ply", "in.ply", "many", *words, says=says.split(" ")[0])

    def test_of_a_run_are_taken_where_they_have_an_effect(self):
        for words in (
            ("--preset", "half-voxel", "--voxel-size", 0.5),
            ("--mode", "Thesis", "--target-triangles", 900, "--auto-normal-tolerance", "on"),
            ("--mode", "Thesis", "--target-triangles", 900, "--normal-tolerance", 0.5),
            ("--max-error", 0.3, "--intersection-guard", "off", "--prove", "off", "--allow-large-error", "on"),
            ("--region", "rest=0.3", "--prove", "on", "--refinement-effort", 2),
        ):
            with self.subTest(words=words):
                self.succeed("in.ply", "out.vtp", *words, *UNMEASURED)

    def test_smoothing_alone_has_an_error_to_prove(self):
        smooth = ("smooth", "in.ply", "out.vtp", "--smooth", 0.1, *UNMEASURED)
        self.assertIn("proved", self.succeed(*smooth, "--prove", "on").stdout)
        self.assertIn("proved          nothing: the proof was switched off\n", self.succeed(*smooth, "--prove", "off").stdout)

    def test_no_largest_error_is_rejected_where_nothing_else_ends_the_run(self):
        run = ("in.ply", "out.vtp", "--max-error", 0, *UNMEASURED)
        for words in ((), ("--mode", "Thesis")):
            self.fail_with(USAGE, *run, *words, says="--max-error 0 sets no largest error, and nothing else ends the run")
        for words in (("--target-reduction", 0.9), ("--target-triangles", 300), ("--region", "rest=0.2"), ("--preset", "half-voxel", "--voxel-size", 0.5)):
            self.succeed(*run, *words)

    def test_dashes_of_word_processors_are_named(self):
        self.fail_with(USAGE, "in.ply", "out.vtp", "\u2014max-error", 0.5, says="'\u2014max-error' begins with a dash; options begin with two hyphens")

    def test_of_slicer_count_if_they_do_not_have_their_default(self):
        run = ("--returnparameterfile", "r.txt", "in.ply", "out.ply", "--target-triangles", 900)
        self.fail_with(USAGE, *run, "--voxel_size", 0.5, says="--voxel-size has no effect")
        self.succeed(*run, "--voxel_size", 0, "--intersection_guard", "on", "--normal_tolerance", 0.95)

    def test_names_of_arrays_that_are_not_there_are_rejected(self):
        for flag in ("--tolerance-array", "--labels"):
            self.fail_with(REJECTED, "in.ply", "out.vtp", flag, "nowhere", says="'nowhere'")

    def test_of_certify(self):
        write(torus(), self.path("b.ply"))
        pair = ("certify", "in.ply", "b.ply")
        self.fail_with(USAGE, *pair, "--first-proof", says="--first-proof has no effect; it needs --tolerance")
        self.fail_with(USAGE, *pair, "--no-means", "--mean-precision", 0.1, says="--mean-precision has no effect")

    def test_levels_that_are_out_of_reach(self):
        output = ("--output", "level.ply")
        self.fail_with(USAGE, "levels", "in.ply", *output, "--triangles", "1200,400", "--coarsest", 1000,
                       says="--triangles 400 is out of reach; --coarsest ends the run at 1000")
        said = self.succeed("levels", "in.ply", *output, "--triangles", 20, "--no-errors", "--max-error", 0.3, "--record", "log").stdout
        self.assertRegex(said, "warning: no level has as few as 20 triangles; the coarsest has [0-9]+, where --max-error ended the run\n")
        said = self.succeed("levels", "in.ply", *output, "--triangles", 20, "--log", "log").stdout
        self.assertIn(", where --coarsest or --max-error ended the run of the log\n", said)
        said = self.succeed("levels", "in.ply", *output, "--errors", "1e-4").stdout
        self.assertIn("warning: no measured level is within 0.0001 mm; the input itself, 1,920 triangles, was written\n",
                      said)
        self.assertEqual(read(self.path("level-1920.ply")).GetNumberOfPolys(), 1920)
        self.fail_with(USAGE, "levels", "in.ply", *output, "--log", "log", "--errors", 1, says="recorded with --no-errors")


if __name__ == "__main__":
    main()
