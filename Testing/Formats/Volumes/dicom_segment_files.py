# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""DICOM segmentations: BINARY and LABELMAP."""

import numpy as np

import dicom_bytes
import truth
from dicom_files import SYNTAXES, number

NAMES = {
    "plain": ("", ["Femur", "Tibia", "Fibula"]),
    "UTF-8": ("ISO_IR 192", ["F\u00e9mur", "\u9aa8", "\u039a\u03bd\u03ae\u03bc\u03b7"]),
    "Latin 1": ("ISO_IR 100", ["F\u00e9mur", "Knochen, gro\u00df", "os \u00e0 c\u00f4t\u00e9"]),
    "signs": ("", ["a=b", "50 % (left)", "\"x\" 'y'"]),
    "blanks": ("", ["left femur", " Tibia", "Fibula "]),
}
LABS = [(43803, 26565, 37722), (20000, 40000, 30000), (65535, 32896, 32896)]
CHOICES = {
    "type": ["BINARY", "BINARY", "LABELMAP", "LABELMAP of 16 bits", "FRACTIONAL"],
    "syntax": ["explicit", "explicit", "implicit", "rle", "big", "deflated"],
    "segments": [1, 2, 3],
    "numbers": ["usual", "usual", "gaps"],
    "names": list(NAMES),
    "color": [True, True, False],
    "overlap": [False, True],
    "frames": ["by segment", "by plane", "shuffled", "backward"],
    "empty frames": ["kept", "left out", "left out"],
    "axes": ["straight", "turned about z", "permuted", "oblique", "four decimals"],
    "decimals": ["16 characters", "6", "exponent", "spaces"],
    "measures": ["shared", "by frame", "shared, without distance", "wrong distance"],
    "orientation": ["shared", "by frame"],
    "undefined lengths": [False, True],
    "offsets": [True, False],
    "odd": [False, True],  # rows of 5 pixels are packed across bytes
    "others": ["none", "private", "without codes"],
}


def sizes_of(choice):
    return (5, 5, 7) if choice["odd"] else truth.SIZE


def numbers_of(choice):
    step = 3 if choice["numbers"] == "gaps" and choice["type"] != "BINARY" else 1
    return [1 + step * i for i in range(choice["segments"])]


def masks_of(choice, random):
    sizes = sizes_of(choice)
    owner = random.integers(-1, choice["segments"], sizes)
    owner[:, :, 2] = -1 if choice["empty frames"] == "left out" else owner[:, :, 2]
    owner[:, :, [0, -1]] = 0  # frames at both ends
    masks = [owner == i for i in range(choice["segments"])]
    if choice["overlap"] and choice["type"] == "BINARY" and choice["segments"] > 1:
        masks[0] |= random.integers(0, 3, sizes) == 0
        masks[0][:, :, 2] &= choice["empty frames"] != "left out"
    return masks


def frames_of(choice, masks, numbers, random):
    """(segment or None, plane, pixels) in the order of the file."""
    planes = range(sizes_of(choice)[2])
    if choice["type"] != "BINARY" and choice["type"] != "FRACTIONAL":
        values = sum(mask * number for mask, number in zip(masks, numbers))
        frames = [(None, k, values[:, :, k]) for k in planes if choice["empty frames"] == "kept" or values[:, :, k].any()]
    else:
        frames = [(number, k, mask[:, :, k]) for mask, number in zip(masks, numbers) for k in planes
                  if choice["empty frames"] == "kept" or mask[:, :, k].any()]
    if choice["frames"] == "by plane":
        frames.sort(key=lambda frame: frame[1])
    if choice["frames"] == "backward":
        frames.reverse()
    if choice["frames"] == "shuffled":
        frames = [frames[i] for i in random.permutation(len(frames))]
    return frames


def item(**_none):
    return dicom_bytes.DataSet()


def measures(choice, spacing):
    data = item().set(0x00280030, "DS", [f"{spacing[1]:.6g}", f"{spacing[0]:.6g}"]).set(0x00180050, "DS", f"{spacing[2]:.6g}")
    if choice["measures"] == "wrong distance":
        data.set(0x00180088, "DS", "5.0")
    elif choice["measures"] != "shared, without distance":
        data.set(0x00180088, "DS", f"{spacing[2]:.6g}")
    return data


def groups(choice, frames, origin, steps):
    """Shared and per-frame functional groups."""
    spacing = np.linalg.norm(steps, axis=1)
    directions = (steps[:2] / spacing[:2, None]).ravel()
    if choice["axes"] == "four decimals":
        directions = np.round(directions, 4)
    orientation = item().set(0x00200037, "DS", [number(value, choice["decimals"]) for value in directions])
    shared, per_frame = item(), []
    if choice["measures"] != "by frame":
        shared.set(0x00289110, "SQ", [measures(choice, spacing)])
    if choice["orientation"] == "shared":
        shared.set(0x00209116, "SQ", [orientation])
    for segment, plane, _pixels in frames:
        point = [number(value, choice["decimals"]) for value in origin + plane * steps[2]]
        group = item().set(0x00209113, "SQ", [item().set(0x00200032, "DS", point)])
        group.set(0x00209111, "SQ", [item().set(0x00209157, "UL", [segment, plane + 1] if segment else [plane + 1])])
        if segment is not None:
            group.set(0x0062000a, "SQ", [item().set(0x0062000b, "US", segment)])
        if choice["measures"] == "by frame":
            group.set(0x00289110, "SQ", [measures(choice, spacing)])
        if choice["orientation"] == "by frame":
            group.set(0x00209116, "SQ", [orientation])
        per_frame.append(group)
    return shared, per_frame


def encoded(text, terms):
    return text.encode("latin-1" if terms == "ISO_IR 100" else "utf-8")


def segment_items(choice, numbers):
    terms, names = NAMES[choice["names"]]
    items = []
    for i, number_ in enumerate(numbers):
        data = item().set(0x00620004, "US", number_).set(0x00620005, "LO", encoded(names[i], terms)).set(0x00620008, "CS", "MANUAL")
        if choice["color"]:
            data.set(0x0062000d, "US", LABS[i])
        if choice["others"] != "without codes":
            code = item().set(0x00080100, "SH", "T-D016E").set(0x00080102, "SH", "SRT").set(0x00080104, "LO", "Bone")
            data.set(0x00620003, "SQ", [code]).set(0x0062000f, "SQ", [code]).set(0x00620020, "UT", "1")
        items.append(data)
    return items


def header(choice, numbers, frames, origin, steps):
    sizes, terms = sizes_of(choice), NAMES[choice["names"]][0]
    is_map = choice["type"].startswith("LABELMAP")
    bits = 16 if choice["type"].endswith("16 bits") else 8 if choice["type"] != "BINARY" else 1
    data = item()
    if terms:
        data.set(0x00080005, "CS", terms)
    data.set(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.7" if is_map else "1.2.840.10008.5.1.4.1.1.66.4")
    data.set(0x00080018, "UI", "1.2.826.0.1.3680043.10.999.4").set(0x00080060, "CS", "SEG")
    data.set(0x00200052, "UI", "1.2.826.0.1.3680043.10.999.6").set(0x0020000e, "UI", "1.2.826.0.1.3680043.10.999.3")
    data.set(0x0020000d, "UI", "1.2.826.0.1.3680043.10.999.2").set(0x00280004, "CS", "MONOCHROME2")
    data.set(0x00280008, "IS", len(frames)).set(0x00620001, "CS", choice["type"].split()[0])
    for tag, value in ((0x00280002, 1), (0x00280010, sizes[1]), (0x00280011, sizes[0]), (0x00280100, bits), (0x00280101, bits),
                       (0x00280102, bits - 1), (0x00280103, 0)):
        data.set(tag, "US", value)
    if is_map:
        data.set(0x00280120, "US", 0)
    if choice["type"] == "FRACTIONAL":
        data.set(0x00620010, "CS", "PROBABILITY").set(0x0062000e, "US", 255)
    shared, per_frame = groups(choice, frames, origin, steps)
    pointers = [item().set(0x00209165, "AT", [0x0062000b]).set(0x00209167, "AT", [0x0062000a])] if not is_map else []
    pointers.append(item().set(0x00209165, "AT", [0x00200032]).set(0x00209167, "AT", [0x00209113]))
    data.set(0x00209222, "SQ", pointers)
    data.set(0x00620002, "SQ", segment_items(choice, numbers)).set(0x52009229, "SQ", [shared]).set(0x52009230, "SQ", per_frame)
    if choice["others"] == "private":
        data.set(0x00090010, "LO", "EXAMPLE").set(0x00091001, "UN", b"\1\2\3\4")
    return data, bits


def rejection(choice):
    is_binary = choice["type"] == "BINARY"
    return truth.sentences(
        (choice["type"] == "FRACTIONAL", "it holds a fractional segmentation"),
        (choice["syntax"] in ("big", "deflated") or (is_binary and choice["syntax"] == "rle"), "its pixels are compressed or stored"))


def color(lab):
    """D65, as DCMTK and highdicom have it."""
    f = np.array([0, 0, 0], float)
    lightness, a, b = lab[0] * 100 / 65535, lab[1] * 255 / 65535 - 128, lab[2] * 255 / 65535 - 128
    f[1] = (lightness + 16) / 116
    f[0], f[2] = f[1] + a / 500, f[1] - b / 200
    xyz = np.where(f > 6 / 29, f ** 3, 3 * (6 / 29) ** 2 * (f - 4 / 29)) * [0.950456, 1, 1.088754]
    linear = np.array([[3.2404542, -1.5371385, -0.4985314], [-0.969266, 1.8760108, 0.041556], [0.0556434, -0.2040259, 1.0572252]]) @ xyz
    return tuple(np.clip(np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 0) ** (1 / 2.4) - 0.055), 0, 1))


def write(folder, choice, random):
    origin, steps = truth.position_of(choice["axes"])
    if choice["axes"] == "four decimals":
        origin, exact = truth.position_of("oblique")
        steps = np.vstack([steps[:2], exact[2:]])
    sizes, numbers = sizes_of(choice), numbers_of(choice)
    masks = masks_of(choice, random)
    frames = frames_of(choice, masks, numbers, random)
    data, bits = header(choice, numbers, frames, origin, steps)
    pixels = np.concatenate([frame.ravel(order="F") for _segment, _plane, frame in frames]).astype(f"u{max(bits // 8, 1)}")
    raw = np.packbits(pixels, bitorder="little").tobytes() if bits == 1 else pixels.astype(pixels.dtype.newbyteorder("<")).tobytes()
    syntax = SYNTAXES[choice["syntax"]]
    if bits == 1 and choice["syntax"] == "rle":
        raw = pixels.tobytes()
    element = dicom_bytes.pixel_element(raw, syntax, "OW" if bits == 16 or choice["syntax"] == "implicit" else "OB", sizes[0],
                                        max(bits // 8, 1), len(frames), choice["offsets"])
    path = folder / "a.dcm"
    path.write_bytes(dicom_bytes.file_bytes(data, element, syntax, choice["undefined lengths"]))
    voxels = np.zeros(sizes, np.int64)
    for mask, number_ in zip(masks, numbers):
        voxels[mask] = number_
    names = [name.strip() for name in NAMES[choice["names"]][1]]
    segments = [(number_, names[i], color(LABS[i]) if choice["color"] else (0.5, 0.5, 0.5)) for i, number_ in enumerate(numbers)]
    notes = ["are in more than one segment"] if np.sum(masks, axis=0).max() > 1 else []
    planes = {plane for _segment, plane, _pixels in frames}
    notes += ["planes have no frame"] if len(planes) < sizes[2] else []
    return path, truth.Truth(voxels, origin, steps, segments, rejected=rejection(choice), notes=tuple(notes))
