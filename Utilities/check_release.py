#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What a release must agree on, without a build: versions and dates, CITATION, placeholders, versions of tools, third-party software.

Prints a line for each problem, and exits with 1 if there is one.
"""
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import third_party

ROOT = third_party.ROOT
# Made of parts, so that this file does not find itself.
PLACEHOLDERS = re.compile("|".join((r"\bOWN" + r"ER/", r"example" + r"\.(?:org|com|net)", r"\.inv" + r"alid\b", r"your[-_]" + r"name",
                                    r"<yo" + r"ur " + r"|lorem " + r"ipsum|\bTB" + r"D\b|@@\w+@@", r"git@" + r"host")), re.IGNORECASE)
CITATION_KEYS = ("cff-version", "message", "type", "title", "version", "date-released", "license", "authors", "abstract")
PAPER_KEYS = ("title", "tags", "authors", "affiliations", "date", "bibliography")
PAPER_SECTIONS = ("Summary", "Statement of need", "Method", "Figures", "Limits", "Acknowledgements", "References")


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def tracked():
    done = subprocess.run(["git", "-c", f"safe.directory={ROOT}", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                          cwd=ROOT, capture_output=True, text=True, check=True)
    return [name for name in done.stdout.split("\0") if name and (ROOT / name).is_file()]


def field(text, key):
    found = re.search(rf'(?m)^{re.escape(key)}:\s*"?([^"\n]*)', text)
    return found[1].strip() if found else None


def problems_of_versions():
    version = third_party.own_version()
    date = re.search(r"set\(BONEDECIMATE_RELEASE_DATE ([\d-]+)\)", read("CMakeLists.txt"))[1]
    citation = read("CITATION.cff")
    for key in CITATION_KEYS:
        if field(citation, key) is None:
            yield f"CITATION.cff lacks {key}"
    for key, wanted in (("version", version), ("date-released", date), ("cff-version", "1.2.0")):
        if field(citation, key) != wanted:
            yield f"CITATION.cff has {key} {field(citation, key)}, not {wanted}"
    heading = re.search(r"(?m)^## (\S+) \((.*)\)$", read("CHANGELOG.md"))
    if heading[1] != version:
        yield f"CHANGELOG.md begins with {heading[1]}, not {version}"
    if heading[2] not in ("unreleased", date):
        yield f"CHANGELOG.md has the date {heading[2]}, not {date}"


def problems_of_placeholders():
    for name in tracked():
        if name.endswith((".png", ".ipynb", ".lock")) or name.endswith("package-lock.json") or name.startswith("Data/"):
            continue
        text = (ROOT / name).read_text(encoding="utf-8", errors="replace")
        for number, line in enumerate(text.splitlines(), 1):
            if PLACEHOLDERS.search(line):
                yield f"{name}:{number}: a placeholder: {line.strip()[:120]}"


def problems_of_tools():
    """Every tool that is fetched has one version."""
    names = [name for name in tracked() if re.search(r"requirements[\w-]*\.txt$", name)] + ["Utilities/wheel_constraints.txt"]
    for name in names:
        for line in read(name).splitlines():
            if line and not line.startswith("#") and not re.fullmatch(r"[\w.\[\]-]+==[\w.+!]+(;.*)?", line):
                yield f"{name}: '{line}' is not one version"
    required = re.search(r"(?m)^requires = \[(.*)\]$", read("pyproject.toml"))[1]
    for name in re.findall(r'"([\w-]+)', required):
        if not third_party.version_of_wheel_tool(name):
            yield f"Utilities/wheel_constraints.txt lacks {name} of pyproject.toml"
    for name in ("Applications/Picture/Viewer", "Applications/Browser", "Testing/Formats"):
        package = json.loads(read(f"{name}/package.json"))
        for kind in ("dependencies", "devDependencies"):
            for one, version in package.get(kind, {}).items():
                if not re.fullmatch(r"[\d.]+[\w.-]*", version):
                    yield f"{name}/package.json: {one} {version} is not one version"
        for one, entry in json.loads(read(f"{name}/package-lock.json"))["packages"].items():
            if one and not entry.get("link") and "integrity" not in entry:
                yield f"{name}/package-lock.json: {one} has no checksum"


def problems_of_paper():
    text = read("Documentation/paper/paper.md")
    head = text.split("---")[1]
    yield from (f"paper.md lacks {key}" for key in PAPER_KEYS if not re.search(rf"(?m)^{key}:", head))
    yield from (f"paper.md has no section {title}" for title in PAPER_SECTIONS if not re.search(rf"(?m)^# {title}$", text))
    known = set(re.findall(r"(?m)^@\w+\{([^,]+),", read("Documentation/paper/paper.bib")))
    cited = set(re.findall(r"@([\w:-]+)", text.split("---", 2)[2]))
    yield from (f"paper.bib lacks {key}" for key in sorted(cited - known))
    yield from (f"paper.md does not cite {key}" for key in sorted(known - cited))


def problems_of_submissions():
    """The templates can be filled, and nothing is left in them."""
    with tempfile.TemporaryDirectory() as folder:
        archive = pathlib.Path(folder) / "archive.tar.gz"
        archive.write_bytes(b"sources")
        done = subprocess.run([sys.executable, "-B", str(ROOT / "Utilities/submissions/write.py"), "--repository", "https://host/a/b",
                               "--archive", str(archive), "--maintainer", "c", "--slicer-repository", "https://host/a/d",
                               "--folder", folder], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            yield f"Utilities/submissions/write.py: {done.stderr.strip()}"
            return
        recipe = (pathlib.Path(folder) / "recipe.yaml").read_text(encoding="utf-8")
        entry = json.loads((pathlib.Path(folder) / "BoneDecimate.json").read_text(encoding="utf-8"))
    for part in (f'version: "{third_party.own_version()}"', hashlib.sha256(b"sources").hexdigest(), "https://host/a/b/archive/refs/tags/v"):
        if part not in recipe:
            yield f"recipe.yaml lacks {part}"
    if entry["scm_url"] != "https://host/a/d.git" or "@" in recipe:
        yield "a submission is not filled"
    required = re.search(r"(?m)^requires = \[(.*)\]$", read("pyproject.toml"))[1]
    for requirement in re.findall(r'"([\w-]+>=[\d.]+)', required):
        if requirement.replace(">=", " >=") not in recipe:
            yield f"recipe.yaml lacks {requirement} of pyproject.toml"


def main():
    checks = (problems_of_versions, problems_of_placeholders, problems_of_tools, problems_of_paper, problems_of_submissions)
    found = [problem for check in checks for problem in check()] + list(third_party.problems([]))
    for problem in found:
        print(problem)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
