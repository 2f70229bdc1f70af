# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The formats, and the readers that each is compared with."""

import dicom_codecs
import dicom_files
import dicom_readers
import dicom_segment_files
import enhanced_files
import metaimage_files
import nifti_files
import nrrd_files
import own_readers
import readers
import segment_files
import segment_readers
import slicer_readers
import tiff_files
import uneven_files
import vti_files

FORMATS = {"nrrd": nrrd_files, "seg.nrrd": segment_files, "nifti": nifti_files, "metaimage": metaimage_files, "dicom": dicom_files,
           "dicom, uneven": uneven_files, "enhanced": enhanced_files, "seg": dicom_segment_files, "tiff": tiff_files, "vti": vti_files}
if dicom_codecs.imagecodecs:
    FORMATS["dicom, compressed"] = dicom_codecs

# Names, modules that have to be installed, functions.
READERS = {
    "nrrd": (("SimpleITK", readers.SimpleITK, readers.simpleitk), ("pynrrd", readers.nrrd, readers.pynrrd),
             ("3D Slicer", slicer_readers.slicer_core, slicer_readers.volume)),
    "seg.nrrd": (("slicerio", segment_readers.slicerio, segment_readers.slicerio_segments),
                 ("3D Slicer", slicer_readers.slicer_core, slicer_readers.segmentation)),
    "nifti": (("SimpleITK", readers.SimpleITK, readers.simpleitk_in_mm), ("nibabel", readers.nibabel, readers.nibabel_image),
              ("VTK", readers.vtk, readers.vtk_nifti), ("3D Slicer", slicer_readers.slicer_core, slicer_readers.volume_in_mm),
              ("the wheel", own_readers.wheel, own_readers.wheel_nifti),
              ("the page", own_readers.page, own_readers.page_nifti)),
    "metaimage": (("SimpleITK", readers.SimpleITK, readers.simpleitk), ("VTK", readers.vtk, readers.vtk_image("vtkMetaImageReader"))),
    "dicom": (("pydicom", dicom_readers.pydicom, dicom_readers.pydicom_series),
              ("SimpleITK", readers.SimpleITK, dicom_readers.simpleitk_series)),
    "enhanced": (("pydicom", dicom_readers.pydicom, dicom_readers.pydicom_enhanced),
                 ("highdicom", dicom_readers.highdicom, dicom_readers.highdicom_enhanced)),
    "seg": (("highdicom", dicom_readers.highdicom, dicom_readers.highdicom_segments),
            ("pydicom", dicom_readers.pydicom, dicom_readers.pydicom_segments)),
    "tiff": (("SimpleITK", readers.SimpleITK, readers.simpleitk_tiff), ("tifffile", readers.tifffile, readers.tifffile_pages),
             ("VTK", readers.vtk, readers.vtk_tiff)),
    "vti": (("VTK", readers.vtk, readers.vti),),
}
READERS["dicom, compressed"] = READERS["dicom"]
READERS["dicom, uneven"] = ()


def readers_of(name):
    """Those that are installed."""
    return {reader: function for reader, module, function in READERS[name] if module is not None}
