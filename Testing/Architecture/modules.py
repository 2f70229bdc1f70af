#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks every include against the table "Modules" of ARCHITECTURE.md, and that headers include what fixed-width integers need.

Reports file, line and rule of each violation.

    modules.py [ROOT]        check the tree
    modules.py --self-test   check that violations added to a copy of the tree's skeleton are found
"""
import re
import sys
from pathlib import Path, PurePosixPath

CORE = "Filters/Core"
FILTERS = "Filters/BoneDecimate"
PARALLEL = "Filters/BoneDecimateParallel"
SOURCES = (".h", ".cxx", ".hpp", ".cpp", ".h.in", ".cxx.in")
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
FIXED_WIDTH = re.compile(r"\bstd::u?int\d+_t\b")

# Modules of the applications that belong together. "system" below means the headers of the operating system and of its
# small libraries.
NEIGHBORS = {
    "Applications/CommandLine": {"Applications/CommandLine/Formats", "Applications/Volume", "Applications/Picture"},
    "Applications/ParaView/Module": {PARALLEL},
    "Applications/Picture": {"Applications/Loading"},
    "Applications/Volume": {"Applications/Loading"},
}
LIBRARIES = {
    "Applications/CommandLine": {"CLI11", "JSON", "system"},
    "Applications/Loading": {"system"},
    "Applications/Picture": {"JSON", "system"},
    "Applications/Volume": {"system"},
    f"{CORE}/Base": {"system"},
    "Wrapping/Npm": {"emscripten"},
    "Wrapping/Wheel": {"nanobind"},
}
STREAMS = {"iostream", "fstream", "sstream", "ostream", "istream", "iomanip", "ios", "iosfwd", "streambuf",
           "filesystem", "syncstream"}
STANDARD = set("""
algorithm any array atomic bitset cassert cctype cerrno cfenv cfloat charconv chrono cinttypes climits clocale cmath
complex condition_variable csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib cstring ctime cwchar cwctype deque
exception execution forward_list functional future initializer_list iterator limits list locale map memory mutex new
numeric optional queue random ratio regex set shared_mutex stack stdexcept string string_view system_error thread
tuple type_traits typeindex typeinfo unordered_map unordered_set utility valarray variant vector
""".split())
KINDS = [
    (re.compile(r"^CGAL/"), "CGAL"),
    (re.compile(r"^Eigen/"), "Eigen"),
    (re.compile(r"^(vtk\w+\.h$|vtk_)"), "VTK"),
    (re.compile(r"^gdcm\w*\.h"), "GDCM"),
    (re.compile(r"^(itk\w+\.h|NrrdIO\.h)$"), "ITK"),
    (re.compile(r"^CLI/"), "CLI11"),
    (re.compile(r"^nlohmann/"), "JSON"),
    (re.compile(r"^nanobind/"), "nanobind"),
    (re.compile(r"^emscripten/"), "emscripten"),
]


class Module:
    """A row of the table: the folders, single headers and libraries that its files may include."""

    def __init__(self, path):
        self.path = path
        self.modules = {path}
        self.headers = set()
        self.libraries = {"standard"}
        self.free = False


def read_rows(page):
    """The rows (paths, words of the last column) of the table under "## Modules"."""
    rows = []
    lines = page.split("## Modules", 1)[1].splitlines()
    for line in lines[1:]:
        if line.startswith("## "):
            break
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if len(cells) == 3 and cells[0].startswith("`"):
            rows.append((cells[0].strip("`").rstrip("/"), [word.strip() for word in cells[2].split(",")]))
    return rows


def named(word, core_modules):
    """The module of the core whose folder has this name; None: there is none."""
    return next((path for path in sorted(core_modules) if path.split("/")[-1] == word), None)


def allow(module, word, core_modules, above):
    """Turns one word of the last column into permissions; False if the word is unknown."""
    if word == "all modules of the core":
        module.modules |= core_modules
    elif word == "all of the above":
        module.modules |= above
    elif named(word, core_modules):
        module.modules.add(named(word, core_modules))
    elif word == "the filters":
        module.modules.add(FILTERS)
    elif word.startswith("`") and word.endswith("`"):
        module.headers.add(f"{CORE}/" + word.strip("`"))
    elif word in ("VTK", "GDCM", "ITK"):
        module.libraries |= {word, "streams"}
    elif word == "anything":
        module.free = True
    elif word not in ("standard library", ""):
        return False
    return True


def read_modules(page):
    """Modules by path, and errors of the table itself."""
    rows = read_rows(page)
    core_modules = {path for path, _ in rows if path.startswith(CORE)}
    modules, errors, above = {}, [], set()
    for path, words in rows:
        module = modules[path] = Module(path)
        for word in words:
            if not allow(module, word, core_modules, above):
                errors.append(f"ARCHITECTURE.md: module {path}: unknown word '{word}'")
        if path in core_modules:
            module.libraries.add("Eigen")
            errors += [f"ARCHITECTURE.md: module {path}: {below} is not above it in the table, so there may be a cycle"
                       for below in sorted(module.modules - above - {path})]
            above.add(path)
        else:
            module.libraries.add("streams")
        module.modules |= NEIGHBORS.get(path, set())
        module.libraries |= LIBRARIES.get(path, set())
    return modules, errors


def module_of(path, modules):
    """The module with the longest path that holds the file; None outside of all modules."""
    folders = [str(parent) for parent in PurePosixPath(path).parents]
    return next((modules[folder] for folder in folders if folder in modules), None)


def resolve(root, includer, name):
    """The file of this project that an include means, as a path from the root; None for a library."""
    folders = [str(PurePosixPath(includer).parent), CORE, FILTERS, PARALLEL, "Testing/Support"]
    folders += [str(folder.relative_to(root)) for folder in sorted((root / "Applications").glob("*"))]
    for folder in folders:
        target = (root / folder / name).resolve()
        if target.is_file() and root in target.parents:
            return target.relative_to(root).as_posix()
    return None


def kind_of(name):
    """The library that a header belongs to."""
    for pattern, kind in KINDS:
        if pattern.match(name):
            return kind
    if name in STREAMS:
        return "streams"
    return "standard" if name in STANDARD else "system"


def broken_rule(module, target, name, modules):
    """The rule an include breaks, or None."""
    if module.free:
        return None
    if target is None:
        kind = kind_of(name)
        if kind == "CGAL":
            return "Filters and Applications may not include CGAL"
        return None if kind in module.libraries else f"{module.path} may not include {kind} headers"
    included = module_of(target, modules)
    if included is not None and included.path in module.modules or target in module.headers:
        return None
    return f"{module.path} may not include {PurePosixPath(target).parent}"


def check_file(root, path, modules):
    module = module_of(path, modules)
    parent = PurePosixPath(path).parent.as_posix()
    if module is None or module.path.startswith(CORE) and module.path != parent:
        return [f"{path}:1: no module of ARCHITECTURE.md contains this file"]
    found = []
    text = (root / path).read_text(encoding="utf-8")
    for number, line in enumerate(text.splitlines(), start=1):
        include = INCLUDE.match(line)
        if not include:
            continue
        target = resolve(root, path, include.group(2)) if include.group(1) == '"' else None
        rule = broken_rule(module, target, include.group(2), modules)
        if rule:
            found.append(f'{path}:{number}: {rule}: "{include.group(2)}"')
    return found + check_integers(path, text)


def check_integers(path, text):
    """A header does not rely on others for the fixed-width integers: since gcc 13 those of the library no longer bring them."""
    used = FIXED_WIDTH.search(text)
    if not path.endswith(".h") or not used or "#include <cstdint>" in text:
        return []
    return [f"{path}:{text.count(chr(10), 0, used.start()) + 1}: {used[0]} without <cstdint>"]


def check_tree(root):
    root = root.resolve()
    modules, found = read_modules((root / "ARCHITECTURE.md").read_text(encoding="utf-8"))
    found += [f"ARCHITECTURE.md: module {path} does not exist" for path in modules if not (root / path).is_dir()]
    for top in ("Filters", "Applications", "Wrapping", "Testing", "Data"):
        for path in sorted((root / top).rglob("*")):
            if path.name.endswith(SOURCES) and path.is_file():
                found += check_file(root, path.relative_to(root).as_posix(), modules)
    return found


def main(arguments):
    if arguments == ["--self-test"]:
        import self_test
        return self_test.run()
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parents[2]
    found = check_tree(root)
    for line in found:
        print(line)
    print(f"{len(found)} violations")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
