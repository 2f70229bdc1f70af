# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The core's table of options as Python's keywords: `max_error` is `--max-error` and `MaximumError`.

Every function that takes options shows them in its signature and its docstring (`takes_options`), and reads them by that
signature (`read`): there is no other list of keywords. Imports the core alone, so that the build can write stubs with it.
"""

from __future__ import annotations

import difflib
import inspect
import numbers
import re
import textwrap
from collections.abc import Callable, Iterable, Mapping

from . import _core

# Keywords of other packages, and ours.
OTHER_NAMES = {"n_triangles": "target_triangles", "target_count": "target_triangles", "n_faces": "target_triangles",
               "target_number_of_triangles": "target_triangles", "reduction": "target_reduction", "tolerance": "max_error"}
_TARGETS = ("max_error", "preset", "target_triangles", "tolerance_array")
# Of every option by keyword: its row.
ROWS: dict[str, _core.OptionInfo] = {}


def words(name: str, joint: str) -> str:
    """CamelCase as words: MeasureInputDistances, "_" -> measure_input_distances."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", joint, name).lower()


def keyword(row: _core.OptionInfo) -> str:
    """As the flag of the command line, or as the name where there is no flag."""
    return row.flag.replace("-", "_") or words(row.name, "_")


for _row in _core.option_table():
    ROWS[keyword(_row)] = _row
_OF_NAME = {row.name: row for row in ROWS.values()}
_NAMES = re.compile(r"(?<![\w'\"])(" + "|".join(_OF_NAME) + r")(?![\w'\"])")


def spelled(sentence: str) -> str:
    """A sentence of the core, which has the names of properties (MaximumError), with what its reader types (max_error)."""
    return _NAMES.sub(lambda found: keyword(_OF_NAME[found[0]]), sentence).replace("vtkBoneSurfaces", "extract_surfaces")


def spell_sentences(outcome: dict) -> None:
    """The same for all sentences of a run."""
    for name in ("problem", "contradiction"):
        outcome[name] = spelled(outcome[name])
    outcome["warnings"] = [spelled(warning) for warning in outcome["warnings"]]


def unsupported(*kinds: str) -> dict[str, str]:
    """The options that runs of these kinds (rows of the core's table) do not have, by keyword, and why."""
    reasons = {key: next(filter(None, (_core.why_unsupported(kind, row.name) for kind in kinds)), "") for key, row in ROWS.items()}
    return {key: reason for key, reason in reasons.items() if reason}


def type_of(row: _core.OptionInfo) -> str:
    """As an annotation."""
    return "Literal[" + ", ".join(f'"{choice}"' for choice in row.choices) + "]" if row.choices else row.kind


def default_of(row: _core.OptionInfo) -> bool | int | float | str:
    return row.default_text if row.choices else row.default


def describe(row: _core.OptionInfo) -> str:
    """Meaning, default, range and unit."""
    unit = f" {row.unit}" if row.unit else ""
    text = f"{row.sentence} Default: {row.default_text or 'none'}{unit}."
    if row.kind in ("int", "float") and not row.choices:
        text += f" Range: {row.minimum:g} to {row.maximum:.10g}{unit}.".replace("e+", "e")
    return text


def options_but(without: Iterable[str]) -> dict[str, _core.OptionInfo]:
    """The rows of all options but those, by keyword."""
    return {key: row for key, row in ROWS.items() if key not in without}


def with_options(docstring: str, rows: Mapping[str, _core.OptionInfo]) -> str:
    """The docstring with an entry for each option in place of "**options"."""
    entries = [f"{key} : {type_of(row)}\n" + textwrap.indent(textwrap.fill(spelled(describe(row)), 100), "    ")
               for key, row in rows.items()]
    return inspect.cleandoc(docstring).replace("**options", "\n".join(entries))


def takes_options(*kinds: str):
    """Decorator of a function with **options: its signature and its docstring show every option of the table but those
    that runs of these kinds do not have, and those that are parameters of their own."""
    without = unsupported(*kinds)

    def decorate(function: Callable) -> Callable:
        signature = inspect.signature(function)
        variable = (inspect.Parameter.VAR_KEYWORD, inspect.Parameter.VAR_POSITIONAL)
        own = [each for each in signature.parameters.values() if each.kind not in variable]
        rows = options_but([*without, *signature.parameters])
        options = [inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=default_of(row), annotation=type_of(row))
                   for key, row in rows.items()]
        function.__signature__ = signature.replace(parameters=own + options)
        function.__doc__ = with_options(function.__doc__ or "", rows)
        function._without = without
        return function
    return decorate


def nearest(word: str, names: Iterable[str]) -> str | None:
    """The name that was probably meant, if there is one. Names of properties count as their keywords."""
    spellings = {name: name for name in names}
    for name in tuple(spellings):
        if name in ROWS:
            spellings.setdefault(words(ROWS[name].name, "_"), name)
    found = difflib.get_close_matches(words(word, "_"), spellings, 1)
    return spellings[found[0]] if found else None


def profile_options(name: str | None, keywords: Iterable[str]) -> dict[str, str]:
    """What a built-in profile sets beside those keywords, which win, also if they say the same in another way.

    Raises TypeError for a name that is no text, ValueError for one that is no profile.
    """
    if name is None:
        return {}
    if not isinstance(name, str):
        raise TypeError(f"profile takes the name of a profile, not {_shown(name)}")
    profiles = {profile.name.lower(): profile for profile in _core.profile_table()}
    if name.lower() not in profiles:
        names = [profile.name for profile in profiles.values()]
        meant = difflib.get_close_matches(name, names, 1)
        raise ValueError(f"profile '{name}' is none of {', '.join(names)}" + (f"; did you mean {meant[0]}?" if meant else ""))
    set_before = {flag for key in keywords if key in ROWS for flag in _core.alternatives_to(ROWS[key].flag)}
    return {flag.replace("-", "_"): value for flag, value, _ in profiles[name.lower()].options if flag not in set_before}


def read(keywords: Mapping[str, object], function: Callable, profile: str | None = None, removes_nothing: bool = False) -> _core.Options:
    """Options with those values, as the function takes them; what a profile sets and the function does not take has no meaning there.

    Raises TypeError for a keyword that is none and for a value of a wrong type, ValueError for a value out of range, and for a zero
    that would leave the default target, which is not what a loop over errors wants.
    """
    options = _core.Options()
    known = inspect.signature(function).parameters
    for key, text in profile_options(profile, keywords).items():
        if key in known:
            options.read(ROWS[key].name, text)
    for key, value in keywords.items():
        if key not in known:
            raise TypeError(_unknown(key, [name for name in known if name != "self"], function._without))
        assign(options, key, value)
    zeros = [key for key in ("max_error", "target_triangles") if key in keywords and not keywords[key]]
    has_target = (removes_nothing or "target_reduction" in keywords or any(keywords.get(key) for key in _TARGETS)
                  or not {*_TARGETS, "target_reduction"}.isdisjoint(profile_options(profile, keywords)))
    if zeros and not has_target:
        raise ValueError(f"{zeros[0]}=0 sets no limit, so that nine tenths of the triangles would go; target_reduction=0 removes none")
    return options


def require_keywords(misplaced: tuple[object, ...]) -> None:
    """Raises TypeError if there are values without a keyword."""
    if misplaced:
        raise TypeError("decimate takes keywords: target_reduction=0.9, target_triangles=20000, or max_error=0.5 (mm)")


def _unknown(key: str, known: list[str], without: Mapping[str, str]) -> str:
    if key in without:
        return f"there is no option '{key}' here: {without[key]}"
    meant = OTHER_NAMES.get(key) or nearest(key, known)
    if meant in known:
        return f"there is no option '{key}' here (did you mean '{meant}'?)"
    there_are = [*(name for name in ROWS if name in known), *(name for name in known if name not in ROWS)]
    return f"there is no option '{key}' here; there are: {', '.join(there_are)}"


def assign(options: _core.Options, key: str, value: object, by_number: bool = False) -> bool:
    """Sets an option; returns whether that changes anything.

    @param by_number Choices come as their numbers, as in VTK, and not as their names.
    """
    row = ROWS[key]
    plain = _plain(value)
    if row.choices and not by_number:
        if not isinstance(plain, str):
            raise TypeError(f"{key} takes one of {', '.join(map(repr, row.choices))}, not {_shown(value)}")
        before = options.get(row.name)
        try:
            options.read(row.name, plain)
        except ValueError as problem:
            raise ValueError(spelled(str(problem)) + _instead(row, plain)) from None
        return options.get(row.name) != before
    kind = "int" if row.choices else row.kind
    if not _IS_OF_KIND[kind](plain):
        instead = "" if by_number else _instead(row, plain)
        raise TypeError(f"{row.name if by_number else key} takes {_WANTED[kind]}, not {_shown(value)}{instead}")
    try:
        return options.set(row.name, _converted(options, row, kind, plain))
    except ValueError as problem:
        raise ValueError(str(problem) if by_number else spelled(str(problem))) from None


def _instead(row: _core.OptionInfo, value: object) -> str:
    """For a word where a number is wanted: the option that says it, if there is one."""
    word = re.sub(r"[\W_]", "", value).lower() if isinstance(value, str) else ""
    for other in (ROWS[name.replace("-", "_")] for name in _core.alternatives_to(row.flag) if name.replace("-", "_") in ROWS):
        said: object = True if other.kind == "bool" and word.startswith("auto") else None
        said = next((choice for choice in other.choices if other is not row and choice.lower() == word), said)
        if said is not None:
            return f"; {keyword(other)}={said!r} says that"
    return ""


def _plain(value: object) -> object:
    """A number of numpy as Python's."""
    return value.item() if hasattr(value, "item") and getattr(value, "ndim", 0) == 0 else value


def _is_number(value: object) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, bool)


_IS_OF_KIND = {"bool": lambda value: isinstance(value, int), "int": _is_number, "float": _is_number,
               "str": lambda value: isinstance(value, str)}
_WANTED = {"bool": "True or False", "int": "a whole number", "float": "a number", "str": "a str"}


def _converted(options: _core.Options, row: _core.OptionInfo, kind: str, value):
    """What the core can take. Values that it cannot even hold are ValueErrors with its sentence."""
    if kind == "bool" and value in (0, 1):
        return bool(value)
    try:
        if kind == "float":
            return float(value)
        if kind == "int" and value == int(value) and abs(value) < 2**31:
            return int(value)
    except (OverflowError, ValueError):
        pass
    if kind == "str":
        return value
    options.read(row.name, repr(value))  # raises
    raise ValueError(f"{row.name} does not take {value!r}")


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"a {type(value).__name__}"


def number(name: str, value: object, minimum: float, maximum: float, unit: str = "", is_whole: bool = False) -> float | int:
    """A number that is no option of the table, checked by the same rules, with the core's sentence."""
    plain = _plain(value)
    if not _is_number(plain):
        raise TypeError(f"{name} takes {_WANTED['int' if is_whole else 'float']}, not {_shown(value)}")
    try:
        size = float(plain)
    except OverflowError:
        size = float("inf") if plain > 0 else -float("inf")
    problem = _core.check_number(name, minimum, maximum, is_whole, unit, size)
    if problem:
        raise ValueError(problem)
    return int(plain) if is_whole else size


def switch(name: str, value: object) -> bool:
    plain = _plain(value)
    if not isinstance(plain, int) or plain not in (0, 1):
        raise TypeError(f"{name} takes {_WANTED['bool']}, not {_shown(value)}")
    return bool(plain)


def thread_count(value: object) -> int:
    options = _core.Options()
    assign(options, "threads", value)
    return options.get(ROWS["threads"].name)
