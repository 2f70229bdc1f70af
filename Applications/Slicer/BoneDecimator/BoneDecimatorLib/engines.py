# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What runs the decimation: the wheel `bonedecimate` in Slicer's own Python, or the program `bonedecimate` beside it."""

import functools
import importlib.util
import json
import re
import shutil
import subprocess
import tempfile
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

from .checks import DecimationError
from .comparison import Comparison
from .option_table import OptionTable

PACKAGE_VERSION = "1.0.0"  # of the Python package that this module was made for
TOLERANCE = "Tolerance"  # mm, point array of what goes in
VIOLATED_OR_UNDECIDED = (6, 7)  # exit codes of the command certify
CAP_TOLERANCE = 0.01  # mm, how far points of a boundary may lie from its plane


class NoEngine(DecimationError):
    """Neither the wheel nor the program was found."""


class Canceled(DecimationError):
    """The user canceled the run; nothing has changed."""


@dataclass
class SharedSurfaces:
    """The surfaces of all segments of a label map, simplified together; a wall between two of them is there once."""

    points: np.ndarray  # (n, 3), mm
    triangles: np.ndarray  # (m, 3)
    sides: np.ndarray  # (m, 2), values of the label map on both sides; normals point from the first to the second
    distance: np.ndarray  # (n,), mm, to the surfaces of the voxels; empty if it was not measured
    report: dict  # nested
    warnings: list

    def segment(self, value):
        """Points and triangles of the closed surface of one value, and for each point its index in `points`."""
        from bonedecimate import extract_label
        points, triangles = extract_label(self.points, self.triangles, self.sides, value)
        all_rows, rows = (np.ascontiguousarray(each, float).view([("", float)] * 3).ravel() for each in (self.points, points))
        order = np.argsort(all_rows)
        return points, triangles, order[np.searchsorted(all_rows, rows, sorter=order)]


def find_engine(program=None):
    """The wheel if it is installed, else the program; raises NoEngine with what to do if there is neither."""
    if importlib.util.find_spec("bonedecimate") is not None and importlib.util.find_spec("bonedecimate._core") is not None:
        return WheelEngine()
    program = program or shutil.which("bonedecimate")
    if program:
        return ProgramEngine(program)
    raise NoEngine("Neither the Python package bonedecimate nor the program bonedecimate is there. Install the package in the section "
                   "'Python package', or put the program on the PATH.")


def _write(surface, file):
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(surface)
    if not writer.Write():
        raise DecimationError(f"Could not write to {file.parent}.")


def with_tolerances(surface, tolerances):
    """A shallow copy with the point array that engines read."""
    copy = vtk.vtkPolyData()
    copy.ShallowCopy(surface)
    if tolerances is not None:
        array = numpy_to_vtk(tolerances, deep=True)
        array.SetName(TOLERANCE)
        copy.GetPointData().AddArray(array)
    return copy


class WheelEngine:
    """In this process."""

    has_levels = True

    def __init__(self):
        self._kept = None  # options and filter of the last run

    @functools.cached_property
    def table(self):
        try:
            from bonedecimate._core import option_table_json
        except ImportError as problem:
            raise DecimationError(f"Install the current wheel of the Python package bonedecimate: {problem}.") from problem
        return OptionTable(option_table_json())

    def release(self):
        """Frees what was kept for further strokes of a brush."""
        self._kept = None

    def _filter_of(self, options, keep):
        """The filter of the last run if it has these options: it runs only those regions of the same surface that are new."""
        from bonedecimate import vtkBoneDecimate
        if keep and self._kept is not None and self._kept[0] == options:
            return self._kept[1]
        decimate = vtkBoneDecimate()
        for flag, value in options.items():
            row = self.table.by_flag[flag]
            getattr(decimate, "Set" + row["name"])(row["choices"].index(value) if row["choices"] else value)
        if keep:
            self._kept = dict(options), decimate
        return decimate

    def decimate_segments(self, label_map, options, tolerances=None, progress=None, model_grid="auto"):
        """SharedSurfaces of a LabelMap.

        @param options, progress As of decimate().
        @param tolerances Function from points (n, 3), mm, to mm at each of them.
        @param model_grid As of a Request.
        """
        import bonedecimate
        keywords = {flag.replace("-", "_"): value for flag, value in options.items()}
        goes_on = _Progress(progress)
        try:
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                found = bonedecimate.extract_surfaces(
                    label_map.voxels, axes="zyx", spacing=label_map.spacing, origin=label_map.origin, direction=label_map.direction,
                    model_grid=model_grid, progress=goes_on)
                limits = None if tolerances is None else tolerances(found.points)
                small = bonedecimate.decimate(found, tolerances=limits, progress=goes_on, **keywords)
        except bonedecimate.Aborted as problem:
            raise Canceled("Canceled.") from problem
        except (OverflowError, TypeError, ValueError) as problem:
            raise DecimationError(str(problem)) from problem
        if goes_on.was_stopped:
            raise Canceled("Canceled.")
        return SharedSurfaces(small.points, small.triangles, small.boundary_labels, small.distance,
                              json.loads(small.report_as_json),
                              [found.model_grid_found] * bool(found.model_grid_found) + [str(each.message) for each in caught])

    def decimate(self, surface, options, tolerances=None, progress=None, keep=True):
        """@param options Those of a Request: checked flags and values.
        @param progress Called with the fraction done; returns False to cancel.
        @param keep Whether the next run of the same surface runs only the regions of a brush that are new.
        """
        decimate = self._filter_of(options, keep)
        decimate.SetToleranceArrayName("" if tolerances is None else TOLERANCE)
        problems, canceled = [], []

        def tell(caller, _event):
            if progress and progress(caller.GetProgress()) is False:
                canceled.append(True)
                caller.SetAbortExecute(1)

        observers = [decimate.AddObserver("ErrorEvent", _collector(problems)), decimate.AddObserver("ProgressEvent", tell)]
        decimate.SetAbortExecute(0)
        decimate.SetInputDataObject(0, with_tolerances(surface, tolerances))
        try:
            decimate.Update()
        finally:
            for observer in observers:
                decimate.RemoveObserver(observer)
        if canceled:
            raise Canceled("Canceled.")
        if problems:
            raise DecimationError(problems[0])
        result = vtk.vtkPolyData()  # the filter fills its own output again
        result.ShallowCopy(decimate.GetOutputDataObject(0))
        return result

    def cap(self, surface, loops):
        """The surface with its boundaries closed, and sentences about what stays open.  @param loops "planes" or "all"."""
        from bonedecimate.caps import close_boundaries
        closed = vtk.vtkPolyData()
        try:
            _counts, notes = close_boundaries(surface, loops, CAP_TOLERANCE, closed)
        except (TypeError, ValueError) as problem:
            raise DecimationError(str(problem)) from problem
        return closed, notes

    def compare(self, reference, result, tolerance=None, progress=None):
        """A Comparison of two surfaces.  @param tolerance mm; None: none."""
        import bonedecimate
        goes_on = _Progress(progress)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # the report has what was left out
                found = bonedecimate.certify(reference, result, tolerance=tolerance, progress=goes_on)
        except (TypeError, ValueError) as problem:
            raise DecimationError(str(problem)) from problem
        if found.stopped:
            raise Canceled("Canceled.")
        return Comparison(json.loads(found.report_as_json), (abs(found.reference_distance), abs(found.result_distance)))

    def record_levels(self, surface, options):
        """bonedecimate.Levels of the surface's triangles."""
        import bonedecimate
        from bonedecimate.polydata import surface_of
        found = surface_of(surface)
        keywords = {flag.replace("-", "_"): value for flag, value in options.items()}
        points = found.points.astype("float32") if found.is_single else found.points
        return bonedecimate.record_levels(points, found.triangles, **keywords)


class _Progress:
    """Tells the fraction done, and remembers whether the run was stopped."""

    def __init__(self, function):
        self.function, self.was_stopped = function, False

    def __call__(self, fraction):
        self.was_stopped = self.was_stopped or (self.function is not None and self.function(fraction) is False)
        return not self.was_stopped


def _collector(problems):
    def collect(_caller, _event, text):
        problems.append(text.strip().splitlines()[-1])

    collect.CallDataType = vtk.VTK_STRING
    return collect


class ProgramEngine:
    """In a process of its own, through files."""

    has_levels = False

    def __init__(self, program):
        self.program = str(program)

    @functools.cached_property
    def table(self):
        try:
            printed = subprocess.run([self.program, "--options-json"], capture_output=True, encoding="utf-8", check=True)
            return OptionTable(printed.stdout)
        except (OSError, ValueError, subprocess.CalledProcessError) as problem:
            raise DecimationError(f"{self.program} prints no table of options; install its current version.") from problem

    def release(self):
        """Nothing is kept between runs."""

    def decimate_segments(self, *_arguments, **_keywords):
        raise DecimationError("Segments need the Python package bonedecimate in Slicer's Python.")

    def decimate(self, surface, options, tolerances=None, progress=None, keep=True):
        words = []
        for flag, value in options.items():
            words += ["--" + flag, "on" if value is True else "off" if value is False else str(value)]
        if tolerances is not None:
            words += ["--tolerance-array", TOLERANCE]

        def line_of(folder, files):
            return ["--returnparameterfile", str(Path(folder, "results.txt")), *words, *files]

        return self._run_on_files(with_tolerances(surface, tolerances), line_of, progress)

    def cap(self, surface, loops):
        """As that of the wheel; the report of the command says what stays open."""
        counts = {}

        def file_in(folder):
            return Path(folder, "caps.json")

        def line_of(folder, files):
            return ["cap", *files, "--loops", loops, "--plane-tolerance", str(CAP_TOLERANCE), "--json", str(file_in(folder)), "--quiet"]

        def read(folder):
            counts.update(json.loads(file_in(folder).read_text(encoding="utf-8")))

        closed = self._run_on_files(surface, line_of, None, read)
        is_open = counts["open_loops"]
        return closed, [f"{is_open} boundaries stay open"] if is_open else []

    def compare(self, reference, result, tolerance=None, progress=None):
        """As that of the wheel, without distances of points."""
        with tempfile.TemporaryDirectory(prefix="bonedecimate-") as folder:
            files = [Path(folder, name) for name in ("reference.vtp", "result.vtp")]
            for surface, file in zip((reference, result), files):
                _write(surface, file)
            report = Path(folder, "certificate.json")
            words = [] if tolerance is None else ["--tolerance", repr(float(tolerance))]
            self._run([self.program, "certify", *map(str, files), "--json", str(report), "--quiet", *words], progress, VIOLATED_OR_UNDECIDED)
            return Comparison(json.loads(report.read_text(encoding="utf-8")), None)

    def _run_on_files(self, surface, line_of, progress, read=None):
        """What the program makes of a surface.

        @param line_of Function of the folder and the two files to the words behind the program.
        @param read Called with the folder afterwards; None: nothing else is read.
        """
        with tempfile.TemporaryDirectory(prefix="bonedecimate-") as folder:
            source, target = Path(folder, "input.vtp"), Path(folder, "output.vtp")
            _write(surface, source)
            self._run([self.program, *line_of(folder, [str(source), str(target)])], progress)
            if read is not None:
                read(folder)
            reader = vtk.vtkXMLPolyDataReader()
            reader.SetFileName(str(target))
            reader.Update()
            if reader.GetErrorCode():
                raise DecimationError(f"Could not read from {folder}.")
            return reader.GetOutput()

    @staticmethod
    def _run(words, progress, accepted=()):
        """@param accepted Exit codes beside 0 that are results."""
        # A file takes any number of messages while only the other stream is read.
        with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as errors:
            with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=errors, text=True) as process:
                for line in process.stdout:
                    found = re.match(r"<filter-progress>(.*)</filter-progress>", line)
                    if found and progress and progress(float(found[1])) is False:
                        process.kill()
                        raise Canceled("Canceled.")
            errors.seek(0)
            problem = errors.read().strip()
        if process.returncode != 0 and process.returncode not in accepted:
            raise DecimationError(problem or f"The program ended with {process.returncode}.")
