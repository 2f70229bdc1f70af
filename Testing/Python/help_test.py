# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""help(vtkBoneDecimate) tells a reader what everything is for."""

import pydoc
import unittest

from bonedecimate import vtkBoneDecimate

# VTK's wrapping gives the comment of a group to its first member only: the setter of a property, and not its getter.
SETTERS = [name for name in vars(vtkBoneDecimate) if name.startswith("Set") and not name.startswith("SetModeTo")]
READERS = [
    name
    for name in vars(vtkBoneDecimate)
    if name.startswith("Get") and name.replace("Get", "Set", 1) not in SETTERS and "Generations" not in name
]


def sentences(name):
    lines = getattr(vtkBoneDecimate, name).__doc__.split("\n\n", 1)
    return " ".join(lines[1].split()) if len(lines) > 1 else ""


class Help(unittest.TestCase):
    def test_of_the_class_tells_what_it_does_and_in_which_unit(self):
        text = " ".join(vtkBoneDecimate.__doc__.split())
        for word in ("bone", "millimeters", "fragment", "port 1"):
            self.assertIn(word, text)

    def test_of_every_property_tells_its_meaning_and_default(self):
        self.assertGreaterEqual(len(SETTERS), 14)
        for name in SETTERS:
            with self.subTest(name):
                self.assertRegex(sentences(name), r"[Dd]efault|\bon by|\boff by")

    def test_of_everything_else_that_can_be_read_tells_its_meaning(self):
        self.assertIn("GetReportValue", READERS)
        for name in READERS:
            with self.subTest(name):
                self.assertNotEqual(sentences(name), "")

    def test_can_be_rendered(self):
        text = pydoc.render_doc(vtkBoneDecimate)
        for name in ("SetTargetReduction", "GetReportValue", "MergePointsOff"):
            self.assertIn(name, text)


if __name__ == "__main__":
    unittest.main()
