# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences of other readers from ours that remain, each with a narrow condition and why ours is right.

What the generator knows is never explained away: ours has to read it, or to reject it with the sentence that it expects.
"""

import dataclasses
import typing

# What differs; "rejects": the other one does not read what ours reads; "reads": it reads what ours rejects.
KINDS = ("reads", "rejects", "size", "voxels", "positions", "segments", "labels", "names", "colors")


@dataclasses.dataclass
class Entry:
    formats: tuple
    readers: tuple  # empty: all
    kinds: tuple
    condition: typing.Callable  # of the choices of a variant, and the sentence of the reader that does not read it
    reason: str


def rejected(formats, sentence, reason):
    return Entry(formats, (), ("reads",), lambda choice, text: sentence in text, reason)


REJECTED = (
    rejected(("nrrd", "metaimage"), "its voxels lie in several files", "not read, and the sentence says what to save"),
    rejected(("nrrd",), "its space is not RAS, LAS or LPS", "the file does not say where the patient's left is"),
    rejected(("nrrd", "metaimage"), "its unit of length is", "others pass over the unit and take millimeters"),
    rejected(("nrrd", "nifti", "metaimage"), "values a voxel", "not one volume of intensities or labels"),
    rejected(("nrrd", "nifti", "metaimage"), "dimensions", "not one volume of three dimensions"),
    rejected(("nrrd",), "bzip2", "the library that reads the format has no bzip2"),
    rejected(("nifti",), "it is no volume", "pairs of .hdr and .img are not read"),
    rejected(("nifti",), "NIfTI-2", "ITK 5.2 does not read the second version"),
    rejected(("nifti",), "begin inside its header", "ITK begins at byte 348, nibabel and VTK at byte 352"),
    rejected(("metaimage",), "how many bytes its compressed voxels have", "whatever follows would be taken as voxels"),
    rejected(("metaimage",), "its voxels are text", "MetaIO takes words that are no numbers for zeros"),
    rejected(("dicom", "dicom, compressed", "enhanced"), "not evenly spaced", "a slice is missing: others pass over it"),
    rejected(("dicom", "dicom, compressed"), "beside the line", "a slice is out of line: others pass over it"),
    rejected(("dicom", "dicom, compressed"), "at the same position", "two slices at one position: others pass over it"),
    rejected(("enhanced",), "does not say where each lies", "a frame has no position"),
    rejected(("seg",), "its pixels are compressed or stored", "big endian, deflated and compressed bits are not read"),
    rejected(("seg",), "fractional", "probabilities are no labels"),
    rejected(("tiff",), "no gray values of 8, 16 or 32 bits", "white at 0, or 64 bits"),
)
OTHERS = (
    Entry(("nrrd",), ("pynrrd",), ("rejects",), lambda c, text: c["case"] != "small", "it knows names of fields in small letters alone"),
    Entry(("nrrd",), ("pynrrd",), ("rejects",), lambda c, text: c["vectors"] == "( 1, 2, 3 )",
          "it allows no blanks between the parentheses and the numbers"),
    Entry(("nrrd",), ("pynrrd",), ("rejects",), lambda c, text: "endian value" in text and c["endian"] == "Big",
          "it knows values in small letters alone"),
    Entry(("nrrd",), ("pynrrd",), ("rejects",), lambda c, text: "Unsupported encoding" in text and c["encoding"] in ("RAW", "GZip", "hex"),
          "it knows encodings in small letters alone, and no hexadecimal one"),
    Entry(("nrrd",), ("pynrrd",), ("rejects",), lambda c, text: "Duplicate header field" in text and c["keys"] == "with a colon",
          "it takes a key for the field of the same name"),
    Entry(("nrrd",), ("pynrrd",), ("rejects",), lambda c, text: "decompressing" in text and c["skip"] in ("bytes", "both"),
          "it skips bytes of the packed voxels, not of what is unpacked"),
    Entry(("nrrd",), ("pynrrd",), ("rejects",), lambda c, text: "Size of the data" in text and c["behind"] > 0,
          "it accepts no bytes behind the voxels"),
    Entry(("nrrd",), ("3D Slicer",), ("voxels",), lambda c, text: is_of_64_bits(c), "it makes floats of 32 bits of whole numbers of 64"),
    Entry(("seg.nrrd",), ("slicerio",), ("rejects",), lambda c, text: "kinds field" in text and c["kinds"] == "vector",
          "it takes the kind list for layers alone"),
    Entry(("seg.nrrd",), ("slicerio",), ("rejects",), lambda c, text: c["space"] == "left-anterior-superior", "it takes LPS and RAS alone"),
    Entry(("seg.nrrd",), ("slicerio",), ("rejects",), lambda c, text: "labelValue" in text and c["layer key"] == "as before layers",
          "it needs label values, which 3D Slicer wrote from version 4.11 on"),
    Entry(("seg.nrrd",), ("slicerio",), ("names",), lambda c, text: c["names"] == "other letters", "it takes the header for ASCII"),
    Entry(("seg.nrrd",), ("slicerio",), ("names",), lambda c, text: c["names"] == "equal", "it removes blanks at the end of a name"),
    Entry(("seg.nrrd",), ("slicerio",), ("names",), lambda c, text: c["names"] == "several words", "it leaves two backslashes for one"),
    Entry(("nifti",), ("nibabel",), ("positions",), lambda c, text: c["sform"] > 1 and c["qform"] > 0,
          "it always takes the sform; ours the qform, as ITK, unless the sform is that of the scanner, and says how far they differ"),
    Entry(("nifti",), ("nibabel",), ("positions",), lambda c, text: c["sform"] == 0 and c["qform"] == 0,
          "a header without a position: it lets y run to the front, ours to the back, as ITK, and says so"),
    Entry(("nifti",), ("3D Slicer",), ("voxels", "rejects"), lambda c, text: c["type"] in (1024, 1280),
          "it makes floats of 32 bits of whole numbers of 64, or ends the process"),
    Entry(("nifti",), ("SimpleITK", "3D Slicer"), ("voxels",), lambda c, text: c["scale"] == (0, 7),
          "it adds an intercept whose slope is 0; by nifti1.h there is no scale then"),
    Entry(("nifti",), ("SimpleITK", "3D Slicer"), ("positions",), lambda c, text: c["axes"] == "sheared" and c["sform"] == 1,
          "it goes by the qform, which cannot be sheared, where the sform is: a gantry that was tilted"),
    Entry(("nifti",), ("SimpleITK", "3D Slicer"), ("rejects",), lambda c, text: c["axes"] == "sheared" and c["qform"] == 0,
          "it reads no sheared axes"),
    Entry(("metaimage",), ("VTK",), ("rejects",), lambda c, text: c["equals"] == "=", "it needs blanks around the equals sign"),
    Entry(("metaimage",), ("VTK",), ("rejects",), lambda c, text: c["type"] in ("MET_LONG_LONG", "MET_ULONG_LONG"),
          "it ends the process on whole numbers of 64 bits"),
    Entry(("metaimage",), ("VTK",), ("voxels",), lambda c, text: c["type"] in ("MET_LONG", "MET_ULONG"),
          "it takes these types for 64 bits; in MetaIO they have 32"),
    Entry(("dicom", "dicom, compressed"), ("pydicom", "SimpleITK"), ("voxels",), lambda c, text: c["padding"] != "none",
          "they leave padding to their user; in ours it is never bone"),
    Entry(("dicom", "dicom, compressed"), ("SimpleITK",), ("voxels",), lambda c, text: c["photometric"] == "MONOCHROME1",
          "it turns values around that are to be shown with white at 0; HU are those of the rescale, as in pydicom"),
    Entry(("dicom", "dicom, compressed"), ("SimpleITK",), ("rejects",), lambda c, text: c["syntax"] == "rle", "its GDCM fails on RLE"),
    Entry(("dicom", "dicom, compressed"), ("SimpleITK",), ("rejects",),
          lambda c, text: c["pixels"] == "12 of 16 signed" and c["photometric"] == "MONOCHROME1",
          "it cannot turn signed values of 12 bits around"),
    Entry(("dicom", "dicom, compressed"), ("SimpleITK",), ("size",), lambda c, text: c["others"] == "localizer",
          "it takes the slices of a localizer that has the same identifier into the volume"),
    Entry(("dicom", "dicom, compressed"), ("SimpleITK",), ("size",), lambda c, text: c["others"] == "copy", "it takes a copy of a slice into the volume"),
    Entry(("dicom", "dicom, compressed"), ("SimpleITK",), ("positions",), lambda c, text: c["axes"] == "sheared",
          "its third axis is perpendicular to the slices, also where the gantry was tilted"),
    Entry(("enhanced",), ("highdicom",), ("rejects",), lambda c, text: c["syntax"] == "big", "it reads no big endian"),
    Entry(("enhanced",), ("highdicom",), ("rejects",), lambda c, text: c["axes"] == "sheared", "it reads no tilted gantry"),
    Entry(("enhanced", "seg"), ("highdicom",), ("positions",), lambda c, text: c["axes"] == "four decimals",
          "its slices are along the normal of the rounded cosines, ours where their positions are"),
    Entry(("seg",), ("highdicom",), ("rejects",), lambda c, text: c["others"] == "without codes", "it needs the codes of segments"),
    Entry(("seg",), ("highdicom",), ("rejects",), lambda c, text: c["measures"] == "wrong distance",
          "it believes the distance of slices in the header; ours takes that of the frames where they differ"),
    Entry(("tiff",), ("VTK",), ("voxels", "rejects"), lambda c, text: c["layout"] == "tiles", "it takes tiles for strips"),
    Entry(("tiff",), ("VTK",), ("voxels",), lambda c, text: c["photometric"] == 0, "it turns values with white at 0 around"),
    Entry(("nifti",), ("the page",), ("rejects",), lambda c, text: "it is an image and not a label map" in text,
          "the page takes labels alone, the program intensities, too"),
    Entry(("nifti",), ("the page",), ("rejects",), lambda c, text: "labels of more than 32 bits" in text and c["type"] in (1024, 1280),
          "labels of the page have 32 bits"),
    Entry(("nifti",), ("the page",), ("rejects",), lambda c, text: "not perpendicular" in text and c["axes"] == "sheared",
          "label maps have perpendicular axes, also in the program"),
    Entry(("tiff",), ("VTK",), ("rejects",), lambda c, text: c["compression"] == "old deflate", "it does not read the old code of deflate"),
    Entry(("tiff",), ("SimpleITK",), ("size", "rejects"), lambda c, text: c["layout"] == "tiles",
          "it makes colors of tiles, or does not read them"),
)
ENTRIES = REJECTED + OTHERS


def is_of_64_bits(choice):
    return "longlong" in choice["type"].replace(" ", "") or "int64" in choice["type"]


def reason(format_, difference):
    """Why a difference is none of ours, or an empty text."""
    for entry in ENTRIES:
        if (format_ in entry.formats and (not entry.readers or difference.reader in entry.readers)
                and difference.kind in entry.kinds and entry.condition(difference.choice, difference.detail)):
            return entry.reason
    return ""
