# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""DICOM segmentations by highdicom are read voxel by voxel, or rejected with a sentence."""

import copy
import functools
import io
import json
import os
import pathlib
import resource
import subprocess
import tempfile
import unittest

import numpy as np
import pydicom
import pydicom.encaps
import pydicom.uid

import dicom_segmentations
from dicom_segmentations import COLORS, NAMES

DIRECTION, _stretch = np.linalg.qr(np.array([[29, 28, 20], [-20, 35, -20], [-28, 4, 29]]) / 45)
SPACING = np.array([0.8, 0.9, 1.3])  # mm
ORIGIN = np.array([112.5, -53.25, 430.75])
LABELS = np.random.default_rng(5).integers(0, 4, (6, 5, 7)).astype(np.uint8)  # z, y, x; 35 pixels are no whole bytes
REJECTED = 2


def as_bytes(data):
    file = io.BytesIO()
    data.save_as(file, enforce_file_format=True)
    return file.getvalue()


@functools.lru_cache
def whole(kind, syntax):
    return as_bytes(dicom_segmentations.segmentation(LABELS, DIRECTION, ORIGIN, SPACING, kind, syntax))


def written(labels=LABELS, kind="BINARY", syntax=pydicom.uid.ExplicitVRLittleEndian, **keywords):
    """A data set that can be changed."""
    if labels is LABELS:
        return pydicom.dcmread(io.BytesIO(whole(kind, syntax)))
    written_ = dicom_segmentations.segmentation(labels, DIRECTION, ORIGIN, SPACING, kind, syntax, **keywords)
    return pydicom.dcmread(io.BytesIO(as_bytes(written_)))


def reordered(data, order):
    """With its frames in another order."""
    pixels = data.Rows * data.Columns
    bits = np.unpackbits(np.frombuffer(data.PixelData, np.uint8), bitorder="little")[: pixels * data.NumberOfFrames]
    changed = np.packbits(bits.reshape(-1, pixels)[order].ravel(), bitorder="little").tobytes()
    data.PixelData = changed + bytes(len(changed) % 2)
    data.PerFrameFunctionalGroupsSequence = [data.PerFrameFunctionalGroupsSequence[i] for i in order]
    data.NumberOfFrames = len(order)
    return data


def limit():
    """Of the memory of a process, in bytes: damaged files announce more."""
    resource.setrlimit(resource.RLIMIT_DATA, (1 << 29, 1 << 29))


def position(data, frame):
    return data.PerFrameFunctionalGroupsSequence[frame].PlanePositionSequence[0]


def measures(data):
    return data.SharedFunctionalGroupsSequence[0].PixelMeasuresSequence[0]


def move(data, frame, step):
    moved = position(data, frame)
    moved.ImagePositionPatient = [f"{a + b:.10g}" for a, b in zip(moved.ImagePositionPatient, step)]


def turn(data):
    turned = copy.deepcopy(data.SharedFunctionalGroupsSequence[0].PlaneOrientationSequence)
    turned[0].ImageOrientationPatient = [0, 1, 0, 0, 0, 1]
    data.PerFrameFunctionalGroupsSequence[3].PlaneOrientationSequence = turned


def encapsulate(data):
    data.file_meta.TransferSyntaxUID = pydicom.uid.RLELossless
    data.PixelData = pydicom.encaps.encapsulate([b"\0" * 64] * data.NumberOfFrames)


# What is changed in a file, and what the program says.
CHANGES = (
    (lambda data: move(data, 2, 0.5 * SPACING[2] * DIRECTION[:, 2]), "not evenly spaced"),
    (lambda data: move(data, 4, DIRECTION[:, 0]), "out of line"),
    (lambda data: move(data, 0, 1e9 * DIRECTION[:, 2]), "too small"),
    (lambda data: setattr(position(data, 0), "ImagePositionPatient", ["1", "2"]), "no position"),
    (lambda data: delattr(data.PerFrameFunctionalGroupsSequence[1], "PlanePositionSequence"), "no position"),
    (turn, "several orientations"),
    (lambda data: setattr(measures(data), "PixelSpacing", ["0", "1"]), "spacing is zero"),
    (lambda data: setattr(measures(data), "PixelSpacing", ["-1", "1"]), "negative"),
    (lambda data: setattr(measures(data), "PixelSpacing", ["1e400", "1"]), "finite"),
    (lambda data: setattr(data.SharedFunctionalGroupsSequence[0].PlaneOrientationSequence[0], "ImageOrientationPatient",
                          [1, 0, 0, 1, 0, 0]), "not perpendicular"),
    (lambda data: setattr(data, "PixelData", data.PixelData[:-2]), "truncated or damaged"),
    (lambda data: setattr(data, "PixelData", data.PixelData + bytes(4)), "truncated or damaged"),
    (lambda data: delattr(data, "PixelData"), "truncated or damaged"),
    (lambda data: setattr(data, "NumberOfFrames", 2000000000), "announces '2000000000' frames"),
    (lambda data: setattr(data, "Rows", 65535), "truncated or damaged"),
    (lambda data: setattr(data, "Columns", 1), "at least two"),
    (lambda data: data.SegmentSequence.pop(), "does not describe"),
    (lambda data: setattr(data.SegmentSequence[2], "SegmentNumber", 1), "missing or repeat"),
    (lambda data: delattr(data, "SegmentSequence"), "no segments"),
    (lambda data: setattr(data, "BitsAllocated", 8), "8 bits"),
    (lambda data: setattr(data, "SegmentationType", "FRACTIONAL"), "fractional"),
    (lambda data: setattr(data, "SegmentationType", "OTHER"), "neither BINARY nor LABELMAP"),
    (lambda data: reordered(data, [0, 0, 1, 2]), "in the same plane"),
    (encapsulate, "compressed"),
    (lambda data: setattr(data.file_meta, "TransferSyntaxUID", pydicom.uid.DeflatedExplicitVRLittleEndian), "compressed"),
    (lambda data: setattr(data, "Modality", "CT"), "no segmentation (SEG)"),
)


class Segmentations(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="bonedecimate-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def dump(self, path):
        words = [os.environ["DUMP_VOLUME"], path, self.folder / "voxels.raw"]
        completed = subprocess.run(words, check=True, capture_output=True, encoding="utf-8", preexec_fn=limit)
        self.assertEqual(completed.stderr, "")
        self.assertNotIn("Secret", completed.stdout)
        return json.loads(completed.stdout)

    def save(self, data, name="bones.dcm"):
        path = self.folder / name
        data.save_as(path, enforce_file_format=True)
        return path

    def compare(self, path, labels=LABELS, direction=DIRECTION):
        found = self.dump(path)
        self.assertEqual(found["problem"], "")
        voxels = np.fromfile(self.folder / "voxels.raw", np.uint16).reshape(found["size"][::-1])
        np.testing.assert_array_equal(voxels, labels)
        np.testing.assert_allclose(found["origin"], ORIGIN, rtol=0, atol=1e-4)
        np.testing.assert_allclose(found["steps"], (direction * SPACING).T, rtol=0, atol=1e-5)
        for segment, name, color in zip(found["segments"], NAMES, COLORS):
            self.assertEqual(segment["name"], name)
            np.testing.assert_allclose(segment["color"], np.array(color) / 255, rtol=0, atol=0.002)
        return found

    def program(self, *words, code=0):
        completed = subprocess.run([os.environ["BONEDECIMATE"], *map(str, words)], cwd=self.folder, check=False,
                                   capture_output=True, encoding="utf-8")
        self.assertEqual(completed.returncode, code, completed.stderr)
        return completed

    def test_have_the_voxels_names_and_colors_that_were_written(self):
        for kind, syntax in (
            ("BINARY", pydicom.uid.ExplicitVRLittleEndian), ("BINARY", pydicom.uid.ImplicitVRLittleEndian),
            ("LABELMAP", pydicom.uid.ExplicitVRLittleEndian), ("LABELMAP", pydicom.uid.RLELossless),
            ("LABELMAP", pydicom.uid.JPEGLSLossless)):
            with self.subTest(kind=kind, syntax=syntax.name):
                found = self.compare(self.save(written(kind=kind, syntax=syntax)))
                self.assertEqual([segment["label"] for segment in found["segments"]], [1, 2, 3])
                self.assertEqual(found["note"], "")

    def test_may_have_labels_of_16_bits(self):
        data = written(kind="LABELMAP")
        data.BitsAllocated, data.BitsStored, data.HighBit = 16, 16, 15
        stored = np.frombuffer(data.PixelData, np.uint8)[: LABELS.size]
        data.PixelData = (stored.astype("<u2") * 300).tobytes()
        for i, segment in enumerate(data.SegmentSequence):
            segment.SegmentNumber = i * 300
        self.assertEqual(data.SegmentSequence[0].SegmentLabel, "Background")
        found = self.compare(self.save(data), LABELS.astype(int) * 300)
        self.assertEqual([segment["label"] for segment in found["segments"]], [300, 600, 900])

    def test_have_their_frames_in_any_order(self):
        order = np.random.default_rng(3).permutation(written().NumberOfFrames)
        self.compare(self.save(reordered(written(), order)))

    def test_that_overlap_get_the_last_segment(self):
        both = np.stack([LABELS > 1, LABELS % 2 == 1], axis=-1).astype(np.uint8)
        expected = np.where(both[..., 1], 2, both[..., 0])
        overlap = np.count_nonzero(LABELS == 3)
        for turn in (1, -1):
            data = written(both)
            found = self.compare(self.save(reordered(data, list(range(data.NumberOfFrames))[::turn])), expected)
            self.assertEqual(found["note"], f"{overlap} of its voxels are in more than one segment and count as those of the last one")

    def test_are_background_where_planes_have_no_frame(self):
        labels = LABELS.copy()
        labels[[1, 3, 4]] = 0
        for spaced, kind in ((True, "BINARY"), (True, "LABELMAP"), (False, "BINARY")):
            data = written(labels, kind=kind)
            self.assertEqual(len({str(position(data, i).ImagePositionPatient) for i in range(data.NumberOfFrames)}), 3)
            if spaced:
                found = self.compare(self.save(data), labels)
                self.assertIn("3 of its 6 planes have no frame and are background", found["note"])
            else:  # planes 0, 2 and 5 have no common distance then but that of the header
                del measures(data).SpacingBetweenSlices
                self.assertIn("not evenly spaced", self.dump(self.save(data))["problem"])

    def test_are_where_their_planes_are_if_the_spacing_changes_or_the_gantry_was_tilted(self):
        heights = np.cumsum([0, 1.3, 1.3, 1.3, 1.3, 3, 3, 3, 3])
        labels = np.random.default_rng(6).integers(0, 4, (9, 5, 7)).astype(np.uint8)
        with_gap = labels.copy()
        with_gap[2] = 0
        tilted = DIRECTION @ [0, 0.3, np.sqrt(1 - 0.09)]
        for way, voxels, spaced in ((DIRECTION[:, 2], labels, False), (tilted, labels, False), (tilted, with_gap, False),
                                    (DIRECTION[:, 2], labels, True), (tilted, labels, True)):
            with self.subTest(way=way, gap=voxels is with_gap, spaced=spaced):
                along = 1.3 * np.arange(9) if spaced else heights
                data = written(voxels, position=lambda k, way=way, along=along: ORIGIN + along[k] * way)
                found = self.dump(self.save(data))
                self.assertEqual(found["problem"], "")
                read = np.fromfile(self.folder / "voxels.raw", np.uint16).reshape(found["size"][::-1])
                np.testing.assert_array_equal(read, voxels)
                layers = np.arange(9) if spaced else np.array(found["layers"])
                positions = np.array(found["origin"]) + layers[:, None] * np.array(found["steps"][2])
                np.testing.assert_allclose(positions, ORIGIN + along[:, None] * way, rtol=0, atol=1e-4)
                self.assertEqual("they are read where they are" in found["note"], not spaced)
                self.assertEqual("1 of its 9 planes have no frame" in found["note"], voxels is with_gap)
                self.program("bones.dcm", "out.vtp", "--segments", "all", "--max-error", "halfvoxel", "--measure", "off")

    def test_need_neither_a_right_distance_of_planes_nor_the_thickness_of_slices(self):
        for distance, thickness in ((None, 0.65), (7, 1.3), ("nan", 1.3), (0, 5)):
            data = written()
            measures(data).SliceThickness = thickness
            measures(data).SpacingBetweenSlices = None
            if distance is not None:
                measures(data).SpacingBetweenSlices = distance if distance != "nan" else None
            self.compare(self.save(data))

    def test_have_positions_and_directions_that_are_rounded(self):
        data = written()
        for i in range(data.NumberOfFrames):
            position(data, i).ImagePositionPatient = [f"{value:.5f}" for value in position(data, i).ImagePositionPatient]
        orientation = data.SharedFunctionalGroupsSequence[0].PlaneOrientationSequence[0]
        orientation.ImageOrientationPatient = [f"{value:.6f}" for value in orientation.ImageOrientationPatient]
        self.compare(self.save(data))
        self.program("bones.dcm", "out.vtp", "--segments", "all")

    def test_have_names_in_any_character_set(self):
        for character_set, name in (("ISO_IR 192", "Sch\u00e4del \u9aa8"), ("ISO_IR 100", "Sch\u00e4del"),
                                    ("ISO_IR 144", "\u043a\u043e\u0441\u0442\u044c"), ("GB18030", "\u9aa8")):
            data = written()
            data.SpecificCharacterSet = character_set
            data.SegmentSequence[1].SegmentLabel = name
            self.assertEqual(self.dump(self.save(data))["segments"][1]["name"], name)

    def test_without_a_color_are_gray(self):
        data = written()
        del data.SegmentSequence[0].RecommendedDisplayCIELabValue
        self.assertEqual(self.dump(self.save(data))["segments"][0]["color"], [0.5, 0.5, 0.5])

    def test_are_found_in_folders(self):
        (self.folder / "case").mkdir()
        self.save(written(), "case/bones")
        self.compare(self.folder / "case")
        self.save(written(), "case/others")
        self.assertIn("2 DICOM segmentations; give the file", self.dump(self.folder / "case")["problem"])

    def test_that_are_damaged_are_rejected_with_a_sentence(self):
        for number, (change, words) in enumerate(CHANGES):
            with self.subTest(words=words, number=number):
                data = written()
                change(data)
                self.assertIn(words, self.dump(self.save(data))["problem"])

    def test_of_an_unknown_transfer_syntax_are_rejected(self):
        changed = whole("BINARY", pydicom.uid.ExplicitVRLittleEndian).replace(b"1.2.840.10008.1.2.1\0", b"1.2.840.10008.1.2.99")
        (self.folder / "bones.dcm").write_bytes(changed)
        self.assertIn("compressed", self.dump(self.folder / "bones.dcm")["problem"])

    def test_with_values_of_no_segment_are_rejected(self):
        data = written(kind="LABELMAP")
        data.PixelData = b"\x09\x08" + data.PixelData[2:]
        self.assertIn("2 values of its voxels are those of no segment", self.dump(self.save(data))["problem"])

    def test_that_end_early_are_rejected(self):
        for kind, syntax in (("BINARY", pydicom.uid.ExplicitVRLittleEndian), ("LABELMAP", pydicom.uid.RLELossless)):
            complete = whole(kind, syntax)
            for part in (0.1, 0.5, 0.9, 0.98):
                (self.folder / "cut.dcm").write_bytes(complete[: int(part * len(complete))])
                self.assertNotEqual(self.dump(self.folder / "cut.dcm")["problem"], "", (syntax.name, part))

    def test_that_are_damaged_anywhere_are_read_or_rejected(self):
        random = np.random.default_rng(11)
        for kind, syntax in (("BINARY", pydicom.uid.ExplicitVRLittleEndian), ("LABELMAP", pydicom.uid.RLELossless)):
            complete = np.frombuffer(whole(kind, syntax), np.uint8)
            for _round in range(6):
                damaged = complete.copy()
                damaged[random.integers(132, len(complete), 12)] = random.integers(0, 256, 12)
                (self.folder / "damaged.dcm").write_bytes(damaged.tobytes())
                found = self.dump(self.folder / "damaged.dcm")
                self.assertEqual("size" in found, found["problem"] == "")

    def test_are_label_maps_of_the_program(self):
        labels = np.zeros((12, 14, 15), np.uint8)
        labels[2:7, 3:10, 4:11], labels[7:10, 3:10, 4:11] = 1, 2
        self.save(written(labels, omit_empty_frames=False))
        text = self.program("bones.dcm", "bones.vtp", "--segments", "all", "--target-reduction", 0).stdout
        self.assertIn("Femur", text)
        self.program("certify", "bones.vtp", "--labels", "bones.dcm")
        self.program("bones.vtp", "small.vtp", "--label-map", "bones.dcm", "--keep-voxels", "on")
        self.assertIn("label map", self.program("bones.dcm", "out.vtp", "--iso", 1, code=REJECTED).stderr)
        data = written()
        data.SegmentationType = "FRACTIONAL"
        self.save(data)
        said = self.program("bones.dcm", "out.vtp", "--segments", "all", code=REJECTED).stderr
        self.assertIn("'bones.dcm' was rejected: it holds a fractional segmentation", said)
        self.assertFalse((self.folder / "out.vtp").exists())
        (self.folder / "page.dcm").write_text("<html>not found</html>\n", encoding="ascii")
        self.assertIn("not a DICOM file", self.program("page.dcm", "out.vtp", "--segments", "all", code=REJECTED).stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
