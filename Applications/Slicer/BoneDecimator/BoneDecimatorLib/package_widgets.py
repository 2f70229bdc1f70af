# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The section that installs the Python package and says what works without it. Needs Slicer's window."""

import importlib
import importlib.metadata
import subprocess

import qt
import slicer

from .checks import DecimationError
from .engines import PACKAGE_VERSION, WheelEngine

PROGRAM_ALONE = ("Without the Python package the program bonedecimate simplifies, closes and compares models. Segments, levels of "
                 "detail and colors of a comparison need the package.")
NOTHING = "Nothing works yet: install the Python package, or put the program bonedecimate on the PATH, which suffices for models."


def install(requirements):
    """@param requirements Words for pip. Raises DecimationError."""
    try:
        try:
            from slicer.packaging import pip_install  # with a dialog of progress and log
        except ImportError:  # Slicer 5.10 and earlier
            _install_with_dialog(requirements)
        else:
            pip_install(requirements, requester="Bone Decimator")
    except subprocess.CalledProcessError as problem:
        raise DecimationError("The Python package was not installed; Slicer's Python console has the messages. Without a network, "
                              "press 'Install from a file' and choose the wheel.") from problem
    importlib.invalidate_caches()


def _install_with_dialog(requirements):
    dialog = slicer.util.createProgressDialog(labelText="Installing the Python package bonedecimate", maximum=0)
    dialog.setCancelButtonText("")  # pip cannot be interrupted
    slicer.app.processEvents()
    try:
        slicer.util.pip_install(requirements)
    finally:
        dialog.close()


def version():
    """Of the installed package; None if there is none."""
    try:
        return importlib.metadata.version("bonedecimate")
    except importlib.metadata.PackageNotFoundError:
        return None


class PackageWidgets:
    """What is installed, and two buttons."""

    def __init__(self, form, attempt, installed):
        """@param attempt Calls a function and shows its errors.  @param installed Called afterwards."""
        self.form, self.installed = form, installed
        self.text = qt.QLabel()
        self.text.wordWrap = True
        form.addRow(self.text)
        for text, action in ((f"Install version {PACKAGE_VERSION}", self.on_install), ("Install from a file (offline)", self.on_file)):
            button = qt.QPushButton(text)
            button.clicked.connect(lambda _checked=False, action=action: attempt(action))
            form.addRow(button)

    def expand(self):
        self.form.parentWidget().collapsed = False

    def tell(self, engine):
        """@param engine None if there is none."""
        if not isinstance(engine, WheelEngine):
            self.text.text = NOTHING if engine is None else PROGRAM_ALONE
            return
        found = version()
        other = "" if found in (PACKAGE_VERSION, None) else f" This module was made for version {PACKAGE_VERSION}."
        self.text.text = f"The Python package{' ' + found if found else ''} is installed: everything works.{other}"

    def on_install(self):
        install([f"bonedecimate=={PACKAGE_VERSION}"])
        self.installed()

    def on_file(self):
        wheel = qt.QFileDialog.getOpenFileName(None, "The wheel", "", f"Wheels (bonedecimate-{PACKAGE_VERSION}-*.whl)")
        if wheel:
            install([wheel])
            self.installed()
