# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The other readers of this project: the wheel, and the page in the browser (BONEDECIMATE_PAGE is a folder with node_modules/)."""

import json
import os
import pathlib
import shutil
import subprocess
import warnings

import numpy as np

from readers import nibabel, optional
from truth import Reading, NotRead

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = os.environ.get("BONEDECIMATE_PAGE")
wheel = optional("bonedecimate.scans") if nibabel else None
page = PAGE if PAGE and shutil.which("node") else None
_processes = {}  # by the process that started it


def wheel_nifti(path, choice):
    image = nibabel.load(str(path))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        scan = wheel.scan_of(image)
    if np.ndim(scan.labels) != 3 or scan.labels.dtype.names or scan.labels.dtype.kind not in "iuf":
        raise NotRead("no volume of numbers")
    affine = scan.where["affine"]
    return Reading(np.asarray(scan.labels), affine[:3, 3], affine[:3, :3].T)


def _page_process():
    if os.getpid() not in _processes:
        module = pathlib.Path(PAGE) / "nifti.mjs"
        shutil.copy(ROOT / "Applications" / "Browser" / "nifti.js", module)
        words = ["node", str(pathlib.Path(__file__).with_name("read_page.mjs")), str(module)]
        _processes[os.getpid()] = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                                   encoding="utf-8")
    return _processes[os.getpid()]


def page_nifti(path, choice):
    process = _page_process()
    process.stdin.write(f"{path}\n")
    process.stdin.flush()
    result = json.loads(process.stdout.readline())
    if "error" in result:
        raise NotRead(result["error"])
    grid = result["grid"]
    direction = np.array(grid["direction"]).reshape(3, 3)
    voxels = np.array(result["labels"]).reshape(grid["dimensions"], order="F")
    return Reading(voxels, np.array(grid["origin"]), (direction * grid["spacing"]).T, is_label_map=True)
