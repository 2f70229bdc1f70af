# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What headers say of voxels: units, positions, slopes, labels of 64 bits, segments that overlap, and series of slices."""

import gzip
import math
import struct

import numpy

from application import REJECTED, USAGE, ApplicationTest, main, read

SEGMENTS = ("--segments", "all", "--max-error", "halfvoxel", "--mode", "Fast", "--measure", "off")
TYPES = {"u1": (2, 8), "<f4": (16, 32), "<u2": (512, 16), "<i8": (1024, 64), "<u8": (1280, 64)}
SPACING = (0.5, 0.75, 1.0)


def balls(size=24):
    """Labels 1 and 2 beside each other along x; indices x, y, z."""
    x, y, z = numpy.indices((size, size, size))
    labels = numpy.zeros((size, size, size), int)
    labels[(x - 16) ** 2 + (y - 12) ** 2 + (z - 12) ** 2 < 25] = 2
    labels[(x - 8) ** 2 + (y - 12) ** 2 + (z - 12) ** 2 < 36] = 1
    return labels


def nifti(values, kind="u1", unit=2, s_code=1, q_code=0, matrix=None, slope=0.0):
    """The bytes of a .nii; the matrix is that of the sform, RAS."""
    matrix = numpy.diag([*SPACING, 1]) if matrix is None else matrix
    spacing = numpy.sqrt((matrix[:3, :3] ** 2).sum(0))
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *values.shape, 1, 1, 1, 1)
    struct.pack_into("<hh", header, 70, *TYPES[kind])
    struct.pack_into("<8f", header, 76, 1, *spacing, 0, 0, 0, 0)
    struct.pack_into("<3f", header, 108, 352, slope, 0)
    header[123] = unit
    struct.pack_into("<hh", header, 252, q_code, s_code)
    struct.pack_into("<12f", header, 280, *matrix[:3].ravel())
    header[344:348] = b"n+1\0"
    return bytes(header) + values.astype(kind).tobytes(order="F")


def layers(*masks, names=("bone", "marrow", "void")):
    """A .seg.nrrd with a layer for each segment."""
    shape = masks[0].shape
    header = (f"NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\nsizes: {len(masks)} {shape[0]} {shape[1]} {shape[2]}\n"
              "space directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\nendian: little\nencoding: raw\n"
              "space origin: (0,0,0)\n")
    for i, name in zip(range(len(masks)), names):
        header += f"Segment{i}_ID:={name}\nSegment{i}_Name:={name}\nSegment{i}_LabelValue:=1\nSegment{i}_Layer:={i}\n"
    return header.encode() + b"\n" + numpy.stack(masks).astype("u1").tobytes(order="F")


class Headers(ApplicationTest):
    def write(self, name, data):
        self.path(name).write_bytes(data)
        return name

    def bounds(self, name, label=1):
        """Of the surface of a label, and what the program says."""
        text = self.succeed(name, "out", "--segments", str(label), "--target-reduction", 0, *SEGMENTS[4:]).stdout
        return numpy.reshape(read(self.path(f"out/label_{label}.vtp")).GetBounds(), (3, 2)), text

    def test_lengths_in_other_units_are_converted_and_told(self):
        expected, text = self.bounds(self.write("mm.nii", nifti(balls())))
        self.assertNotIn("warning: its", text)
        for unit, factor, name in ((3, 0.001, "micrometer"), (1, 1000.0, "meter")):
            found, text = self.bounds(self.write("unit.nii", nifti(balls(), unit=unit)))
            numpy.testing.assert_allclose(found, factor * expected, rtol=1e-5)
            self.assertIn(f"its unit is the {name} by its header", text)
        space = "NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 24 24 24\nspace units: {} {} {}\n" \
                "space directions: (0.5,0,0) (0,0.75,0) (0,0,1)\nencoding: raw\nspace origin: (4,0,0)\n\n"
        voxels = balls().astype("u1").tobytes(order="F")
        plain, _ = self.bounds(self.write("mm.nrrd", space.format(*['"mm"'] * 3).encode() + voxels))
        found, text = self.bounds(self.write("um.nrrd", space.format(*['"um"'] * 3).encode() + voxels))
        numpy.testing.assert_allclose(found, 0.001 * plain, rtol=1e-5)
        self.assertIn("its unit is the micrometer", text)
        meta = "ObjectType = Image\nNDims = 3\nDimSize = 24 24 24\n{}Offset = 4 0 0\nElementSpacing = 0.5 0.75 1\n" \
               "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
        found, text = self.bounds(self.write("um.mha", meta.format("DistanceUnits = um\n").encode() + voxels))
        numpy.testing.assert_allclose(found, 0.001 * plain, rtol=1e-5)
        self.assertIn("its unit is the micrometer", text)
        self.write("mixed.nrrd", space.format('"um"', '"mm"', '"mm"').encode() + voxels)
        self.fail_with(REJECTED, "mixed.nrrd", "out.vtp", *SEGMENTS, says="its unit of length is 'micrometer, millimeter, millimeter'")

    def test_a_header_without_a_position_is_told(self):
        _, text = self.bounds(self.write("none.nii", nifti(balls(), s_code=0)))
        self.assertIn("does not say how the patient lies (sform_code and qform_code are 0)", text)

    def test_compression_is_seen_in_the_file_and_not_in_its_name(self):
        self.bounds(self.write("plain.nii.gz", nifti(balls())))
        self.write("packed.nii", gzip.compress(nifti(balls())))
        self.fail_with(REJECTED, "packed.nii", "out.vtp", *SEGMENTS, says="it is compressed by gzip, but not named so: call it .nii.gz")

    def test_cosines_of_four_decimals_are_perpendicular_axes(self):
        turn = numpy.array([[29, 28, 20], [-20, 35, -20], [-28, 4, 29]]) / 45
        turn, _ = numpy.linalg.qr(turn)
        matrix = numpy.eye(4)
        matrix[:3, :3] = numpy.round(turn, 4) * SPACING
        rounded, text = self.bounds(self.write("rounded.nii", nifti(balls(), matrix=matrix)))
        self.assertIn("they are made perpendicular, which moves no voxel by more than 0.00", text)
        matrix[:3, :3] = turn * SPACING
        exact, text = self.bounds(self.write("exact.nii", nifti(balls(), matrix=matrix)))
        self.assertNotIn("made perpendicular", text)
        numpy.testing.assert_allclose(rounded, exact, atol=0.01)
        matrix[0, 1] += 0.01
        text = self.succeed(self.write("sheared.nii", nifti(balls(), matrix=matrix)), "out.vtp", *SEGMENTS).stdout
        self.assertNotIn("made perpendicular", text)  # but extracted as it is

    def test_values_that_a_slope_left_a_fraction_are_labels(self):
        expected, _ = self.bounds(self.write("whole.nii", nifti(balls())))
        stored = numpy.round(balls() * 32767.0)
        found, text = self.bounds(self.write("slope.nii", nifti(stored, "<u2", slope=1.00002 / 32767)))
        numpy.testing.assert_array_equal(found, expected)
        self.assertRegex(text, r"warning: its values are whole numbers but for rounding, .* voxel \d+, \d+, \d+ has 1.00002, which counts as 1")
        words = ("slope.nii", "slabs.vtp", *SEGMENTS[:4], "--memory", "256M")
        self.assertIn("which counts as 1", self.succeed(*words).stdout)

    def test_probabilities_and_fractions_are_no_labels(self):
        for factor, says in ((0.45, "voxel 7, 9, 7 has 0.45; they are probabilities from 0 to 1: --iso 0.5"), (1.5, "has 1.5; --iso VALUE"),
                             (math.nan, "not finite numbers")):
            values = numpy.where(balls() == 1, factor, 0)
            self.fail_with(REJECTED, self.write("in.nii", nifti(values, "<f4")), "out.vtp", *SEGMENTS, says=says)

    def test_labels_of_64_bits_are_exact_or_rejected(self):
        for first in (2**53 + 1, 2**63 - 2):
            labels = numpy.where(balls() > 0, balls() - 1 + first, 0)
            self.write("in.nii", nifti(labels, "<i8"))
            self.succeed("in.nii", "out", *SEGMENTS)
            for label in (first, first + 1):
                self.assertGreater(read(self.path(f"out/label_{label}.vtp")).GetNumberOfPolys(), 30)
        large = numpy.where(balls() > 0, numpy.uint64(2**64 - 1), numpy.uint64(0))
        self.fail_with(REJECTED, self.write("in.nii", nifti(large, "<u8")), "out.vtp", *SEGMENTS,
                       says="has the label 18446744073709551615; labels go up to 2^63 - 1")

    def test_formats_that_are_read_are_named_where_one_is_not(self):
        for name in ("map.img", "map.mgz", "map.zip"):
            self.write(name, b"x" * 1000)
            self.fail_with(USAGE, name, "out", *SEGMENTS, says="is none: read are .nii, .nii.gz, .nrrd")

    def test_small_volumes_have_three_digits(self):
        _, text = self.bounds(self.write("micro.nii", nifti(balls(), matrix=numpy.diag([0.01, 0.01, 0.01, 1]))))
        self.assertRegex(text, r"1 component of 0\.000\d{3} mm3")

    def test_a_segment_that_another_covers_is_named_and_can_be_chosen(self):
        ball = balls() > 0
        self.write("hidden.seg.nrrd", layers(ball, ball, balls() > 9))
        text = self.succeed("hidden.seg.nrrd", "all", *SEGMENTS).stdout
        self.assertIn("warning: no surface of 1 (bone), 3 (void): no voxel has one of these labels", text)
        self.assertFalse(self.path("all/bone.vtp").exists())
        for memory in ((), ("--memory", "256M")):
            self.succeed("hidden.seg.nrrd", "alone", "--segments", "BONE", *SEGMENTS[2:], *memory)
            alone, covering = (read(self.path(name)).GetBounds() for name in ("alone/bone.vtp", "all/marrow.vtp"))
            numpy.testing.assert_allclose(alone, covering, atol=0.6)
        text = self.succeed("hidden.seg.nrrd", "two", "--segments", "bone,void", *SEGMENTS[2:]).stdout
        self.assertIn("warning: no surface of 3 (void)", text)
        self.fail_with(REJECTED, "hidden.seg.nrrd", "none", "--segments", "void", *SEGMENTS[2:], says="no voxel belongs to what --segments chooses, 3 (void)")
        self.fail_with(REJECTED, "hidden.seg.nrrd", "none", "--segments", "tibia", *SEGMENTS[2:],
                       says="no segment 'tibia'; its segments are")

    def test_empty_masks_of_a_folder_are_named(self):
        self.path("masks").mkdir()
        for name, label in (("femur", 1), ("tibia", 2), ("patella", 3)):
            self.write(f"masks/{name}.nii", nifti(balls() == label))
        text = self.succeed("masks", "out/", *SEGMENTS).stdout
        self.assertIn("no surface of 2 (patella): no voxel has this label", text)
        self.assertEqual([file.name for file in sorted(self.path("out").glob("*.vtp"))], ["femur.vtp", "tibia.vtp"])


def element(group, number, kind, value):
    value = value if isinstance(value, bytes) else struct.pack("<H", value) if kind in ("US", "SS") else value.encode()
    value += b"" if len(value) % 2 == 0 else b"\0" if kind in ("UI", "OW") else b" "
    length = struct.pack("<HI", 0, len(value)) if kind in ("OW", "SQ") else struct.pack("<H", len(value))
    return struct.pack("<HH", group, number) + kind.encode() + length + value


def sequence(*items):
    data = b""
    for item in items:
        content = b"".join(element(*values) for values in item)
        data += struct.pack("<HHI", 0xfffe, 0xe000, len(content)) + content
    return data


def slice_file(image, z, number, series="1", more=(), frames=0):
    """A slice of a CT; the image is indexed row, column. Stored values are HU + 1024."""
    meta = element(2, 0x10, "UI", "1.2.840.10008.1.2.1")
    elements = {
        (8, 0x16): ("UI", "1.2.840.10008.5.1.4.1.1.2"), (8, 0x18): ("UI", f"1.2.{series}.{number + 1}"), (8, 0x60): ("CS", "CT"),
        (0x20, 0xd): ("UI", "1.2"), (0x20, 0xe): ("UI", f"1.9.{series}"), (0x20, 0x32): ("DS", f"0\\0\\{z:g}"),
        (0x20, 0x37): ("DS", "1\\0\\0\\0\\1\\0"), (0x28, 2): ("US", 1), (0x28, 4): ("CS", "MONOCHROME2"), (0x28, 0x10): ("US", image.shape[0]),
        (0x28, 0x11): ("US", image.shape[1]), (0x28, 0x30): ("DS", "1\\1"), (0x28, 0x100): ("US", 16), (0x28, 0x101): ("US", 16),
        (0x28, 0x102): ("US", 15), (0x28, 0x103): ("US", 0), (0x28, 0x1052): ("DS", "-1024"), (0x28, 0x1053): ("DS", "1"),
        (0x7fe0, 0x10): ("OW", image.astype("<u2").tobytes())}
    elements.update(more)
    if frames:
        elements[(0x28, 8)] = ("IS", str(frames))
        for tag in ((0x20, 0x32), (0x20, 0x37), (0x28, 0x30)):
            del elements[tag]
    data = b"".join(element(*tag, *elements[tag]) for tag in sorted(elements))
    return bytes(128) + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta))) + meta + data


def images(count=24):
    """Bone within 7 voxels of the middle of slices 4 to 19."""
    y, x = numpy.indices((24, 24))
    disk = numpy.where((x - 11.5) ** 2 + (y - 11.5) ** 2 < 49, 1700, 100)
    return [disk if 4 <= k < 20 else numpy.full((24, 24), 100) for k in range(count)]


class Scans(ApplicationTest):
    ISO = ("--iso", "bone", "--max-error", "halfvoxel", "--mode", "Fast", "--measure", "off")

    def write_series(self, folder, positions, left_out=(), **keywords):
        self.path(folder).mkdir(parents=True, exist_ok=True)
        for k, (image, z) in enumerate(zip(images(), positions)):
            if k not in left_out:
                self.path(f"{folder}/IM{k + 1:04d}.dcm").write_bytes(slice_file(image, z, k, **keywords))

    def heights(self, folder):
        text = self.succeed(folder, "out.vtp", *self.ISO).stdout
        return read(self.path("out.vtp")).GetBounds()[4:], text

    def test_a_gap_is_named_by_the_slices_beside_it(self):
        self.write_series("ct", [0.8 * k for k in range(24)], left_out=(14,))
        says = "1.6 mm instead of 0.8 mm between IM0014.dcm and IM0016.dcm, slices 14 and 15 of 23"
        self.fail_with(REJECTED, "ct", "out.vtp", *self.ISO, says=says)
        self.write_series("twice", [0.8 * (k - (k > 9)) for k in range(24)])
        self.fail_with(REJECTED, "twice", "out.vtp", *self.ISO, says="IM0010.dcm and IM0011.dcm lie at the same position")

    def test_slices_whose_spacing_changes_are_read_where_they_are(self):
        """The bone ends between slices 3 and 4 and between 19 and 20; iso 226 is 0.719 of the way out of it."""
        positions = [4.0 * k if k < 14 else 56 + 7 * (k - 14) for k in range(24)]
        self.write_series("head", positions)
        (low, high), text = self.heights("head")
        outside = (676 - 226) / 1600
        self.assertAlmostEqual(low, positions[4] - 4 * outside, delta=0.5)
        self.assertAlmostEqual(high, positions[19] + 7 * outside, delta=0.5)
        self.assertIn("Its slices are 4 mm apart and 7 mm from IM0015.dcm on; they are read where they are.", text)
        whole = read(self.path("out.vtp"))
        self.succeed("head", "slabs.vtp", *self.ISO, "--memory", "256M")
        numpy.testing.assert_allclose(read(self.path("slabs.vtp")).GetBounds(), whole.GetBounds(), atol=0.6)
        self.succeed("head", "out.ply", *self.ISO, "--fill-volume", 5)

    def test_padding_is_air(self):
        def padded(image):
            image = image.copy()
            image[:, :4] = 4000
            image[:, 20:] = 4010
            return image

        plain = {(0x28, 0x120): ("US", 4000), (0x28, 0x121): ("US", 4010)}
        self.path("ct").mkdir()
        for k, image in enumerate(images()):
            self.path(f"ct/{k}.dcm").write_bytes(slice_file(padded(image), k, k, more=plain))
        self.succeed("ct", "out.vtp", *self.ISO)
        bounds = read(self.path("out.vtp")).GetBounds()
        self.assertGreater(bounds[0], 3.5)
        self.assertLess(bounds[1], 19.5)

    def test_the_largest_series_below_a_folder_is_taken_and_others_are_named(self):
        self.write_series("cd/S1/S20", range(24))
        self.write_series("cd/S1/S10", range(3), series="5")
        (low, _), text = self.heights("cd")
        self.assertAlmostEqual(low, 3.5, delta=0.5)
        self.assertIn("Of 2 series the one with 24 slices was taken in S1/S20; others, for --series: 2: 3 slices in S1/S10 from IM0001.dcm on.", text)
        meta = element(2, 0x10, "UI", "1.2.840.10008.1.2.1")
        self.path("cd/DICOMDIR").write_bytes(bytes(128) + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta))) + meta + element(4, 0x1130, "CS", "CD"))
        for name in ("cd", "cd/DICOMDIR"):
            self.assertIn("was taken", self.heights(name)[1])
        self.assertIn("2 files: 1 done, 1 failed", self.run_program("cd/S1", "batch/", *self.ISO).stdout)

    def test_enhanced_images_are_read_as_the_series_of_their_frames(self):
        """Frames from the last to the first."""
        self.write_series("ct", range(24))
        self.succeed("ct", "series.ply", *self.ISO)
        groups = (0x20, 0x9116), sequence([(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")])
        measures = (0x28, 0x9110), sequence([(0x28, 0x30, "DS", "1\\1")])
        scale = (0x28, 0x9145), sequence([(0x28, 0x1052, "DS", "-1024"), (0x28, 0x1053, "DS", "1")])
        shared = sequence([(*tag, "SQ", value) for tag, value in (groups, measures, scale)])
        frames = sequence(*([(0x20, 0x9113, "SQ", sequence([(0x20, 0x32, "DS", f"0\\0\\{z}")]))] for z in reversed(range(24))))
        more = {(0x5200, 0x9229): ("SQ", shared), (0x5200, 0x9230): ("SQ", frames), (0x28, 0x10): ("US", 24)}
        self.path("one").mkdir()
        data = slice_file(numpy.concatenate(images()[::-1]), 0, 0, frames=24, more=more)
        self.path("one/enhanced.dcm").write_bytes(data)
        for name in ("one", "one/enhanced.dcm"):
            self.succeed(name, "enhanced.ply", *self.ISO)
            self.assertEqual(self.path("enhanced.ply").read_bytes(), self.path("series.ply").read_bytes())
        self.path("one/enhanced.dcm").write_bytes(data[:-5000])
        self.fail_with(REJECTED, "one", "out.vtp", *self.ISO, says="enhanced.dcm: its pixels are damaged")

    def test_frames_without_positions_are_rejected_with_a_way_on(self):
        self.path("ct").mkdir()
        self.path("ct/frames.dcm").write_bytes(slice_file(numpy.concatenate(images()[:4]), 0, 0, frames=4))
        for name in ("ct", "ct/frames.dcm"):
            self.fail_with(REJECTED, name, "out.vtp", *self.ISO, says="frames.dcm has several frames and does not say where each lies")


if __name__ == "__main__":
    main()
