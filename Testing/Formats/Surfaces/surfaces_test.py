# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The short form of compare_surfaces.py: some variants of each format, read by the program and by Debian's VTK."""

import argparse
import importlib
import itertools
import os
import pathlib
import sys
import unittest

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER.parent), str(FOLDER)]

import compare_surfaces  # noqa: E402
import explained  # noqa: E402
import pairwise  # noqa: E402
import plant_bugs  # noqa: E402

ARGUMENTS = argparse.Namespace(
    program=os.environ["BONEDECIMATE_PROGRAM"],
    variants=40,
    python=None,
    readers=["vtk of Debian"],
    by_program=1,
    keep=None,
    own=False,
    analyze=False,
    find=None,
)


class Surfaces(unittest.TestCase):
    def test_variants_of_each_format_are_read_as_they_were_made_or_as_explained(self):
        for name in compare_surfaces.FORMATS:
            with self.subTest(name):
                table = compare_surfaces.compare_format(ARGUMENTS, name)
                found = [(reader, kind, variant.choices) for reader, kind, variant, _ in table.unexplained]
                self.assertEqual(found, [])

    def test_every_pair_of_choices_is_covered(self):
        for name in compare_surfaces.FORMATS:
            choices = importlib.import_module("grammar_" + name).CHOICES
            rows = pairwise.all_pairs(choices, compare_surfaces.SEED)
            for a, b in itertools.combinations(choices, 2):
                seen = {(row[a], row[b]) for row in rows}
                self.assertEqual(len(seen), len(choices[a]) * len(choices[b]), (name, a, b))

    def test_explanations_name_choices_that_there_are(self):
        for explanation in explained.EXPLAINED:
            for name in explanation.formats:
                choices = importlib.import_module("grammar_" + name).CHOICES
                for choice, values in explanation.when.items():
                    self.assertLessEqual(set(values), set(choices[choice]), (name, choice))
                self.assertTrue(explanation.when or explanation.kinds, explanation)

    def test_planted_bugs_have_their_code(self):
        for _, _, file, old, _ in plant_bugs.BUGS:
            self.assertEqual((plant_bugs.SOURCE / plant_bugs.FORMATS / file).read_text(encoding="utf-8").count(old), 1, (file, old))


if __name__ == "__main__":
    unittest.main()
