# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Folders of DICOM slices, one a file."""

import numpy as np

import dicom_bytes
import truth

CT, MR = "1.2.840.10008.5.1.4.1.1.2", "1.2.840.10008.5.1.4.1.1.4"
SYNTAXES = {"explicit": dicom_bytes.EXPLICIT, "implicit": dicom_bytes.IMPLICIT, "big": dicom_bytes.BIG,
            "deflated": dicom_bytes.DEFLATED, "rle": dicom_bytes.RLE}
# Bits allocated, stored; signed.
PIXELS = {"12 of 16": (16, 12, 0), "16": (16, 16, 0), "16 signed": (16, 16, 1), "12 of 16 signed": (16, 12, 1), "8": (8, 8, 0),
          "8 signed": (8, 8, 1)}
# Heights of slices whose distances change, in distances of slices (uneven_files.py).
HEIGHTS = {"finer below": (0, 1, 2, 3, 5, 7, 9), "finer above": (0, 2, 4, 6, 7, 8, 9), "one missing at the end": (0, 1, 2, 3, 4, 5, 7),
           "every third missing": (0, 1, 3, 4, 6, 7, 9)}
CHOICES = {
    "syntax": list(SYNTAXES),
    "pixels": list(PIXELS),
    "modality": ["CT", "CT", "CT", "MR"],
    "rescale": [("1", "-1024"), ("1", "0"), ("1.0", "-1024.0"), ("0.5", "-10"), ("2E0", "0"), ("-1", "5"), None, "by slice"],
    "padding": ["none", "none", "none", "value", "range", "range backward", "signed as US"],
    "names": ["in order", "backward", "shuffled", "without extension", "upper case"],
    "instances": ["in order", "missing", "backward", "all equal"],
    "axes": ["straight", "turned about z", "permuted", "oblique", "four decimals", "sheared"],
    "decimals": ["16 characters", "6", "3", "exponent", "spaces"],
    "spacing": ["usual", "thickness missing", "thickness wrong", "between slices wrong", "five decimals"],
    "photometric": ["MONOCHROME2", "MONOCHROME2", "MONOCHROME2", "MONOCHROME1"],
    "others": ["none"] * 6 + ["report", "copy", "localizer", "text", "another series"],
    "slices": ["all"] * 10 + ["one missing", "one aside", "at one position"],
    "frame": ["missing", "1"],
    "uids": ["usual", "without instance"],
    "private": ["none", "private", "sequence", "undefined lengths"],
    "behind": [False, False, True],
}


def number(value, style):
    """Of at most 16 characters."""
    if style == "exponent":
        return f"{value:.8E}"
    if style in ("3", "6"):
        return f"{value:.{style}f}"
    text = f"{value:.16g}"
    digits = 16
    while len(text) > (15 if style == "spaces" else 16):
        digits -= 1
        text = f"{value:.{digits}g}"
    return f" {text}" if style == "spaces" else text


def stored_values(choice, random):
    """[x, y, z] and the type."""
    allocated, stored, is_signed = PIXELS[choice["pixels"]]
    dtype = np.dtype(f"{'i' if is_signed else 'u'}{allocated // 8}")
    low, high = (-(1 << stored - 1), (1 << stored - 1) - 1) if is_signed else (0, (1 << stored) - 1)
    values = random.integers(low, high, truth.SIZE, endpoint=True)
    if choice["padding"] == "none":
        values.flat[:2] = [low, high]
    else:
        values = np.clip(values, low + 10, high)
        values[0, :, :] = low
        values[1, 0, :] = low + 2
    return values.astype(dtype), low


def padding_of(choice, low):
    """Elements, and the values that are padding."""
    kind = choice["padding"]
    is_signed = PIXELS[choice["pixels"]][2]
    vr = "SS" if is_signed else "US"
    if kind == "none":
        return [], None
    if kind == "value":
        return [(0x00280120, vr, low)], (low, low)
    if kind == "range":
        return [(0x00280120, vr, low), (0x00280121, vr, low + 4)], (low, low + 4)
    if kind == "range backward":
        return [(0x00280120, vr, low + 4), (0x00280121, vr, low)], (low, low + 4)
    return [(0x00280120, "US", low & 0xffff)], (low, low)


def scale_of(choice, k):
    """Texts of slope and intercept."""
    return ("1", str(-1000 - k)) if choice["rescale"] == "by slice" else choice["rescale"]


def scaled(stored, choice, padding):
    """What is read, mm: padding is air, or the least other value of the slice."""
    voxels = stored.astype(np.float64)
    for k in range(voxels.shape[2]):
        slope, intercept = map(float, scale_of(choice, k) or (1, 0))
        voxels[:, :, k] = voxels[:, :, k] * slope + intercept
        if padding:
            is_padding = (stored[:, :, k] >= padding[0]) & (stored[:, :, k] <= padding[1])
            others = voxels[:, :, k][~is_padding]
            least = others.min() if choice["modality"] != "CT" else min(others.min(), -1000)
            voxels[:, :, k][is_padding] = least
    return voxels


def header(choice, k, position, steps, sizes):
    style = choice["decimals"]
    data = dicom_bytes.DataSet()
    data.set(0x00080016, "UI", CT if choice["modality"] == "CT" else MR)
    if choice["uids"] == "usual":
        data.set(0x00080018, "UI", f"1.2.826.0.1.3680043.10.999.1.{k + 1}")
    data.set(0x00080060, "CS", choice["modality"]).set(0x00100010, "PN", "Example")
    data.set(0x0020000d, "UI", "1.2.826.0.1.3680043.10.999.2").set(0x0020000e, "UI", "1.2.826.0.1.3680043.10.999.3")
    instance = {"in order": k + 1, "backward": 100 - k, "all equal": 1, "missing": None}[choice["instances"]]
    if instance is not None:
        data.set(0x00200013, "IS", instance)
    spacing = np.linalg.norm(steps, axis=1)
    directions = steps[:2] / spacing[:2, None]
    if choice["axes"] == "four decimals":
        directions = np.round(directions, 4)
    data.set(0x00200032, "DS", [number(value, style) for value in position])
    data.set(0x00200037, "DS", [number(value, style if style != "3" else "6") for value in directions.ravel()])
    between = "5.0" if choice["spacing"] == "between slices wrong" else number(spacing[2], "6")
    thickness = {"thickness missing": None, "thickness wrong": "7.5"}.get(choice["spacing"], number(spacing[2], "6"))
    if thickness:
        data.set(0x00180050, "DS", thickness)
    data.set(0x00180088, "DS", between)
    form = ".5f" if choice["spacing"] == "five decimals" else ".6g"
    data.set(0x00280030, "DS", [format(spacing[1], form), format(spacing[0], form)])
    allocated, stored, is_signed = PIXELS[choice["pixels"]]
    for tag, value in ((0x00280002, 1), (0x00280010, sizes[1]), (0x00280011, sizes[0]), (0x00280100, allocated),
                       (0x00280101, stored), (0x00280102, stored - 1), (0x00280103, is_signed)):
        data.set(tag, "US", value)
    data.set(0x00280004, "CS", choice["photometric"])
    if choice["frame"] == "1":
        data.set(0x00280008, "IS", 1)
    scale = scale_of(choice, k)
    if scale:
        data.set(0x00281053, "DS", scale[0]).set(0x00281052, "DS", scale[1])
    if choice["private"] == "private":
        data.set(0x00090010, "LO", "EXAMPLE").set(0x00091001, "UN", b"\1\2\3\4").set(0x00291010, "LO", "x")
    if choice["private"] in ("sequence", "undefined lengths"):
        item = dicom_bytes.DataSet().set(0x00080100, "SH", "T-D0050").set(0x00200032, "DS", ["9", "9", "9"])
        data.set(0x00082218, "SQ", [item, dicom_bytes.DataSet()])
    return data


def file_of(choice, data, values):
    syntax = SYNTAXES[choice["syntax"]]
    size = PIXELS[choice["pixels"]][0] // 8
    vr = "OW" if size == 2 or syntax == dicom_bytes.IMPLICIT else "OB"
    little = values.astype(values.dtype.newbyteorder("<")).tobytes(order="F")
    pixels = dicom_bytes.pixel_element(little, syntax, vr, values.shape[0], size, 1)
    behind = dicom_bytes.DataSet().set(0xfffcfffc, "OB", b"\0" * 8).bytes(syntax) if choice["behind"] else b""
    return dicom_bytes.file_bytes(data, pixels, syntax, choice["private"] == "undefined lengths", behind)


def names(choice, count, random):
    orders = {"backward": list(range(count))[::-1], "shuffled": random.permutation(count).tolist()}
    order = orders.get(choice["names"], list(range(count)))
    extension = {"without extension": "", "upper case": ".DCM"}.get(choice["names"], ".dcm")
    return [f"I{number:04}{extension}" for number in order]


def write_others(folder, choice, data, first):
    """Files that are no slices of the series."""
    if choice["others"] == "report":
        report = dicom_bytes.DataSet().set(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.88.11").set(0x00080060, "CS", "SR")
        (folder / "report.dcm").write_bytes(dicom_bytes.file_bytes(report, b"", dicom_bytes.EXPLICIT))
    if choice["others"] == "copy" and choice["uids"] == "usual":
        (folder / "copy.dcm").write_bytes(first)
    if choice["others"] == "text":
        (folder / "readme.txt").write_text("slices of a bone")
    if choice["others"] in ("localizer", "another series"):
        for k in range(2):
            other = dicom_bytes.DataSet()
            other.elements.update(data.elements)
            other.set(0x00080018, "UI", f"1.2.826.0.1.3680043.10.999.7.{k}")
            other.set(0x00200032, "DS", ["0", "0", str(10 * k)])
            if choice["others"] == "localizer":
                other.set(0x00200037, "DS", ["0", "1", "0", "0", "0", "-1"])
            else:
                other.set(0x0020000e, "UI", "1.2.826.0.1.3680043.10.999.8")
            allocated = PIXELS[choice["pixels"]][0]
            (folder / f"other{k}.dcm").write_bytes(file_of(choice, other, np.zeros(truth.SIZE[:2], f"u{allocated // 8}")))


def positions(choice, origin, steps):
    """Of the slices that are written, with their index."""
    heights = HEIGHTS.get(choice["slices"], range(truth.SIZE[2]))
    located = [(k, origin + height * steps[2]) for k, height in enumerate(heights)]
    if choice["slices"] == "one missing":
        del located[3]
    if choice["slices"] == "one aside":
        located[3] = (3, located[3][1] + 2 * steps[0])
    if choice["slices"] == "at one position":
        located[3] = (3, located[2][1])
    return located


def notes_of(choice):
    if choice["others"] == "report":
        return ("left aside",)
    if choice["others"] == "copy" and choice["uids"] == "usual":
        return ("copies of others",)
    return ("series",) if choice["others"] in ("localizer", "another series") else ()


def rejection(choice):
    return truth.sentences(
        ("missing" in choice["slices"], "its slices are not evenly spaced"),
        (choice["slices"] == "one aside", "beside the line"),
        (choice["slices"] == "at one position", "at the same position"))


def write(folder, choice, random):
    origin, steps = truth.position_of(choice["axes"])
    if choice["axes"] == "four decimals":  # of the directions in the header; the positions are exact
        origin, exact = truth.position_of("oblique")
        steps = np.vstack([steps[:2], exact[2:]])
    stored, low = stored_values(choice, random)
    elements, padding = padding_of(choice, low)
    series = folder / "series"
    series.mkdir()
    first = b""
    for name, (k, position) in zip(names(choice, truth.SIZE[2], random), positions(choice, origin, steps)):
        data = header(choice, k, position, steps, truth.SIZE)
        for element in elements:
            data.set(*element)
        content = file_of(choice, data, stored[:, :, k])
        first = first or content
        (series / name).write_bytes(content)
    write_others(series, choice, data, first)
    expected = truth.Truth(scaled(stored, choice, padding), origin, steps, rejected=rejection(choice), notes=notes_of(choice))
    if choice["slices"] in HEIGHTS:
        heights = np.array(HEIGHTS[choice["slices"]])
        mean = heights[-1] / (len(heights) - 1)
        expected.steps, expected.layers = steps * [[1], [1], [mean]], heights / mean
        expected.notes += ("they are read where they are",)
    return series, expected
