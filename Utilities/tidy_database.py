#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Joins the sources that clang-tidy checks, and writes the compile commands for that.

    tidy_database.py BUILD/compile_commands.json FOLDER SOURCE...

What the build compiles together is one file in FOLDER, too, so that common headers are read once: the names of the files of FOLDER
and of the sources that stand alone are printed, largest first. Each SOURCE is in exactly one of them; one that the build does not
compile is an error. Left out of the commands: precompiled headers, which are those of another compiler, and a warning that clang does
not know. Added: definitions without which Debian's ITK knows GCC alone.
"""

import json
import re
import sys
from pathlib import Path


def sources_of(file):
    """The sources that a file of a unity build includes, or the file itself."""
    if re.fullmatch(r"unity_\w+\.cxx", Path(file).name):
        return re.findall(r'^#include "(.+\.cxx)"$', Path(file).read_text(encoding="utf-8"), re.MULTILINE)
    return [file]


def command_for(file, entry):
    command = entry["command"].replace(entry["file"], file)
    command = re.sub(r"-Winvalid-pch -include [^ ]+|-Wno-subobject-linkage", "", command)
    return re.sub(r"-isystem [^ ]*/ITK-[0-9.]+", r"\g<0> -DITK_COMPILER_DETECTION_H -DITK_NOEXCEPT=noexcept", command)


def join(sources, file):
    """A check finds that includes of sources are suspicious."""
    file.write_text(
        "".join(f'#include "{source}" // NOLINT(bugprone-suspicious-include)\n' for source in sources), encoding="utf-8")
    return str(file)


def main(database, folder, *names):
    missing = {str(Path(name).resolve()) for name in names}
    entries, sizes = [], {}
    for entry in json.loads(Path(database).read_text(encoding="utf-8")):
        sources = [source for source in sources_of(entry["file"]) if source in missing]
        if not sources:
            continue
        missing.difference_update(sources)
        file = sources[0]
        if len(sources) > 1:
            file = join(sources, Path(folder).resolve() / f"joined_{len(entries)}.cxx")
        entries.append({"directory": entry["directory"], "file": file, "command": command_for(file, entry)})
        sizes[file] = sum(Path(source).stat().st_size for source in sources)
    if missing:
        sys.exit("not compiled by the build: " + ", ".join(sorted(missing)))
    (Path(folder) / "compile_commands.json").write_text(json.dumps(entries, indent=1), encoding="utf-8")
    print("\n".join(sorted(sizes, key=sizes.get, reverse=True)))


if __name__ == "__main__":
    main(*sys.argv[1:])
