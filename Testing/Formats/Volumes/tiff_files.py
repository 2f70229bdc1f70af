# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""TIFF: files of several pages, and folders of slices, by TIFF 6.0 and the notes on BigTIFF."""

import struct
import zlib

import numpy as np

import dicom_bytes
import truth

TYPES = {"u1": (8, 1), "u2": (16, 1), "u4": (32, 1), "i1": (8, 2), "i2": (16, 2), "i4": (32, 2), "f4": (32, 3), "f8": (64, 3)}
CODES = {"H": 3, "I": 4, "Q": 16, "2I": 5, "s": 2}
CHOICES = {
    "input": ["pages", "pages", "pages", "folder"],
    "endian": ["<", "<", ">"],
    "big": [False, False, True],
    "type": list(TYPES),
    "compression": ["none", "none", "deflate", "old deflate", "packbits"],
    "predictor": [1, 1, 2],
    "layout": ["one strip", "rows of two", "a row a strip", "tiles"],
    "sample format": ["present", "missing where possible"],
    "samples": ["present", "missing"],
    "photometric": [1, 1, 1, 1, 0],
    "planar": ["missing", 1, 2],
    "resolution": ["none", "inches", "centimeters"],
    "text": ["none", "ImageJ", "OME", "software"],
    "directories": ["behind the pixels", "in front"],
    "orientation": ["missing", 1],
    "fill order": ["missing", 1],
    "names": ["bone_8.tif", "0008.tif", "8.TIFF", "slice8_of.tif"],
    "size": [(5, 6, 7), (20, 17, 3)],
}


def compressed(block, choice):
    """@param block Rows of values in the byte order of the file."""
    if choice["compression"] == "none":
        return block.tobytes()
    if choice["compression"] == "packbits":
        return b"".join(dicom_bytes.packed_bits(row.tobytes()) for row in block)
    return zlib.compress(block.tobytes())


def predicted(block, choice):
    """Horizontal differences, in the byte order of the system."""
    if choice["predictor"] == 2 and choice["compression"] in ("deflate", "old deflate") and block.dtype.kind in "iu":
        first = block[:, :1]
        with np.errstate(over="ignore"):
            return np.hstack([first, block[:, 1:] - block[:, :-1]]).astype(block.dtype)
    return block


def blocks_of(page, choice):
    """Blocks of pixels, and the tags of their size. @param page [y, x]"""
    height, width = page.shape
    if choice["layout"] == "tiles":
        padded = np.zeros((-(-height // 16) * 16, -(-width // 16) * 16), page.dtype)
        padded[:height, :width] = page
        blocks = [padded[y:y + 16, x:x + 16] for y in range(0, padded.shape[0], 16) for x in range(0, padded.shape[1], 16)]
        return blocks, [(322, "I", [16]), (323, "I", [16])], (324, 325)
    rows = {"one strip": height, "rows of two": 2, "a row a strip": 1}[choice["layout"]]
    return [page[y:y + rows] for y in range(0, height, rows)], [(278, "I", [rows])], (273, 279)


def tags_of(page, choice, offsets, counts, more, where):
    bits, form = TYPES[page.dtype.str[1:]]
    compression = {"none": 1, "deflate": 8, "old deflate": 32946, "packbits": 32773}[choice["compression"]]
    number = "Q" if choice["big"] else "I"
    tags = [(256, "I", [page.shape[1]]), (257, "I", [page.shape[0]]), (258, "H", [bits]), (259, "H", [compression]),
            (262, "H", [choice["photometric"]]), (where[0], number, offsets), (where[1], number, counts), *more]
    if choice["samples"] == "present":
        tags.append((277, "H", [1]))
    if form != 1 or choice["sample format"] == "present":
        tags.append((339, "H", [form]))
    if choice["planar"] != "missing":
        tags.append((284, "H", [choice["planar"]]))
    if choice["resolution"] != "none":
        tags += [(282, "2I", [254, 10]), (283, "2I", [254, 10]), (296, "H", [2 if choice["resolution"] == "inches" else 3])]
    if choice["orientation"] == 1:
        tags.append((274, "H", [1]))
    if choice["fill order"] == 1:
        tags.append((266, "H", [1]))
    if choice["predictor"] == 2 and choice["compression"] in ("deflate", "old deflate") and form != 3:
        tags.append((317, "H", [2]))
    text = {"ImageJ": (270, b"ImageJ=1.53\nimages=7\nslices=7\nspacing=2.5\nunit=um\n\0"), "software": (305, b"a program\0"),
            "OME": (270, b"<OME><Image/></OME>\0")}.get(choice["text"])
    if text:
        tags.append((text[0], "s", text[1]))
    return sorted(tags)


class Writer:
    def __init__(self, choice):
        self.choice = choice
        self.order = choice["endian"]
        mark = b"II" if self.order == "<" else b"MM"
        self.is_big = choice["big"]
        self.data = bytearray(mark + struct.pack(self.order + ("HHHQ" if self.is_big else "HI"), *(
            (43, 8, 0, 0) if self.is_big else (42, 0))))
        self.link = 8 if self.is_big else 4

    def align(self):
        self.data += b"\0" * (-len(self.data) % 8)

    def put(self, data):
        self.align()
        at = len(self.data)
        self.data += data
        return at

    def set_link(self, at):
        struct.pack_into(self.order + ("Q" if self.is_big else "I"), self.data, self.link, at)

    def directory(self, tags):
        width = 8 if self.is_big else 4
        size = (8 + 20 * len(tags) + 8) if self.is_big else (2 + 12 * len(tags) + 4)
        entries = []
        for tag, form, values in tags:
            data = values if form == "s" else struct.pack(
                f"{self.order}{len(values)}{form[-1]}", *values)
            count = len(values) // (2 if form == "2I" else 1)
            field = data.ljust(width, b"\0") if len(data) <= width else struct.pack(
                self.order + ("Q" if self.is_big else "I"), self.put(data))
            entries.append(struct.pack(self.order + ("HHQ" if self.is_big else "HHI"), tag, CODES[form], count) + field)
        self.align()
        at = len(self.data)
        self.set_link(at)
        self.data += struct.pack(self.order + ("Q" if self.is_big else "H"), len(tags)) + b"".join(entries)
        self.link = len(self.data)
        self.data += b"\0" * width
        assert len(self.data) - at == size

    def page(self, page):
        blocks, more, where = blocks_of(page, self.choice)
        offsets, counts = [], []
        for block in blocks:
            data = compressed(predicted(block, self.choice).astype(block.dtype.newbyteorder(self.order)), self.choice)
            offsets.append(self.put(data))
            counts.append(len(data))
        self.directory(tags_of(page, self.choice, offsets, counts, more, where))


def rejection(choice):
    is_tiled = choice["layout"] == "tiles"
    return truth.sentences(
        (choice["photometric"] == 0 and (is_tiled or choice["type"] in ("u4", "i4")), "gray values"),
        (choice["type"] == "f8", "8, 16 or 32 bits"))


def write(folder, choice, random):
    voxels = truth.values_of(choice["type"], random, choice["size"])
    pages = [np.ascontiguousarray(voxels[:, :, k].T) for k in range(voxels.shape[2])]
    if choice["input"] == "pages":
        writer = Writer(choice)
        for page in pages:
            writer.page(page)
        path = folder / "a.tif"
        path.write_bytes(writer.data)
    else:
        path = folder / "slices"
        path.mkdir()
        for k, page in enumerate(pages):
            writer = Writer(choice)
            writer.page(page)
            name = {"bone_8.tif": f"bone_{k + 8}.tif", "0008.tif": f"{k + 8:04}.tif", "8.TIFF": f"{k + 8}.TIFF",
                    "slice8_of.tif": f"slice{k + 8}_of.tif"}[choice["names"]]
            (path / name).write_bytes(writer.data)
    return path, truth.Truth(voxels, np.zeros(3), np.diag(truth.SPACING), rejected=rejection(choice), spacing=tuple(truth.SPACING))
