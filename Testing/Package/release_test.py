# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The list of third-party software agrees with what was built, and bills of materials are whole and the same each time."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "third_party.py"


def run(*words, **variables):
    return subprocess.run([sys.executable, "-B", str(TOOL), *map(str, words)], capture_output=True, text=True, check=False,
                          env={**os.environ, **variables})


class ThirdParty(unittest.TestCase):
    def test_list_page_and_binaries_agree(self):
        done = run("--check", *os.environ["BINARIES"].split(";"))
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_a_library_that_is_not_listed_is_found(self):
        done = run("--check", sys.executable)
        self.assertEqual(done.returncode, 1)
        self.assertIn("libexpat", done.stdout)

    def test_bills_name_all_components_and_depend_on_the_input_alone(self):
        for product, some in (("deb", "VTK"), ("wheel", "nanobind"), ("wheel-windows", "winpthreads"), ("wheel-program", "GDCM"),
                              ("page", "@kitware/vtk.js")):
            with tempfile.TemporaryDirectory() as folder:
                texts = []
                for name in ("a.json", "b.json"):
                    file = pathlib.Path(folder) / name
                    self.assertEqual(run("--sbom", product, file, SOURCE_DATE_EPOCH="1700000000").returncode, 0)
                    texts.append(file.read_text(encoding="utf-8"))
            self.assertEqual(*texts)
            bill = json.loads(texts[0])
            self.assertEqual((bill["bomFormat"], bill["specVersion"]), ("CycloneDX", "1.6"))
            self.assertEqual(bill["metadata"]["timestamp"], "2023-11-14T22:13:20Z")
            names = [component["bom-ref"] for component in bill["components"]]
            self.assertIn(some, names)
            self.assertEqual(len(names), len(set(names)))
            self.assertEqual(bill["dependencies"][0]["dependsOn"], names)
            for component in bill["components"]:
                self.assertTrue(component["licenses"], component)


if __name__ == "__main__":
    unittest.main()
