#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The core as WebAssembly: the table of checksums, tests of the core, the package for npm and the page in Chromium.
#   Utilities/check_wasm.sh [--build]     --build: makes package and page (build/wasm/npm, build/wasm/bonedecimate.html) and ends
# Needs Debian's emscripten, and npm with a network. With build/release/bin/bonedecimate results are compared with the program's.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# What depends on the processor, the compiler or the standard library. The test left out compares sizes, and padding is larger than a
# text of libc++.
suites='Kernel*:*KernelReference*:ExactPredicates*:Text*:Option*:BoundingTree*:LabelSurface*:LabelTypes*:PointRounding*:LogBytes*:CertificateFoot*:ColumnCrossings*'
suites+=':-OptionTable.HasEveryFieldOfOptionsExactlyOnce'

Utilities/install_packages.sh wasm
cmake --preset wasm
cmake --build --preset wasm --target bonedecimate-npm bonedecimate-page
if [ "${1:-}" = --build ]; then
  exit 0
fi
cmake --build --preset wasm --target bonedecimate-checksums BoneDecimateCoreTests
node=(node --no-experimental-fetch)
echo "Checksums"
diff <("${node[@]}" build/wasm/bin/bonedecimate-checksums.js --short) Testing/Checksums/short.txt
echo "Core"
"${node[@]}" build/wasm/bin/BoneDecimateCoreTests.js --gtest_brief=1 --gtest_filter="$suites"
program=build/release/bin/bonedecimate
[ -x "$program" ] || program=
echo "Package"
NATIVE="$program" PACKAGE=build/wasm/npm node --test Testing/Browser/package.test.mjs
PROGRAMS= PACKAGE=build/wasm/npm python3 -B Testing/Readme/run_tutorial.py Documentation/tutorials/browser.md
echo "Page"
/usr/bin/python3 -B Testing/Browser/page_test.py build/wasm/bonedecimate.html ${program:+"$program"}
driver=build/release/bin/bonedecimate-dump-volume
if [ -x "$driver" ]; then
  echo "NIfTI"
  BONEDECIMATE_PAGE=build/wasm/Applications/Browser/bundle /usr/bin/python3 -B Testing/Formats/compare_volumes.py --format nifti \
    --variants 300 --driver "$driver"
fi
