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

# The entrance of the site is the page that is also the entrance on a Git host.
root_doc = "Documentation/README"
# Pages that only the site has.
GENERATED = """
## Generated reference

* [Python: functions and classes](../python-reference.md)
* [C++: classes](../cpp-reference.md)
"""
PAGE = re.compile(r"\]\(([^)#]+)\.md\)")

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


def with_contents(text):
    """The entrance with the contents of the site: the pages that each section links to, under its heading.

    Sphinx warns about a page that is in no contents, so every page is linked here.
    """
    listed, sections = set(), []
    text = re.sub(r"(?m)^.*\(paper/paper\.md\).*\n", "", text)  # has a form of its own, which the site cannot show
    for section in re.split(r"(?m)^(?=## )", text + GENERATED):
        title = re.match(r"## (.+)", section)
        # The pages of the first section are those that the sections below list.
        if title and title[1] != "Start here":
            pages = [page for page in PAGE.findall(section) if page not in listed]
            listed.update(pages)
            section += "\n".join(["", "```{toctree}", ":hidden:", f":caption: {title[1]}", "", *pages, "```", ""])
        sections.append(section)
    return "\n".join(sections)


def setup(app):
    def read(_, name, source):
        if name == root_doc:
            source[0] = with_contents(source[0])

    app.connect("source-read", read)
