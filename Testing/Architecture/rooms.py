#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Walks the include arrows and fails with file, line and rule where one leaves its room.

What a room may include is read from the table "The rooms" of ARCHITECTURE.md, so that page and code cannot part.

    rooms.py [ROOT]        check the tree
    rooms.py --self-test   plant violations in a copy of the frame and see that each one is found
"""
import re
import sys
from pathlib import Path, PurePosixPath

CORE = "Filters/Core"
DOOR = "Filters/BoneDecimate"
PARALLEL = "Filters/BoneDecimateParallel"
SOURCES = (".h", ".cxx", ".hpp", ".cpp", ".h.in", ".cxx.in")
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')

# Headers that every room of the core may know: the words in which its rooms talk.
VOCABULARY = {"Surface.h", "Options.h", "Report.h", "Monitor.h", "Parallel.h", "Memory/LargeArray.h", "Memory/Prefetch.h"}
# Geometry is below them; the table says `Surface.h` and nothing else.
WITHOUT_VOCABULARY = {f"{CORE}/Geometry"}
# The program puts its own rooms together, and takes what the table does not list one by one: "system" is the
# headers of the operating system and of its small libraries.
NEIGHBOURS = {
    "Applications/CommandLine": {"Applications/Volume", "Applications/Picture"},
    "Applications/ParaView/Module": {PARALLEL},
}
LIBRARIES = {
    "Applications/CommandLine": {"CLI11", "JSON", "system"},
    "Applications/Picture": {"JSON", "system"},
    "Applications/Volume": {"system"},
    f"{CORE}/Memory": {"system"},
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
    (re.compile(r"^CLI/"), "CLI11"),
    (re.compile(r"^nlohmann/"), "JSON"),
    (re.compile(r"^nanobind/"), "nanobind"),
]


class Room:
    """A row of the table: which folders, single headers and libraries its files may include."""

    def __init__(self, path):
        self.path = path
        self.rooms = {path}
        self.headers = set()
        self.libraries = {"standard"}
        self.free = False


def read_rows(page):
    """The rows (paths, words of the last column) of the table under "## The rooms"."""
    rows = []
    lines = page.split("## The rooms", 1)[1].splitlines()
    for line in lines[1:]:
        if line.startswith("## "):
            break
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if len(cells) == 3 and cells[0].startswith("`"):
            rows.append((cells[0].strip("`").rstrip("/"), [word.strip() for word in cells[2].split(",")]))
    return rows


def allow(room, word, core_rooms, above):
    """Turns one word of the last column into permissions; False if the word has no meaning here."""
    if word == "all core rooms":
        room.rooms |= core_rooms
    elif word == "all of the above":
        room.rooms |= above
    elif f"{CORE}/{word}" in core_rooms:
        room.rooms.add(f"{CORE}/{word}")
    elif word == "the door":
        room.rooms.add(DOOR)
    elif word == "Core":
        room.rooms.add(CORE)
    elif word == "Core's report":
        room.headers |= {f"{CORE}/Report.h", f"{CORE}/ReportTable.h"}
    elif word.startswith("`") and word.endswith("`"):
        room.headers.add(f"{CORE}/" + word.strip("`"))
    elif word in ("VTK", "GDCM"):
        room.libraries |= {word, "streams"}
    elif word == "anything":
        room.free = True
    elif word not in ("standard library", ""):
        return False
    return True


def read_rooms(page):
    """Rooms by path, and complaints about the table itself."""
    rows = read_rows(page)
    core_rooms = {path for path, _ in rows if path.startswith(CORE)}
    rooms, complaints, above = {}, [], set()
    for path, words in rows:
        room = rooms[path] = Room(path)
        for word in words:
            if not allow(room, word, core_rooms, above):
                complaints.append(f"ARCHITECTURE.md: room {path}: nobody knows what '{word}' allows")
        if path in core_rooms:
            room.libraries.add("Eigen")
            if path not in WITHOUT_VOCABULARY:
                room.headers |= {f"{CORE}/{name}" for name in VOCABULARY}
            if path != CORE:
                above.add(path)
        else:
            room.libraries.add("streams")
        room.rooms |= NEIGHBOURS.get(path, set())
        room.libraries |= LIBRARIES.get(path, set())
    return rooms, complaints


def room_of(path, rooms):
    """The room with the longest path that holds the file; None outside of all rooms."""
    folders = [str(parent) for parent in PurePosixPath(path).parents]
    return next((rooms[folder] for folder in folders if folder in rooms), None)


def resolve(root, includer, name):
    """The file of ours that an include means, as a path from the root; None if it is not ours."""
    folders = [str(PurePosixPath(includer).parent), CORE, DOOR, PARALLEL, "Testing/Support"]
    folders += [str(folder.relative_to(root)) for folder in sorted((root / "Applications").glob("*"))]
    for folder in folders:
        target = (root / folder / name).resolve()
        if target.is_file() and root in target.parents:
            return target.relative_to(root).as_posix()
    return None


def kind_of(name):
    """Which library a header that is not ours belongs to."""
    for pattern, kind in KINDS:
        if pattern.match(name):
            return kind
    if name in STREAMS:
        return "streams"
    return "standard" if name in STANDARD else "system"


def broken_rule(room, target, name):
    """The rule an include breaks, or None."""
    if room.free:
        return None
    if target is None:
        kind = kind_of(name)
        if kind == "CGAL":
            return "CGAL is nowhere in Filters and Applications"
        return None if kind in room.libraries else f"{room.path} may not include {kind} headers"
    folder = PurePosixPath(target).parent.as_posix()
    if folder in room.rooms or target in room.headers:
        return None
    return f"{room.path} may not include {folder}"


def check_file(root, path, rooms):
    room = room_of(path, rooms)
    if room is None:
        return [f"{path}:1: no room of ARCHITECTURE.md holds this file"]
    found = []
    text = (root / path).read_text(encoding="utf-8")
    for number, line in enumerate(text.splitlines(), start=1):
        include = INCLUDE.match(line)
        if not include:
            continue
        target = resolve(root, path, include.group(2)) if include.group(1) == '"' else None
        rule = broken_rule(room, target, include.group(2))
        if rule:
            found.append(f'{path}:{number}: {rule}: "{include.group(2)}"')
    return found


def check_tree(root):
    root = root.resolve()
    rooms, found = read_rooms((root / "ARCHITECTURE.md").read_text(encoding="utf-8"))
    found += [f"ARCHITECTURE.md: room {path} is not there" for path in rooms if not (root / path).is_dir()]
    for top in ("Filters", "Applications", "Wrapping", "Testing", "Data"):
        for path in sorted((root / top).rglob("*")):
            if path.name.endswith(SOURCES) and path.is_file():
                found += check_file(root, path.relative_to(root).as_posix(), rooms)
    return found


def main(arguments):
    if arguments == ["--self-test"]:
        import self_test
        return self_test.run()
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parents[2]
    found = check_tree(root)
    for line in found:
        print(line)
    print(f"{len(found)} broken rules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
