# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkBoneDecimate for the VTK that is there, whatever its version: the C++ filter's name, properties, arrays and report."""

from __future__ import annotations

import inspect
import math

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import _core
from .checks import label_value
from .label_arrays import add_grid
from .kept import KeepsPrepared
from .options import ROWS, assign, describe, nearest, words
from .report import number_text
from .run import InputArrays, fill_input_copy, fill_output, run
from .surface_report import checksum_of
from .surfaces import surface_from
from .voxel_check import Comparison, source_with

PROOF_STATUSES = ("not_requested", "proved", "violated", "undecided", "aborted")
POINTS, CELLS = vtkDataObject.FIELD_ASSOCIATION_POINTS, vtkDataObject.FIELD_ASSOCIATION_CELLS


class vtkBoneDecimate(KeepsPrepared, VTKPythonAlgorithmBase):
    """Make a bone surface smaller, keep every fragment, report the error in millimeters.

    Input port 0: vtkPolyData of triangles, strips or polygons, mm. Input port 1, optional: the reference, the surface
    that the input was made from; with it MaximumError is proved and measured against the reference. Input port 2, optional: the label
    map, vtkImageData, that another program extracted the input from; KeepVoxels and AutomaticSmoothing use its grid. Output port 0: the smaller surface; point data: the
    distance to the input, the error recorded along the collapses (mm) and how many input points each point represents;
    field data: the report as one JSON text, BoneDecimateReport, and its main figures as arrays (bonedecimate.output.triangles, ...).
    Vertices and lines pass through. Output port 1: the input, with the distance of each of its points to the result when MeasureInputDistances is on.

    Tolerances and labels are arrays of the input, chosen by name or by SetInputArrayToProcess(TOLERANCE_ARRAY or LABEL_ARRAY, ...);
    a name takes precedence. The arrays of vtkBoneSurfaces and of image.bone.surfaces() say from which label map the input was made:
    KeepVoxels and AutomaticSmoothing use them, and the result has its own BoundaryLabels.

    Every option is SetName() and GetName(), a Python property (name.maximum_error = 0.2), and a keyword of the constructor.
    A value out of its range is a ValueError, one of a wrong type a TypeError, and the value before stays; an unknown name
    is an AttributeError. An input that cannot be used is an ErrorEvent with an empty output, as everywhere in VTK; an
    empty one gives an empty output. Ctrl-C in the main thread ends the run, and Update() raises KeyboardInterrupt.
    """

    def __init__(self, **properties) -> None:
        super().__init__(nInputPorts=3, inputType="vtkPolyData", nOutputPorts=2, outputType="vtkPolyData")
        self._options = _core.Options()
        self._forget_report()
        self._interrupted = False
        self._error_code = self._percent = self._time_of_run = 0
        self._label = 0
        for name, value in properties.items():
            if name not in PROPERTIES:
                raise TypeError(f"vtkBoneDecimate has no property '{name}'{_meant(name)}")
            setattr(self, name, value)

    def __setattr__(self, name: str, value) -> None:
        """Unknown names are errors, since nothing would read them. Derived classes may have others."""
        if not (name.startswith("_") or name in ("InputType", "OutputType") or _is_settable(type(self), name)):
            if type(self) is vtkBoneDecimate or hasattr(type(self), name) or nearest(name, PROPERTIES):
                raise AttributeError(f"vtkBoneDecimate has no property '{name}'{_meant(name)}")
        super().__setattr__(name, value)

    def SetInputData(self, data: vtkPolyData) -> None:
        self.SetInputDataObject(data)

    def SetReferenceData(self, reference: vtkPolyData) -> None:
        self.SetInputDataObject(1, reference)

    def SetReferenceConnection(self, reference) -> None:
        self.SetInputConnection(1, reference)

    def SetLabelMapData(self, label_map: vtkImageData) -> None:
        """The label map that the input was extracted from, if the input does not carry its grid."""
        self.SetInputDataObject(2, label_map)

    def SetLabelMapConnection(self, label_map) -> None:
        self.SetInputConnection(2, label_map)

    def SetLabel(self, label: int) -> None:
        """The label that the input encloses, of a label map with several; 0, the default: the only one."""
        self._label = label_value("label", label)
        self.Modified()

    def GetLabel(self) -> int:
        return self._label

    label = property(GetLabel, SetLabel, doc="The label that the input encloses, of a label map with several; 0: the only one.")

    def FillInputPortInformation(self, port: int, info) -> int:
        if port > 0:
            info.Set(vtkAlgorithm.INPUT_IS_OPTIONAL(), 1)
        known = super().FillInputPortInformation(port, info)
        if port == 2:
            info.Set(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), "vtkImageData")
        return known

    def GetInput(self) -> vtkPolyData:
        return self.GetInputDataObject(0, 0)

    def GetOutput(self, port: int = 0) -> vtkPolyData:
        return self.GetOutputDataObject(port)

    def GetRejectedValue(self, _property: str) -> str:
        """Always empty: a value out of its range raises at once and leaves the property as it was."""
        return ""

    def GetStopReason(self) -> int:
        """Why the last run ended: NOT_RUN, TARGET_REACHED, ..."""
        return self._stop.value

    def GetStopReasonAsString(self) -> str:
        """Why the last run ended, as a sentence."""
        return _core.stop_sentence(self._stop)

    def GetProvedError(self) -> float:
        """Proved upper bound of the distance to the input (or the reference), both directions and boundaries, mm; NaN without a
        proof and before the first update."""
        return self.GetReportValue("proof.upper")

    def GetProofStatus(self) -> int:
        """Whether the largest error is proved: NO_PROOF, PROVED, VIOLATED, UNDECIDED or PROOF_ABORTED."""
        return PROOF_STATUSES.index(self.GetReportText("proof.status") or PROOF_STATUSES[0])

    def GetProofStatusAsString(self) -> str:
        """The same in one word: "proved", "violated", "undecided", "aborted", "no_proof", or "not_requested" if the error is proved and there is no
        largest error to compare with."""
        return self.GetReportText("proof.status") or "no_proof"

    def GetMeasuredError(self) -> float:
        """Largest distance by samples, both directions, mm; NaN without MeasureDistances and before the first update."""
        return max(self.GetReportValue(f"distance.{direction}.max") for direction in ("output_to_input", "input_to_output"))

    def GetNumberOfInputTriangles(self) -> int:
        """Triangles of the input after cleaning and pruning; 0 before the first update."""
        return int(self.GetReportValue("input.triangles"))

    def GetNumberOfOutputTriangles(self) -> int:
        """Triangles of the result; 0 before the first update."""
        return int(self.GetReportValue("output.triangles"))

    def GetNumberOfRejectedEdits(self, reason: str = "") -> int:
        """Edits that were rejected, for all reasons or for one of the report ("error_bound"); 0 before the first update."""
        if not reason:
            return self._rejected_edits
        value = self.GetReportValue("rejections." + reason)
        return 0 if math.isnan(value) else int(value)

    def HasOption(self, name: str) -> bool:
        """Whether there is an option of that name ("MaximumError")."""
        return any(row.name == name for row in ROWS.values())

    def SetOptionFromText(self, name: str, text: str) -> bool:
        """Sets an option by its name from text; raises AttributeError for an unknown name, ValueError for a value out of range."""
        if not self.HasOption(name):
            raise AttributeError(f"vtkBoneDecimate has no option '{name}'{_meant(name)}")
        self._options.read(name, text)
        self.Modified()
        return True

    def GetOptionAsText(self, name: str) -> str:
        """Value of an option as SetOptionFromText() reads it; empty if there is no such option."""
        return self._options.text(name) if self.HasOption(name) else ""

    def GetReportAsJson(self) -> str:
        """The report as JSON, objects within objects, as Documentation/report.schema.json describes it."""
        return self._json

    @staticmethod
    def HasReportOfItself(surface: vtkPolyData) -> bool:
        """Whether the report that a surface carries in its field data was made for this very surface: whether its triangles have
        the checksum of the report, to the bit and in any order. If not, what the report proves was proved of another surface."""
        array = surface.GetFieldData().GetAbstractArray("bonedecimate.output.checksum")
        return array is not None and array.GetNumberOfValues() > 0 and array.GetValue(0) == checksum_of(surface)

    @staticmethod
    def GetTriangleChecksum(surface: vtkPolyData) -> str:
        """That checksum, "triangles:0123456789abcdef"."""
        return checksum_of(surface)

    def GetNumberOfReportEntries(self) -> int:
        """Number of entries of the report as a flat list of named values."""
        return len(self._entries)

    def GetReportEntryName(self, entry: int) -> str:
        """Name of an entry, 0 to GetNumberOfReportEntries() - 1; empty for other numbers."""
        return self._entries[entry][0] if 0 <= entry < len(self._entries) else ""

    def GetReportEntryUnit(self, name: str) -> str:
        """Unit of the entry of that name; empty if it has none."""
        return self._entry(name)[1]

    def GetReportValue(self, name: str) -> float:
        """A number of the report; NaN where the name is unknown or the entry is a text."""
        value = self._entry(name)[2]
        return math.nan if isinstance(value, str) else float(value)

    def GetReportText(self, name: str) -> str:
        """An entry as text, numbers with all their digits; empty where the name is unknown."""
        value = self._entry(name)[2]
        return number_text(value) if isinstance(value, float) else str(value)

    def _entry(self, name: str) -> tuple[str, str, int | float | str]:
        return next((entry for entry in self._entries if entry[0] == name), (name, "", ""))

    def Update(self, *arguments) -> None:
        super().Update(*arguments)
        if self.GetExecutive().GetPipelineMTime() > self._time_of_run:  # VTK does not run a filter if one before it fails
            self._error_code = self.INPUT_FAILED
            self._forget_report()
        if self._interrupted:
            self._interrupted = False
            raise KeyboardInterrupt

    def GetErrorCode(self) -> int:
        """Why the last update failed: 0, REJECTED_RUN, NOT_PROVED or INPUT_FAILED; the error event has the reason."""
        return self._error_code

    def RequestData(self, _request, inInfo, outInfo) -> int:
        self._error_code = self._percent = 0
        self._time_of_run = self.GetExecutive().GetPipelineMTime()
        self._forget_report()
        self.SetProgressText("Simplifying the surface")
        try:
            data = self._with_label_map(vtkPolyData.GetData(inInfo[0]), vtkImageData.GetData(inInfo[2]))
            return self._run(data, vtkPolyData.GetData(inInfo[1]), *(vtkPolyData.GetData(outInfo, port) for port in range(2)))
        except (ValueError, MemoryError) as problem:
            return self._fail(str(problem) or "out of memory")
        except KeyboardInterrupt:  # VTK would print it and go on
            self._interrupted = True
            return 0

    def _forget_report(self) -> None:
        """No figure of a run outlives its surface if the next one fails."""
        self._entries, self._json, self._stop, self._rejected_edits = _core.empty_report(), _core.empty_json(), _core.StopReason.NotRun, 0

    def _with_label_map(self, data: vtkPolyData, label_map: vtkImageData | None) -> vtkPolyData:
        """The input, or a copy with the grid of the label map. Warns of voxels in which both differ."""
        if label_map is None and self._label != 0:
            raise ValueError("Label has no effect without a label map")
        if label_map is None or data.GetNumberOfPoints() == 0:
            return data
        surface = surface_from(data, "input", with_source=True)
        source, labels = source_with(surface, label_map)
        for sentence in Comparison(surface, labels, label=self._label or None).differences(self._options.get("NumberOfThreads")):
            self._say("WarningEvent", sentence)
        copy = vtkPolyData()
        copy.ShallowCopy(data)
        add_grid(source.grid, copy)
        return copy

    def _run(self, data: vtkPolyData, reference: vtkPolyData | None, output: vtkPolyData, input_copy: vtkPolyData) -> int:
        outcome, surface = run(data, self._options, self._should_continue, reference, self._input_arrays(data), self._kept())
        self._entries, self._json, self._stop, self._rejected_edits = (outcome[name] for name in ("entries", "json", "stop", "rejected_edits"))
        status = outcome["status"]
        if status == _core.InputStatus.NoTriangles:
            self._say("WarningEvent", outcome["problem"])
        elif status not in (_core.InputStatus.Good, _core.InputStatus.Empty):
            return self._fail(outcome["problem"])
        for warning in outcome["warnings"]:
            self._say("WarningEvent", warning)
        fill_output(outcome, surface, self._options, data, output)
        fill_input_copy(outcome, self._options, data, input_copy)
        if outcome["contradiction"]:
            self._error_code = self.NOT_PROVED
            self._say("ErrorEvent", outcome["contradiction"])
        return 1

    def _input_arrays(self, data: vtkPolyData) -> InputArrays:
        """Of SetInputArrayToProcess; a name among the options takes precedence and is read there."""
        found = {}
        for index, name in ((self.TOLERANCE_ARRAY, "ToleranceArrayName"), (self.LABEL_ARRAY, "LabelArrayName")):
            chosen = self.GetInformation().Get(vtkAlgorithm.INPUT_ARRAYS_TO_PROCESS())
            information = chosen.GetInformationObject(index) if chosen and index < chosen.GetNumberOfInformationObjects() else None
            if self._options.get(name) or not information or not information.Has(vtkDataObject.FIELD_ASSOCIATION()):
                continue
            association = information.Get(vtkDataObject.FIELD_ASSOCIATION())
            attributes = data.GetCellData() if association == CELLS else data.GetPointData()
            # VTK 9.1 does not wrap GetInputArrayToProcess() for Python.
            array = (attributes.GetArray(information.Get(vtkDataObject.FIELD_NAME())) if information.Has(vtkDataObject.FIELD_NAME()) else
                     attributes.GetAttribute(information.Get(vtkDataObject.FIELD_ATTRIBUTE_TYPE())))
            is_label = index == self.LABEL_ARRAY
            if array is None or not (association == POINTS or (is_label and association == CELLS)):
                kind = "cell or point array" if is_label else "point array"
                name = information.Get(vtkDataObject.FIELD_NAME())
                raise ValueError(f"the input has no {kind} " + (f"'{name}'" if name else f"for index {index}"))
            found.update({"labels": array, "labels_are_of_cells": association == CELLS} if is_label else {"tolerances": array})
        return InputArrays(**found) if data.GetNumberOfPoints() else InputArrays()

    def _should_continue(self, fraction: float) -> bool:
        """An event per percent. An aborted run still has a valid surface: CheckAbort() would have the executive throw it away."""
        while not self.GetAbortExecute() and self._percent < int(100 * fraction + 1e-9):
            self._percent += 1
            self.UpdateProgress(self._percent / 100)
        return not self.GetAbortExecute()

    def _fail(self, text: str) -> int:
        self._error_code = self.REJECTED_RUN
        for port in range(2):  # also of field data, which VTK passes from the input
            self.GetOutput(port).Initialize()
        self._say("ErrorEvent", text)
        return 0

    def _say(self, event: str, text: str) -> None:
        """To the observers, or to VTK's output window if there are none, as the macros of C++ do."""
        if not self.GetGlobalWarningDisplay():
            return
        if self.HasObserver(event):
            self.InvokeEvent(event, text)
        elif event == "ErrorEvent":
            vtkOutputWindow.GetInstance().DisplayErrorText(f"ERROR: In vtkBoneDecimate: {text}\n")
        else:
            vtkOutputWindow.GetInstance().DisplayWarningText(f"Warning: In vtkBoneDecimate: {text}\n")

    def __str__(self) -> str:
        units = {row.name: f" {row.unit}" if row.unit else "" for row in ROWS.values()}
        lines = [f"  {name}: {self._options.text(name)}{unit}" for name, unit in units.items()]
        return "\n".join([super().__str__().rstrip("\n"), *lines, f"  StopReason: {self.GetStopReasonAsString()}", ""])


def _is_settable(kind: type, name: str) -> bool:
    """Methods are not: they would be hidden."""
    return inspect.isdatadescriptor(getattr(kind, name, None))


def _meant(name: str) -> str:
    word = name.removeprefix("Set")
    found = nearest(word, PROPERTIES)
    return f"; did you mean '{found}'?" if found else ""


def _add_property(key: str, row: _core.OptionInfo) -> None:
    """SetName(), GetName(), the property name and, for a switch, NameOn() and NameOff()."""
    def put(self, value) -> None:
        if assign(self._options, key, value, by_number=True):
            self.Modified()

    def get(self):
        return self._options.get(row.name)

    def switch(name: str, value: bool):
        def turn(self) -> None:
            put(self, value)
        return _named(turn, name, describe(row))

    members = [_named(put, "Set" + row.name, describe(row)), _named(get, "Get" + row.name, describe(row))]
    if row.kind == "bool":
        members += [switch(row.name + "On", True), switch(row.name + "Off", False)]
    for member in members:
        setattr(vtkBoneDecimate, member.__name__, member)
    setattr(vtkBoneDecimate, words(row.name, "_"), property(get, put, doc=describe(row)))


def _named(function, name: str, text: str):
    function.__name__, function.__qualname__, function.__doc__ = name, f"vtkBoneDecimate.{name}", text
    return function


def _add_getter(name: str) -> None:
    """A property for a getter: GetProvedError() as proved_error."""
    getter = getattr(vtkBoneDecimate, "Get" + name)
    setattr(vtkBoneDecimate, words(name, "_"), property(lambda self: getter(self), doc=getter.__doc__))


def _add_mode(mode) -> None:
    """SetModeToFast() and so on."""
    def choose(self) -> None:
        self.SetMode(mode.value)
    name = "SetModeTo" + mode.name
    setattr(vtkBoneDecimate, name, _named(choose, name, ""))


PROPERTIES = {words(row.name, "_"): key for key, row in ROWS.items()}  # keyword of each property
_parameters = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=ROWS[key].default,
                                 annotation="int" if ROWS[key].choices else ROWS[key].kind)
               for name, key in PROPERTIES.items()]
vtkBoneDecimate.__init__.__signature__ = inspect.Signature(
    [inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD), *_parameters])
for _key, _row in ROWS.items():
    _add_property(_key, _row)
for _name in ("ProvedError", "ProofStatus", "ProofStatusAsString", "MeasuredError", "NumberOfInputTriangles",
              "NumberOfOutputTriangles", "NumberOfRejectedEdits", "ReportAsJson", "StopReason", "StopReasonAsString",
              "NumberOfReportEntries"):
    _add_getter(_name)
for _mode in _core.Mode:
    _add_mode(_mode)
for _value, _name in enumerate(("NO_PROOF", "PROVED", "VIOLATED", "UNDECIDED", "PROOF_ABORTED")):
    setattr(vtkBoneDecimate, _name, _value)
vtkBoneDecimate.TOLERANCE_ARRAY, vtkBoneDecimate.LABEL_ARRAY = 0, 1
for _value, _name in enumerate(("REJECTED_VALUE", "REJECTED_RUN", "NOT_PROVED", "INPUT_FAILED"), 40001):  # as in C++
    setattr(vtkBoneDecimate, _name, _value)
for _enumeration in (_core.Mode, _core.ErrorPreset, _core.KeepVoxels, _core.StopReason):
    for _member in _enumeration:
        setattr(vtkBoneDecimate, words(_member.name, "_").upper(), _member.value)
