#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the compile commands that clang-tidy needs, from those of a build.

    tidy_database.py BUILD/compile_commands.json OUTPUT.json

A source that the build compiles together with others gets a command of its own. Left out: precompiled headers, which are those of
another compiler, and a warning that clang does not know. Added: definitions without which Debian's ITK knows GCC alone.
"""

import json
import re
import sys
from pathlib import Path


def sources_of(file):
    """The sources that a file of a unity build includes, or the file itself."""
    if re.fullmatch(r"unity_\d+_cxx\.cxx", Path(file).name):
        return re.findall(r'^#include "(.+\.cxx)"$', Path(file).read_text(encoding="utf-8"), re.MULTILINE)
    return [file]


def command_for(source, entry):
    command = entry["command"].replace(entry["file"], source)
    command = re.sub(r"-Winvalid-pch -include [^ ]+|-Wno-subobject-linkage", "", command)
    return re.sub(r"-isystem [^ ]*/ITK-[0-9.]+", r"\g<0> -DITK_COMPILER_DETECTION_H -DITK_NOEXCEPT=noexcept", command)


def main(database, output):
    entries = [
        {"directory": entry["directory"], "file": source, "command": command_for(source, entry)}
        for entry in json.loads(Path(database).read_text(encoding="utf-8"))
        for source in sources_of(entry["file"])
    ]
    Path(output).write_text(json.dumps(entries, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
