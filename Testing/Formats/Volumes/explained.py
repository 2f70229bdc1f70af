# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences of other readers from ours that remain, each with a narrow condition and why ours is right.

What the generator knows is never explained away: ours has to read it, or to reject it with the sentence that it expects.
"""

import dataclasses
import typing

# What differs; "refuses": the other one does not read what ours reads; "reads": it reads what ours rejects.
KINDS = ("reads", "refuses", "size", "voxels", "positions", "segments", "labels", "names", "colors")


@dataclasses.dataclass(frozen=True)
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
    rejected(("dicom", "enhanced"), "not evenly spaced", "a slice is missing: others pass over it"),
    rejected(("dicom",), "beside the line", "a slice is out of line: others pass over it"),
    rejected(("dicom",), "at the same position", "two slices at one position: others pass over it"),
    rejected(("enhanced",), "does not say where each lies", "a frame has no position"),
    rejected(("seg",), "its pixels are compressed or stored", "big endian, deflated and compressed bits are not read"),
    rejected(("seg",), "fractional", "probabilities are no labels"),
    rejected(("tiff",), "no gray values of 8, 16 or 32 bits", "white at 0, or 64 bits"),
)
ENTRIES = REJECTED


def reason(format_, difference):
    """Why a difference is none of ours, or an empty text."""
    for entry in ENTRIES:
        if (format_ in entry.formats and (not entry.readers or difference.reader in entry.readers)
                and difference.kind in entry.kinds and entry.condition(difference.choice, difference.detail)):
            return entry.reason
    return ""
