# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Widgets for the options that the panel knows from the engine's table alone. Needs Slicer's window."""

import html

import ctk
import qt

from .option_table import description, label, value_of

# Property and signal of the widgets for kinds of options.
VALUES = {"double": "value", "int": "value", "bool": "checked", "choice": "currentText"}
SIGNALS = {"double": "valueChanged", "int": "valueChanged", "bool": "toggled", "choice": "currentTextChanged"}


def number_box(value, least, most, suffix):
    box = ctk.ctkDoubleSpinBox()
    box.minimum, box.maximum, box.decimals, box.suffix, box.value = least, most, 3, suffix, value
    box.singleStep = 0.05 if suffix == " mm" else 1.0
    return box


def widget_for(row):
    """By the kind of the option, with its range, unit, default and meaning."""
    value, unit = value_of(row, row["default"]), row["unit"] and " " + row["unit"]
    if row["kind"] == "double":
        widget = number_box(value, row["minimum"], row["maximum"], unit)
    elif row["kind"] == "int":
        widget = qt.QSpinBox()
        widget.minimum, widget.maximum, widget.suffix, widget.value = row["minimum"], row["maximum"], unit, value
    elif row["kind"] == "bool":
        widget = qt.QCheckBox()
        widget.checked = value
    else:
        widget = qt.QComboBox()
        widget.addItems(row["choices"])
        widget.currentText = value
    widget.toolTip = f"<p>{html.escape(description(row))}</p>"  # Qt wraps lines of rich text only
    return widget


class OptionWidgets:
    """In forms for groups of the table, which say why they are empty until fill()."""

    SECTIONS = {"Proof": "Proof", "Shape": "Triangle shapes", "Input": "Repair and pruning", "Output": "Output"}  # titles of groups
    FIRST = ("NumberOfThreads",)  # with the options that have a widget of their own

    def __init__(self, first, section):
        """@param first Form of FIRST.  @param section Makes a form with a title."""
        self._first, self._forms = first, {group: section(title) for group, title in self.SECTIONS.items()}
        self.notes = [qt.QLabel() for _ in self._forms]
        self.of_flag = {}  # row and widget
        for form, note in zip(self._forms.values(), self.notes):
            note.wordWrap = True
            form.addRow(note)

    def explain(self, problem):
        for note in self.notes:
            note.text = problem

    def fill(self, table, changed):
        """@param changed Called after each change of a value."""
        for note in self.notes:
            note.visible = False
        for row in table.panel_rows():
            widget = widget_for(row)
            getattr(widget, SIGNALS[row["kind"]]).connect(changed)
            self.of_flag[row["flag"]] = row, widget
            form = self._first if row["name"] in self.FIRST else self._forms.get(row["group"], self._forms["Output"])
            form.addRow(label(row), widget)

    def values(self, only_enabled=False):
        """By flag."""
        return {flag: getattr(widget, VALUES[row["kind"]]) for flag, (row, widget) in self.of_flag.items()
                if widget.enabled or not only_enabled}

    def enable(self, table, others, runs):
        """Those that have an effect beside the values of others, in runs of these kinds."""
        values = {**others, **self.values()}
        for row, widget in self.of_flag.values():
            widget.enabled = table.has_effect(row, values) and not any(run in row["unsupported"] for run in runs)
