# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what the C++ filter, wrapped by the VTK that it was built with, makes of the specimens.

    write_reference.py FILE.json
"""

import json
import sys

from bonedecimate import vtkBoneDecimate
from vtkmodules.vtkCommonCore import vtkVersion

import specimens

PROPERTIES = sorted(name[3:] for name in dir(vtkBoneDecimate) if name.startswith("Set") and "Set" + name[3:] in vars(vtkBoneDecimate))


def constants():
    found = {name: getattr(vtkBoneDecimate, name) for name in vars(vtkBoneDecimate) if name.isupper()}
    return {name: int(value) for name, value in found.items() if isinstance(value, int)}


def main(path):
    # Names in small letters are properties that VTK adds to each Set and Get since 9.4.
    filters = {name: getattr(vtkBoneDecimate(), "Get" + name) for name in PROPERTIES if hasattr(vtkBoneDecimate, "Get" + name)}
    record = {"vtk": vtkVersion.GetVTKVersion(), "constants": constants(),
              "members": sorted(name for name in vars(vtkBoneDecimate) if not name.startswith("_") and not name[0].islower()),
              "defaults": {name: get() for name, get in filters.items()},
              "runs": {name: specimens.run(vtkBoneDecimate, *case) for name, case in specimens.cases().items()}}
    with open(path, "w", encoding="utf-8") as file:
        json.dump(record, file, indent=1)


if __name__ == "__main__":
    main(sys.argv[1])
