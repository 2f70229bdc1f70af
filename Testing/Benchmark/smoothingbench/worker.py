# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One step on a label map, in a process of its own: python -m smoothingbench.worker STEP MAP.npz THREADS[,...] [RESULT.npz]

Prints a line of JSON for each number of threads: seconds and processor seconds (all threads) of the step alone, its memory, the number of triangles and a hash of
the result. RESULT.npz gets the surface of each label. The steps of this project need the package `bonedecimate` that is built with VTK;
the others run with any VTK that has the filter.
"""

from __future__ import annotations

import hashlib
import json
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from bonebench.peer_worker import forget_peak, give_back_memory, held
from vtkmodules import vtkFiltersCore
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

from .surfaces import arrays_of, image_of, isosurface

ERROR = 0.5  # mm, of the steps with a largest error
# A step's input, made before the clock starts, and the filters whose time is measured.
Step = Callable[[vtkImageData, int], list[Any]]


def chained(source: Any, filters: list[Any]) -> list[Any]:
    """Each filter gets the output of the one before."""
    for one in filters:
        if isinstance(source, (vtkImageData, vtkPolyData)):
            one.SetInputData(source)
        else:
            one.SetInputConnection(source.GetOutputPort())
        source = one
    return filters


def extraction(threads: int) -> Any:
    from bonedecimate import vtkBoneSurfaces
    return vtkBoneSurfaces(number_of_threads=threads)


def run(threads: int, mode: str = "FAST", **options: Any) -> Any:
    from bonedecimate import vtkBoneDecimate
    return vtkBoneDecimate(number_of_threads=threads, measure_distances=False, mode=getattr(vtkBoneDecimate, mode),
                           automatic_smoothing=True, label_array_name="BoundaryLabels", **options)


def smoothing(threads: int) -> Any:
    """Without distances and without a certificate, which the smoothing does not need."""
    return run(threads, target_reduction=0.0, prove_result=False)


def extracted(image: vtkImageData, threads: int) -> vtkPolyData:
    one = extraction(threads)
    one.SetInputData(image)
    one.Update()
    return one.GetOutput()


def extract(image: vtkImageData, threads: int) -> list[Any]:
    return chained(image, [extraction(threads)])


def smooth(image: vtkImageData, threads: int) -> list[Any]:
    return chained(extracted(image, threads), [smoothing(threads)])


def extract_and_smooth(image: vtkImageData, threads: int) -> list[Any]:
    return chained(image, [extraction(threads), smoothing(threads)])


def proved(image: vtkImageData, threads: int) -> list[Any]:
    """Smoothing and simplification within one largest error, with the certificate."""
    return chained(extracted(image, threads), [run(threads, maximum_error=ERROR, keep_voxels=0)])


def keep_voxels(image: vtkImageData, threads: int) -> list[Any]:
    """The same, and every voxel keeps its label."""
    return chained(extracted(image, threads), [run(threads, maximum_error=ERROR, keep_voxels=1)])


def simplified(keep: int) -> Step:
    """From the label map to the simplified surface, mode Balanced."""
    return lambda image, threads: chained(image, [extraction(threads), run(threads, "BALANCED", maximum_error=ERROR, keep_voxels=keep)])


def flying_edges(image: vtkImageData, _threads: int) -> list[Any]:
    contour = vtkFiltersCore.vtkFlyingEdges3D()
    contour.SetValue(0, 0.5)
    contour.ComputeNormalsOff()
    contour.ComputeGradientsOff()
    contour.ComputeScalarsOff()
    return chained(image, [contour])


def surface_nets(image: vtkImageData, _threads: int) -> list[Any]:
    nets = vtkFiltersCore.vtkSurfaceNets3D()
    values = np.unique(vtk_to_numpy(image.GetPointData().GetScalars()))
    for index, value in enumerate(value for value in values if value):
        nets.SetValue(index, value)
    nets.SetOutputMeshTypeToTriangles()
    return chained(image, [nets])


def sinc_of(factor: float) -> Any:
    """With the parameters of 3D Slicer's closed surface conversion."""
    smooth_ = vtkFiltersCore.vtkWindowedSincPolyDataFilter()
    smooth_.SetNumberOfIterations(int(20 + 40 * factor))
    smooth_.SetPassBand(10.0**(-4.0 * factor))
    smooth_.BoundarySmoothingOff()
    smooth_.FeatureEdgeSmoothingOff()
    smooth_.NonManifoldSmoothingOn()
    smooth_.NormalizeCoordinatesOn()
    return smooth_


def windowed_sinc(image: vtkImageData, _threads: int) -> list[Any]:
    return chained(isosurface(image, 0.5), [sinc_of(0.5)])


OURS: dict[str, Step] = {"extract": extract, "smooth": smooth, "extract and smooth": extract_and_smooth, "proved": proved,
                         "keep voxels": keep_voxels}
WHOLE: dict[str, Step] = {"within 0.5 mm": simplified(0), "within 0.5 mm, KeepVoxels": simplified(1)}
STEPS = OURS | WHOLE | {"vtkFlyingEdges3D": flying_edges, "vtkSurfaceNets3D": surface_nets, "windowed sinc": windowed_sinc}


def digest(surface: vtkPolyData) -> str:
    """Of the bytes of points, triangles and labels."""
    sum_ = hashlib.sha256()
    for array in (surface.GetPoints().GetData(), surface.GetPolys().GetConnectivityArray(),
                  surface.GetCellData().GetArray("BoundaryLabels")):
        if array:
            sum_.update(np.ascontiguousarray(vtk_to_numpy(array)))
    return sum_.hexdigest()


def label_surfaces(surface: vtkPolyData, values: np.ndarray) -> dict[str, np.ndarray]:
    """Points and triangles of each label."""
    from bonedecimate import vtkBoneSurfaces
    arrays = {}
    for value in values:
        one = vtkPolyData()
        vtkBoneSurfaces.ExtractLabel(surface, int(value), one)
        arrays[f"points {value}"], arrays[f"triangles {value}"] = arrays_of(one)
    return arrays


def report_of(surface: vtkPolyData) -> dict[str, Any]:
    text = surface.GetFieldData().GetAbstractArray("BoneDecimateReport")
    return json.loads(text.GetValue(0)) if text else {}


def measured(filters: list[Any]) -> tuple[vtkPolyData, dict[str, Any]]:
    """The output of the last filter, and what it took."""
    give_back_memory()
    forget_peak()
    before = held("VmRSS:")
    cpu, wall = time.process_time(), time.perf_counter()
    filters[-1].Update()
    figures = {"seconds": time.perf_counter() - wall, "cpu_seconds": time.process_time() - cpu, "held_bytes": before,
               "peak_bytes": held("VmHWM:") - before}
    return filters[-1].GetOutput(), figures


def warm_up(step: Step) -> None:
    """What is loaded at the first call is not the step's."""
    cube = np.zeros((5, 5, 5), np.uint8)
    cube[1:4, 1:4, 1:4] = 1
    step(image_of(cube, (1.0, 1.0, 1.0)), 1)[-1].Update()


def figures_of(step: Step, image: vtkImageData, threads: int) -> tuple[vtkPolyData, dict[str, Any]]:
    """The result, and what is printed of it."""
    if threads > 1 and vtkSMPTools.GetBackend() == "Sequential":  # of the VTK of PyPI
        vtkSMPTools.SetBackend("STDThread")
    vtkSMPTools.Initialize(threads)
    filters = step(image, threads)
    source = filters[0].GetInputDataObject(0, 0)
    surface, figures = measured(filters)
    report = report_of(surface)
    return surface, figures | {
        "threads": threads, "triangles": surface.GetNumberOfPolys(), "sha256": digest(surface), "vtk": vtkVersion.GetVTKVersion(),
        "input_triangles": source.GetNumberOfPolys() if isinstance(source, vtkPolyData) else 0,
        "smoothing": report.get("smoothing", {}), "voxel_check": report.get("voxels", {}), "proof": report.get("proof", {})}


def main(name: str, source: str, threads: str, target: str | None = None) -> None:
    step = STEPS[name]
    warm_up(step)
    with np.load(source) as file:
        labels = file["labels"]
        image = image_of(labels, file["spacing"], file["origin"])
        values = np.unique(labels[labels > 0])
    for count in threads.split(","):
        surface, figures = figures_of(step, image, int(count))
        print("\n" + json.dumps(figures), flush=True)
    if target:
        np.savez(target, **label_surfaces(surface, values))


if __name__ == "__main__":
    main(*sys.argv[1:5])
