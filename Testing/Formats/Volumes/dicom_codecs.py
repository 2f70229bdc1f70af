# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""DICOM slices that are compressed without loss by JPEG, JPEG-LS and JPEG 2000, with imagecodecs."""

import numpy as np

import dicom_bytes
import dicom_files
from readers import optional

imagecodecs = optional("imagecodecs")
SYNTAXES = {"jpeg": "1.2.840.10008.1.2.4.70", "jpeg-ls": "1.2.840.10008.1.2.4.80", "jpeg 2000": "1.2.840.10008.1.2.4.90"}
CHOICES = {**dicom_files.CHOICES, "syntax": list(SYNTAXES), "pixels": ["12 of 16", "16", "8"]}


def coded(syntax):
    """A function that codes one frame. @param image [y, x]"""
    if syntax == SYNTAXES["jpeg"]:
        return lambda image: imagecodecs.ljpeg_encode(image, bitspersample=8 * image.dtype.itemsize)
    if syntax == SYNTAXES["jpeg-ls"]:
        return imagecodecs.jpegls_encode
    return lambda image: imagecodecs.jpeg2k_encode(image, level=0, reversible=True, codecformat="j2k")


def coder_of(syntax):
    def code(values, columns, size):
        image = np.frombuffer(values, f"<u{size}").reshape(-1, columns)
        data = bytes(coded(syntax)(np.ascontiguousarray(image)))
        return data + b"\0" * (len(data) % 2)
    return code


if imagecodecs:
    dicom_files.SYNTAXES.update(SYNTAXES)
    dicom_bytes.CODERS.update({syntax: coder_of(syntax) for syntax in SYNTAXES.values()})
write = dicom_files.write
