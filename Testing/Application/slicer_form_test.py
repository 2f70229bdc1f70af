# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The program as 3D Slicer calls it: description, words, progress, results. Slicer itself: Testing/Slicer."""

import re
import xml.etree.ElementTree as ElementTree

from application import USAGE, ApplicationTest, main, read, torus, write


class SlicerForm(ApplicationTest):
    def setUp(self):
        super().setUp()
        write(torus(), self.path("in.vtp"))

    def description(self):
        return ElementTree.fromstring(self.succeed("--xml").stdout)

    def defaults(self):
        """What a panel passes with all its defaults."""
        words = []
        for group in self.description().iter("parameters"):
            for one in group:
                flag, value = one.findtext("longflag"), one.findtext("default")
                if flag and value and one.tag not in ("geometry", "region", "point"):
                    words += [flag, value]
        return words

    def call(self, *words):
        return self.succeed("--returnparameterfile", self.path("results.txt"), *words, "in.vtp", "out.vtp")

    def results(self):
        with open(self.path("results.txt"), encoding="utf-8") as file:
            return dict(line.rstrip("\n").split(" = ", 1) for line in file)

    def test_description_begins_as_slicer_wants_it_and_has_each_option_once(self):
        text = self.succeed("--xml").stdout
        self.assertTrue(text.startswith('<?xml version="1.0" encoding="utf-8"?>\n'))
        names = [one.text for one in self.description().iter("name")]
        self.assertEqual(len(names), len(set(names)))
        self.assertTrue(all(re.fullmatch(r"[A-Za-z]\w*", name) for name in names))
        flags = {one.text for one in self.description().iter("longflag")}
        self.assertTrue(all(re.fullmatch(r"--[A-Za-z_]\w*", flag) for flag in flags), "Slicer takes no dashes")
        flags = {"--" + flag[2:].replace("_", "-") for flag in flags}
        table = set(re.findall(r"`(--[a-z-]+)`", self.succeed("--options-markdown").stdout))
        self.assertLessEqual(table, flags)
        self.assertEqual(flags - table, {"--heatmap", "--roi", "--keep", "--keep-radius"})

    def test_every_default_is_one_that_the_program_takes(self):
        self.call(*self.defaults())
        results = self.results()
        self.assertEqual(results["proofStatus"], "proved")
        self.assertLessEqual(float(results["provedError"]), 0.2)
        self.assertEqual(int(results["outputTriangles"]), read(self.path("out.vtp")).GetNumberOfPolys())
        self.assertLess(int(results["outputTriangles"]), int(results["inputTriangles"]))

    def test_progress_comes_in_tags_and_nothing_on_the_error_output(self):
        done = self.call("--max-error", 0.2)  # succeeding is to say nothing there
        fractions = [float(one) for one in re.findall(r"<filter-progress>(.*?)</filter-progress>", done.stdout)]
        self.assertGreater(len(fractions), 5)
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(fractions[-1], 1.0)
        self.assertLess(done.stdout.index("<filter-start>"), done.stdout.index("<filter-progress>"))
        self.assertIn("</filter-end>", done.stdout)

    def test_only_the_region_of_interest_changes_and_what_is_kept_stays(self):
        before = self.positions("in.vtp")
        right = {position for position in before if position[0] > 0.0}
        self.call("--max-error", 0.3, "--roi", "-50,0,0,50,99,99")
        self.assertLessEqual(before - self.positions("out.vtp"), before - right)
        self.assertLess(len(self.positions("out.vtp")), len(before))
        kept = min(before)
        near = {position for position in before if sum((a - b) ** 2 for a, b in zip(position, kept)) < 9.0}
        self.call("--max-error", 0.3, "--keep", ",".join(map(repr, kept)), "--keep-radius", 3)
        self.assertLessEqual(near, self.positions("out.vtp"))
        self.assertGreater(len(near), 1)

    def positions(self, name):
        surface = read(self.path(name))
        return {surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())}

    def test_what_makes_no_sense_is_a_usage_error(self):
        run = ("--returnparameterfile", "r.txt", "in.vtp", "out.vtp")
        self.fail_with(USAGE, *run, "--roi", "0,0,0,1,1,1", says="--max-error")
        self.fail_with(USAGE, *run, "--max-error", 0.1, "--roi", "0,0,0,1,1", says="6 numbers")
        self.fail_with(USAGE, *run, "--max-error", 0.1, "--keep", "0,0,x", says="3 numbers")
        self.fail_with(USAGE, "in.vtp", "out.vtp", "--returnparameterfile", says="takes a value")


if __name__ == "__main__":
    main()
