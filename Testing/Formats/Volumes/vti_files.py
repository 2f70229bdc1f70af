# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of VTK's XML format."""

import base64
import lzma
import struct
import zlib

import numpy as np

import truth

TYPES = {"Int8": "i1", "UInt8": "u1", "Int16": "i2", "UInt16": "u2", "Int32": "i4", "UInt32": "u4", "Int64": "i8", "UInt64": "u8",
         "Float32": "f4", "Float64": "f8"}
CHOICES = {
    "type": list(TYPES),
    "format": ["ascii", "binary", "appended raw", "appended base64"],
    "compressor": ["none", "none", "vtkZLibDataCompressor", "vtkLZMADataCompressor"],
    "header": ["UInt32", "UInt64", "missing"],
    "endian": ["LittleEndian", "LittleEndian", "BigEndian"],
    "version": ["0.1", "1.0", "2.2"],
    "extent": [(0, 0, 0), (0, 0, 0), (3, -2, 10)],
    "origin": [True, True, False],
    "spacing": [True] * 5 + [False],
    "direction": [True, True, False],
    "axes": [axes for axes in truth.AXES if axes != "sheared"],
    "arrays": ["one", "one with Scalars", "two", "two, second active", "one of three components"],
    "fields": ["none", "labels", "other"],
    "quotes": ['"', "'"],
    "line end": ["\n", "\r\n", ""],
    "first line": ["none", "xml", "xml and comment"],
    "range": [True, False],
    "attributes": ["usual", "reversed"],
}
NAMES = ["Femur & Tibia", "<bone>", "F\u00e9mur"]


def raw_of(values, choice):
    order = "<" if choice["endian"] == "LittleEndian" else ">"
    return values.astype(values.dtype.newbyteorder(order)).tobytes(), order


def header_type(choice, order):
    return order + ("Q" if choice["header"] == "UInt64" else "I")


def packed(values, choice):
    """Header and data."""
    raw, order = raw_of(values, choice)
    form = header_type(choice, order)
    if choice["compressor"] == "none":
        return struct.pack(form, len(raw)), raw
    pack = zlib.compress if "ZLib" in choice["compressor"] else lambda data: lzma.compress(data)
    size = 256  # bytes of a block
    blocks = [raw[i:i + size] for i in range(0, len(raw), size)]
    coded = [pack(block) for block in blocks]
    last = len(blocks[-1]) if len(blocks[-1]) < size else 0
    numbers = [len(blocks), size, last, *map(len, coded)]
    return b"".join(struct.pack(form, number) for number in numbers), b"".join(coded)


def base64_of(head, data, choice):
    if choice["compressor"] == "none":
        return base64.b64encode(head + data)
    return base64.b64encode(head) + base64.b64encode(data)


class Arrays:
    """Elements of arrays; what is appended is collected."""

    def __init__(self, choice):
        self.choice = choice
        self.appended = b""

    def element(self, name, type_, values, components=1, more=""):
        choice = self.choice
        kind = choice["format"]
        format_ = "appended" if kind.startswith("appended") else kind
        attributes = [f'type="{type_}"', f'Name="{name}"', f'format="{format_}"']
        if components > 1:
            attributes.append(f'NumberOfComponents="{components}"')
        if choice["range"] and values.size:
            attributes += [f'RangeMin="{values.min()}"', f'RangeMax="{values.max()}"']
        text = b""
        if kind == "ascii":
            text = " ".join(repr(value) for value in values.ravel().tolist()).encode()
        elif kind == "binary":
            text = base64_of(*packed(values, choice), choice)
        else:
            attributes.append(f'offset="{len(self.appended)}"')
            head, data = packed(values, choice)
            self.appended += head + data if kind == "appended raw" else base64_of(head, data, choice)
        return f"<DataArray {' '.join(attributes)}{more}>".encode() + text + b"</DataArray>"


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def fields_of(choice, arrays):
    if choice["fields"] == "none":
        return b""
    if choice["fields"] == "other":
        return b"<FieldData>" + arrays.element("TimeValue", "Float64", np.array([1.5]), more=' NumberOfTuples="1"') + b"</FieldData>"
    codes = " ".join(str(code) for name in NAMES for code in [*name.encode("utf-8"), 0])
    names = f'<Array type="String" Name="LabelNames" NumberOfTuples="3" format="ascii">{codes}</Array>'.encode()
    values = arrays.element("LabelValues", "Int64", np.array([1, 2, 5]), more=' NumberOfTuples="3"')
    colors = arrays.element("LabelColors", "Float64", np.arange(9) / 8, 3, ' NumberOfTuples="3"')
    return b"<FieldData>" + values + names + colors + b"</FieldData>"


def image_attributes(choice, origin, steps):
    spacing = np.linalg.norm(steps, axis=1)
    first = np.array(choice["extent"])
    ends = [f"{a} {a + n - 1}" for a, n in zip(first, truth.SIZE)]
    attributes = [f'WholeExtent="{" ".join(ends)}"']
    if choice["origin"]:
        attributes.append(f'Origin="{" ".join(f"{value:.17g}" for value in origin)}"')
    if choice["spacing"]:
        attributes.append(f'Spacing="{" ".join(f"{value:.17g}" for value in spacing)}"')
    if choice["direction"]:
        matrix = (steps / spacing[:, None]).T
        attributes.append(f'Direction="{" ".join(f"{value:.17g}" for value in matrix.ravel())}"')
    return (attributes[::-1] if choice["attributes"] == "reversed" else attributes), " ".join(ends)


def effective(choice):
    """What the format allows."""
    choice = dict(choice)
    if choice["version"] == "0.1" and choice["header"] == "UInt64":
        choice["version"] = "1.0"
    if not choice["spacing"]:  # it is given for axes of length 1, and voxels are counted from the first one
        choice["extent"] = (0, 0, 0)
        choice["axes"] = "oblique" if choice["axes"] == "four decimals" else choice["axes"]
    return choice


def write(folder, choice, random):
    choice = effective(choice)
    origin, steps = truth.position_of(choice["axes"] if choice["direction"] else "straight")
    origin = origin if choice["origin"] else np.zeros(3)
    voxels = truth.values_of(TYPES[choice["type"]], random)
    arrays = Arrays(choice)
    end = choice["line end"].encode()
    fields = fields_of(choice, arrays)
    values = voxels.ravel(order="F")
    components = 3 if choice["arrays"] == "one of three components" else 1
    elements = arrays.element("voxels", choice["type"], np.repeat(values, components), components)
    if choice["arrays"].startswith("two"):
        elements += end + arrays.element("others", "UInt8", np.zeros(voxels.size, np.uint8))
    active = {"one with Scalars": ' Scalars="voxels"', "two": ' Scalars="voxels"', "two, second active": ' Scalars="others"'}.get(
        choice["arrays"], "")
    attributes, extent = image_attributes(choice, origin, steps)
    root = ['type="ImageData"', f'version="{choice["version"]}"', f'byte_order="{choice["endian"]}"']
    if choice["header"] != "missing":
        root.append(f'header_type="{choice["header"]}"')
    if choice["compressor"] != "none":
        root.append(f'compressor="{choice["compressor"]}"')
    first = {"none": "", "xml": '<?xml version="1.0"?>', "xml and comment": '<?xml version="1.0"?><!-- Spacing="7 7 7" -->'}
    parts = [first[choice["first line"]].encode(), f"<VTKFile {' '.join(root)}>".encode(), f"<ImageData {' '.join(attributes)}>".encode(),
             fields, f'<Piece Extent="{extent}">'.encode(), f"<PointData{active}>".encode(), elements, b"</PointData>", b"<CellData/>",
             b"</Piece>", b"</ImageData>"]
    data = end.join(part for part in parts if part)
    data = data.replace(b'"', choice["quotes"].encode()) if choice["quotes"] == "'" and choice["format"] != "appended raw" else data
    if arrays.appended:
        encoding = "raw" if choice["format"] == "appended raw" else "base64"
        data += f'<AppendedData encoding="{encoding}">_'.encode() + arrays.appended + b"</AppendedData>"
    data += end + b"</VTKFile>"
    path = folder / "a.vti"
    path.write_bytes(data)
    read = np.zeros(truth.SIZE, np.uint8) if choice["arrays"] == "two, second active" else voxels
    rejected = "one value a voxel" if components == 3 else ""
    first_voxel = origin + np.array(choice["extent"]) @ steps
    segments = [(1, NAMES[0], (0, .125, .25)), (2, NAMES[1], (.375, .5, .625)), (5, NAMES[2], (.75, .875, 1))]
    return path, truth.Truth(read, first_voxel, steps, segments if choice["fields"] == "labels" else [], rejected=rejected,
                             spacing=() if choice["spacing"] else tuple(truth.SPACING))

