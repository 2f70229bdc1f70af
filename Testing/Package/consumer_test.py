# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Projects of users: ${VTK_LIBRARIES} of their find_package(VTK) is theirs, before and after find_package(vtkBoneDecimate)."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["SOURCE_DIR"])
sys.path.append(str(SOURCE / "Testing" / "Readme"))
from code_blocks import blocks_of  # noqa: E402

VTK = "find_package(VTK REQUIRED COMPONENTS IOImage IOXML)"
BONES = "find_package(vtkBoneDecimate REQUIRED)"
ORDERS = {"before": (VTK, BONES), "after": (BONES, VTK), "twice": (BONES, VTK, BONES)}
# VTK's commonest idiom.
PROJECT = """cmake_minimum_required(VERSION 3.20)
project(consumer LANGUAGES CXX)
add_executable(bones ../bones.cxx)
{0}
target_link_libraries(bones PRIVATE ${{VTK_LIBRARIES}} BoneDecimate::FiltersBoneDecimate)
vtk_module_autoinit(TARGETS bones MODULES ${{VTK_LIBRARIES}})
file(WRITE "${{CMAKE_BINARY_DIR}}/libraries.txt" "${{VTK_LIBRARIES}}")
"""


def run(*words, **keywords):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **keywords)
    assert done.returncode == 0, f"{words}:\n{done.stdout}\n{done.stderr}"
    return done.stdout


class Consumer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        run("cmake", "--install", os.environ["BINARY_DIR"], "--prefix", cls.folder / "installed")
        (program,) = [text for _, language, text in blocks_of(SOURCE / "Documentation/tutorials/cpp.md") if language == "cpp"]
        (cls.folder / "bones.cxx").write_text(program, encoding="utf-8")

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def configured(self, name, lines):
        """The build folder of a project that finds packages by these lines."""
        source, build = self.folder / name, self.folder / name / "build"
        source.mkdir()
        (source / "CMakeLists.txt").write_text(PROJECT.format("\n".join(lines)), encoding="utf-8")
        run("cmake", "-G", "Ninja", "-S", source, "-B", build, f"-DCMAKE_PREFIX_PATH={self.folder / 'installed'}")
        return build

    def test_libraries_are_those_of_the_projects_own_request_in_any_order(self):
        for name, lines in ORDERS.items():
            libraries = (self.configured(name, lines) / "libraries.txt").read_text(encoding="utf-8")
            self.assertEqual(libraries, "VTK::IOImage;VTK::IOXML", name)

    def test_components_that_are_not_there_are_an_error(self):
        with self.assertRaisesRegex(AssertionError, "There are no components, such as Meshes"):
            self.configured("component", (VTK, BONES.replace(")", " COMPONENTS Meshes)")))

    def test_the_tutorials_program_links_and_fails_without_its_input(self):
        build = self.configured("built", (VTK, BONES))
        run("cmake", "--build", build)
        result = self.folder / "result.vtp"
        done = subprocess.run([build / "bones", self.folder / "missing.mha", result], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, result.exists()), (1, False))
        self.assertIn("missing.mha cannot be read", done.stderr)

    def test_installed_headers_are_those_of_the_public_classes(self):
        headers = {path.name for path in (self.folder / "installed/include/vtkbonedecimate").rglob("*.h")}
        self.assertIn("vtkBoneDecimate.h", headers)
        self.assertTrue(all(name.startswith("vtk") for name in headers), headers)


if __name__ == "__main__":
    unittest.main()
