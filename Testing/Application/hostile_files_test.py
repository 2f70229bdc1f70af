# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of files in Documentation/results/invalid-files.md: problem of a file, exit code and message of the program.

Each row is tried in every format that it names, with a limit of the memory of the process. The message is that of the first
format. `hostile_files_test.py --print` prints the table that the page must contain.
"""

import gzip
import os
import pathlib
import resource
import struct
import sys

import vtk

from application import (
    NOT_WRITTEN,
    REJECTED,
    SURFACES,
    ApplicationTest,
    limit,
    main,
    torus,
    without_root_powers,
    write,
)
from damaged_files_test import TEXTS
from volumes_test import ball

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "results" / "invalid-files.md"
MEMORY = 1 << 29  # bytes of data that a process may have; 10^9 of anything are more
LARGEST = 1 << 28  # bytes that the largest of the processes was resident with, at most
BILLION = "1000000000"
PRINTS = False
VOLUMES = ("mha", "nrrd", "nii", "nii.gz", "tif", "vti")
NRRD = "NRRD0004\ntype: short\ndimension: 3\nsizes: 24 24 24\nspacings: 1 1 1\nendian: little\nencoding: raw\n\n"


def whole_surface(extension):
    path = write(torus(20, 16), pathlib.Path(f"whole.{extension}"))
    return path.read_bytes()


def whole_volume(extension):
    if extension.startswith("nii"):
        return nifti() if extension == "nii" else gzip.compress(nifti())
    if extension == "nrrd":
        return NRRD.encode() + bytes(24**3 * 2)
    writer = {"vti": vtk.vtkXMLImageDataWriter, "tif": vtk.vtkTIFFWriter, "mha": vtk.vtkMetaImageWriter}[extension]()
    if extension == "tif":
        writer.SetFileDimensionality(3)
    writer.SetFileName(f"whole.{extension}")
    writer.SetInputData(ball())
    if extension == "mha":
        writer.SetCompression(False)
    writer.Write()
    return pathlib.Path(f"whole.{extension}").read_bytes()


def nifti():
    """With a position by an sform, which is that of the scanner."""
    header = struct.pack("<i36x8h14x2h2x8f3f3xB", 348, 3, 24, 24, 24, 1, 1, 1, 1, 4, 16, *(1.0,) * 8, 352.0, 1.0, 0.0, 2)
    header = header.ljust(254, b"\0") + struct.pack("<h24x12f", 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)
    return header.ljust(344, b"\0") + b"n+1\0" + bytes(4 + 24**3 * 2)


def whole(extension):
    if extension == "levels":
        return pathlib.Path("first.levels").read_bytes()
    return whole_volume(extension) if extension in VOLUMES else whole_surface(extension)


def in_text(old, new):
    """The tetrahedron of that format with a piece of its text replaced."""
    return lambda extension: changed(TEXTS[extension].encode(), old, new)


def in_volume(old, new):
    return lambda extension: changed(whole_volume(extension), old, new)


def changed(data, old, new):
    assert old.encode() in data, old
    return data.replace(old.encode(), new.encode(), 1)


def cut(part):
    return lambda extension: whole(extension)[: int(part * len(whole(extension)))]


def everywhere(make, *extensions):
    return dict.fromkeys(extensions, make)


ALL = (*SURFACES, *VOLUMES, "levels")
COUNTED = tuple(extension for extension in ALL if extension != "obj")  # which announces nothing
CLOSED = tuple(extension for extension in COUNTED if extension != "vti")  # whose last bytes are not closing tags alone

# What is wrong, and how each of the formats is made to have it.
INPUTS = (
    ("0 bytes", everywhere(lambda _: b"", *ALL)),
    ("truncated in the first half", everywhere(cut(0.3), *ALL)),
    ("truncated in the last tenth", everywhere(cut(0.95), *COUNTED)),
    ("truncated by the last 20 bytes", everywhere(lambda extension: whole(extension)[:-20], *CLOSED)),
    ("header declares one point too many", {
        "ply": in_text("vertex 4", "vertex 5"), "vtk": in_text("POINTS 4", "POINTS 5"),
        "vtp": in_text('Points="4"', 'Points="5"')}),
    ("header declares one point too few", {
        "ply": in_text("vertex 4", "vertex 3"), "vtk": in_text("POINTS 4", "POINTS 3"),
        "vtp": in_text('Points="4"', 'Points="3"')}),
    ("header declares one triangle too many", {
        "ply": in_text("face 4", "face 5"), "vtk": in_text("POLYGONS 4 16", "POLYGONS 5 20"),
        "vtp": in_text('Polys="4"', 'Polys="5"'),
        "stl": lambda _: whole("stl")[:80] + b"\x81\x02\0\0" + whole("stl")[84:]}),
    ("header declares one triangle too few", {
        "ply": in_text("face 4", "face 3"), "vtk": in_text("POLYGONS 4 16", "POLYGONS 3 12"),
        "stl": lambda _: whole("stl")[:80] + b"\x7f\x02\0\0" + whole("stl")[84:]}),
    ("a polygon with fewer vertices than its count", {
        "ply": in_text("3 0 2 1", "4 0 2 1"), "vtk": in_text("3 0 2 1", "4 0 2 1")}),
    ("a polygon with more vertices than its count", {
        "ply": in_text("3 0 2 1", "3 0 2 1 3"), "vtk": in_text("3 0 2 1", "3 0 2 1 3")}),
    ("text instead of a coordinate", {
        "obj": in_text("v 1 0 0", "v 1 0 x"), "stl": in_text("vertex 1 0 0", "vertex 1 0 x"),
        "ply": in_text("\n1 0 0", "\n1 0 x"), "vtk": in_text("1 0 0", "1 0 x"), "vtp": in_text("1 0 0", "1 0 x")}),
    ("text instead of a vertex index", {
        "obj": in_text("f 1 3 2", "f 1 3 x"), "ply": in_text("3 0 2 1", "3 0 2 x"),
        "vtk": in_text("3 0 2 1", "3 0 2 x"), "vtp": in_text(">0 2 1", ">0 2 x")}),
    ("text instead of a count", {
        "ply": in_text("vertex 4", "vertex x"), "vtk": in_text("POINTS 4", "POINTS x"),
        "vtp": in_text('Points="4"', 'Points="x"'), "nrrd": in_volume("sizes: 24", "sizes: x"),
        "mha": in_volume("DimSize = 24", "DimSize = x")}),
    ("NaN instead of a coordinate", {
        "obj": in_text("v 1 0 0", "v 1 0 nan"), "stl": in_text("vertex 1 0 0", "vertex 1 0 nan"),
        "ply": in_text("\n1 0 0", "\n1 0 nan"), "vtk": in_text("1 0 0", "1 0 nan"),
        "vtp": in_text("1 0 0", "1 0 nan")}),
    ("a vertex index out of range", {
        "obj": in_text("f 1 3 2", "f 1 3 9"), "ply": in_text("3 0 2 1", "3 0 2 9"),
        "vtk": in_text("3 0 2 1", "3 0 2 9"), "vtp": in_text(">0 2 1", ">0 2 9")}),
    ("header declares 10^9 points or voxels", {
        "ply": in_text("vertex 4", "vertex " + BILLION), "vtk": in_text("POINTS 4", "POINTS " + BILLION),
        "vtp": in_text('Points="4"', f'Points="{BILLION}"'),
        "nrrd": in_volume("sizes: 24 24 24", "sizes: 1000 1000 1000"),
        "mha": in_volume("DimSize = 24 24 24", "DimSize = 1000 1000 1000")}),
    ("header declares 10^9 triangles", {
        "ply": in_text("face 4", "face " + BILLION), "vtk": in_text("POLYGONS 4 16", f"POLYGONS {BILLION} {BILLION}"),
        "vtp": in_text('Polys="4"', f'Polys="{BILLION}"'),
        "stl": lambda _: whole("stl")[:80] + b"\x00\xca\x9a\x3b" + whole("stl")[84:]}),
    ("10^9 vertices in one polygon", {
        "ply": in_text("3 0 2 1", BILLION + " 0 2 1"), "vtk": in_text("3 0 2 1", BILLION + " 0 2 1")}),
    ("another type of data set", {
        "vtk": in_text("POLYDATA", "STRUCTURED_POINTS"), "vtp": in_text('type="PolyData"', 'type="UnstructuredGrid"')}),
    ("an HTML page with this extension", everywhere(lambda _: b"<html>not found</html>\n", *ALL)),
)


class HostileFiles(ApplicationTest):
    def setUp(self):
        super().setUp()
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        write(torus(), self.path("first.ply"))
        self.succeed("levels", "first.ply", "--record", "first.levels", "--no-errors", "--quiet")

    def words_for(self, name):
        """What reads a file of that format."""
        if name.endswith(".levels"):
            return "levels", "first.ply", "--log", name
        spacing = ("--spacing", 1) if name.endswith("tif") else ()
        return (name, "out.vtp", *spacing, *(("--iso", 226) if name.endswith(VOLUMES) else ()))

    def rejection(self, *words, **keywords):
        """What the program says, without its own name."""
        keywords.setdefault("preexec_fn", limit(resource.RLIMIT_DATA, MEMORY))
        return self.fail_with(REJECTED, *words, **keywords).stderr.removeprefix("bonedecimate: ").strip()

    def rejected_as_anything(self, name):
        """Whatever it was to do with the surface."""
        self.rejection("first.ply", "out.vtp", "--reference", name, "--max-error", 0.1)
        self.rejection("certify", "first.ply", name)
        self.rejection("diagnose", name)
        return self.rejection(name, "out.vtp")

    def input_rows(self):
        for what, ways in INPUTS:
            said = []
            for extension, make in ways.items():
                with self.subTest(what=what, extension=extension):
                    name = "in." + extension
                    self.path(name).write_bytes(make(extension))
                    said.append(self.rejection(*self.words_for(name)))
                    self.path(name).unlink()
            yield what, ", ".join(ways), REJECTED, said[0]

    def name_rows(self):
        self.path("folder.ply").mkdir()
        self.path("bone.xyz").write_text("1 2 3\n", encoding="ascii")
        os.mkfifo(self.path("pipe.ply"))
        write(torus(), self.path("unreadable.ply")).chmod(0)
        yield "no such file", "all", REJECTED, self.rejected_as_anything("nothing.ply")
        yield "a file as a folder in the path", "all", REJECTED, self.rejected_as_anything("first.ply/in.ply")
        yield "a folder", "all", REJECTED, self.rejection("certify", "first.ply", "folder.ply")
        yield "a pipe", "all", REJECTED, self.rejected_as_anything("pipe.ply")
        yield "an unknown extension", "-", REJECTED, self.rejected_as_anything("bone.xyz")
        unreadable = self.rejection("unreadable.ply", "out.vtp", preexec_fn=without_root_powers)
        yield "no read permission", "all", REJECTED, unreadable

    def output_rows(self):
        def said(*words, **keywords):
            completed = self.fail_with(NOT_WRITTEN, "first.ply", *words, **keywords)
            return completed.stderr.removeprefix("bonedecimate: ").strip()

        full = {"preexec_fn": limit(resource.RLIMIT_FSIZE, 1000)}
        self.path("closed").mkdir(mode=0o555)
        yield "a missing output folder", "all", NOT_WRITTEN, said("nowhere/out.ply")
        yield "a file as the output folder", "all", NOT_WRITTEN, said("first.ply/out.ply")
        yield "no write permission", "all", NOT_WRITTEN, said("closed/out.ply", preexec_fn=without_root_powers)
        yield "a full disk", ", ".join(SURFACES), NOT_WRITTEN, [said("out." + format, **full) for format in SURFACES][0]
        yield "a full disk, writing the report", "json", NOT_WRITTEN, said(
            "out.ply", "--target-triangles", 8, "--report", "report.json", **full
        )
        yield "a device as the report", "json", NOT_WRITTEN, said("out.ply", "--report", "/dev/full")

    def table(self):
        lines = ["| problem | formats | exit code | message for the first format |", "|---|---|---:|---|"]
        for rows in (self.input_rows(), self.name_rows(), self.output_rows()):
            lines += [f"| {what} | {formats} | {code} | {said} |" for what, formats, code, said in rows]
        return "\n".join(lines)

    def test_end_and_say_what_the_table_of_the_documentation_says(self):
        table = self.table()
        if PRINTS:
            print(table)
        self.assertIn(table, PAGE.read_text(encoding="utf-8"))
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024, LARGEST)

    def test_a_full_disk_leaves_neither_a_log_nor_diagnostics_nor_a_certificate(self):
        full = {"preexec_fn": limit(resource.RLIMIT_FSIZE, 100)}
        self.fail_with(NOT_WRITTEN, "levels", "first.ply", "--record", "new.levels", "--no-errors", **full)
        self.fail_with(NOT_WRITTEN, "diagnose", "first.ply", "--json", "found.json", **full)
        self.fail_with(NOT_WRITTEN, "certify", "first.ply", "first.ply", "--json", "proof.json", **full)

    def test_names_with_blanks_and_letters_beyond_ascii_are_good_and_shown(self):
        for extension in SURFACES:
            name = f"Sch\u00e4del \u9aa8 '1' %s.{extension}"
            write(torus(20, 16), self.path("in." + extension)).rename(self.path(name))
            self.succeed(name, "a \u00fc." + extension, "--reference", name, "--max-error", 0.5, "--quiet")
            self.assertTrue(self.path("a \u00fc." + extension).exists())
            self.path(name).write_bytes(b"")
            self.assertIn(f"'{name}' was rejected", self.rejection(name, "out.vtp"))


if __name__ == "__main__":
    PRINTS = "--print" in sys.argv
    sys.argv = [word for word in sys.argv if word != "--print"]
    main()
