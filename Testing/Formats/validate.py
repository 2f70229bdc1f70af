#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Validates GLB and 3MF files with programs of others.

    validate.py FILE...     ends with 1 if a validator finds an error

GLB: gltf-validator and gltfpack of npm (package.json, package-lock.json). 3MF: lib3mf of PyPI, and PrusaSlicer if Debian's
prusa-slicer is installed. The first two are installed in build/formats.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import venv
import xml.etree.ElementTree
import zipfile

FOLDER = pathlib.Path(__file__).resolve().parent
TOOLS = FOLDER.parents[1] / "build" / "formats"
LIB3MF = "lib3mf==2.5.0"


def install():
    if not (TOOLS / "node_modules").is_dir():
        TOOLS.mkdir(parents=True, exist_ok=True)
        for name in ("package.json", "package-lock.json", "validate_glb.js"):
            shutil.copy(FOLDER / name, TOOLS)
        subprocess.run(["npm", "ci", "--no-audit", "--no-fund"], cwd=TOOLS, check=True)
    if not (TOOLS / "python").is_dir():
        venv.create(TOOLS / "python", with_pip=True)
        subprocess.run([TOOLS / "python/bin/pip", "install", "--quiet", LIB3MF, "numpy"], check=True)


def check_glb(paths):
    """gltf-validator, and the sizes of what gltfpack makes of an OBJ file of the same name."""
    failed = subprocess.run(["node", TOOLS / "validate_glb.js", *paths], check=False).returncode != 0
    for path in paths:
        surface = path.with_suffix(".obj")
        for words in ([], ["-c"], ["-cc"]) if surface.exists() else ():
            packed = TOOLS / "packed.glb"
            subprocess.run([TOOLS / "node_modules/.bin/gltfpack", "-i", surface, "-o", packed, *words], check=True,
                           stdout=subprocess.DEVNULL)
            print(f"{path}: {path.stat().st_size} bytes; gltfpack {' '.join(words)}: {packed.stat().st_size} bytes")
    return failed


def check_3mf(path):
    failed = subprocess.run([TOOLS / "python/bin/python", __file__, "--lib3mf", path], check=False).returncode != 0
    is_solid = b'type="surface"' not in zipfile.ZipFile(path).read("3D/3dmodel.model")
    return failed or (is_solid and slice_info(path))


def by_lib3mf(path):
    """lib3mf in strict mode: no warning, closed parts, and the coordinates of the file in single precision."""
    import lib3mf
    import numpy

    model = lib3mf.get_wrapper().CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(path)
    failed = reader.GetWarningCount() > 0 or model.GetUnit() != lib3mf.ModelUnit.MilliMeter
    print(f"{path} lib3mf: {reader.GetWarningCount()} warnings")
    core = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    objects = xml.etree.ElementTree.fromstring(zipfile.ZipFile(path).read("3D/3dmodel.model")).iter(core + "object")
    parts = model.GetMeshObjects()
    while parts.MoveNext():
        part = parts.GetCurrentMeshObject()
        written = [[numpy.float32(vertex.get(axis)) for axis in "xyz"] for vertex in next(objects).iter(core + "vertex")]
        same = numpy.array_equal([list(vertex.Coordinates) for vertex in part.GetVertices()], written)
        closed = part.IsManifoldAndOriented()
        solid = part.GetType() == lib3mf.ObjectType.Model
        print(f"  {part.GetName() or 'surface'}: {part.GetTriangleCount()} triangles, closed {closed}, solid {solid}, same coordinates {same}")
        failed = failed or not same or closed != solid
    return failed


def slice_info(path):
    """PrusaSlicer repairs nothing and finds every part manifold."""
    if not shutil.which("prusa-slicer"):
        return False
    said = subprocess.run(["prusa-slicer", "--info", path], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False).stdout
    manifold = re.findall(r"^manifold = (\w+)", said, re.MULTILINE)
    problems = re.findall(r"^(?:open_edges|facets_\w+|backwards_edges|edges_fixed|degenerate_facets) = [1-9].*", said, re.MULTILINE)
    print(f"{path} PrusaSlicer: manifold {' '.join(manifold) or 'none'}; repaired: {', '.join(problems) or 'nothing'}")
    return not manifold or "no" in manifold or bool(problems)


def main(words):
    if words[:1] == ["--lib3mf"]:
        return by_lib3mf(words[1])
    install()
    paths = [pathlib.Path(word).resolve() for word in words]
    glb = [path for path in paths if path.suffix == ".glb"]
    results = [check_glb(glb)] if glb else []
    results += [check_3mf(path) for path in paths if path.suffix == ".3mf"]
    return any(results)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
