#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The core for Windows, compiled with Debian's mingw-w64 and run in Wine: the table of checksums, and all tests of the core.
#   Utilities/check_windows.sh [--checksums]     --checksums: the table alone
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

Utilities/install_packages.sh windows
cmake --preset windows
targets=(bonedecimate-checksums)
[ "${1:-}" = --checksums ] || targets+=(BoneDecimateCoreTests)
cmake --build --preset windows --target "${targets[@]}"
WINEPREFIX=$(mktemp -d)
export WINEPREFIX WINEDEBUG=-all
trap '/usr/lib/wine/wineserver64 -k; rm -rf "$WINEPREFIX"' EXIT
run=(/usr/lib/wine/wine64)
echo "Checksums"
diff <("${run[@]}" build/windows/bin/bonedecimate-checksums.exe --short | tr -d '\r') Testing/Checksums/short.txt
if [ "${1:-}" != --checksums ]; then
  echo "Core"
  "${run[@]}" build/windows/bin/BoneDecimateCoreTests.exe --gtest_brief=1
fi
