# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes, headers and names that hang, crash or outgrow a program that trusts them, and what reaches the terminal of them."""

import csv
import os
import resource
import signal
import stat
import struct
import subprocess
import time

import numpy

from application import DONE, INTERRUPTED, PROGRAM, REJECTED, USAGE, ApplicationTest, main, read, torus, write

ISO = ("--iso", 50, "--target-reduction", 0.5, "--quiet")
META = "ObjectType = Image\nNDims = {dimensions}\nBinaryData = True\nDimSize = {size}\n{more}ElementType = MET_SHORT\nElementDataFile = voxels.raw\n"
NRRD = "NRRD0005\ntype: short\ndimension: 3\nsizes: 24 24 24\n{more}encoding: raw\nendian: little\n"
SEGMENTS = ("NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 24 24 24\n"
            "space directions: (1,0,0) (0,1,0) (0,0,1)\nkinds: domain domain domain\nendian: little\nencoding: raw\nspace origin: (0,0,0)\n"
            "Segment0_ID:=a\nSegment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Name:=")


def distances():
    return ((numpy.indices((24, 24, 24)) - 11.7) ** 2).sum(0)


def ball():
    """100 in the middle of 24 x 24 x 24 voxels, falling by 8 a voxel."""
    return (100 - 8 * numpy.sqrt(distances())).astype("<i2").tobytes()


class HostileVolumes(ApplicationTest):
    def setUp(self):
        super().setUp()
        self.path("voxels.raw").write_bytes(ball())

    def write_meta(self, name, dimensions=3, size="24 24 24", more="ElementSpacing = 1 1 1\n"):
        self.path(name).write_text(META.format(dimensions=dimensions, size=size, more=more), encoding="ascii")

    def rejected_in_time(self, *words, says):
        """Within 20 seconds, which a hang is not."""
        return self.fail_with(REJECTED, *words, says=says, timeout=20)

    def test_pipes_instead_of_voxels_are_rejected(self):
        os.mkfifo(self.path("pipe.raw"))
        self.path("pipe.nhdr").write_text(NRRD.format(more="spacings: 1 1 1\n") + "data file: pipe.raw\n", encoding="ascii")
        self.rejected_in_time("pipe.nhdr", "out.ply", *ISO, says="no regular file")
        self.write_meta("pipe.mhd")
        text = self.path("pipe.mhd").read_text(encoding="ascii")
        self.path("pipe.mhd").write_text(text.replace("voxels.raw", "pipe.raw"), encoding="ascii")
        self.rejected_in_time("pipe.mhd", "out.ply", *ISO, says="pipe.raw, cannot be read")
        os.mkfifo(self.path("pipe.tif"))
        self.rejected_in_time("pipe.tif", "out.ply", "--spacing", 1, *ISO, says="cannot be read")

    def test_a_signal_ends_the_reading_of_a_volume(self):
        header = META.format(dimensions=3, size="1024 1024 4000", more="ElementSpacing = 1 1 1\n").replace("voxels.raw", "LOCAL")
        with open(self.path("in.mha"), "wb") as file:
            file.write(header.encode())
            file.truncate(len(header) + (1024 * 1024 * 4000 << 1))  # 8 GB of zeros that take no disk
        process = subprocess.Popen([PROGRAM, "in.mha", "out.ply", "--iso", "50", "--max-error", "1", "--memory", "256M"], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")
        time.sleep(1)
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=20)
        self.assertEqual((process.returncode, errors), (INTERRUPTED, "bonedecimate: interrupted\n"))

    def test_numbers_of_dimensions_that_are_none_are_rejected(self):
        for dimensions in (-1, -3, 0, 2, 4, "x"):
            self.write_meta("in.mhd", dimensions)
            self.rejected_in_time("in.mhd", "out.ply", *ISO, says=f"its NDims is {dimensions}, only volumes of three")
        for size in ("-24 24 24", "24 0 24"):
            self.write_meta("in.mhd", size=size)
            self.rejected_in_time("in.mhd", "out.ply", *ISO, says="at least two along each axis")
        self.write_meta("in.mhd", more="ElementSpacing = 1 1 1\nNDims = -1\n")
        self.rejected_in_time("in.mhd", "out.ply", *ISO, says="NDims and DimSize once each")

    def test_volumes_without_spacing_take_it_from_the_option(self):
        self.write_meta("in.mhd", more="")
        self.path("in.nrrd").write_bytes((NRRD.format(more="") + "\n").encode() + ball())
        self.path("nan.nrrd").write_bytes((NRRD.format(more="spacings: nan nan nan\n") + "\n").encode() + ball())
        image = ('<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="0 23 0 23 0 23">'
                 '<Piece Extent="0 23 0 23 0 23"><PointData Scalars="a"><DataArray type="Int16" Name="a" format="ascii">'
                 + " ".join(map(str, numpy.frombuffer(ball(), "<i2"))) + "</DataArray></PointData></Piece></ImageData></VTKFile>")
        self.path("in.vti").write_text(image, encoding="ascii")
        for name in ("in.mhd", "in.nrrd", "nan.nrrd", "in.vti"):
            with self.subTest(name=name):
                self.rejected_in_time(name, "out.ply", *ISO, says="does not say how far its voxels are apart: give --spacing")
                self.succeed(name, "out.ply", *ISO, "--spacing", "2,2,3")
                bounds = read(self.path("out.ply")).GetBounds()
                self.assertAlmostEqual(bounds[1] - bounds[0], 2 * 12.5, delta=1.5)
                self.assertAlmostEqual(bounds[5] - bounds[4], 3 * 12.5, delta=2)
        self.write_meta("spaced.mhd")
        self.fail_with(USAGE, "spaced.mhd", "out.ply", *ISO, "--spacing", 1, says="for volumes that have none of their own")

    def test_pages_in_a_circle_are_rejected(self):
        entries = ((256, 3, 24), (257, 3, 24), (258, 3, 8), (259, 3, 1), (262, 3, 1), (273, 4, 8), (277, 3, 1), (278, 3, 24), (279, 4, 576))
        directory = struct.pack("<H", len(entries)) + b"".join(struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in entries)
        length = len(directory) + 4
        own = b"II*\0" + struct.pack("<I", 8) + directory + struct.pack("<I", 8)
        two = b"II*\0" + struct.pack("<I", 8) + directory + struct.pack("<I", 8 + length) + directory + struct.pack("<I", 8)
        for data in (own, two):
            self.path("in.tif").write_bytes(data + bytes(600))
            self.rejected_in_time("in.tif", "out.ply", "--spacing", 1, *ISO, says="its pages form a circle")

    def test_many_keys_of_a_header_cost_little(self):
        keys = "".join(f"key{i}:=value\n" for i in range(60000))
        self.path("in.nrrd").write_bytes((NRRD.format(more="spacings: 1 1 1\n") + keys + "\n").encode() + ball())
        self.path("in.nhdr").write_text(NRRD.format(more="spacings: 1 1 1\n") + "data file: voxels.raw\n" + keys, encoding="ascii")
        before = set(os.listdir("/tmp"))
        for name in ("in.nrrd", "in.nhdr"):
            self.succeed(name, "out.ply", *ISO, timeout=20)
            self.assertAlmostEqual(read(self.path("out.ply")).GetBounds()[0], 11.7 - 6.25, delta=0.5)
        left = [name for name in set(os.listdir("/tmp")) - before if name.startswith("bonedecimate-") and name.endswith(".nhdr")]
        self.assertEqual(left, [])

    def test_nested_and_numerous_elements_of_xml_are_rejected(self):
        self.path("in.vtp").write_text('<VTKFile type="PolyData"><PolyData>' + "<a>" * 300000 + "</a>" * 300000 + "</PolyData></VTKFile>",
                                       encoding="ascii")
        self.rejected_in_time("in.vtp", "out.ply", says="nested more than 64 levels deep")
        self.rejected_in_time("diagnose", "in.vtp", says="nested more than 64 levels deep")
        self.rejected_in_time("certify", "in.vtp", "in.vtp", says="nested more than 64 levels deep")
        self.path("in.vtp").write_text('<VTKFile type="PolyData"><PolyData><!-- <AppendedData> -->' + "<a b='>'>" * 100 + "</VTKFile>", encoding="ascii")
        self.rejected_in_time("in.vtp", "out.ply", says="nested more than 64 levels deep")
        self.path("in.vtp").write_text('<VTKFile type="PolyData"><PolyData><FieldData>' + "<DataArray/>" * 10001 + "</FieldData></PolyData></VTKFile>",
                                       encoding="ascii")
        self.rejected_in_time("in.vtp", "out.ply", says="more than 10000 arrays")

    def test_counts_that_a_file_cannot_hold_take_no_memory(self):
        """A megabyte of blanks cannot hold 900 million points, compressed or not."""
        for compressor, count in (("", 2_000_000), (' compressor="vtkLZ4DataCompressor"', 900_000_000)):
            self.path("in.vtp").write_text(f'<VTKFile type="PolyData"{compressor}><PolyData><Piece NumberOfPoints="{count}"/></PolyData>'
                                           + " " * 1000000 + "</VTKFile>", encoding="ascii")
            self.rejected_in_time("in.vtp", "out.ply", says="NumberOfPoints is more than a file of this size can hold")

    def test_names_of_many_parts_in_a_configuration_file_are_rejected(self):
        write(torus(), self.path("in.ply"))
        for text in ("[" + "a." * 100000 + "b]\nquiet = true\n", "a." * 100000 + "b = 1\n"):
            self.path("settings.toml").write_text(text, encoding="ascii")
            self.fail_with(USAGE, "in.ply", "out.ply", "--config", "settings.toml", says="a name of more than 8 parts", timeout=20)

    def test_properties_and_continued_lines_without_end_cost_little(self):
        header = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        self.path("in.ply").write_text(header + "".join(f"property float p{i}\n" for i in range(20000)), encoding="ascii")
        self.rejected_in_time("in.ply", "out.ply", says="more than 4096 properties")
        write(torus(), self.path("in.obj"))
        whole = self.path("in.obj").read_text(encoding="ascii")
        first = next(line for line in whole.splitlines() if line.startswith("f "))
        words = first.split()
        self.path("long.obj").write_text(whole.replace(first, " ".join(words[:3]) + " \\\n" * 200000 + words[3]), encoding="ascii")
        for name in ("in.obj", "long.obj"):
            self.succeed(name, name + ".ply", "--target-reduction", 0, "--quiet", timeout=20)
        self.assertEqual(self.path("in.obj.ply").read_bytes(), self.path("long.obj.ply").read_bytes())

    def test_announced_elements_of_dicom_take_no_memory(self):
        preamble = bytes(128) + b"DICM"
        meta = struct.pack("<HH2sHI", 2, 0, b"UL", 4, 26) + struct.pack("<HH2sH", 2, 0x10, b"UI", 18) + b"1.2.840.10008.1.2\0"
        self.path("in.dcm").write_bytes(preamble + meta + struct.pack("<HHI", 8, 0x60, 2**32 - 2) + b"SEG ")
        self.path("folder").mkdir()
        self.path("folder/in.dcm").write_bytes(self.path("in.dcm").read_bytes())
        for name, says in (("in.dcm", "damaged"), ("folder", "none of its DICOM files is an image")):
            self.rejected_in_time(name, "out.ply", *ISO, says=says)
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss << 10, 2 << 30)


class HostileNames(ApplicationTest):
    NAME = b"bone\xff\x1b[2J\xe2\x80\xae\xc2\x9b\x7f"  # no UTF-8, clears a terminal, turns the direction of text
    SHOWN = "bone??[2J??????"

    def setUp(self):
        super().setUp()
        self.path("map.seg.nrrd").write_bytes(SEGMENTS.encode() + self.NAME + b"\n\n" + (distances() < 60).astype(numpy.uint8).tobytes())

    def run_bytes(self, *words):
        completed = subprocess.run([PROGRAM, *words], cwd=self.folder, capture_output=True, check=False)
        text = completed.stdout + completed.stderr
        text.decode("utf-8")  # raises
        for wrong in (b"\x1b", b"\xe2\x80\xae", b"\xc2\x9b", b"\x7f"):
            self.assertNotIn(wrong, text)
        return completed

    def test_names_of_segments_are_plain_text_in_every_format(self):
        for extension in ("vtp", "vtk", "ply", "obj", "stl", "3mf", "glb"):
            with self.subTest(extension=extension):
                words = ("map.seg.nrrd", "out." + extension, "--segments", "all", "--max-error", "halfvoxel", "--report", "report.json")
                completed = self.run_bytes(*words)
                if completed.returncode == DONE:
                    self.assertIn(self.SHOWN, completed.stdout.decode())
                    self.assertNotIn(b"\x1b[2J", self.path("out." + extension).read_bytes())
        completed = self.run_bytes("map.seg.nrrd", "folder", "--segments", "all", "--max-error", "halfvoxel")
        self.assertEqual(completed.returncode, DONE, completed.stderr)
        self.path("folder/index.html").read_bytes().decode("utf-8")
        completed = self.run_bytes("map.seg.nrrd", b"a\xff.vtm", "--segments", "all", "--max-error", "halfvoxel")
        self.assertIn(b"that the XML of a .vtm file cannot hold", completed.stderr)
        self.assertNotIn("\x1b", self.path("folder/index.html").read_text(encoding="utf-8"))

    def test_names_of_files_and_options_do_not_command_the_terminal(self):
        name = b"a\x1b[31m\xff.ply"
        os.rename(write(torus(), self.path("in.ply")), os.fsencode(self.folder) + b"/" + name)
        self.assertEqual(self.run_bytes(name, b"out\x1b.ply", "--target-reduction", "0.5").returncode, DONE)
        for words in ((name, "out.ply", "--target-reduction", "0.5", "--page", "page.html"),
                      ("certify", name, name, "--tolerance", "1", "--page", "page.html")):
            self.assertEqual(self.run_bytes(*words).returncode, DONE)
            page = self.path("page.html").read_bytes().decode("utf-8")
            self.assertRegex(page, r"a\?\[31m[?\ufffd]\.ply")
            self.assertNotIn("\x1b", page)
        for words in ((name, b"out.\x1b[2Jxyz"), (b"none\x1b[2J.ply", "out.ply"), (b"--opt\x1b[2J", "1"), ("diagnose", b"\x1b[2J.stl")):
            self.assertNotEqual(self.run_bytes(*words).returncode, DONE)

    def test_tables_have_no_formulas_and_are_valid_text(self):
        self.path("in").mkdir()
        for name in ("=cmd", "+1", "@SUM(1)", "-2"):
            write(torus(), self.path("in/bone.ply")).rename(self.path(f"in/{name}.ply"))
        os.rename(write(torus(), self.path("in/bone.ply")), os.fsencode(self.folder) + b"/in/\xff.ply")
        self.succeed("in", "out", "--target-reduction", 0.5, "--measure", "off")
        table = self.path("out/summary.csv").read_bytes().decode("utf-8")
        rows = list(csv.DictReader(table.splitlines()))
        self.assertEqual({row["name"] for row in rows}, {"'=cmd", "'+1", "'@SUM(1)", "'-2", "?"})
        self.assertFalse([field for row in rows for field in (row["name"], row["input"]) if field[0] in "=+-@"])

    def test_a_file_that_is_replaced_keeps_its_mode(self):
        write(torus(), self.path("in.ply"))
        for mode in (0o600, 0o640, 0o444):
            self.path("out.ply").unlink(missing_ok=True)
            self.path("out.ply").touch()
            self.path("out.ply").chmod(mode)
            self.succeed("in.ply", "out.ply", "--target-reduction", 0.5, "--quiet")
            self.assertEqual(stat.S_IMODE(self.path("out.ply").stat().st_mode), mode)
            self.assertGreater(self.path("out.ply").stat().st_size, 100)

    def test_output_to_a_closed_pipe_ends_quietly(self):
        for words in (["--help"], ["--options-markdown"]):
            reader, writer = os.pipe()
            os.close(reader)
            completed = subprocess.run([PROGRAM, *words], stdout=writer, stderr=subprocess.PIPE, check=False)
            os.close(writer)
            self.assertEqual((completed.returncode, completed.stderr), (DONE, b""))


if __name__ == "__main__":
    main()
