# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Enhanced CT and MR images: all slices are frames of one file."""

import numpy as np

import dicom_bytes
import truth
from dicom_files import PIXELS, SYNTAXES, number

CT, MR = "1.2.840.10008.5.1.4.1.1.2.1", "1.2.840.10008.5.1.4.1.1.4.1"
CHOICES = {
    "syntax": list(SYNTAXES),
    "pixels": ["12 of 16", "16", "16 signed", "12 of 16 signed"],
    "modality": ["CT", "CT", "MR"],
    "frames": ["in order", "backward", "shuffled"],
    "rescale": ["shared", "by frame", "missing", "one a frame"],
    "orientation": ["shared", "by frame"],
    "measures": ["shared", "by frame"],
    "axes": ["straight", "turned about z", "permuted", "oblique", "four decimals", "sheared"],
    "decimals": ["16 characters", "6", "exponent", "spaces"],
    "undefined lengths": [False, True],
    "offsets": [True, False],
    "dimensions": ["none", "indices", "stack"],
    "input": ["file", "folder"],
    "others": ["none", "private"],
    "slices": ["all"] * 8 + ["one missing", "one without a position"],
    "photometric": ["MONOCHROME2", "MONOCHROME2", "MONOCHROME1"],
}


def scale_of(choice, k):
    return {"missing": None, "one a frame": (1, -1000 - k), "shared": (1, -1024), "by frame": (0.5, -10)}[choice["rescale"]]


def transformation(scale):
    data = dicom_bytes.DataSet().set(0x00281052, "DS", scale[1]).set(0x00281053, "DS", scale[0])
    return data.set(0x00281054, "LO", "HU")


def groups(choice, order, origin, steps):
    spacing = np.linalg.norm(steps, axis=1)
    directions = (steps[:2] / spacing[:2, None]).ravel()
    directions = np.round(directions, 4) if choice["axes"] == "four decimals" else directions
    orientation = dicom_bytes.DataSet().set(0x00200037, "DS", [number(value, choice["decimals"]) for value in directions])
    measures = dicom_bytes.DataSet().set(0x00280030, "DS", [f"{spacing[1]:.6g}", f"{spacing[0]:.6g}"]).set(0x00180050, "DS", "7")
    shared, per_frame = dicom_bytes.DataSet(), []
    for name, tag, group in (("orientation", 0x00209116, orientation), ("measures", 0x00289110, measures)):
        if choice[name] == "shared":
            shared.set(tag, "SQ", [group])
    if choice["rescale"] == "shared":
        shared.set(0x00289145, "SQ", [transformation(scale_of(choice, 0))])
    for position, k in enumerate(order):
        point = [number(value, choice["decimals"]) for value in origin + k * steps[2]]
        frame = dicom_bytes.DataSet()
        if not (choice["slices"] == "one without a position" and position == 2):
            frame.set(0x00209113, "SQ", [dicom_bytes.DataSet().set(0x00200032, "DS", point)])
        content = dicom_bytes.DataSet().set(0x00209157, "UL", [k + 1]).set(0x00209056, "SH", "1").set(0x00209057, "UL", k + 1)
        if choice["dimensions"] != "none":
            frame.set(0x00209111, "SQ", [content])
        for name, tag, group in (("orientation", 0x00209116, orientation), ("measures", 0x00289110, measures)):
            if choice[name] == "by frame":
                frame.set(tag, "SQ", [group])
        if choice["rescale"] in ("by frame", "one a frame"):
            frame.set(0x00289145, "SQ", [transformation(scale_of(choice, k))])
        per_frame.append(frame)
    return shared, per_frame


def header(choice, order, origin, steps):
    data = dicom_bytes.DataSet().set(0x00080016, "UI", CT if choice["modality"] == "CT" else MR)
    data.set(0x00080018, "UI", "1.2.826.0.1.3680043.10.999.5").set(0x00080060, "CS", choice["modality"])
    data.set(0x0020000d, "UI", "1.2.826.0.1.3680043.10.999.2").set(0x0020000e, "UI", "1.2.826.0.1.3680043.10.999.3")
    data.set(0x00200052, "UI", "1.2.826.0.1.3680043.10.999.6")
    allocated, stored, is_signed = PIXELS[choice["pixels"]]
    for tag, value in ((0x00280002, 1), (0x00280010, truth.SIZE[1]), (0x00280011, truth.SIZE[0]), (0x00280100, allocated),
                       (0x00280101, stored), (0x00280102, stored - 1), (0x00280103, is_signed)):
        data.set(tag, "US", value)
    data.set(0x00280004, "CS", choice["photometric"]).set(0x00280008, "IS", len(order))
    if choice["dimensions"] == "indices":
        pointer = dicom_bytes.DataSet().set(0x00209165, "AT", [0x00200032]).set(0x00209167, "AT", [0x00209113])
        data.set(0x00209222, "SQ", [pointer])
    if choice["others"] == "private":
        data.set(0x00090010, "LO", "EXAMPLE").set(0x00091001, "UN", b"\1\2\3\4")
    shared, per_frame = groups(choice, order, origin, steps)
    return data.set(0x52009229, "SQ", [shared]).set(0x52009230, "SQ", per_frame)


def order_of(choice, random):
    order = list(range(truth.SIZE[2]))
    if choice["slices"] == "one missing":
        del order[3]
    if choice["frames"] == "backward":
        order.reverse()
    return [order[i] for i in random.permutation(len(order))] if choice["frames"] == "shuffled" else order


def rejection(choice):
    return truth.sentences(
        (choice["slices"] == "one missing", "its slices are not evenly spaced"),
        (choice["slices"] == "one without a position", "does not say where each lies"))


def write(folder, choice, random):
    origin, steps = truth.position_of(choice["axes"])
    if choice["axes"] == "four decimals":
        origin, exact = truth.position_of("oblique")
        steps = np.vstack([steps[:2], exact[2:]])
    allocated, stored_bits, is_signed = PIXELS[choice["pixels"]]
    low, high = (-(1 << stored_bits - 1), (1 << stored_bits - 1) - 1) if is_signed else (0, (1 << stored_bits) - 1)
    stored = random.integers(low, high, truth.SIZE, endpoint=True).astype(f"{'i' if is_signed else 'u'}{allocated // 8}")
    order = order_of(choice, random)
    data = header(choice, order, origin, steps)
    syntax = SYNTAXES[choice["syntax"]]
    raw = b"".join(stored[:, :, k].astype(stored.dtype.newbyteorder("<")).tobytes(order="F") for k in order)
    pixels = dicom_bytes.pixel_element(raw, syntax, "OW", truth.SIZE[0], allocated // 8, len(order), choice["offsets"])
    content = dicom_bytes.file_bytes(data, pixels, syntax, choice["undefined lengths"])
    path = folder / "image.dcm"
    if choice["input"] == "folder":
        path = folder / "series"
        path.mkdir()
        (path / "IMG1").write_bytes(content)
    else:
        path.write_bytes(content)
    voxels = stored.astype(np.float64)
    for k in range(truth.SIZE[2]):
        slope, intercept = scale_of(choice, k) or (1, 0)
        voxels[:, :, k] = voxels[:, :, k] * slope + intercept
    return path, truth.Truth(voxels, origin, steps, rejected=rejection(choice))
