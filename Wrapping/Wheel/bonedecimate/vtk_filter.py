# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkBoneDecimate for the VTK that is there, whatever its version: the C++ filter's name, properties, arrays and report."""

from __future__ import annotations

import inspect
import math

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import _core
from .options import ROWS, assign, describe, nearest, words
from .run import fill_input_copy, fill_output, run


class vtkBoneDecimate(VTKPythonAlgorithmBase):
    """Make a bone surface smaller, keep every fragment, report the error in millimeters.

    Input port 0: vtkPolyData of triangles, strips or polygons, mm. Input port 1, optional: the reference, what that was made
    from by runs before; with it MaximumError is promised, proved and measured against the reference. Output port 0: the smaller surface; point data: the
    distance to the input, the error recorded along the collapses (mm) and how many input points each point stands for;
    field data: the report, one array an entry ("bonedecimate." and its name). Vertices and lines pass through.
    Output port 1: the input, with the distance of each of its points to the result when MeasureInputDistances is on.

    Every option is SetName() and GetName(), a Python property (name.maximum_error = 0.2), and a keyword of the constructor.
    A value out of its range is a ValueError, one of a wrong type a TypeError, and the value before stays; a name that there
    is not is an AttributeError. An input that cannot be used is an ErrorEvent with an empty output, as everywhere in VTK; an
    empty one gives an empty output. Ctrl-C in the main thread ends the run, and Update() raises KeyboardInterrupt.
    """

    def __init__(self, **properties) -> None:
        super().__init__(nInputPorts=2, inputType="vtkPolyData", nOutputPorts=2, outputType="vtkPolyData")
        self._options = _core.Options()
        self._entries = _core.empty_report()
        self._stop = _core.StopReason.NotRun
        self._interrupted = False
        for name, value in properties.items():
            if name not in PROPERTIES:
                raise TypeError(f"vtkBoneDecimate has no property '{name}'{_meant(name)}")
            setattr(self, name, value)

    def __setattr__(self, name: str, value) -> None:
        """Names that there are not are refused, since nothing would read them. Classes made of this one may have others."""
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

    def FillInputPortInformation(self, port: int, info) -> int:
        if port == 1:
            info.Set(vtkAlgorithm.INPUT_IS_OPTIONAL(), 1)
        return super().FillInputPortInformation(port, info)

    def GetInput(self) -> vtkPolyData:
        return self.GetInputDataObject(0, 0)

    def GetOutput(self, port: int = 0) -> vtkPolyData:
        return self.GetOutputDataObject(port)

    def SetModeToThesis(self) -> None:
        self.SetMode(self.THESIS)

    def SetModeToFast(self) -> None:
        self.SetMode(self.FAST)

    def SetModeToBalanced(self) -> None:
        self.SetMode(self.BALANCED)

    def SetModeToAccurate(self) -> None:
        self.SetMode(self.ACCURATE)

    def GetRejectedValue(self, _property: str) -> str:
        """Always empty: a value out of its range raises at once and leaves the property as it was."""
        return ""

    def GetStopReason(self) -> int:
        """Why the last run ended: NOT_RUN, TARGET_REACHED, ..."""
        return self._stop.value

    def GetStopReasonAsString(self) -> str:
        """Why the last run ended, as a sentence."""
        return _core.stop_sentence(self._stop)

    def GetNumberOfReportEntries(self) -> int:
        return len(self._entries)

    def GetReportEntryName(self, entry: int) -> str:
        """Empty beyond them."""
        return self._entries[entry][0] if 0 <= entry < len(self._entries) else ""

    def GetReportEntryUnit(self, name: str) -> str:
        """Empty where there is none."""
        return self._entry(name)[1]

    def GetReportValue(self, name: str) -> float:
        """A number of the report; NaN where the name is unknown or the entry is a text."""
        value = self._entry(name)[2]
        return math.nan if isinstance(value, str) else float(value)

    def GetReportText(self, name: str) -> str:
        """An entry as text, numbers with all their digits; empty where the name is unknown."""
        value = self._entry(name)[2]
        return f"{value:.17g}" if isinstance(value, float) else str(value)

    def _entry(self, name: str) -> tuple[str, str, int | float | str]:
        return next((entry for entry in self._entries if entry[0] == name), (name, "", ""))

    def Update(self, *arguments) -> None:
        super().Update(*arguments)
        if self._interrupted:
            self._interrupted = False
            raise KeyboardInterrupt

    def RequestData(self, _request, inInfo, outInfo) -> int:
        outputs = [vtkPolyData.GetData(outInfo, port) for port in range(2)]
        try:
            return self._run(vtkPolyData.GetData(inInfo[0]), vtkPolyData.GetData(inInfo[1]), *outputs)
        except (ValueError, MemoryError) as problem:
            return self._fail(str(problem) or "out of memory")
        except KeyboardInterrupt:  # VTK would print it and go on
            self._interrupted = True
            return 0

    def _run(self, data: vtkPolyData, reference: vtkPolyData | None, output: vtkPolyData, input_copy: vtkPolyData) -> int:
        answer, surface = run(data, self._options, self._goes_on, reference)
        self._entries, self._stop = answer["entries"], answer["stop"]
        status = answer["status"]
        if status == _core.InputStatus.NoTriangles:
            self._say("WarningEvent", answer["problem"])
        elif status not in (_core.InputStatus.Good, _core.InputStatus.Empty):
            return self._fail(answer["problem"])
        for warning in answer["warnings"]:
            self._say("WarningEvent", warning)
        fill_output(answer, surface, self._options, data, output)
        fill_input_copy(answer, self._options, data, input_copy)
        if answer["contradiction"]:
            self._say("ErrorEvent", answer["contradiction"])
        return 1

    def _goes_on(self, fraction: float) -> bool:
        """An aborted run still has a valid surface. CheckAbort() would have the executive throw it away."""
        self.UpdateProgress(fraction)
        return not self.GetAbortExecute()

    def _fail(self, text: str) -> int:
        self._say("ErrorEvent", text)
        return 0

    def _say(self, event: str, text: str) -> None:
        """To observers, or where VTK prints what nobody observes, as the macros of C++ do."""
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


PROPERTIES = {words(row.name, "_"): key for key, row in ROWS.items()}  # keyword of each property
_parameters = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=ROWS[key].default,
                                 annotation="int" if ROWS[key].choices else ROWS[key].kind)
               for name, key in PROPERTIES.items()]
vtkBoneDecimate.__init__.__signature__ = inspect.Signature(
    [inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD), *_parameters])
for _key, _row in ROWS.items():
    _add_property(_key, _row)
for _enumeration in (_core.Mode, _core.ErrorPreset, _core.StopReason):
    for _member in _enumeration:
        setattr(vtkBoneDecimate, words(_member.name, "_").upper(), _member.value)
