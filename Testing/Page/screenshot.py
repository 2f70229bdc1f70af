#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a picture of the interactive view of a page, with error colors: screenshot.py PAGE PNG"""

import base64
import pathlib
import sys

import browser as chromium
from browser import Browser


def main(page, png):
    if not (chromium.CHROMIUM and chromium.DRIVER):
        sys.exit(chromium.MISSING)
    with Browser(*chromium.SOFTWARE, "--window-size=1000,900") as browser:
        browser.open(page)
        browser.run("document.querySelector('.viewer').scrollIntoView()")
        browser.picture(".viewer")
        element = browser.find(".viewer")
        pathlib.Path(png).write_bytes(base64.b64decode(browser.command("GET", f"/element/{element}/screenshot")))


if __name__ == "__main__":
    main(*sys.argv[1:])
