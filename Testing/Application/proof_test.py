# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""--max-error: the proof of what was written, on the terminal, in the report and in the file."""

from application import SURFACES, UNMEASURED, ApplicationTest, array_names, as_doubles, main, read, torus, write


class Proof(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.ply"))

    def decimate(self, *words):
        return self.succeed(*words, "--max-error", 0.2, "--report", "report.json").stdout

    def test_is_printed_rounded_up_and_reported(self):
        text = self.decimate("in.ply", "out.vtp")
        proof = self.report()["proof"]
        self.assertEqual(proof["status"], "proved")
        self.assertRegex(text, r"(?m)^proved +at most 0\.\d{6} mm in both directions$")
        printed = float(text.split("at most ")[1].split()[0])
        self.assertLessEqual(proof["upper"], printed)
        self.assertLessEqual(printed, 0.2)
        self.assertLessEqual(proof["input_to_output"]["lower"], proof["input_to_output"]["upper"])
        self.assertGreater(self.report()["seconds"]["prove"], 0.0)
        self.assertEqual(self.report()["units"]["proof.upper"], "mm")

    def test_is_that_of_every_file_as_it_was_read_back(self):
        write(as_doubles(torus(center=4000.0)), self.path("doubles.vtp"))
        others = [word for name in SURFACES for word in ("--also", "also." + name)]
        for source in ("in.ply", "doubles.vtp"):
            self.decimate(source, "out.ply", *others, *UNMEASURED)
            self.assertEqual(set(self.report()["proof"]["files"].values()), {"same_bits"})
            for name in SURFACES:
                self.succeed("certify", source, "also." + name, "--tolerance", 0.2, "--no-means", "--quiet")

    def test_keeps_double_precision_where_the_file_does(self):
        write(as_doubles(torus()), self.path("doubles.vtp"))
        self.decimate("doubles.vtp", "out.vtp", *UNMEASURED)
        self.assertEqual(read(self.path("out.vtp")).GetPoints().GetDataType(), 11)
        self.assertEqual(self.report()["proof"]["files"], {"out.vtp": "same_bits"})

    def test_stands_in_the_file_with_a_bound_at_each_point(self):
        self.decimate("in.ply", "out.vtp", "--heatmap", "map.vtp")
        output = read(self.path("out.vtp"))
        self.assertIn("ErrorBound", array_names(output.GetPointData()))
        self.assertIn("ErrorBoundToResult", array_names(read(self.path("map.vtp")).GetPointData()))
        upper = output.GetFieldData().GetArray("bonedecimate.proof.if_unchanged.upper").GetValue(0)
        self.assertEqual(upper, self.report()["proof"]["upper"])

    def test_takes_its_error_from_the_voxels_of_the_scan(self):
        for words, source, error in (
            (("--preset", "half-voxel", "--voxel-size", 0.5), "given", 0.25),
            (("--preset", "OneVoxel", "--voxel-size", 0.5, "--max-error", 0.3), "given", 0.3),
            (("--preset", "quarter-voxel"), "edges", None),
        ):
            text = self.succeed("in.ply", "out.ply", "--report", "report.json", *words, *UNMEASURED).stdout
            report = self.report()
            self.assertEqual(report["voxel"]["from"], source)
            self.assertEqual(report["proof"]["status"], "proved")
            self.assertEqual(report["proof"]["tolerance"], report["voxel"]["largest_error"])
            self.assertEqual(report["voxel"]["largest_error"], error or 0.25 * report["voxel"]["size"])
            self.assertIn("estimated" if source == "edges" else "0.5000 mm;", text)

    def test_can_be_left_out(self):
        text = self.decimate("in.ply", "out.vtp", "--prove", "off")
        self.assertIn("proved          nothing: the proof was switched off\n", text)
        self.assertNotIn("proof", self.report())


if __name__ == "__main__":
    main()
