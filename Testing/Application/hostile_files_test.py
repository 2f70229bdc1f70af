# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of files in Documentation/bad-input.md: what is wrong with a file, how the program ends, what it says.

Each row is tried in every format it names, as the input of a decimation, as its reference and as a side of a certificate; memory is
limited. With the word --print the table is printed instead.
"""

import os
import pathlib
import resource
import sys

from application import (
    NOT_WRITTEN,
    REFUSED,
    SURFACES,
    ApplicationTest,
    limit,
    main,
    torus,
    without_root_powers,
    write,
)
from damaged_files_test import TEXTS

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "bad-input.md"
MEMORY = 1 << 30  # bytes of data that a process may have
BILLION = "1000000000"


def replaced(old, new):
    return lambda extension: TEXTS[extension].replace(old, new, 1).encode()


def whole(extension):
    path = write(torus(20, 16), pathlib.Path(f"whole.{extension}"))
    data = path.read_bytes()
    path.unlink()
    return data


def cut(part):
    return lambda extension: whole(extension)[: int(part * len(whole(extension)))]


# What is wrong, the formats of which each has a way to make it.
INPUTS = (
    ("0 bytes", {extension: lambda _: b"" for extension in SURFACES}),
    ("cut off in the first half", {extension: cut(0.3) for extension in SURFACES}),
    ("cut off in the last tenth", {extension: cut(0.95) for extension in SURFACES if extension != "obj"}),
    ("text in place of a coordinate", {
        "obj": replaced("v 1 0 0", "v 1 0 x"), "stl": replaced("vertex 1 0 0", "vertex 1 0 x"),
        "ply": replaced("\n1 0 0", "\n1 0 x"), "vtk": replaced("1 0 0", "1 0 x"), "vtp": replaced("1 0 0", "1 0 x")}),
    ("text in place of a corner", {
        "obj": replaced("f 1 3 2", "f 1 3 x"), "ply": replaced("3 0 2 1", "3 0 2 x"),
        "vtk": replaced("3 0 2 1", "3 0 2 x"), "vtp": replaced(">0 2 1", ">0 2 x")}),
    ("NaN in place of a coordinate", {
        "obj": replaced("v 1 0 0", "v 1 0 nan"), "stl": replaced("vertex 1 0 0", "vertex 1 0 nan"),
        "ply": replaced("\n1 0 0", "\n1 0 nan"), "vtp": replaced("1 0 0", "1 0 nan")}),
    ("a corner that is no point", {
        "obj": replaced("f 1 3 2", "f 1 3 9"), "ply": replaced("3 0 2 1", "3 0 2 9"),
        "vtk": replaced("3 0 2 1", "3 0 2 9"), "vtp": replaced(">0 2 1", ">0 2 9")}),
    ("10^9 points announced", {
        "ply": replaced("vertex 4", "vertex " + BILLION), "vtk": replaced("POINTS 4", "POINTS " + BILLION),
        "vtp": replaced('Points="4"', f'Points="{BILLION}"')}),
    ("10^9 triangles announced", {
        "ply": replaced("face 4", "face " + BILLION), "vtk": replaced("POLYGONS 4 16", f"POLYGONS {BILLION} {BILLION}"),
        "vtp": replaced('Polys="4"', f'Polys="{BILLION}"'),
        "stl": lambda _: whole("stl")[:80] + b"\x00\xca\x9a\x3b" + whole("stl")[84:]}),
    ("10^9 corners in one polygon", {
        "ply": replaced("3 0 2 1", BILLION + " 0 2 1"), "vtk": replaced("3 0 2 1", BILLION + " 0 2 1")}),
    ("another kind of data in the format", {
        "vtk": replaced("POLYDATA", "STRUCTURED_POINTS"), "vtp": replaced('type="PolyData"', 'type="UnstructuredGrid"')}),
    ("a web page under the name", {extension: lambda _: b"<html>not found</html>\n" for extension in SURFACES}),
)


class HostileFiles(ApplicationTest):
    def setUp(self):
        super().setUp()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, "/")
        write(torus(), self.path("first.vtp"))

    def refusal(self, name, **keywords):
        """What the program says of the file, whatever it was to do with it."""
        keywords.setdefault("preexec_fn", limit(resource.RLIMIT_DATA, MEMORY))
        said = self.fail_with(REFUSED, name, "out.vtp", **keywords).stderr
        error = ("--max-error", 0.1)
        self.fail_with(REFUSED, "first.vtp", "out.vtp", "--reference", name, *error, **keywords)
        self.fail_with(REFUSED, "certify", "first.vtp", name, **keywords)
        return said.removeprefix("bonedecimate: ").strip()

    def input_rows(self):
        for what, ways in INPUTS:
            said = ""
            for extension, make in ways.items():
                with self.subTest(what=what, extension=extension):
                    self.path("in." + extension).write_bytes(make(extension))
                    said = said or self.refusal("in." + extension)
                    self.refusal("in." + extension)
                    self.path("in." + extension).unlink()
            yield what, ", ".join(ways), REFUSED, said

    def name_rows(self):
        self.path("folder.ply").mkdir()
        os.mkfifo(self.path("pipe.ply"))
        write(torus(), self.path("locked.ply")).chmod(0)
        yield "no such file", "all", REFUSED, self.refusal("nothing.ply")
        yield "a folder", "all", REFUSED, self.fail_with(REFUSED, "certify", "first.vtp", "folder.ply").stderr[14:-1]
        yield "a pipe", "all", REFUSED, self.refusal("pipe.ply")
        yield "no permission", "all", REFUSED, self.refusal("locked.ply", preexec_fn=without_root_powers)

    def output_rows(self):
        def said(*words, **keywords):
            return self.fail_with(NOT_WRITTEN, "first.vtp", *words, **keywords).stderr[14:-1]

        self.path("closed").mkdir(mode=0o555)
        yield "an output folder that is not there", "all", NOT_WRITTEN, said("nowhere/out.ply")
        yield "no permission for the output", "all", NOT_WRITTEN, said("closed/out.ply", preexec_fn=without_root_powers)
        full = limit(resource.RLIMIT_FSIZE, 1000)
        yield "a full disk", "all", NOT_WRITTEN, [said("out." + extension, preexec_fn=full) for extension in SURFACES][2]
        yield "a device as a report", "all", NOT_WRITTEN, said("out.ply", "--report", "/dev/full")

    def table(self):
        lines = ["| what is wrong | formats | exit code | for example |", "|---|---|---:|---|"]
        for rows in (self.input_rows(), self.name_rows(), self.output_rows()):
            lines += [f"| {what} | {formats} | {code} | {said} |" for what, formats, code, said in rows]
        return "\n".join(lines)

    def test_end_and_say_what_the_table_of_the_documentation_says(self):
        table = self.table()
        if "--print" in sys.argv:
            print(table)
        self.assertIn(table, PAGE.read_text(encoding="utf-8"))

    def test_names_with_blanks_and_letters_beyond_ascii_are_good_and_shown(self):
        name = "Sch\u00e4del \u9aa8 '1'.vtp"
        write(torus(), self.path(name))
        self.succeed(name, "a \u00fc.ply", "--reference", name, "--max-error", 0.1, "--quiet")
        self.assertTrue(self.path("a \u00fc.ply").exists())
        self.path(name).write_bytes(b"")
        self.assertIn("0 bytes", self.refusal(name))


if __name__ == "__main__":
    main()
