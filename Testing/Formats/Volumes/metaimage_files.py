# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""MetaImage files, .mha and .mhd, as https://itk.org/Wiki/ITK/MetaIO/Documentation has them."""

import zlib

import numpy as np

import truth

TYPES = {"MET_CHAR": "i1", "MET_UCHAR": "u1", "MET_SHORT": "i2", "MET_USHORT": "u2", "MET_INT": "i4", "MET_UINT": "u4",
         "MET_LONG": "i4", "MET_ULONG": "u4", "MET_LONG_LONG": "i8", "MET_ULONG_LONG": "u8", "MET_FLOAT": "f4", "MET_DOUBLE": "f8"}
UNITS = {"": 1, "mm": 1, "um": 1e-3, "cm": 10, "m": 1000, "?": 1, "inch": None}
CHOICES = {
    "file": ["local"] * 5 + ["LOCAL", "beside", "beside", "beside", "in a folder", "list", "pattern"],
    "type": list(TYPES),
    "order": ["little", "big", "big, BinaryData", "big, 1", "missing"],
    "binary": ["True"] * 4 + ["true", "T", "1", "missing", "False"],
    "compressed": ["missing", "False", "True", "True", "without size"],
    "matrix": ["TransformMatrix"] * 4 + ["Rotation", "Orientation", "missing"],
    "offset": ["Offset", "Offset", "Position", "Origin", "missing"],
    "spacing": ["ElementSpacing"] * 4 + ["ElementSize", "both", "missing"],
    "axes": list(truth.AXES),
    "header size": ["missing", "missing", "0", "5", "-1"],
    "units": ["", "mm"] * 3 + list(UNITS),
    "channels": ["missing"] * 6 + ["1", "1", "3"],
    "dimensions": ["3"] * 12 + ["4 with one", "2"],
    "equals": [" = ", " = ", "=", " =  "],
    "line end": ["\n", "\n", "\r\n"],
    "sequence": ["usual", "shuffled", "without ObjectType"],
    "others": ["none", "comment", "anatomical", "many"],
    "numbers": ["17", "e", "6"],
    "behind": [0, 0, 9],
}


def text(values, style):
    form = {"17": ".17g", "e": ".16e", "6": ".6g"}[style]
    return " ".join(format(float(value), form) for value in values)


def effective(choice):
    """What can be written: text and lists are not compressed, MetaIO finds voxels from the end in files of their own."""
    choice = dict(choice)
    if choice["file"] == "LOCAL":
        choice["file"] = "local"
        choice["local"] = "LOCAL"
    if choice["binary"] == "False":
        choice["compressed"] = "missing"
    if choice["file"] == "local" or choice["compressed"] in ("True", "without size"):
        choice["header size"] = "missing"
    return choice


def orders(choice):
    return {"little": [("BinaryDataByteOrderMSB", "False")], "big": [("ElementByteOrderMSB", "True")],
            "big, BinaryData": [("BinaryDataByteOrderMSB", "True")], "big, 1": [("ElementByteOrderMSB", "1")],
            "missing": []}[choice["order"]]


def geometry(choice, sizes):
    """Fields; origin and steps."""
    spacing, style = truth.SPACING, choice["numbers"]
    directions = truth.AXES[choice["axes"]]
    if choice["spacing"] == "missing":  # it is given in mm for axes of length 1
        directions = directions / np.linalg.norm(directions, axis=0)
    dimensions = len(sizes)
    fields = []
    if choice["matrix"] == "missing":
        directions = np.eye(3)
    else:
        matrix = np.eye(dimensions)
        matrix[:3, :3] = directions.T[:dimensions, :dimensions] if dimensions < 3 else directions.T
        fields.append((choice["matrix"], text(matrix.ravel(), style)))
    pad = lambda values, fill: [*values, fill][:dimensions] if dimensions > 3 else list(values)[:dimensions]
    if choice["offset"] != "missing":
        fields.append((choice["offset"], text(pad(truth.ORIGIN, 0), style)))
    if choice["spacing"] in ("ElementSpacing", "both"):
        fields.append(("ElementSpacing", text(pad(spacing, 1), style)))
    if choice["spacing"] in ("ElementSize", "both"):
        size = spacing if choice["spacing"] == "ElementSize" else spacing / 2
        fields.append(("ElementSize", text(pad(size, 1), style)))
    if choice["units"]:
        fields.append(("DistanceUnits", choice["units"]))
    origin = truth.ORIGIN if choice["offset"] != "missing" else np.zeros(3)
    return fields, origin, (directions * spacing).T


def others(choice):
    return {"none": [], "comment": [("Comment", "a bone = a bone; ElementSpacing")], "anatomical": [("AnatomicalOrientation", "RAI")],
            "many": [("CenterOfRotation", "0 0 0"), ("Name", "bone"), ("ID", "3"), ("ParentID", "-1"), ("Modality", "MET_MOD_CT"),
                     ("ElementMin", "-5"), ("ElementMax", "7"), ("Color", "1 0 0 1")]}[choice["others"]]


def rejection(choice):
    return truth.sentences(
        (choice["dimensions"] != "3", "only volumes of three dimensions are read"),
        (choice["file"] in ("list", "pattern"), "its voxels lie in several files"),
        (UNITS[choice["units"]] is None, "its unit of length is"),
        (choice["channels"] == "3", "values a voxel"),
        (choice["binary"] == "False", "its voxels are text"),
        (choice["compressed"] == "without size" and choice["file"] == "local", "its header does not say how many bytes"))


def encoded(voxels, choice):
    if choice["binary"] == "False":
        return " ".join(repr(value) for value in voxels.ravel(order="F").tolist()).encode()
    order = ">" if choice["order"].startswith("big") else "<"
    raw = voxels.astype(voxels.dtype.newbyteorder(order)).tobytes(order="F")
    return zlib.compress(raw) if choice["compressed"] in ("True", "without size") else raw


def write(folder, choice, random):
    choice = effective(choice)
    voxels = truth.values_of(TYPES[choice["type"]], random)
    stored = np.concatenate([voxels[None]] * (3 if choice["channels"] == "3" else 1), axis=0)
    sizes = {"3": truth.SIZE, "4 with one": (*truth.SIZE, 1), "2": truth.SIZE[:2]}[choice["dimensions"]]
    data = encoded(stored, choice)
    placed, origin, steps = geometry(choice, sizes)
    fields = placed + orders(choice) + others(choice) + [("ElementType", choice["type"])]
    fields += [("BinaryData", choice["binary"])] if choice["binary"] != "missing" else []
    fields += [("ElementNumberOfChannels", choice["channels"])] if choice["channels"] != "missing" else []
    if choice["compressed"] != "missing":
        fields.append(("CompressedData", str(choice["compressed"] != "False")))
    if choice["compressed"] == "True":
        fields.append(("CompressedDataSize", str(len(data))))
    fields += [("HeaderSize", choice["header size"])] if choice["header size"] != "missing" else []
    if choice["sequence"] == "shuffled":
        fields = [fields[i] for i in random.permutation(len(fields))]
    kind = [] if choice["sequence"] == "without ObjectType" else [("ObjectType", "Image")]
    name = {"local": choice.get("local", "LOCAL"), "beside": "voxels.raw", "in a folder": "data/voxels.raw", "list": "LIST",
            "pattern": "voxels%d.raw 0 0 1"}[choice["file"]]
    fields = kind + [("NDims", str(len(sizes))), ("DimSize", " ".join(map(str, sizes)))] + fields + [("ElementDataFile", name)]
    head = "".join(key + choice["equals"] + value + choice["line end"] for key, value in fields).encode()
    data = b"junk!" + data if choice["header size"] in ("5", "-1") else data
    is_plain = choice["compressed"] in ("missing", "False") and choice["header size"] != "-1" and choice["binary"] != "False"
    data += b"\0" * (choice["behind"] if is_plain else 0)
    path = folder / ("a.mha" if choice["file"] == "local" else "a.mhd")
    path.write_bytes(head + (data if choice["file"] == "local" else b""))
    if choice["file"] != "local":
        file = folder / ("voxels0.raw" if choice["file"] in ("list", "pattern") else name)
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(data)
    unit = UNITS[choice["units"]] or 1
    steps = steps if choice["spacing"] == "missing" else steps * unit
    return path, truth.Truth(voxels, origin * unit, steps, rejected=rejection(choice),
                             notes=("lengths are converted",) if unit != 1 else (),
                             unit=unit, spacing=tuple(truth.SPACING) if choice["spacing"] == "missing" else ())
