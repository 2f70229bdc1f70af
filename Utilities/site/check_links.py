#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Lists links of a site that lead nowhere: check_links.py FOLDER

Each file and each anchor that a page links to must be there. Links to other servers are not followed, but nothing that a page
shows or runs may come from one. Pages of doxygen are link targets only: doxygen checks its own.
"""

import html.parser
import pathlib
import sys
import urllib.parse

LINKS = {"a": "href", "link": "href", "img": "src", "script": "src", "source": "src", "iframe": "src"}
NAVIGATION = ("next", "prev", "search", "index", "canonical")


class Page(html.parser.HTMLParser):
    """The anchors and the links of a page."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links = {""}, []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}
        target = values.get(LINKS.get(tag))
        if target:
            self.links.append((target, tag == "a" or values.get("rel") in NAVIGATION))


def problems(folder):
    pages = {path.resolve(): Page(path) for path in folder.rglob("*.html")}
    for path, page in sorted(pages.items()):
        if "classes" in path.relative_to(folder.resolve()).parts:
            continue
        for link, is_followed_by_readers in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                if not is_followed_by_readers and parts.scheme != "data":
                    yield f"{path}: {link} is fetched from another server"
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file():
                yield f"{path}: there is no {link}"
            elif target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].anchors:
                yield f"{path}: there is no anchor {link}"


def main():
    found = list(problems(pathlib.Path(sys.argv[1])))
    for problem in found:
        print(problem)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
