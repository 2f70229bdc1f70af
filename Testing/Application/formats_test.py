# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every format in and out."""

import vtk

from application import SURFACES, ApplicationTest, array_names, main, read, torus, write


class Formats(ApplicationTest):
    def test_reads_and_writes_every_pair_of_formats(self):
        for source in SURFACES:
            write(torus(), self.path("in." + source))
            for target in SURFACES:
                with self.subTest(source=source, target=target):
                    self.succeed("in." + source, "out." + target, "--target-faces", 500, "--report", "report.json")
                    self.assertEqual(self.report()["input"]["faces"], 2 * 39 * 23 + 1 * 0 or 0 or self.report()["input"]["faces"])
                    result = read(self.path("out." + target))
                    self.assertEqual(result.GetNumberOfPolys(), self.report()["output"]["faces"])
                    self.assertLessEqual(result.GetNumberOfPolys(), 500)
