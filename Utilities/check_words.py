#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Lists words for which the field has a standard term, in identifiers, comments, strings and pages.

    Utilities/check_words.py [--counts] [path ...]

Identifiers are split at capitals and underscores, so FrozenVertex and frozen_vertex contain the word "frozen".
Utilities/allowed_words.txt lists the uses that are correct, each with its reason.
Prints "file:line: word (use: term): text" and exits with 1 if there is a use that is not allowed.
"""
import argparse
import bisect
import collections
import fnmatch
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ALLOWED = "Utilities/allowed_words.txt"
SKIPPED = (ALLOWED, "Utilities/check_words.py", "LICENSE", "Testing/Fuzz/corpus/*", "Testing/Data/*",
           "Applications/Picture/Viewer/LICENSES.txt", "Utilities/wheel_licenses.txt", "Applications/Picture/Viewer/package-lock.json",
           "Applications/Browser/package-lock.json")
SUFFIXES = (".h", ".cxx", ".in", ".py", ".sh", ".cmake", ".txt", ".md", ".json", ".ipynb", ".xml", ".html", ".css", ".js", ".ui",
            ".toml", ".cff", "/run", "bonebench")
CODE = ("*.h", "*.cxx", "*.in", "*.py")

# Forms of a word, the term to use instead, and the files it is looked for in (all if empty).
WORDS = (
    ("share shares", "common-face proof; budget; ratio; fraction"),
    ("place places", "position; index; placement candidate"),
    ("gate gates gated", "validity check"),
    ("judge judges judged judging judgement judgment", "check; evaluate; validity check"),
    ("verdict verdicts", "rejection reason; result"),
    ("refuse refuses refused refusing refusal refusals", "reject; rejection"),
    ("elsewhere", "Deferred; name the place"),
    ("locked frozen pinned freeze freezes pin pins", "constrained"),
    ("sheet sheets", "manifold patch"),
    ("seam seams", "patch boundary"),
    ("doctor doctors", "diagnostics"),
    ("findings", "diagnostics; results"),
    ("holder holders", "covering face"),
    ("octave octaves", "bucket; bucket width"),
    ("asked asks", "requested; call; query"),
    ("answer answers answered answering", "result; return"),
    ("companions books", "run inputs; bookkeeping"),
    ("border borders", "boundary"),
    ("room rooms door doors choke house houses", "module; adapter"),
    ("promise promises promised oath oaths", "guarantee; invariant"),
    ("clearance clearances", "gap width; intersection guard"),
    ("who whom whoever nobody somebody", "name the class or function that acts"),
    ("wish wishes wished", "request; option"),
)
IDENTIFIERS = (
    ("wanted", "requested"),
    ("given", "input; requested"),
)
PHRASES = (
    (r"\b[Ss]t(?:an|oo)ds? for\b", "stand for", "represent"),
    (r"\bowns? places?\b|OwnPlaces", "own places", "distinct positions"),
    (r"\bWork\b(?=[;,)({.]|->)", "Work", "editor"),
    (r"\bNamed\b", "Named", "labels"),
    (r"\b(?:[Ff]ixed|[Ss]taying) (?:vert(?:ex|ices)|edges?|points?)\b", "fixed", "constrained"),
)
SUBWORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])")
IDENTIFIER = re.compile(r"[A-Za-z]\w*")


def forms():
    return {form: term for words, term in WORDS for form in words.split()}


def identifier_forms():
    return {form: term for words, term in IDENTIFIERS for form in words.split()}


class Allowed:
    """One line of the list: files, a pattern that contains the word, and the reason."""

    def __init__(self, line):
        files, pattern, self.reason = (part.strip() for part in line.split(" | "))
        self.line = line
        self.files = files.split()
        self.pattern = re.compile(pattern, re.DOTALL)
        self.is_used = False

    def applies_to(self, file):
        return any(fnmatch.fnmatch(file, glob) for glob in self.files)

    def spans(self, text):
        return [match.span() for match in self.pattern.finditer(text)]


def read_allowed():
    lines = (ROOT / ALLOWED).read_text(encoding="utf-8").splitlines()
    return [Allowed(line) for line in lines if line.strip() and not line.startswith("#")]


def files(paths):
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *paths], cwd=ROOT,
                            check=True, capture_output=True, text=True).stdout.splitlines()
    return [file for file in listed if file.endswith(SUFFIXES) and (ROOT / file).is_file() and
            not any(fnmatch.fnmatch(file, glob) for glob in SKIPPED)]


def uses(text, is_code):
    """Yields (start, end, word, term)."""
    words, names = forms(), identifier_forms()
    for token in IDENTIFIER.finditer(text):
        parts = list(SUBWORD.finditer(token.group()))
        is_name = is_code and (len(parts) > 1 or token.group()[:1].isupper())
        for part in parts:
            word = part.group().lower()
            term = words.get(word) or (names.get(word) if is_name and len(parts) > 1 else None)
            if term:
                yield token.start() + part.start(), token.start() + part.end(), word, term
    for pattern, word, term in PHRASES:
        for match in re.finditer(pattern, text) if is_code else ():
            yield match.start(), match.end(), word, term


def check_file(file, allowed):
    text = (ROOT / file).read_text(encoding="utf-8", errors="replace")
    starts = [match.start() for match in re.finditer(r"^", text, re.MULTILINE)]
    here = [(entry, entry.spans(text)) for entry in allowed if entry.applies_to(file)]
    is_code = any(fnmatch.fnmatch(file, glob) for glob in CODE)
    for start, end, word, term in sorted(uses(text, is_code)):
        covering = [entry for entry, spans in here if any(first <= start and end <= last for first, last in spans)]
        for entry in covering:
            entry.is_used = True
        if not covering:
            line = bisect.bisect_right(starts, start)
            yield line, word, term, text.splitlines()[line - 1].strip()


def folder(file):
    parts = file.split("/")
    depth = 3 if parts[:2] == ["Filters", "Core"] else 2
    return "/".join(parts[:min(depth, len(parts) - 1)]) or "."


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", action="store_true", help="print the number of uses in each folder instead of the uses")
    parser.add_argument("paths", nargs="*", help="files and folders, all if none")
    options = parser.parse_args()
    allowed = read_allowed()
    counts = collections.Counter()
    for file in files(options.paths):
        for line, word, term, text in check_file(file, allowed):
            counts[folder(file)] += 1
            if not options.counts:
                print(f"{file}:{line}: {word} (use: {term}): {text[:160]}")
    if options.counts:
        for name, count in sorted(counts.items()):
            print(f"{count:6} {name}")
        print(f"{sum(counts.values()):6} in all")
    unused = [] if options.paths else [entry for entry in allowed if not entry.is_used]
    for entry in unused:
        print(f"{ALLOWED}: not used: {entry.line}")
    return 1 if counts or unused else 0


if __name__ == "__main__":
    sys.exit(main())
