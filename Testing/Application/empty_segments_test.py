# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Segments without a voxel are named, and a batch passes over maps without any, whatever the format."""

import struct

import numpy

from application import REJECTED, ApplicationTest, main
from label_names_test import extended, table
from volume_headers_test import SEGMENTS, balls, element, layers, nifti, sequence

REST = SEGMENTS[2:]
NAMES = {1: "femur", 2: "patella"}


def seg_nrrd(labels):
    """Both segments in one layer."""
    header = f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {labels.shape[0]} {labels.shape[1]} {labels.shape[2]}\n" \
             "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\nspace origin: (0,0,0)\n"
    for i, (label, name) in enumerate(NAMES.items()):
        header += f"Segment{i}_ID:=S{i}\nSegment{i}_Name:={name}\nSegment{i}_LabelValue:={label}\nSegment{i}_Layer:=0\n"
    return header.encode() + b"\n" + labels.astype("u1").tobytes(order="F")


def layered(labels):
    """Each segment in a layer of its own."""
    return layers(labels == 1, labels == 2, names=tuple(NAMES.values()))


def mha(labels):
    size = " ".join(map(str, labels.shape))
    header = f"ObjectType = Image\nNDims = 3\nBinaryData = True\nElementSpacing = 1 1 1\nDimSize = {size}\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
    return header.encode() + labels.astype("u1").tobytes(order="F")


def named_nifti(labels):
    return extended(nifti(labels), table([(label, name, (255, 0, 0)) for label, name in NAMES.items()]))


def dicom_segmentation(labels):
    """A frame for each slice of each segment that has voxels there."""
    frames, pixels = [], []
    for label in NAMES:
        for z in range(labels.shape[2]):
            plane = labels[:, :, z].T == label
            if plane.any():
                identity = element(0x62, 0xa, "SQ", sequence([(0x62, 0xb, "US", label)]))
                position = element(0x20, 0x9113, "SQ", sequence([(0x20, 0x32, "DS", f"0\\0\\{z}")]))
                frames.append(position + identity)
                pixels.append(plane.ravel())
    items = b"".join(struct.pack("<HHI", 0xfffe, 0xe000, len(item)) + item for item in frames)
    shared = sequence([(0x20, 0x9116, "SQ", sequence([(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")])),
                       (0x28, 0x9110, "SQ", sequence([(0x18, 0x88, "DS", "1"), (0x28, 0x30, "DS", "1\\1")]))])
    segments = sequence(*([(0x62, 4, "US", label), (0x62, 5, "LO", name)] for label, name in NAMES.items()))
    bits = numpy.packbits(numpy.concatenate(pixels), bitorder="little").tobytes() if pixels else b""
    elements = [
        (8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.66.4"), (8, 0x18, "UI", "1.2.3"), (8, 0x60, "CS", "SEG"), (8, 0x103e, "LO", "Bones"), (0x20, 0xe, "UI", "1.9.3"),
        (0x28, 2, "US", 1), (0x28, 4, "CS", "MONOCHROME2"), (0x28, 8, "IS", str(len(frames))), (0x28, 0x10, "US", labels.shape[1]), (0x28, 0x11, "US", labels.shape[0]),
        (0x28, 0x100, "US", 1), (0x28, 0x101, "US", 1), (0x28, 0x102, "US", 0), (0x28, 0x103, "US", 0), (0x62, 1, "CS", "BINARY"), (0x62, 2, "SQ", segments),
        (0x5200, 0x9229, "SQ", shared), (0x5200, 0x9230, "SQ", items), (0x7fe0, 0x10, "OW", bits)]
    meta = element(2, 0x10, "UI", "1.2.840.10008.1.2.1")
    data = b"".join(element(*values) for values in elements)
    return bytes(128) + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta))) + meta + data


WRITERS = {"a.seg.nrrd": seg_nrrd, "b.seg.nrrd": layered, "c.dcm": dicom_segmentation, "d.nii": named_nifti, "e.mha": mha}
NAMELESS = ("e.mha",)


class EmptySegments(ApplicationTest):
    def write(self, name, labels):
        self.path(name).parent.mkdir(parents=True, exist_ok=True)
        self.path(name).write_bytes(WRITERS[name.split("/")[-1]](labels))
        return name

    def test_a_segment_without_a_voxel_is_named(self):
        labels = numpy.where(balls() == 1, 1, 0)
        for name in WRITERS:
            self.write(name, labels)
            with self.subTest(name=name):
                chosen = "1" if name in NAMELESS else "femur,patella"
                text = self.succeed(name, "out.vtp", "--segments", chosen, *REST).stdout
                (self.assertNotIn if name in NAMELESS else self.assertIn)("warning: no surface of 2 (patella): no voxel has this label", text)
                is_described = name in ("a.seg.nrrd", "b.seg.nrrd", "c.dcm")  # a table names what a map may have
                text = self.succeed(name, "out.vtp", *SEGMENTS).stdout
                (self.assertIn if is_described else self.assertNotIn)("no surface of 2 (patella)", text)
                if name not in NAMELESS:
                    self.fail_with(REJECTED, name, "no.vtp", "--segments", "patella", *REST, says="no voxel belongs to what --segments chooses, 2 (patella)")

    def test_a_map_without_a_voxel_is_rejected_and_skipped_by_a_batch(self):
        for name in WRITERS:
            with self.subTest(name=name):
                self.write(f"maps/empty/{name}", numpy.zeros_like(balls()))
                self.write(f"maps/full/{name}", balls())
                self.fail_with(REJECTED, f"maps/empty/{name}", "no.vtp", *SEGMENTS, says="none of its voxels has a label")
        # the folders of DICOM files are taken whole
        for kind in ("empty", "full"):
            (self.path(f"maps/{kind}/dicom")).mkdir()
            self.path(f"maps/{kind}/c.dcm").rename(self.path(f"maps/{kind}/dicom/c.dcm"))
        text = self.succeed("maps", "out/", *SEGMENTS).stdout
        self.assertIn("10 files: 5 done, 5 skipped", text)
        self.assertEqual(text.count("none of its voxels has a label"), 5)

    def test_a_batch_skips_maps_without_the_chosen_segment(self):
        for name in WRITERS:
            if name not in NAMELESS:
                self.write(f"one/{name}/{name}", numpy.where(balls() == 1, 1, 0))
        text = self.succeed("one", "out/", "--segments", "patella", *REST).stdout
        self.assertEqual(text.count("no voxel belongs to what --segments chooses, 2 (patella)"), 4)
        self.assertIn("4 skipped", text)

    def test_a_segmentation_of_several_is_chosen(self):
        self.write("seg/c.dcm", balls())
        self.path("seg/d.dcm").write_bytes(self.path("seg/c.dcm").read_bytes().replace(b"Bones ", b"Joints").replace(b"1.9.3", b"1.9.4"))
        says = ("it holds 2 DICOM segmentations; give the file of one of them, or --series with its number: "
                "1: segmentation c.dcm, 'Bones'; 2: segmentation d.dcm, 'Joints'")
        self.fail_with(REJECTED, "seg", "no.vtp", *SEGMENTS, says=says)
        self.succeed("seg", "out.vtp", *SEGMENTS, "--series", "joints")


if __name__ == "__main__":
    main()
