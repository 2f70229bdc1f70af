# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""NIfTI files of both versions, by the offsets of nifti1.h and nifti2.h."""

import gzip
import struct

import numpy as np

import truth

TYPES = {2: "u1", 4: "i2", 8: "i4", 16: "f4", 64: "f8", 256: "i1", 512: "u2", 768: "u4", 1024: "i8", 1280: "u8"}
UNREAD_TYPES = {1: 1, 32: 64, 128: 24, 1536: 128, 2304: 32}  # bits: binary, complex, RGB, 128 bits, RGBA
UNITS = {0: 1, 1: 1000, 2: 1, 3: 1e-3}
RAS = np.array([-1, -1, 1])
CHOICES = {
    "version": [1] * 11 + [2],
    "file": [".nii"] * 6 + [".nii.gz"] * 6 + [".NII", ".hdr", ".hdr.gz"],
    "endian": ["<", "<", ">"],
    "type": list(TYPES) * 4 + list(UNREAD_TYPES)[:4],
    "scale": [(1, 0), (1, 0), (0, 0), (0, 7), (1, 5), (2, 0), (0.5, -10), (-1, 3), (float("nan"), 0)],
    "qform": [0, 1, 1, 2, 3, 4],
    "sform": [0, 1, 1, 2, 3, 4],
    "relation": ["same", "same", "same", "moved", "turned", "within rounding"],
    "axes": list(truth.AXES),
    "first of pixdim": [1, 1, -1, 0],
    "length": list(UNITS),
    "time": [0, 8, 16],
    "offset": ["usual"] * 4 + ["more", "more", "extension", "extension", "zero"],
    "dimensions": ["3"] * 12 + ["4", "4", "5", "7", "4, zeros behind", "4, two volumes", "vectors"],
    "other sizes": [0, 1, 3],
    "intent": [0, 1002, 2001],
    "text": ["none", "full"],
    "behind": [0, 0, 16],
}


def quaternion(rotation):
    """b, c, d of a rotation, a >= 0."""
    trace = np.trace(rotation)
    if trace > 1e-6 - 1:
        a = np.sqrt(max(1 + trace, 0)) / 2
        if a > 1e-3:
            return np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]]) / (4 * a)
    axis = np.sqrt(np.maximum((np.diag(rotation) + 1) / 2, 0))
    i = int(np.argmax(axis))
    signs = np.sign(rotation[i] + rotation[:, i])
    signs[i] = 1
    return axis * np.where(signs == 0, 1, signs)


def rotation_of(b, c, d):
    a = np.sqrt(max(1 - b * b - c * c - d * d, 0))
    return np.array([[a * a + b * b - c * c - d * d, 2 * b * c - 2 * a * d, 2 * b * d + 2 * a * c],
                     [2 * b * c + 2 * a * d, a * a + c * c - b * b - d * d, 2 * c * d - 2 * a * b],
                     [2 * b * d - 2 * a * c, 2 * c * d + 2 * a * b, a * a + d * d - c * c - b * b]])


def forms(choice):
    """The axes of both forms in RAS, with their origins, in the unit of the file, and the sign of the third axis."""
    axes = truth.AXES[choice["axes"]] * RAS[:, None]
    origin = truth.ORIGIN * RAS
    turned, moved = axes, origin
    if choice["relation"] == "moved":
        moved = origin + [3, -2, 1]
    if choice["relation"] == "turned":
        turned = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]) @ axes
    if choice["relation"] == "within rounding":
        moved = origin + 0.004
    u, _, v = np.linalg.svd(axes)
    rotation = u @ v
    expected_sign = -1 if np.linalg.det(rotation) < 0 else 1
    sign = choice["first of pixdim"] or 1
    if sign != expected_sign:  # the qform says what it says: the sform follows
        rotation, turned = rotation * [1, 1, -1], turned * [1, 1, -1]
    rotation = rotation * [1, 1, sign]
    return (rotation, origin, sign), (turned, moved)


def qform_steps(rotation, sign):
    b, c, d = (float(np.float32(value)) for value in quaternion(rotation))
    return (rotation_of(b, c, d) * [1, 1, sign] * truth.SPACING).T, (b, c, d)


def dimensions(choice):
    rest = {"3": [], "4": [1], "5": [1, 1], "7": [1, 1, 1, 1], "4, zeros behind": [1], "4, two volumes": [2],
            "vectors": [1, 3]}[choice["dimensions"]]
    sizes = [3 + len(rest), *truth.SIZE, *rest]
    fill = 0 if choice["dimensions"] == "4, zeros behind" else choice["other sizes"]
    return sizes + [fill] * (8 - len(sizes)), int(np.prod(rest, dtype=int))


def header(choice, sizes, bits, offset, q, s):
    """The fields that both versions have, in the order of nifti1.h, with the offsets of both."""
    order, version = choice["endian"], choice["version"]
    first = choice["first of pixdim"]
    pixdim = [first, *truth.SPACING, 1.5, 0, 0, 0]
    slope, intercept = choice["scale"]
    rows = [*(np.column_stack([(s[0] * truth.SPACING), s[1]])).ravel()]
    real, whole = ("f", "h") if version == 1 else ("d", "q")
    is_pair = choice["file"].startswith(".hdr")
    fields = [
        (40, 16, f"8{whole}", sizes), (70, 12, "h", [choice["type"]]), (72, 14, "h", [bits]), (76, 104, f"8{real}", pixdim),
        (108, 168, "f" if version == 1 else "q", [offset]), (112, 176, real, [slope]), (116, 184, real, [intercept]),
        (252, 344, "h" if version == 1 else "i", [choice["qform"]]), (254, 348, "h" if version == 1 else "i", [choice["sform"]]),
        (256, 352, f"3{real}", q[0]), (268, 376, f"3{real}", q[1]), (280, 400, f"12{real}", rows),
        (123, 500, "B" if version == 1 else "i", [choice["length"] | choice["time"]]),
        (68, 504, "h" if version == 1 else "i", [choice["intent"]])]
    buffer = bytearray(348 if version == 1 else 540)
    struct.pack_into(order + "i", buffer, 0, len(buffer))
    for one, two, form, values in fields:
        struct.pack_into(order + form, buffer, one if version == 1 else two, *values)
    if version == 1:
        buffer[344:348] = b"ni1\0" if is_pair else b"n+1\0"
    else:
        buffer[4:12] = b"ni2\0\r\n\x1a\n" if is_pair else b"n+2\0\r\n\x1a\n"
    if choice["text"] == "full":
        begin, end = (148, 252) if version == 1 else (240, 344)
        buffer[begin:end] = b"x" * (end - begin)
    return bytes(buffer)


def rejection(choice):
    return truth.sentences(
        (choice["file"].startswith(".hdr"), "it is no volume|its voxels lie in another file"),
        (choice["type"] in UNREAD_TYPES, "cannot be read|values a voxel|is damaged or of a kind"),
        (choice["dimensions"] in ("4, two volumes", "vectors"), "dimensions|values a voxel"),
        (choice["offset"] == "zero" and choice["version"] == 1, "its voxels begin inside its header"),
        (choice["version"] == 2, "it is a NIfTI-2 file"))


def position(choice, q_steps, q, s):
    """By the rule of Documentation/reference/volumes.md: origin and steps in RAS, and parts of the note."""
    sform = (s[1].astype(np.float32).astype(float), ((s[0] * truth.SPACING).astype(np.float32).T).astype(float))
    qform = (q[1].astype(np.float32).astype(float), q_steps)
    if choice["sform"] > 0 and (choice["sform"] == 1 or choice["qform"] == 0):
        return *sform, ()
    if choice["qform"] > 0:
        differ = choice["sform"] > 0 and (
            choice["relation"] in ("moved", "turned") or choice["axes"] == "sheared")
        return *qform, ("positions are those of its qform",) if differ else ()
    return np.zeros(3), np.diag(truth.SPACING * [-1, -1, 1]), ("does not say how the patient lies",)


def scaled(voxels, choice):
    """What is read: values that have a scale are real numbers."""
    slope, intercept = choice["scale"]
    if slope == 0 or np.isnan(slope) or (slope, intercept) == (1, 0):
        return voxels
    return voxels.astype(np.float64) * slope + intercept


def write(folder, choice, random):
    dtype = TYPES.get(choice["type"], "u1")
    voxels = truth.values_of(dtype, random)
    if choice["scale"] not in ((1, 0), (0, 0), (0, 7)):
        voxels = random.integers(0, 100, truth.SIZE).astype(dtype)
    sizes, count = dimensions(choice)
    q, s = forms(choice)
    q_steps, numbers = qform_steps(q[0], q[2])
    bits = UNREAD_TYPES.get(choice["type"], np.dtype(dtype).itemsize * 8)
    size = 348 if choice["version"] == 1 else 540
    is_pair = choice["file"].startswith(".hdr")
    kind = choice["offset"]
    offset = {"usual": size + 4, "more": size + 4 + 160, "extension": size + 4 + 32, "zero": size + 4}[kind]
    written = 0 if is_pair or (kind == "zero" and choice["version"] == 1) else offset
    head = header(choice, sizes, bits, written, (numbers, q[1]), s)
    extension = b"\1\0\0\0" + struct.pack(choice["endian"] + "ii", 32, 6) + b"a comment".ljust(24, b"\0")
    head += extension if kind == "extension" else b"\0" * 4
    raw = voxels.astype(voxels.dtype.newbyteorder(choice["endian"])).tobytes(order="F") * count
    raw = raw.ljust(bits * voxels.size // 8 * count, b"\0") + b"\7" * choice["behind"]
    pack = gzip.compress if choice["file"].endswith(".gz") else bytes
    path = folder / ("a" + choice["file"])
    if is_pair:
        path.write_bytes(pack(head))
        (folder / ("a" + choice["file"].replace("hdr", "img"))).write_bytes(pack(raw))
    else:
        path.write_bytes(pack(head.ljust(offset, b"\0") + raw))
    origin, steps, notes = position(choice, q_steps, q, s)
    unit = UNITS[choice["length"]]
    notes += ("lengths are converted",) if unit != 1 else ()
    return path, truth.Truth(scaled(voxels, choice), origin * RAS * unit, steps * RAS * unit, rejected=rejection(choice), notes=notes, unit=unit)
