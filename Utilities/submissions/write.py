#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what is submitted with a release: the recipe for conda-forge and the entry for 3D Slicer's extension index.

    write.py --repository URL --archive FILE --maintainer ACCOUNT --slicer-repository URL [--folder FOLDER]

The archive is the .tar.gz of the tag as the repository delivers it: its checksum goes into the recipe. The repository for 3D Slicer has the
contents of Applications/Slicer at its root. Nothing of this is known to the project itself, so no file of it has placeholders for them.
"""
import argparse
import hashlib
import json
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TEMPLATES = {"recipe.yaml.in": "recipe.yaml", "BoneDecimate.json.in": "BoneDecimate.json"}
URL = re.compile(r"https://[\w.-]+(/[\w.-]+)+")


def version():
    return re.search(r"project\(vtkBoneDecimate VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def filled(template, values):
    """Raises ValueError if a value is missing."""
    text = template.read_text(encoding="utf-8")
    missing = set(re.findall(r"@([A-Z0-9_]+)@", text)) - values.keys()
    if missing:
        raise ValueError(f"{template.name} needs {', '.join(sorted(missing))}")
    return re.sub(r"@([A-Z0-9_]+)@", lambda found: values[found[1]], text)


def url(text):
    found = text.removesuffix("/").removesuffix(".git")
    if not URL.fullmatch(found):
        raise argparse.ArgumentTypeError(f"'{text}' is no https address of a repository")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repository", type=url, required=True)
    parser.add_argument("--archive", type=pathlib.Path, required=True)
    parser.add_argument("--maintainer", required=True, help="an account of conda-forge")
    parser.add_argument("--slicer-repository", type=url, required=True)
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "submissions")
    arguments = parser.parse_args()
    values = {"VERSION": version(), "REPOSITORY": arguments.repository, "MAINTAINER": arguments.maintainer,
              "SHA256": hashlib.sha256(arguments.archive.read_bytes()).hexdigest(), "SLICER_REPOSITORY": arguments.slicer_repository}
    texts = {name: filled(HERE / template, values) for template, name in TEMPLATES.items()}
    json.loads(texts["BoneDecimate.json"])
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        (arguments.folder / name).write_text(text, encoding="utf-8")
        print(arguments.folder / name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
