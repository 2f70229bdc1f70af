# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The Debian package: what it says of itself, what is in it, and that this runs."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

VERSION = os.environ["VERSION"]


def run(*words, **keywords):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **keywords)
    assert done.returncode == 0, f"{words}:\n{done.stdout}\n{done.stderr}"
    return done.stdout


class DebianPackage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.scratch.name)
        run(os.environ["CPACK"], "--config", f"{os.environ['BINARY_DIR']}/CPackConfig.cmake", "-B", folder)
        (cls.file,) = folder.glob("*.deb")
        cls.root = folder / "root"
        run("dpkg-deb", "-x", cls.file, cls.root)
        cls.usr = cls.root / "usr"

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_says_what_it_is_and_what_it_needs(self):
        field = {name: run("dpkg-deb", "-f", self.file, name).strip() for name in ("Package", "Version", "Depends")}
        self.assertEqual((field["Package"], field["Version"]), ("vtkbonedecimate", VERSION))
        self.assertRegex(field["Depends"], r"\blibvtk9")
        self.assertRegex(field["Depends"], r"\blibinsighttoolkit5")
        self.assertRegex(field["Depends"], r"\blibc6 ")
        self.assertIn("BSD 3-Clause", (self.usr / "share/doc/vtkbonedecimate/copyright").read_text(encoding="utf-8"))

    def test_program_runs(self):
        self.assertIn(VERSION, run(self.usr / "bin/bonedecimate", "--version"))

    def test_loads_what_few_runs_need(self):
        folder = pathlib.Path(self.scratch.name) / "few"
        folder.mkdir()
        (folder / "slices").mkdir()
        (folder / "slices/one.dcm").write_bytes(bytes(128) + b"DICM")
        program, libraries = self.usr / "bin/bonedecimate", {"Dicom": "reads DICOM", "Rendering": "draws pictures"}

        def messages():
            surface = subprocess.run([program, folder / "demo/ct.mha", folder / "bone.stl", "--iso", "bone", "--picture", folder / "bone.png"],
                                     capture_output=True, text=True, check=False)
            slices = subprocess.run([program, folder / "slices", folder / "bone.stl", "--iso", "bone"], capture_output=True, text=True, check=False)
            self.assertNotEqual(slices.returncode, 0)
            return slices.stderr + surface.stderr

        run(program, "demo", folder / "demo")
        self.assertNotIn("cannot be loaded", messages())
        self.assertTrue((folder / "bone.png").is_file())
        (folder / "bone.png").unlink()
        for name in libraries:
            next(self.usr.glob(f"lib/**/libBoneDecimate{name}.so")).rename(folder / name)
        without = messages()
        for name, purpose in libraries.items():
            self.assertIn(f"the library that {purpose} cannot be loaded: libBoneDecimate{name}.so", without)
            (folder / name).rename(next(self.usr.glob("lib/**/libBoneDecimateVolume.so")).with_name(f"libBoneDecimate{name}.so"))
        self.assertFalse((folder / "bone.png").exists())

    def test_has_the_manual_page_and_completions(self):
        program = self.usr / "bin/bonedecimate"
        for file, *words in (("man/man1/bonedecimate.1", "--man"), ("bash-completion/completions/bonedecimate", "--completion", "bash"),
                             ("zsh/vendor-completions/_bonedecimate", "--completion", "zsh"),
                             ("fish/vendor_completions.d/bonedecimate.fish", "--completion", "fish")):
            self.assertEqual((self.usr / f"share/{file}").read_text(encoding="utf-8"), run(program, *words))

    def test_has_a_bill_of_materials_with_the_versions_of_its_libraries(self):
        bill = json.loads((self.usr / "share/doc/vtkbonedecimate/sbom.cdx.json").read_text(encoding="utf-8"))
        versions = {component["name"]: component.get("version") for component in bill["components"]}
        self.assertEqual(versions["VTK"], run("dpkg-query", "-W", "-f", "${Version}", "libvtk9-dev"))
        self.assertIn("vtk.js", (self.usr / "share/doc/vtkbonedecimate/LICENSES.txt").read_text(encoding="utf-8"))

    def test_python_package_runs(self):
        packages = self.usr / "lib/python3/dist-packages"
        printed = run(sys.executable, "-c", "import bonedecimate as b; print(b.vtkBoneDecimate().GetClassName())",
                      env=dict(os.environ, PYTHONPATH=str(packages)))
        self.assertEqual(printed.strip(), "vtkBoneDecimate")

    def test_takes_away_what_python_compiled_in_it(self):
        compiled = self.usr / "lib/python3/dist-packages/bonedecimate/__pycache__"
        compiled.mkdir()
        run("sh", "-c", run("dpkg-deb", "-I", self.file, "prerm").replace("/usr/", f"{self.usr}/"))
        self.assertFalse(compiled.exists())

    def test_has_headers_and_the_cmake_package(self):
        self.assertTrue((self.usr / "include/vtkbonedecimate/vtkBoneDecimate.h").is_file())
        self.assertTrue((self.usr / "lib/cmake/vtkBoneDecimate/vtkBoneDecimateConfig.cmake").is_file())

    def test_looks_for_libraries_only_beside_itself(self):
        binaries = [self.usr / "bin/bonedecimate", *self.usr.glob("lib/**/*.so")]
        self.assertGreater(len(binaries), 2)
        for binary in binaries:
            paths = re.findall(r"R(?:UN)?PATH.*\[(.*)\]", run("readelf", "-d", binary))
            for path in ":".join(paths).split(":"):
                self.assertTrue(path == "" or path.startswith("$ORIGIN"), f"{binary.name}: {path}")


if __name__ == "__main__":
    unittest.main()
