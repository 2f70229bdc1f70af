# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""NRRD files, attached and detached, from the grammar of https://teem.sourceforge.net/nrrd/format.html."""

import bz2
import gzip

import numpy as np

import truth

TYPES = {
    "signed char": "i1", "int8": "i1", "int8_t": "i1", "uchar": "u1", "unsigned char": "u1", "uint8": "u1", "uint8_t": "u1",
    "short": "i2", "short int": "i2", "signed short": "i2", "signed short int": "i2", "int16": "i2", "int16_t": "i2",
    "ushort": "u2", "unsigned short": "u2", "unsigned short int": "u2", "uint16": "u2", "uint16_t": "u2",
    "int": "i4", "signed int": "i4", "int32": "i4", "int32_t": "i4", "uint": "u4", "unsigned int": "u4", "uint32": "u4",
    "uint32_t": "u4", "longlong": "i8", "long long": "i8", "long long int": "i8", "signed long long": "i8",
    "signed long long int": "i8", "int64": "i8", "int64_t": "i8", "ulonglong": "u8", "unsigned long long": "u8",
    "unsigned long long int": "u8", "uint64": "u8", "uint64_t": "u8", "float": "f4", "double": "f8"}
SIGNS = {"left-posterior-superior": (1, 1, 1), "LPS": (1, 1, 1), "right-anterior-superior": (-1, -1, 1), "RAS": (-1, -1, 1),
         "left-anterior-superior": (1, -1, 1), "LAS": (1, -1, 1), "scanner-xyz": (1, 1, 1), "3D-right-handed": (1, 1, 1),
         "3D-left-handed": (1, 1, 1), "Left-Posterior-Superior": (1, 1, 1), "ras": (-1, -1, 1), "dimension 3": (1, 1, 1)}
UNITS = {"": 1, "mm": 1, "um": 1e-3, "micron": 1e-3, "cm": 10, "m": 1000, "nm": 1e-6, "millimeters": 1, "furlong": None}
CHOICES = {
    "file": ["attached"] * 6 + ["nrrd with detached data", "detached", "detached, datafile", "detached in a folder", "list",
                                "pattern"],
    "magic": ["NRRD0001", "NRRD0002", "NRRD0003", "NRRD0004", "NRRD0005"],
    "encoding": ["raw", "raw", "RAW", "gzip", "GZip", "gz", "ascii", "text", "txt", "hex", "bzip2"],
    "type": list(TYPES),
    "endian": ["little", "big", "Big"],
    "line end": ["\n", "\n", "\r\n"],
    "comments": ["none", "first", "between", "with a colon"],
    "order": ["usual", "reversed", "shuffled"],
    "case": ["small", "small", "small", "capital", "large"],
    "keys": ["none", "some", "escaped", "with a colon", "empty"],
    "space": list(SIGNS),
    "geometry": ["directions"] * 8 + ["spacings", "spacings and mins", "nothing"],
    "axes": list(truth.AXES),
    "vectors": ["(1,2,3)", "( 1, 2, 3 )", "(1e0,2,3)"],
    "origin": [True, True, True, False],
    "units": ["", "mm"] * 4 + list(UNITS),
    "kinds": ["none", "domain", "space", "domains and thickness"],
    "centers": ["none", "cell", "node"],
    "skip": ["none", "none", "none", "bytes", "lines", "both", "from the end"],
    "axis": ["none"] * 16 + ["one in front", "one behind", "three in front", "two behind", "list behind"],
    "extra": ["none", "content", "old min and max", "measurement frame"],
    "behind": [0, 0, 0, 5],
}


def vector(values, style):
    if style == "(1e0,2,3)":
        return "(" + ",".join(f"{value:.16e}" for value in values) + ")"
    separator = ", " if " " in style else ","
    text = separator.join(f"{value:.17g}" for value in values)
    return f"( {text} )" if " " in style else f"({text})"


def axis_lists(choice):
    """Sizes of the axes in front and behind."""
    front = {"one in front": [1], "three in front": [3]}.get(choice["axis"], [])
    behind = {"one behind": [1], "two behind": [2], "list behind": [1]}.get(choice["axis"], [])
    return front, behind


def geometry_fields(choice, spacing, front, behind):
    """Fields, and origin and steps in the units of the file."""
    origin, steps = truth.position_of(choice["axes"], spacing)
    fill = lambda values, none: [none] * len(front) + list(values) + [none] * len(behind)
    sign = np.array(SIGNS[choice["space"]])
    unit = choice["units"]
    if choice["geometry"] == "directions":
        space = ("space dimension", "3") if choice["space"] == "dimension 3" else ("space", choice["space"])
        fields = [space, ("space directions", " ".join(fill([vector(step * sign, choice["vectors"]) for step in steps], "none")))]
        if choice["origin"]:
            fields.append(("space origin", vector(origin * sign, choice["vectors"])))
        if unit:
            fields.append(("space units", " ".join([f'"{unit}"'] * 3)))
        return fields, origin if choice["origin"] else np.zeros(3), steps
    if choice["geometry"] == "nothing":
        return [], np.zeros(3), np.diag(spacing)
    fields = [("spacings", " ".join(fill([f"{value:.17g}" for value in spacing], "nan")))]
    origin = np.zeros(3)
    if choice["geometry"] == "spacings and mins":
        mins = truth.ORIGIN * spacing
        fields.append(("axis mins", " ".join(fill([f"{value:.17g}" for value in mins], "nan"))))
        origin = mins if choice["centers"] == "node" else mins + spacing / 2
    if unit:
        fields.append(("units", " ".join(fill([f'"{unit}"'] * 3, '""'))))
    return fields, origin, np.diag(spacing)


def other_fields(choice, front, behind):
    fill = lambda one, other: " ".join([other] * len(front) + [one] * 3 + [other] * len(behind))
    fields = []
    if choice["kinds"] != "none" or choice["axis"] in ("three in front", "list behind"):
        other = "list" if choice["axis"] == "list behind" else "vector" if front else "???"
        fields.append(("kinds", fill("space" if choice["kinds"] == "space" else "domain", other)))
    if choice["kinds"] == "domains and thickness":
        fields.append(("thicknesses", fill("0.5", "nan")))
    if choice["centers"] != "none":
        fields.append(("centers", fill(choice["centers"], "???")))
    fields += {"none": [], "content": [("content", "bone: of a (left) leg")],
               "old min and max": [("old min", "-5"), ("old max", "7")],
               "measurement frame": [("measurement frame", "(1,0,0) (0,1,0) (0,0,1)")] if choice["geometry"] == "directions" else []
               }[choice["extra"]]
    return fields


def ordered(fields, choice, random):
    """Dimension and space come before what depends on them."""
    first = [field for field in fields if field[0] in ("dimension", "space", "space dimension")]
    rest = [field for field in fields if field not in first]
    if choice["order"] == "reversed":
        rest.reverse()
    if choice["order"] == "shuffled":
        rest = [rest[i] for i in random.permutation(len(rest))]
    last = [field for field in rest if field[0] in ("data file", "datafile") and field[1].startswith("LIST")]
    return first + [field for field in rest if field not in last] + last


def named(name, case):
    return name.capitalize() if case == "capital" else name.upper() if case == "large" else name


def header_lines(fields, choice):
    lines = [choice["magic"]]
    if choice["comments"] == "first":
        lines.append("# Complete NRRD file format specification at:")
    for number, (name, text) in enumerate(fields):
        lines.append(f"{named(name, choice['case'])}: {text}")
        if choice["comments"] == "between" and number % 3 == 1:
            lines += ["#", "# a comment"]
        if choice["comments"] == "with a colon" and number == 2:
            lines.append("# spacings: 7 7 7")
    lines += {"none": [], "some": ["modality:=CT", "institution:=somewhere"], "escaped": ["note:=two\\nlines and a \\\\"],
              "with a colon": ["sizes:=9 9 9", "a:=b:c"], "empty": ["nothing:="]}[choice["keys"]]
    return lines


def encoded(voxels, choice):
    """The bytes of the data."""
    order = ">" if choice["endian"].lower() == "big" else "<"
    raw = voxels.astype(voxels.dtype.newbyteorder(order)).tobytes(order="F")
    encoding = choice["encoding"].lower()
    if encoding in ("gzip", "gz"):
        return gzip.compress(raw)
    if encoding == "bzip2":
        return bz2.compress(raw)
    if encoding == "hex":
        return raw.hex().encode()
    if encoding in ("ascii", "text", "txt"):
        return "\n".join(repr(value) for value in voxels.ravel(order="F").tolist()).encode()
    return raw


def skipped(data, choice):
    """Fields, and what is in front of the data."""
    encoding = choice["encoding"].lower()
    if choice["skip"] == "from the end" and encoding == "raw":
        return [("byte skip", "-1")], b"junk" + data
    fields, front = [], b""
    if choice["skip"] in ("lines", "both"):
        fields.append(("line skip", "2"))
        front += b"a line\nanother one\n"
    if choice["skip"] in ("bytes", "both"):
        fields.append(("byte skip", "3"))
        if encoding in ("gzip", "gz", "bzip2"):  # bytes of what is unpacked
            pack = bz2 if encoding == "bzip2" else gzip
            return fields, front + pack.compress(b"xyz" + pack.decompress(data))
        front += b"xyz"
    return fields, front + data


def rejection(choice):
    is_placed = choice["geometry"] == "directions"
    return truth.sentences(
        (choice["file"] in ("list", "pattern"), "its voxels lie in several files"),
        (is_placed and choice["space"] == "3D-left-handed", "its space is not RAS, LAS or LPS"),
        (UNITS[choice["units"]] is None and choice["geometry"] != "nothing", "its unit of length is"),
        (choice["axis"] in ("three in front", "two behind"), "values a voxel|4 dimensions"),
        (choice["axis"] == "one behind" or (choice["axis"] == "one in front" and choice["kinds"] == "none"), "4 dimensions"),
        (choice["encoding"] == "bzip2", "bzip2"))


def write(folder, choice, random):
    spacing = truth.SPACING
    front, behind = axis_lists(choice)
    voxels = truth.values_of(TYPES[choice["type"]], random)
    stored = np.concatenate([voxels.reshape((1, *truth.SIZE, 1))] * (front or [1])[0], axis=0)
    stored = np.concatenate([stored] * (behind or [1])[0], axis=4)
    sizes = front + list(truth.SIZE) + behind
    fields = [("type", choice["type"]), ("dimension", str(len(sizes))), ("sizes", " ".join(map(str, sizes))),
              ("encoding", choice["encoding"])]
    if voxels.dtype.itemsize > 1:
        fields.append(("endian", choice["endian"]))
    placed, origin, steps = geometry_fields(choice, spacing, front, behind)
    skips, data = skipped(encoded(stored, choice), choice)
    fields += placed + skips + other_fields(choice, front, behind)
    is_detached = choice["file"] not in ("attached",)
    name = {"detached in a folder": "data/voxels.bin", "list": "LIST", "pattern": "voxels%d.bin 0 0 1"}.get(
        choice["file"], "voxels.bin")
    if is_detached:
        fields.append(("datafile" if "datafile" in choice["file"] else "data file", name))
    lines = header_lines(ordered(fields, choice, random), choice)
    if choice["file"] == "list":
        lines = [line for line in lines if not line.startswith("#") and ":=" not in line] + ["voxels0.bin"]
    header = (choice["line end"].join(lines) + choice["line end"]).encode()
    data += b"\0" * (choice["behind"] if choice["skip"] != "from the end" and choice["encoding"].lower() == "raw" else 0)
    path = folder / ("a.nrrd" if choice["file"] in ("attached", "nrrd with detached data") else "a.nhdr")
    if is_detached:
        file = folder / {"list": "voxels0.bin", "pattern": "voxels0.bin"}.get(choice["file"], name)
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(data)
        path.write_bytes(header + (choice["line end"].encode() if choice["file"] not in ("list",) else b""))
    else:
        path.write_bytes(header + choice["line end"].encode() + data)
    unit = UNITS[choice["units"]] or 1 if choice["geometry"] != "nothing" else 1
    return path, truth.Truth(voxels, origin * unit, steps * unit, rejected=rejection(choice),
                             notes=("lengths are converted",) if unit != 1 else (),
                             unit=unit, spacing=tuple(spacing) if choice["geometry"] == "nothing" else ())
