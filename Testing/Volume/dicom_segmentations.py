# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""DICOM segmentations (SEG) as highdicom writes them."""

import warnings

import highdicom
import numpy as np
import pydicom
import pydicom.uid
from pydicom.sr.codedict import codes

NAMES = ("Femur", "Sch\u00e4del", "Screw")
COLORS = ((230, 200, 150), (10, 120, 240), (255, 255, 0))


def source(shape, geometry):
    """Slices of the CT that was segmented. @param geometry From an index to the position of a voxel, mm, and the two directions."""
    position, directions, spacing = geometry
    study, series, frame = (pydicom.uid.generate_uid() for _ in range(3))
    for k in range(shape[0]):
        data = pydicom.Dataset()
        data.file_meta = pydicom.dataset.FileMetaDataset()
        data.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
        data.SOPClassUID, data.SOPInstanceUID = pydicom.uid.CTImageStorage, pydicom.uid.generate_uid()
        data.StudyInstanceUID, data.SeriesInstanceUID, data.FrameOfReferenceUID = study, series, frame
        data.PatientID, data.PatientName, data.PatientBirthDate, data.PatientSex = "Secret0815", "Secret^Patient", "", "O"
        data.StudyID, data.StudyDate, data.StudyTime, data.AccessionNumber, data.ReferringPhysicianName = "1", "", "", "", ""
        data.Modality, data.SeriesNumber, data.InstanceNumber, data.PositionReferenceIndicator = "CT", 1, k + 1, ""
        data.Rows, data.Columns = shape[1:]
        data.PixelSpacing = [f"{spacing[1]:.10g}", f"{spacing[0]:.10g}"]
        data.SliceThickness = f"{spacing[2]:.10g}"
        data.ImagePositionPatient = [f"{value:.10g}" for value in position(k)]
        data.ImageOrientationPatient = [f"{value:.10g}" for value in directions]
        data.SamplesPerPixel, data.PhotometricInterpretation, data.PixelRepresentation = 1, "MONOCHROME2", 1
        data.BitsAllocated = data.BitsStored = 16
        data.HighBit = 15
        yield data


def description(number, name, color):
    return highdicom.seg.SegmentDescription(
        number, name, codes.SCT.Tissue, codes.SCT.Bone, highdicom.seg.SegmentAlgorithmTypeValues.MANUAL,
        display_color=highdicom.color.CIELabColor.from_rgb(*color) if color else None)


def segmentation(labels, direction, origin, spacing, kind="BINARY", syntax=pydicom.uid.ExplicitVRLittleEndian,
                 position=None, **keywords):
    """@param labels (z, y, x), or (z, y, x, segment) of 0 and 1. @param position Of a plane, mm, if planes are not evenly spaced.
    @return A data set that can be changed before it is saved."""
    geometry = (position or (lambda k: origin + k * direction[:, 2] * spacing[2]), direction[:, :2].T.ravel(), spacing)
    count = labels.shape[3] if labels.ndim == 4 else int(labels.max())
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about names that hold no patient's
        return highdicom.seg.Segmentation(
            list(source(labels.shape[:3], geometry)), labels, kind,
            [description(i + 1, NAMES[i], COLORS[i]) for i in range(count)],
            pydicom.uid.generate_uid(), 2, pydicom.uid.generate_uid(), 1, "bonedecimate", "test", "1", "1",
            transfer_syntax_uid=syntax, **keywords)
