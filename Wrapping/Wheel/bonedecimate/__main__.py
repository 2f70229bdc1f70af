# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""`python -m bonedecimate`: the program bonedecimate, which portable wheels have and those that are built from source do not."""

import importlib.metadata
import os
import subprocess
import sys

NAME = "bonedecimate.exe" if os.name == "nt" else "bonedecimate"


def main() -> int:
    files = importlib.metadata.files("bonedecimate") or ()
    program = next((file.locate() for file in files if file.name == NAME), None)
    if program is None:
        print("bonedecimate: this wheel was built from source and has no program; a portable wheel (Utilities/build_wheel.sh --portable) "
              "and the Debian package have it", file=sys.stderr)
        return 1
    words = [str(program), *sys.argv[1:]]
    if os.name == "nt":  # execv would not wait
        return subprocess.call(words)
    os.execv(program, words)


if __name__ == "__main__":
    sys.exit(main())
