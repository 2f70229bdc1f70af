# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes written by other programs are read voxel by voxel and direction by direction as these programs say.

`formats_test.py --print` prints the table of Documentation/results/formats.md.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import nibabel
import nrrd
import numpy as np
import pydicom
import pydicom.uid
import SimpleITK
import tifffile

import dicom_segmentations

PAGE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "results" / "formats.md"
TYPES = {"unsigned char": np.uint8, "signed char": np.int8, "short": np.int16, "unsigned short": np.uint16, "int": np.int32,
         "unsigned int": np.uint32, "long long": np.int64, "unsigned long long": np.uint64, "float": np.float32,
         "double": np.float64}
PRINTS = False

TURN, _stretch = np.linalg.qr(np.array([[29, 28, 20], [-20, 35, -20], [-28, 4, 29]]) / 45)
MIRROR = TURN * [1, -1, 1]
SPACING = np.array([0.8, 0.9, 1.3])  # mm
ORIGIN = np.array([112.5, -53.25, 430.75])
RAS = np.diag([-1.0, -1.0, 1.0])
VOXELS = np.random.default_rng(5).integers(-1000, 1500, (5, 6, 7)).astype(np.int16)  # z, y, x
LABELS = (VOXELS % 4).astype(np.uint8)


def affine(direction):
    """Of NIfTI: from voxels to RAS."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = RAS @ direction * SPACING, RAS @ ORIGIN
    return matrix


def nifti(path, direction, voxels=VOXELS, sform=1, qform=1, scaled=False):
    image = nibabel.Nifti1Image(voxels.transpose(), affine(direction))
    image.set_sform(affine(direction), sform)
    image.set_qform(affine(direction), qform)
    if scaled:
        image.header.set_slope_inter(0.5, -10)
    nibabel.save(image, path)


def simpleitk(path, direction, voxels=VOXELS, **keywords):
    image = SimpleITK.GetImageFromArray(voxels)
    image.SetSpacing(SPACING.tolist())
    image.SetOrigin(ORIGIN.tolist())
    image.SetDirection(direction.ravel().tolist())
    SimpleITK.WriteImage(image, path, **keywords)


def pynrrd(path, direction, space="left-posterior-superior", voxels=VOXELS, **fields):
    sign = {"left-posterior-superior": [1, 1, 1], "right-anterior-superior": [-1, -1, 1], "left-anterior-superior": [1, -1, 1]}
    header = {"space": space, "space directions": (direction * SPACING).T * sign[space], "space origin": ORIGIN * sign[space]}
    nrrd.write(path, voxels.transpose(), {**header, **fields}, detached_header=path.endswith("nhdr"))


def dicom(folder, direction, shear=0.0, intercept=-1024, names=lambda k: f"{(k * 3) % 5}.dcm"):
    """One slice a file, CT. @param shear Of the gantry: how far a slice is shifted along y, mm."""
    pathlib.Path(folder).mkdir()
    series = pydicom.uid.generate_uid()
    for k, values in enumerate(VOXELS):
        position = ORIGIN + k * (direction[:, 2] * SPACING[2] + direction[:, 1] * shear)
        data = pydicom.Dataset()
        data.file_meta = pydicom.dataset.FileMetaDataset()
        data.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
        data.file_meta.MediaStorageSOPClassUID = data.SOPClassUID = pydicom.uid.CTImageStorage
        data.file_meta.MediaStorageSOPInstanceUID = data.SOPInstanceUID = pydicom.uid.generate_uid()
        data.SeriesInstanceUID, data.StudyInstanceUID, data.Modality, data.PatientName = series, series, "CT", "Secret^Patient"
        data.Rows, data.Columns = values.shape
        data.PixelSpacing = [f"{SPACING[1]:.10g}", f"{SPACING[0]:.10g}"]
        data.ImagePositionPatient = [f"{value:.10g}" for value in position]
        data.ImageOrientationPatient = [f"{value:.10g}" for value in direction[:, :2].T.ravel()]
        data.SamplesPerPixel, data.PhotometricInterpretation, data.PixelRepresentation = 1, "MONOCHROME2", 1
        data.BitsAllocated = data.BitsStored = 16
        data.HighBit = 15
        data.RescaleSlope, data.RescaleIntercept = "1", str(intercept)
        data.PixelData = (values - np.int16(intercept)).astype("<i2").tobytes()
        data.save_as(pathlib.Path(folder) / names(k), enforce_file_format=True)


def slices(folder, write=tifffile.imwrite):
    pathlib.Path(folder).mkdir()
    for k, values in enumerate(VOXELS):
        write(f"{folder}/bone_{k + 8}.tif", values)


def tiles(path, voxels, **keywords):
    """Larger than a page."""
    tifffile.imwrite(path, voxels, tile=(16, 32), compression="zlib", photometric="minisblack", **keywords)


def dicom_segments(path, **keywords):
    dicom_segmentations.segmentation(LABELS, TURN, ORIGIN, SPACING, **keywords).save_as(path)


def segments(path, layers):
    """As 3D Slicer writes them. The second segment is in a layer of its own, and overlaps the first."""
    header = {"Segment0_ID": "a", "Segment0_Name": "Femur", "Segment0_LabelValue": "1", "Segment0_Layer": "0",
              "Segment0_Color": "1 0.5 0", "Segment1_ID": "b", "Segment1_Name": "Screw", "Segment1_LabelValue": "1" if layers else "2",
              "Segment1_Layer": str(int(layers)), "Segment1_Color": "0 0 1"}
    first, second = LABELS > 1, LABELS % 2 == 1
    if not layers:
        return pynrrd(path, TURN, voxels=np.where(second, 2, first).astype(np.uint8), **header)
    both = np.stack([first, second], axis=-1).astype(np.uint8)  # z, y, x, layer
    directions = np.vstack([[np.nan] * 3, (TURN * SPACING).T])
    nrrd.write(path, both.transpose(), {"space": "left-posterior-superior", "space directions": directions, "space origin": ORIGIN,
                                        "kinds": ["list", "domain", "domain", "domain"], **header})
    return None


WHERE = {"direction": TURN}
TIFF = {"direction": np.eye(3), "origin": np.zeros(3), "spacing": (0.8, 0.9, 1.3)}
SEGMENTS = {"voxels": np.where(LABELS % 2 == 1, 2, LABELS > 1), "segments": ["Femur", "Screw"]}
DICOM_SEGMENTS = {"voxels": LABELS, "segments": dicom_segmentations.NAMES}
ROWS = (
    ("`.nii`", "nibabel", "16 bits, oblique", "a.nii", lambda p: nifti(p, TURN), WHERE),
    ("`.nii.gz`", "nibabel", "mirrored; qform alone", "a.nii.gz", lambda p: nifti(p, MIRROR, sform=0), {"direction": MIRROR}),
    ("`.nii.gz`", "nibabel", "sform alone", "a.nii.gz", lambda p: nifti(p, TURN, qform=0), WHERE),
    ("`.nii.gz`", "nibabel", "scaled: 0.5 x - 10", "a.nii.gz", lambda p: nifti(p, TURN, scaled=True),
     {**WHERE, "voxels": VOXELS * 0.5 - 10}),
    ("`.nii.gz`", "nibabel", "labels of 8 bits", "a.nii.gz", lambda p: nifti(p, TURN, LABELS), {**WHERE, "voxels": LABELS}),
    ("`.nii.gz`", "SimpleITK", "32-bit floating point", "a.nii.gz", lambda p: simpleitk(p, TURN, VOXELS.astype(np.float32)), WHERE),
    ("`.nrrd`", "SimpleITK", "compressed", "a.nrrd", lambda p: simpleitk(p, TURN, useCompression=True), WHERE),
    ("`.nrrd`", "pynrrd", "gzip, RAS", "a.nrrd", lambda p: pynrrd(p, TURN, "right-anterior-superior"), WHERE),
    ("`.nrrd`", "pynrrd", "raw, LAS, mirrored", "a.nrrd",
     lambda p: pynrrd(p, MIRROR, "left-anterior-superior", encoding="raw"), {"direction": MIRROR}),
    ("`.nhdr`", "pynrrd", "voxels in a file of their own", "a.nhdr", lambda p: pynrrd(p, TURN), WHERE),
    ("`.seg.nrrd`", "pynrrd", "two segments", "a.seg.nrrd", lambda p: segments(p, False), {**WHERE, **SEGMENTS}),
    ("`.seg.nrrd`", "pynrrd", "two layers that overlap", "a.seg.nrrd", lambda p: segments(p, True), {**WHERE, **SEGMENTS}),
    ("DICOM segmentation", "highdicom", "BINARY, oblique", "a.dcm", dicom_segments, {**WHERE, **DICOM_SEGMENTS}),
    ("DICOM segmentation", "highdicom", "LABELMAP, compressed", "a.dcm",
     lambda p: dicom_segments(p, kind="LABELMAP", syntax=pydicom.uid.RLELossless), {**WHERE, **DICOM_SEGMENTS}),
    ("`.mha`", "SimpleITK", "oblique", "a.mha", lambda p: simpleitk(p, TURN), WHERE),
    ("`.mha`", "SimpleITK", "compressed, mirrored", "a.mha", lambda p: simpleitk(p, MIRROR, useCompression=True), {"direction": MIRROR}),
    ("`.mhd`", "SimpleITK", "64-bit floating point in a file of their own", "a.mhd",
     lambda p: simpleitk(p, TURN, VOXELS.astype(np.float64)), WHERE),
    ("DICOM series", "pydicom", "shuffled, oblique", "series", lambda p: dicom(p, TURN), WHERE),
    ("DICOM series", "pydicom", "tilted gantry", "series", lambda p: dicom(p, TURN, shear=0.3),
     {**WHERE, "shear": 0.3}),
    ("`.tif`", "tifffile", "pages of 16 bits", "a.tif", lambda p: tifffile.imwrite(p, VOXELS, photometric="minisblack"), TIFF),
    ("`.tif`", "tifffile", "BigTIFF, deflated, floating point", "a.tif",
     lambda p: tifffile.imwrite(p, VOXELS.astype(np.float32), bigtiff=True, compression="zlib", photometric="minisblack"), TIFF),
    ("`.tif`", "tifffile", "tiles, deflated", "a.tif", lambda p: tiles(p, VOXELS), TIFF),
    ("`.tif`", "SimpleITK", "labels of 8 bits", "a.tiff", lambda p: simpleitk(p, TURN, LABELS), {**TIFF, "voxels": LABELS}),
    ("folder of `.tif`", "tifffile", "a file a slice", "slices", slices, TIFF),
    ("folder of `.tif`", "tifffile", "a file a slice, in tiles", "slices", lambda p: slices(p, tiles), TIFF),
)


class Formats(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="bonedecimate-test-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def read(self, path, spacing=()):
        raw = self.folder / "voxels.raw"
        words = [os.environ["DUMP_VOLUME"], path, raw, *map(str, spacing)]
        completed = subprocess.run(words, check=True, capture_output=True, encoding="utf-8")
        self.assertEqual(completed.stderr, "")
        found = json.loads(completed.stdout)
        self.assertEqual(found["problem"], "")
        return found, np.fromfile(raw, TYPES[found["type"]]).reshape(found["size"][::-1])

    def compare(self, path, direction, voxels=VOXELS, origin=ORIGIN, spacing=(), shear=0.0, segments=(), tolerance=0.0):
        found, read = self.read(path, spacing)
        np.testing.assert_allclose(read, voxels, rtol=0, atol=tolerance)
        steps = (direction * SPACING).T
        steps[2] += shear * direction[:, 1]
        np.testing.assert_allclose(found["origin"], origin, rtol=0, atol=1e-4)
        np.testing.assert_allclose(found["steps"], steps, rtol=0, atol=1e-5)
        self.assertEqual([segment["name"] for segment in found["segments"]], list(segments))

    def test_are_read_voxel_by_voxel_and_direction_by_direction(self):
        lines = ["| format | written by | |", "|---|---|---|"]
        for number, (format_, program, what, name, write, expected) in enumerate(ROWS):
            with self.subTest(format=format_, program=program, what=what):
                folder = self.folder / str(number)
                folder.mkdir()
                write(str(folder / name))
                self.compare(folder / name, **expected)
            lines.append(f"| {format_} | {program} | {what} |")
        table = "\n".join(lines)
        if PRINTS:
            print(table)
        self.assertIn(table, PAGE.read_text(encoding="utf-8"))

    def test_of_segments_have_labels_and_colors(self):
        segments(str(self.folder / "a.seg.nrrd"), True)
        found, _voxels = self.read(self.folder / "a.seg.nrrd")
        self.assertEqual(found["segments"], [{"label": 1, "name": "Femur", "color": [1.0, 0.5, 0.0]},
                                             {"label": 2, "name": "Screw", "color": [0.0, 0.0, 1.0]}])
        overlap = np.count_nonzero(LABELS == 3)
        self.assertIn(f"{overlap} of its voxels are in more than one segment", found["note"])

    def rejection(self, path, spacing=()):
        words = [os.environ["DUMP_VOLUME"], path, self.folder / "voxels.raw", *map(str, spacing)]
        return json.loads(subprocess.run(words, check=True, capture_output=True, encoding="utf-8").stdout)["problem"]

    def test_of_the_second_version_of_nifti_are_rejected(self):
        for name, order in (("a.nii", "<"), ("b.nii", ">"), ("c.nii.gz", "<")):
            header = nibabel.Nifti2Header(endianness=order)
            nibabel.save(nibabel.Nifti2Image(VOXELS.transpose(), affine(TURN), header), self.folder / name)
            self.assertIn("it is a NIfTI-2 file", self.rejection(self.folder / name))

    def test_in_tiles_have_all_types_and_sizes_of_values(self):
        voxels = np.random.default_rng(3).integers(0, 120, (3, 40, 70))
        for type_ in (np.uint8, np.int8, np.uint16, np.int16, np.uint32, np.int32, np.float32):
            for order in "<>":
                path = self.folder / "tiles.tif"
                tiles(path, voxels.astype(type_), byteorder=order)
                _found, read = self.read(path, (1, 1, 1))
                self.assertEqual(read.dtype, type_)
                np.testing.assert_array_equal(read, voxels)

    def test_in_tiles_that_are_no_volume_are_rejected(self):
        path = self.folder / "tiles.tif"
        pages = np.random.default_rng(3).integers(0, 255, (4, 40, 70)).astype(np.uint8)
        tiles(path, pages)
        complete = path.read_bytes()
        for part in (0.2, 0.5, 0.9):
            path.write_bytes(complete[: int(part * len(complete))])
            self.assertNotEqual(self.rejection(path, (1, 1, 1)), "")
        tifffile.imwrite(path, np.zeros((4, 40, 70, 3), np.uint8), tile=(16, 16), photometric="rgb")
        self.assertIn("3 values a voxel", self.rejection(path, (1, 1, 1)))
        tifffile.imwrite(path, pages, tile=(16, 16), photometric="miniswhite")
        self.assertIn("gray values", self.rejection(path, (1, 1, 1)))
        tifffile.imwrite(path, pages.astype(np.float64), tile=(16, 16), photometric="minisblack")
        self.assertIn("8, 16 or 32 bits", self.rejection(path, (1, 1, 1)))
        with tifffile.TiffWriter(path) as writer:
            writer.write(pages[0], tile=(16, 16))
            writer.write(pages[1])
        self.assertIn("not all of one size and type", self.rejection(path, (1, 1, 1)))

    def test_whose_sform_and_qform_differ_have_a_note(self):
        image = nibabel.Nifti1Image(VOXELS.transpose(), affine(TURN))
        moved = affine(TURN)
        moved[0, 3] += 3
        image.set_sform(moved, 4)
        image.set_qform(affine(TURN), 1)
        nibabel.save(image, self.folder / "a.nii")
        self.assertIn("sform and qform are up to 3 mm apart", self.read(self.folder / "a.nii")[0]["note"])


if __name__ == "__main__":
    PRINTS = "--print" in sys.argv
    sys.argv = [word for word in sys.argv if word != "--print"]
    unittest.main(verbosity=2)
