# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python of Documentation/tutorials/slicer.md on a scene with the phantom as a segmentation.

    tutorial_test.py [--write]     --write puts what it prints now into the page

Needs the wheels slicer-core and bonedecimate; run.sh installs them and calls this.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import types

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from segmentation_test import image_of, scene_with

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Readme"))
from run_tutorial import run_page  # noqa: E402

PHANTOM = pathlib.Path(os.environ["BONEDECIMATE_PROGRAM"]).with_name("bonedecimate-phantom")


def phantom():
    """Labels (z, y, x), and the matrix from voxels to RAS; the file is in LPS."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "labels.mha"
        subprocess.run([PHANTOM, path, "--size", "small", "--labels"], check=True)
        reader = vtk.vtkMetaImageReader()
        reader.SetFileName(str(path))
        reader.Update()
        image = reader.GetOutput()
    (dx, dy, dz), (x, y, z) = image.GetSpacing(), image.GetOrigin()
    to_ras = np.array([[-dx, 0, 0, -x], [0, -dy, 0, -y], [0, 0, dz, z], [0, 0, 0, 1]])
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1]), to_ras


def main():
    labels, to_ras = phantom()
    scene, node, _ = scene_with(**{f"Segment_{label}": image_of(labels == label, to_ras) for label in (1, 2, 3)})
    node.SetName("labels")
    names = {"slicer": types.SimpleNamespace(mrmlScene=scene)}
    return run_page(ROOT / "Documentation" / "tutorials" / "slicer.md", "--write" in sys.argv, names)


if __name__ == "__main__":
    sys.exit(main())
