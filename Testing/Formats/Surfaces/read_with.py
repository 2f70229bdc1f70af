# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""read_with.py READER: reads surfaces with a reader of others, in a process of its own, because readers crash.

Standard input: a path a line. Standard output: a line of JSON for each, as ReadSurfaces.cxx writes it, or of the plain form:
points, faces, and "uv", "normals", "colors" as {"of": "points" | "corners" | "faces", "values": [...]}.
"""

import json
import os
import pathlib
import sys


def main(name):
    reader = load(name)
    out = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # readers print what they like
    out.write(json.dumps({"reader": name}) + "\n")
    out.flush()
    for line in sys.stdin:
        try:
            result = reader(pathlib.Path(line.rstrip("\n")))
        except BaseException as error:  # whatever a reader throws is its rejection; that of assimp is no Exception
            result = {"error": type(error).__name__ + ": " + str(error)[:200]}
        out.write(json.dumps(result) + "\n")
        out.flush()


def load(name):
    if name == "vtk":
        import read_with_vtk

        return read_with_vtk.read
    import read_with_others

    return getattr(read_with_others, "make_" + name)()


if __name__ == "__main__":
    main(sys.argv[1])
