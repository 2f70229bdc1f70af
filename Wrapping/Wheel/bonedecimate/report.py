# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Reports, and their numbers as text."""

from __future__ import annotations

import decimal
import difflib
import html
import math
from collections.abc import Iterator, Mapping


class Report(dict[str, "int | float | str"]):
    """A report by name, "proof.upper".

    Printed, it is a table that begins with the sentence of the proof: numbers have six digits, bounds rounded outwards, the options of
    the run are counted, and entries with an empty text are left out.
    """

    units: dict[str, str]  #: of each entry that has one

    def __init__(self, entries: Mapping[str, int | float | str] = {}, units: Mapping[str, str] = {}) -> None:
        super().__init__(entries)
        self.units = {name: unit for name, unit in units.items() if name in self}

    def __missing__(self, name: str) -> int | float | str:
        if not self:
            raise KeyError("this mesh has no report: no run made it, or what changed it since dropped its field data")
        meant = difflib.get_close_matches(str(name), self, 1)
        hint = f"; did you mean '{meant[0]}'?" if meant else ""
        if str(name).startswith("proof.") and "proof.status" not in self and "proof.sentence" in self:
            hint = f": {self['proof.sentence']}"
        raise KeyError(f"the report has no entry '{name}'{hint}")

    def _rows(self) -> Iterator[tuple[str, str, str]]:
        for name, value in sorted(self.items(), key=lambda entry: entry[0] not in ("proof.sentence", "sentence")):
            if value != "":
                yield name, rounded_text(value, name) if isinstance(value, float) else str(value), self.units.get(name, "")

    def __str__(self) -> str:
        rows = [row for row in self._rows() if not row[0].startswith("options.")]
        options = [name for name in self if name.startswith("options.")]
        rows += [("options.*", f"{len(options)} more", "")] if options else []
        width = max((len(name) for name, _, _ in rows), default=0)
        return "\n".join(f"{name:{width}}  {value} {unit}".rstrip() for name, value, unit in rows)

    def _repr_html_(self) -> str:
        """For notebooks. The options of the run are folded."""
        tables = {False: "", True: ""}
        for name, *cells in self._rows():
            tables[name.startswith("options.")] += (
                f"<tr><td style='text-align:left'>{html.escape(name)}</td>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in cells) + "</tr>")
        options = f"<details><summary>options</summary><table>{tables[True]}</table></details>" if tables[True] else ""
        return f"<table>{tables[False]}</table>{options}"


def rounded_text(value: float, name: str) -> str:
    """Six digits. A bound by its name, "upper", is rounded outwards: what is printed is proved, too."""
    if not math.isfinite(value):
        return number_text(value)
    end = name.rpartition(".")[2]
    is_upper = end == "upper" or name.startswith("left_out.") and end == "distance"
    rounding = decimal.ROUND_CEILING if is_upper else decimal.ROUND_FLOOR if end == "lower" else decimal.ROUND_HALF_EVEN
    return number_text(float(decimal.Context(prec=6, rounding=rounding).create_decimal(value)))


def number_text(value: float) -> str:
    """The shortest decimals, six at least, that read back the same, as in JSON reports."""
    if not math.isfinite(value):
        return "NaN" if math.isnan(value) else "infinity" if value > 0 else "-infinity"
    return next(text for digits in range(6, 18) if float(text := f"{value:.{digits}g}") == value)
