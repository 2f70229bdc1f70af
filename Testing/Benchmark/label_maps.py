#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Times the extraction of label maps by vtkBoneSurfaces and by VTK's filters: the table of Documentation/results/measurements.md.

    label_maps.py [--repeats 7] [--ct Cranium.inv3] [--json]

Runs with every VTK that Python finds and leaves out the filters that it does not have; vtkSurfaceNets3D needs 9.3. The label maps
are the CT of Debian's package invesalius-examples at 226 HU, the same bone in four parts, and random labels.
"""
import argparse
import json
import time
from pathlib import Path

import numpy as np
from smoothingbench.cases import CRANIUM, CT_SPACING, HU, ct_values
from smoothingbench.surfaces import image_of
from vtkmodules import vtkFiltersCore, vtkFiltersGeneral
from vtkmodules.vtkCommonCore import vtkVersion

try:
    from bonedecimate import vtkBoneSurfaces
except ImportError:
    vtkBoneSurfaces = None


def ct_labels(path):
    """The bone of the CT, and the same bone in four parts."""
    bone = (ct_values(path) >= HU).astype(np.uint8)
    _z, y, x = np.ogrid[:108, :256, :256]
    return bone, (bone * (1 + (x > 128) + 2 * (y > 120))).astype(np.uint8)


def padded_image(labels):
    """With a voxel of background on all sides, so that all filters give closed surfaces."""
    return image_of(np.pad(labels, 1), CT_SPACING)


def filters(values):
    """Name and function that makes a filter, as far as this VTK has it."""
    def with_values(kind):
        one = kind()
        for index, value in enumerate(values):
            one.SetValue(index, value)
        return one

    def bare(kind):
        one = with_values(kind)
        one.SetValue(0, 0.5)
        for name in ("ComputeNormalsOff", "ComputeGradientsOff", "ComputeScalarsOff"):
            getattr(one, name)()
        return one

    def surface_net(kind):
        one = with_values(kind)
        one.SmoothingOff()
        return one

    if vtkBoneSurfaces:
        yield "vtkBoneSurfaces", lambda: vtkBoneSurfaces(closed=False)
    if len(values) == 1:
        yield "vtkFlyingEdges3D", lambda: bare(vtkFiltersCore.vtkFlyingEdges3D)
    yield "vtkDiscreteFlyingEdges3D", lambda: with_values(vtkFiltersGeneral.vtkDiscreteFlyingEdges3D)
    yield "vtkDiscreteMarchingCubes", lambda: with_values(vtkFiltersGeneral.vtkDiscreteMarchingCubes)
    if hasattr(vtkFiltersCore, "vtkSurfaceNets3D"):
        yield "vtkSurfaceNets3D, not smoothed", lambda: surface_net(vtkFiltersCore.vtkSurfaceNets3D)
        yield "vtkSurfaceNets3D", lambda: with_values(vtkFiltersCore.vtkSurfaceNets3D)


def measured(make, image, repeats):
    """The least time, and the least time of all processors together, in seconds, and the output."""
    times, processor_times = [], []
    for _ in range(repeats):
        one = make()
        one.SetInputData(image)
        start, processor_start = time.perf_counter(), time.process_time()
        one.Update()
        times.append(time.perf_counter() - start)
        processor_times.append(time.process_time() - processor_start)
    return min(times), min(processor_times), one.GetOutput()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeats", type=int, default=7)
    parser.add_argument("--ct", type=Path, default=CRANIUM)
    parser.add_argument("--json", action="store_true", help="in the last line, for features.sh")
    options = parser.parse_args()
    bone, parts = ct_labels(options.ct)
    noise = np.random.default_rng(1).integers(0, 4, (64, 64, 64), dtype=np.uint8)
    rows = []
    for name, labels in (("CT, 1 label", bone), ("CT, 4 labels", parts), ("noise, 3 labels", noise)):
        image = padded_image(labels)
        for filter_name, make in filters(np.unique(labels)[1:].tolist()):
            seconds, processor_seconds, surface = measured(make, image, options.repeats)
            rows.append({"label map": name, "filter": f"`{filter_name}`", "VTK": vtkVersion.GetVTKVersion(), "time, s": round(seconds, 3),
                         "CPU s": round(processor_seconds, 3), "points": surface.GetNumberOfPoints(), "cells": surface.GetNumberOfCells()})
            print(", ".join(f"{column} {value}" for column, value in rows[-1].items()))
    if options.json:
        print(json.dumps(rows))


if __name__ == "__main__":
    main()
