#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads 3MF files with the program's reader and with lib3mf, and compares triangles and bounds.

    samples_3mf.py READER FOLDER     READER: bonedecimate-read-surfaces; FOLDER: such as the samples of the 3MF Consortium

Needs lib3mf of PyPI (requirements.txt). A line for each file on which the two differ, then the counts.
"""

import json
import pathlib
import subprocess
import sys

import lib3mf
import numpy

NEAR = 1e-3  # mm
UNITS = {"MicroMeter": 1e-3, "MilliMeter": 1.0, "CentiMeter": 10.0, "Inch": 25.4, "Foot": 304.8, "Meter": 1000.0}


def matrix_of(transform):
    """Of row vectors, as 3MF has it."""
    return numpy.array([[transform.Fields[row][column] for column in range(3)] for row in range(4)])


def corners_of(resource, matrix):
    """The corners of all triangles of an object, with its components."""
    if resource.GetType() == lib3mf.ObjectType.Support:
        return []  # is printed, but is no surface
    if resource.IsMeshObject():
        points = numpy.array([list(vertex.Coordinates) for vertex in resource.GetVertices()]).reshape(-1, 3)
        triangles = numpy.array([list(each.Indices) for each in resource.GetTriangleIndices()], dtype=int).reshape(-1)
        return [(points @ matrix[:3] + matrix[3])[triangles]]
    found = []
    for i in range(resource.GetComponentCount()):
        part = resource.GetComponent(i)
        own = matrix_of(part.GetTransform())
        found += corners_of(part.GetObjectResource(), numpy.vstack([own[:3] @ matrix[:3], own[3] @ matrix[:3] + matrix[3]]))
    return found


def by_lib3mf(path):
    """Corners in mm of what is built, or why the file was rejected."""
    model = lib3mf.get_wrapper().CreateModel()
    reader = model.QueryReader("3mf")
    try:
        reader.ReadFromFile(str(path))
        items, found = model.GetBuildItems(), []
        while items.MoveNext():
            item = items.GetCurrent()
            found += corners_of(item.GetObjectResource(), matrix_of(item.GetObjectTransform()))
    except lib3mf.ELib3MFException as error:
        return str(error)
    return numpy.concatenate(found or [numpy.empty((0, 3))]) * UNITS[model.GetUnit().name]


def by_program(reader, path):
    """The same by the program."""
    said = subprocess.run([reader], input=f"{path}\n", capture_output=True, encoding="utf-8", check=True).stdout
    read = json.loads(said)
    if "error" in read:
        return read["error"]
    return numpy.array(read["points"]).reshape(-1, 3)[[corner for cell in read["polys"] for corner in cell]]


def difference(ours, theirs):
    """Why two readings differ; empty if they do not."""
    if len(ours) != len(theirs):
        return f"{len(ours) // 3} triangles instead of {len(theirs) // 3}"
    if not len(ours):
        return ""
    apart = max(numpy.abs(bound(ours, axis=0) - bound(theirs, axis=0)).max() for bound in (numpy.min, numpy.max))
    return "" if apart <= NEAR else f"bounds differ by {apart:.3g} mm"


def main(reader, folder):
    files = sorted(pathlib.Path(folder).rglob("*.3mf"))
    ours, theirs = [by_program(reader, file) for file in files], [by_lib3mf(file) for file in files]
    both = same = 0
    for file, one, other in zip(files, ours, theirs):
        texts = [value if isinstance(value, str) else f"{len(value) // 3} triangles" for value in (one, other)]
        if not isinstance(one, str) and not isinstance(other, str):
            both += 1
            reason = difference(one, other)
            same += not reason
            texts.append(reason)
        if isinstance(one, str) or isinstance(other, str) or texts[2]:
            print(f"{file.relative_to(folder)}: " + "; ".join(text for text in texts if text))
    for name, values in (("program", ours), (f"lib3mf {'.'.join(map(str, lib3mf.get_wrapper().GetLibraryVersion()))}", theirs)):
        rejected = sum(isinstance(value, str) for value in values)
        print(f"{name}: {len(values) - rejected} of {len(values)} read, {rejected} rejected")
    print(f"read by both: {both}, of these the same triangles and bounds: {same}")


if __name__ == "__main__":
    main(*sys.argv[1:])
