# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The glossary: words that users looked for are in it, in order, and every entry is a word that is used."""

import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ["SOURCE_DIR"])
GLOSSARY = SOURCE / "Documentation/reference/glossary.md"
LOOKED_FOR = ("component", "draft", "error bound", "forced collapse", "fragment", "HU", "label map", "largest error", "LPS", "measured distance",
              "phantom", "prune", "RAS", "reference", "slack", "speck", "strip", "tolerance", "voxel guard")


def tables():
    """The terms of each table; an entry may have several."""
    for table in re.split(r"\n## ", GLOSSARY.read_text(encoding="utf-8"))[1:]:
        rows = re.findall(r"^\| ([^|]+) \| .+ \|$", table, re.MULTILINE)
        yield [re.split(r", | \(|\)", row) for row in rows if row not in ("term", "")]


class Glossary(unittest.TestCase):
    def setUp(self):
        self.tables = list(tables())
        self.terms = [term for table in self.tables for entry in table for term in entry if term]

    def test_words_that_users_looked_for_are_in_it(self):
        here = {term.lower() for term in self.terms}
        self.assertEqual([word for word in LOOKED_FOR if word.lower() not in here], [])

    def test_tables_are_in_order(self):
        for table in self.tables:
            firsts = [entry[0].lower() for entry in table]
            self.assertEqual(sorted(set(firsts)), sorted(firsts))
            self.assertEqual(sorted(firsts, key=lambda word: word[0]), firsts)

    def test_every_entry_is_a_word_that_is_used(self):
        pages = [*SOURCE.glob("Documentation/**/*.md"), SOURCE / "README.md", SOURCE / "ARCHITECTURE.md", *SOURCE.glob("Filters/**/*.h"),
                 *SOURCE.glob("Filters/**/*.def"), *SOURCE.glob("Applications/**/*.h")]
        text = " ".join(page.read_text(encoding="utf-8").lower() for page in pages if page != GLOSSARY)
        text = re.sub(r"[\s*/]+", " ", text)
        self.assertEqual([term for term in self.terms if term.lower() not in text], [])

    def test_the_class_comment_says_what_measuring_costs(self):
        comment = (SOURCE / "Filters/BoneDecimate/vtkBoneDecimate.h").read_text(encoding="utf-8").split("class ")[1]
        self.assertRegex(comment, r"Measuring the distances is about .*of the time")


if __name__ == "__main__":
    unittest.main()
