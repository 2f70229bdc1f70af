# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""DICOM data sets as bytes, by parts 5 and 10 of the standard, independent of any library."""

import struct
import zlib

IMPLICIT = "1.2.840.10008.1.2"
EXPLICIT = "1.2.840.10008.1.2.1"
DEFLATED = "1.2.840.10008.1.2.1.99"
BIG = "1.2.840.10008.1.2.2"
RLE = "1.2.840.10008.1.2.5"
LONG = ("OB", "OW", "OF", "SQ", "UN", "UT")  # the length has four bytes
NUMBERS = {"US": "H", "SS": "h", "UL": "I", "SL": "i", "FD": "d", "FL": "f"}


class DataSet:
    """Elements by tag: (VR, value); a value is a text, a list of numbers, bytes, or a list of data sets (SQ)."""

    def __init__(self, **_none):
        self.elements = {}

    def set(self, tag, vr, value):
        self.elements[tag] = (vr, value)
        return self

    def bytes(self, syntax, has_undefined_lengths=False):
        coder = _Coder(syntax, has_undefined_lengths)
        return b"".join(coder.element(tag, *self.elements[tag]) for tag in sorted(self.elements))


class _Coder:
    def __init__(self, syntax, has_undefined_lengths):
        self.syntax = syntax
        self.order = ">" if syntax == BIG else "<"
        self.is_implicit = syntax == IMPLICIT
        self.is_undefined = has_undefined_lengths

    def element(self, tag, vr, value):
        if vr == "SQ":
            return self.sequence(tag, value)
        data = self.value(vr, value)
        data += (b"\0" if vr in ("UI", "OB", "OW", "UN") else b" ") * (len(data) % 2)
        return self.head(tag, vr, len(data)) + data

    def head(self, tag, vr, length):
        words = struct.pack(self.order + "HH", tag >> 16, tag & 0xffff)
        if self.is_implicit:
            return words + struct.pack("<I", length)
        if vr in LONG:
            return words + vr.encode() + b"\0\0" + struct.pack(self.order + "I", length)
        return words + vr.encode() + struct.pack(self.order + "H", length)

    def value(self, vr, value):
        if isinstance(value, bytes):
            return value
        if vr in NUMBERS:
            values = value if isinstance(value, (list, tuple)) else [value]
            return struct.pack(f"{self.order}{len(values)}{NUMBERS[vr]}", *values)
        if vr == "AT":
            return b"".join(struct.pack(self.order + "HH", tag >> 16, tag & 0xffff) for tag in value)
        return "\\".join(map(str, value)).encode("utf-8") if isinstance(value, (list, tuple)) else str(value).encode("utf-8")

    def sequence(self, tag, items):
        parts = []
        for item in items:
            data = b"".join(self.element(one, *item.elements[one]) for one in sorted(item.elements))
            mark = struct.pack(self.order + "HH", 0xfffe, 0xe000)
            end = struct.pack(self.order + "HHI", 0xfffe, 0xe00d, 0)
            parts.append(mark + struct.pack(self.order + "I", 0xffffffff if self.is_undefined else len(data)) + data
                         + (end if self.is_undefined else b""))
        data = b"".join(parts)
        if self.is_undefined:
            return self.head(tag, "SQ", 0xffffffff) + data + struct.pack(self.order + "HHI", 0xfffe, 0xe0dd, 0)
        return self.head(tag, "SQ", len(data)) + data


def packed_bits(row):
    """PackBits with literal runs and repetitions."""
    result, i = bytearray(), 0
    while i < len(row):
        run = 1
        while run < 128 and i + run < len(row) and row[i + run] == row[i]:
            run += 1
        if run > 1:
            result += bytes([257 - run, row[i]])
            i += run
            continue
        end = i + 1
        while end < len(row) and end - i < 128 and (end + 1 >= len(row) or row[end] != row[end + 1]):
            end += 1
        result += bytes([end - i - 1]) + row[i:end]
        i = end
    return bytes(result)


def rle_frame(values, columns, size):
    """@param values Little endian. Segments of the high bytes first (part 5, annex G); rows are packed one by one."""
    segments = []
    for byte in reversed(range(size)):
        plane = values[byte::size]
        segments.append(b"".join(packed_bits(plane[i:i + columns]) for i in range(0, len(plane), columns)))
        segments[-1] += b"\0" * (len(segments[-1]) % 2)
    offsets, at = [], 64
    for segment in segments:
        offsets.append(at)
        at += len(segment)
    return struct.pack("<16I", len(segments), *offsets, *[0] * (15 - len(offsets))) + b"".join(segments)


def encapsulated(frames, has_offsets):
    """The value of pixel data in fragments, one a frame."""
    item = struct.pack("<HH", 0xfffe, 0xe000)
    offsets, at = [], 0
    for frame in frames:
        offsets.append(at)
        at += 8 + len(frame)
    table = struct.pack(f"<{len(offsets)}I", *offsets) if has_offsets else b""
    data = item + struct.pack("<I", len(table)) + table
    for frame in frames:
        data += item + struct.pack("<I", len(frame)) + frame
    return data + struct.pack("<HHI", 0xfffe, 0xe0dd, 0)


CODERS = {RLE: rle_frame}  # of one frame, by the transfer syntax


def pixel_element(values, syntax, vr, columns, size, frames, has_offsets=True):
    """The element of the pixels, to be put at the end. @param values Little endian bytes."""
    if syntax in CODERS:
        part = len(values) // frames
        coded = [CODERS[syntax](values[i:i + part], columns, size) for i in range(0, len(values), part)]
        return struct.pack("<HH", 0x7fe0, 0x10) + b"OB\0\0" + b"\xff" * 4 + encapsulated(coded, has_offsets)
    if syntax == BIG and size == 2 and vr == "OW":
        swapped = bytearray(values)
        swapped[0::2], swapped[1::2] = values[1::2], values[0::2]
        values = bytes(swapped)
    return _Coder(syntax, False).element(0x7fe00010, vr, values)


def file_bytes(data, pixels, syntax, has_undefined_lengths=False, behind=b""):
    """With the preamble and the header of the file."""
    meta = DataSet().set(0x00020001, "OB", b"\0\1")
    meta.set(0x00020002, "UI", data.elements[0x00080016][1]).set(0x00020003, "UI", data.elements.get(0x00080018, ("UI", "1.2.3"))[1])
    meta.set(0x00020010, "UI", syntax).set(0x00020012, "UI", "1.2.826.0.1.3680043.10.999")
    head = meta.bytes(EXPLICIT)
    length = DataSet().set(0x00020000, "UL", len(head)).bytes(EXPLICIT)
    body = data.bytes(syntax, has_undefined_lengths) + pixels + behind
    if syntax == DEFLATED:
        packer = zlib.compressobj(wbits=-15)
        body = packer.compress(body) + packer.flush()
        body += b"\0" * (len(body) % 2)
    return b"\0" * 128 + b"DICM" + length + head + body
