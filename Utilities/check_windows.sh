#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# For Windows, compiled with Debian's mingw-w64 and run in Wine: the core with the table of checksums and all its tests, the program with its tests, or
# the wheel with its tests.
#   Utilities/check_windows.sh [--checksums|--program] [TEST...]     --checksums: the table alone
#   Utilities/check_windows.sh --wheel [VERSION...]                  VERSION of Python, by default 3.11 and 3.13; needs build/release
# The libraries of the program (Utilities/build_libraries.sh) take about an hour the first time.
# TEST: of Testing/Application, without _test.py; by default those that pass.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

Utilities/install_packages.sh windows
WINEPREFIX=$(mktemp -d)
export WINEPREFIX WINEDEBUG=-all
trap '/usr/lib/wine/wineserver64 -k; rm -rf "$WINEPREFIX"' EXIT
wine=/usr/lib/wine/wine64

check_core()
{
  cmake --preset windows
  cmake --build --preset windows --target "$@"
  echo "Checksums"
  diff <("$wine" build/windows/bin/bonedecimate-checksums.exe --short | tr -d '\r') Testing/Checksums/short.txt
  if [ $# -gt 1 ]; then
    echo "Core"
    "$wine" build/windows/bin/BoneDecimateCoreTests.exe --gtest_brief=1
  fi
}

check_program()
{
  Utilities/build_libraries.sh windows
  cmake --preset windows-program
  cmake --build --preset windows-program --target bonedecimate
  (cd build/windows-program && cpack)
  export BONEDECIMATE_PROGRAM=$PWD/Utilities/windows/bonedecimate
  local failed=0
  for test in "$@"; do
    echo "$test"
    /usr/bin/python3 -B "Testing/Application/${test}_test.py" || failed=$((failed + 1))
  done
  echo "$(($# - failed)) of $# passed"
  [ "$failed" -eq 0 ]
}

check_wheel()
{
  # PyVista draws.
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" /usr/bin/python3 -B Testing/Wheel/matrix_windows.py "$@"
}

case "${1:-}" in
  --program)
    shift
    [ $# -gt 0 ] || set -- cap certify commands file_names precision profiles prune readers reference regions thesis_form tunnels units volumes voxels
    check_program "$@" ;;
  --wheel)
    shift
    check_wheel "$@" ;;
  --checksums) check_core bonedecimate-checksums ;;
  *) check_core bonedecimate-checksums BoneDecimateCoreTests ;;
esac
