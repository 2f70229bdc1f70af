# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""DICOM by pydicom, highdicom and SimpleITK."""

import pathlib

import numpy as np

from readers import SimpleITK, optional
from truth import NotRead, Reading, reversed_layers

pydicom = optional("pydicom")
highdicom = optional("highdicom")


def scaled(values, data):
    return values.astype(np.float64) * float(data.get("RescaleSlope", 1)) + float(data.get("RescaleIntercept", 0))


def series_of(folder):
    """Data sets of the largest series: those of one orientation, one of each identifier."""
    groups, seen = {}, set()
    for path in sorted(pathlib.Path(folder).iterdir()):
        try:
            data = pydicom.dcmread(path)
        except Exception:  # a text
            continue
        instance = data.get("SOPInstanceUID")
        if "ImagePositionPatient" not in data or "PixelData" not in data or (instance and instance in seen):
            continue
        seen.add(instance)
        key = (data.SeriesInstanceUID, tuple(np.round(np.array(data.ImageOrientationPatient, float), 3)))
        groups.setdefault(key, []).append(data)
    return max(groups.values(), key=len)


def pydicom_series(path, choice):
    slices = series_of(path)
    rows = np.array(slices[0].ImageOrientationPatient, float).reshape(2, 3)
    normal = np.cross(*rows)
    slices.sort(key=lambda data: np.dot(np.array(data.ImagePositionPatient, float), normal))
    voxels = np.stack([scaled(data.pixel_array, data).T for data in slices], axis=-1)
    origin, last = (np.array(slices[k].ImagePositionPatient, float) for k in (0, -1))
    spacing = np.array(slices[0].PixelSpacing, float)
    steps = np.vstack([rows[0] * spacing[1], rows[1] * spacing[0], (last - origin) / (len(slices) - 1)])
    heights = [np.dot(np.array(data.ImagePositionPatient, float), normal) for data in slices]
    gaps = np.diff(heights)
    if np.abs(gaps - gaps.mean()).max() > 0.05 * gaps.mean():
        raise NotRead("slices that are not evenly spaced")
    return Reading(voxels, origin, steps)


def simpleitk_series(path, choice):
    reader = SimpleITK.ImageSeriesReader()
    candidates = [reader.GetGDCMSeriesFileNames(str(path), series) for series in reader.GetGDCMSeriesIDs(str(path))]
    reader.SetFileNames(max(candidates, key=len))
    image = reader.Execute()
    voxels = SimpleITK.GetArrayFromImage(image).transpose().astype(np.float64)
    steps = (np.array(image.GetDirection()).reshape(3, 3) * np.array(image.GetSpacing())).T
    return Reading(voxels, np.array(image.GetOrigin()), steps)


def first_file(path):
    path = pathlib.Path(path)
    return next(path.iterdir()) if path.is_dir() else path


def group(data, i, name):
    """Of a frame, or shared."""
    frame = data.PerFrameFunctionalGroupsSequence[i]
    found = frame.get(name) or data.SharedFunctionalGroupsSequence[0].get(name)
    return found[0] if found else None


def placed(data, count):
    """Positions, rows and spacing of frames."""
    positions = np.array([group(data, i, "PlanePositionSequence").ImagePositionPatient for i in range(count)], float)
    rows = np.array(group(data, 0, "PlaneOrientationSequence").ImageOrientationPatient, float).reshape(2, 3)
    return positions, rows, np.array(group(data, 0, "PixelMeasuresSequence").PixelSpacing, float)


def pydicom_enhanced(path, choice):
    data = pydicom.dcmread(first_file(path))
    count = int(data.NumberOfFrames)
    positions, rows, spacing = placed(data, count)
    order = np.argsort(positions @ np.cross(*rows))
    pixels = data.pixel_array
    planes = []
    for i in order:
        scale = group(data, i, "PixelValueTransformationSequence")
        planes.append(scaled(pixels[i], scale if scale is not None else {}).T)
    origin, last = positions[order[0]], positions[order[-1]]
    gaps = np.diff(positions[order] @ np.cross(*rows))
    if np.abs(gaps - gaps.mean()).max() > 0.05 * gaps.mean():
        raise NotRead("slices that are not evenly spaced")
    steps = np.vstack([rows[0] * spacing[1], rows[1] * spacing[0], (last - origin) / (count - 1)])
    return Reading(np.stack(planes, axis=-1), origin, steps)


def from_highdicom(volume):
    """Its axes are planes, rows, columns."""
    affine = volume.affine
    return Reading(volume.array.transpose(2, 1, 0), affine[:3, 3], affine[:3, [2, 1, 0]].T)


def highdicom_enhanced(path, choice):
    image = highdicom.imread(first_file(path))
    has_scale = choice["rescale"] != "missing"
    return oriented(from_highdicom(image.get_volume(dtype=np.float64, apply_real_world_transform=False,
                                                    apply_modality_transform=has_scale, apply_presentation_lut=False)))


def described(data, numbers_only=False):
    segments = []
    for one in data.SegmentSequence:
        lab = one.get("RecommendedDisplayCIELabValue")
        color = (0.5, 0.5, 0.5)
        if lab is not None:
            from dicom_segment_files import color as color_of
            color = color_of(list(lab))
        segments.append((int(one.SegmentNumber), str(one.SegmentLabel).strip(), color))
    return segments


def highdicom_segments(path, choice):
    data = highdicom.seg.segread(str(path))
    volume = data.get_volume(combine_segments=False, rescale_fractional=False) if str(data.SegmentationType) == "BINARY" else \
        data.get_volume(combine_segments=True)
    if str(data.SegmentationType) == "BINARY":
        merged = np.zeros(volume.array.shape[:3], np.int64)
        for i, number in enumerate(data.segment_numbers):
            merged[volume.array[..., i] > 0] = number
        affine = volume.affine
        return oriented(Reading(merged.transpose(2, 1, 0), affine[:3, 3], affine[:3, [2, 1, 0]].T, described(data)))
    reading = from_highdicom(volume)
    reading.segments = described(data)
    return oriented(reading)


def oriented(reading):
    """Planes in the order of the normal of their rows and columns, as in ours."""
    return reversed_layers(reading) if np.linalg.det(reading.steps) < 0 else reading


def pydicom_segments(path, choice):
    data = pydicom.dcmread(path)
    if data.SegmentationType == "FRACTIONAL":
        raise NotRead("fractions")
    count = int(data.NumberOfFrames)
    pixels = data.pixel_array.reshape(count, data.Rows, data.Columns)
    positions, rows, spacing = placed(data, count)
    normal = np.cross(*rows)
    heights = positions @ normal
    step = 1.3  # of the generator: the tag may be wrong, and planes may be missing
    planes = np.round((heights - heights.min()) / step).astype(int)
    voxels = np.zeros((data.Columns, data.Rows, planes.max() + 1), np.int64)
    order = range(count)
    if data.SegmentationType == "BINARY":
        numbers = [int(group(data, i, "SegmentIdentificationSequence").ReferencedSegmentNumber) for i in range(count)]
        order = np.argsort(numbers, kind="stable")
    for i in order:
        if data.SegmentationType == "BINARY":
            voxels[:, :, planes[i]][pixels[i].T > 0] = numbers[i]
        else:
            voxels[:, :, planes[i]] = pixels[i].T
    steps = np.vstack([rows[0] * spacing[1], rows[1] * spacing[0], normal * step])
    return Reading(voxels, positions[np.argmin(heights)], steps, described(data))
