# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What a batch prints and writes of its inputs: lines, summary.csv, summary.html."""

import csv
import re

from application import UNMEASURED, USAGE, ApplicationTest, main, torus, write

CUT_OFF = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3"  # without a last line end


class BatchTable(ApplicationTest):
    def setUp(self):
        super().setUp()
        self.path("bones").mkdir()

    def rows(self):
        with open(self.path("out/summary.csv"), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def names_and_inputs(self):
        return [(row["name"], row["input"]) for row in self.rows()]

    def test_the_table_never_shows_a_measured_distance_above_its_bound(self):
        for name in ("a", "b"):
            write(torus(), self.path(f"{name}.ply"))
        for words in (("--max-error", 0.2), ("--target-triangles", 700)):
            said = self.succeed("a.ply", "b.ply", "out/", *words, "--force").stdout
            page = self.path("out/summary.html").read_text(encoding="utf-8")
            for row in self.rows():
                largest = max(float(row["max_output_to_input_mm"]), float(row["max_input_to_output_mm"]))
                shown = [float(text) for text in re.search(rf"(?m)^{row['name']} .*$", said)[0].split() if re.fullmatch(r"\d+\.\d{4}", text)]
                if row["proved_mm"]:
                    bound = float(re.search(r"<strong>at most ([\d.]+) mm</strong>, proved<", page)[1])
                    self.assertTrue(0 <= bound - float(row["proved_mm"]) < 2e-4)
                    self.assertLessEqual(max(shown), bound)
                else:
                    measured = float(re.search(r"<strong>([\d.]+) mm or more</strong>, measured<", page)[1])
                    self.assertTrue(0 <= largest - measured < 1e-4)
                self.assertGreaterEqual(len(shown), 2)

    def test_an_input_with_another_name_has_one_row(self):
        write(torus(), self.path("bones/tibia.stl"))
        write(torus(), self.path("bones/femur.stl"))
        self.succeed("bones", "out", *UNMEASURED)
        write(torus(), self.path("bones/tibia.ply"))
        self.succeed("bones", "out", *UNMEASURED, "--only", "tibia*")
        self.assertEqual(self.names_and_inputs(), [("tibia_ply", "tibia.ply"), ("tibia_stl", "tibia.stl"), ("femur", "femur.stl")])
        self.assertNotIn(">tibia<", self.path("out/summary.html").read_text(encoding="utf-8"))
        self.assertTrue(self.path("out/tibia.stl").exists())
        self.path("bones/tibia.stl").rename(self.path("bones/moved.stl"))  # what is no input of a run keeps its row
        self.succeed("bones", "out", *UNMEASURED, "--only", "femur*")
        self.assertIn(("tibia_stl", "tibia.stl"), self.names_and_inputs())

    def test_progress_counts_on_the_error_output_what_has_ended(self):
        for name in ("a", "b", "c"):
            write(torus(), self.path(f"bones/{name}.stl"))
        said = self.run_program("bones", "out", *UNMEASURED, "--progress").stderr
        self.assertEqual(said, "".join(f"{number} of 3 inputs have ended\n" for number in (1, 2, 3)))
        self.assertEqual(self.succeed("bones", "out", *UNMEASURED, "--progress", "--quiet", "--force").stdout, "")

    def test_columns_are_counted_in_characters(self):
        for name in ("M\u00fcller_J\u00f6rg_\u00fc\u00fc", "Tibia"):
            write(torus(), self.path(f"bones/{name}.stl"))
        for words in (("bones", "out", *UNMEASURED), ("summary", "out")):
            lines = self.succeed(*words).stdout.splitlines()
            self.assertEqual([line.index(word) for line in lines for word in (" status ", " done ") if word in line], 3 * [15])

    def test_messages_of_files_are_of_the_result_alone(self):
        self.path("bones/c.obj").write_text(CUT_OFF)
        self.succeed("bones", "out", *UNMEASURED)
        first = self.rows()
        again = self.succeed("bones", "out", *UNMEASURED).stdout
        self.assertRegex(again, "(?m)^c +done .* by an earlier run; --force does it again; warning: the last line")
        self.assertEqual(self.rows(), first)
        self.assertRegex(first[0]["message"], "^warning: the last line")
        self.assertNotIn("by an earlier run", self.path("out/summary.html").read_text(encoding="utf-8"))

    def test_a_folder_without_a_volume_is_named_where_a_surface_was_expected(self):
        self.fail_with(USAGE, "bones", "ct.stl", "--iso", 226, says="'bones' has neither a DICOM series nor slices of one volume")

    def test_the_page_has_the_width_of_the_window(self):
        write(torus(), self.path("bones/a.stl"))
        self.succeed("bones", "out", *UNMEASURED)
        page = self.path("out/summary.html").read_text(encoding="utf-8")
        self.assertIn('<body class="wide">', page)
        self.assertIn(".wide { max-width: none; }", page)


if __name__ == "__main__":
    main()
