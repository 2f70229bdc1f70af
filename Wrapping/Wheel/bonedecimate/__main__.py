# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""`python -m bonedecimate` and `bonedecimate-py`: one surface, with the options of the table.

The program bonedecimate of the C++ project does more: CT, label maps, batches, levels, certificates, pages, pictures.
"""

from __future__ import annotations

import argparse
import json
import pathlib
import sys
import warnings
from collections.abc import Callable
from typing import NamedTuple, NoReturn

from . import __version__, _core, files
from .arrays import raise_problems, run_on_arrays
from .options import ROWS, flag, keyword, profile_options, read_text, spell_sentences, unsupported
from .progress import listener
from .surfaces import input_from

DONE, USAGE, REJECTED, COULD_NOT_WRITE, INTERRUPTED, OUT_OF_MEMORY, VIOLATED = range(7)  # as the C++ program


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """In one line, as the C++ program."""
        self.exit(USAGE, f"{self.prog}: {message}; see {self.prog} --help\n")


def parser() -> argparse.ArgumentParser:
    made = Parser(prog="bonedecimate-py", description="Make a bone surface smaller; lengths are mm.",
                  epilog="Exit codes: 0 done, 1 usage, 2 input rejected, 3 could not write, "
                         "4 interrupted, 5 out of memory, 6 the certificate contradicts the largest error.")
    made.add_argument("input", type=pathlib.Path, help=f"{' '.join(files.VTK_KINDS)} by VTK; what meshio reads; or binary STL")
    made.add_argument("output", type=pathlib.Path)
    made.add_argument("--report", type=pathlib.Path, metavar="FILE", help="the report as JSON")
    made.add_argument("--profile", metavar="|".join(profile.name for profile in _core.profile_table()),
                      help="options for a purpose; those of the command line win")
    made.add_argument("--quiet", action="store_true", help="no progress, no summary")
    made.add_argument("--version", action="version", version=__version__)
    for row in ROWS.values():
        if row.flag:
            default = f" Default: {row.default_text or 'none'} {row.unit}".rstrip()
            alone = {"nargs": "?", "const": "on"} if row.kind == "bool" else {}
            made.add_argument("--" + row.flag, metavar=_values(row), help=(row.sentence + default).replace("%", "%%"),
                              **alone)
    return made


def _values(row: _core.OptionInfo) -> str:
    if row.kind == "bool":
        return "on|off"
    return "|".join(row.choices) or row.unit.upper() or row.kind.upper()


def options_of(arguments: argparse.Namespace) -> _core.Options:
    options = _core.Options()
    for row in ROWS.values():
        text = getattr(arguments, keyword(row), None)
        if text is not None:
            read_text(options, row, text, flag)
    return options


class Run(NamedTuple):
    report: dict
    json: str
    warnings: list[str]
    write: Callable[[], None]


def _with_vtk(arguments: argparse.Namespace, options: _core.Options, progress) -> Run:
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .run import fill_output, run
    data = files.read_vtk(arguments.input)
    outcome, surface = run(data, options, progress)
    spell_sentences(outcome, flag)
    raise_problems(outcome)

    def write() -> None:
        output = vtkPolyData()
        fill_output(outcome, surface, options, data, output)
        files.write_vtk(output, arguments.output)
    return Run({name: value for name, _, value in outcome["entries"]}, outcome["json"], outcome["warnings"], write)


def _without_vtk(arguments: argparse.Namespace, options: _core.Options, progress) -> Run:
    for key in sorted(unsupported("Arrays")):
        if getattr(arguments, key, None):
            raise ValueError(f"--{ROWS[key].flag} is about arrays of a file, which need VTK: pip install vtk")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # they are printed from the list
        result = run_on_arrays(input_from(*files.read(arguments.input)), options, progress=progress, spell=flag)
    return Run(result.report, result.report_as_json, result.warnings, lambda: files.write(tuple(result), arguments.output))


def _work(arguments: argparse.Namespace) -> int:
    if arguments.output.suffix.lower() in files.SINGLE:  # what is proved is what is written
        arguments.precision = "Single"
    try:
        given = [key for key in ROWS if getattr(arguments, key, None) is not None]
        for key, text in profile_options(arguments.profile, given).items():
            setattr(arguments, key, text)
        options = options_of(arguments)
    except ValueError as problem:
        return _fail(USAGE, problem)
    known = files.endings()
    for path in (arguments.input, arguments.output):
        if known and path.suffix.lower() not in known:
            return _fail(USAGE, ValueError(f"'{path}' has none of the endings {' '.join(known)}; the C++ program bonedecimate has more"))
    for path in (arguments.output, arguments.report):
        if path and path.exists() and arguments.input.exists() and path.samefile(arguments.input):
            return _fail(USAGE, ValueError(f"'{path}' is the input; it is not overwritten"))
    engine = _with_vtk if files.has("vtkmodules.vtkIOGeometry") else _without_vtk
    try:
        with listener(_bar(arguments)) as heard:
            report, text, found, write = engine(arguments, options, heard)
    except (OSError, ValueError) as problem:
        return _fail(REJECTED, problem)
    except RuntimeError as problem:
        return _fail(VIOLATED, problem)
    for warning in found:
        print(f"bonedecimate-py: warning: {warning}", file=sys.stderr)
    try:
        write()
        if arguments.report:
            with files.whole(arguments.report) as made:
                made.write_text(json.dumps(json.loads(text), indent=2) + "\n", encoding="utf-8")
    except (OSError, ValueError) as problem:
        return _fail(COULD_NOT_WRITE, problem)
    if not arguments.quiet:
        print(f"{report['input.triangles']} -> {report['output.triangles']} triangles: {report['stop_sentence']}")
        if "proof.upper" in report:
            print(f"proved: no point is farther than {report['proof.upper']:.6g} mm from the other surface")
        if "voxels.changed" in report:
            print(f"voxels: {report['voxels.changed']} of {report['voxels.compared']} changed their label")
    return DONE


def _bar(arguments: argparse.Namespace):
    """A bar for people, if there is something that draws one."""
    return True if not arguments.quiet and sys.stderr.isatty() and (files.has("tqdm") or files.has("rich")) else None


def _fail(code: int, problem: Exception) -> int:
    print(f"bonedecimate-py: {problem}", file=sys.stderr)
    return code


def main(words: list[str] | None = None) -> int:
    try:
        arguments = parser().parse_args(words)
    except SystemExit as end:
        return end.code
    try:
        return _work(arguments)
    except KeyboardInterrupt:
        return _fail(INTERRUPTED, InterruptedError("interrupted; nothing was written"))
    except MemoryError:
        return _fail(OUT_OF_MEMORY, MemoryError("out of memory"))


if __name__ == "__main__":
    sys.exit(main())
