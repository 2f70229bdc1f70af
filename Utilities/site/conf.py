# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx makes the site of the pages that Utilities/build_site.sh collects in build/site/pages."""

import os
import re
import sys
from pathlib import Path

ROOT = Path(os.environ["SOURCE_DIR"])
# The wheel, numpy, VTK and PyVista, from which the reference of Python is made. The packages of the generator come first.
sys.path.append(os.environ["WHEEL_PACKAGES"])

project = "vtkBoneDecimate"
author = "vtkBoneDecimate contributors"
copyright = author
version = re.search(r"project\(\w+\s+VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
highlight_language = "none"

# Anchors of headings as on a plain Git host, so that links work in both.
myst_heading_anchors = 4

default_role = "code"
autodoc_member_order = "bysource"
autodoc_typehints = "none"
napoleon_google_docstring = False
napoleon_use_param = False
napoleon_use_rtype = False

html_theme = "furo"
html_title = f"vtkBoneDecimate {version}"
html_extra_path = [str(ROOT / "build/site/files")]
html_static_path = ["static"]
html_css_files = ["wide.css"]
html_copy_source = False
html_show_copyright = False
html_show_sphinx = False
