#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Compiles the tests of the core in build/release, or in build/core where that is not configured, and prints the value of
# BONEDECIMATE_TEST_TARGETS for builds that run the same tests with another core: with sanitizers, or recording coverage.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=release
if [ ! -f build/release/CMakeCache.txt ]; then
  preset=core
  cmake --preset core >&2
fi
cmake --build --preset "$preset" --parallel "$(getconf _NPROCESSORS_ONLN)" --target BoneDecimateUnitTests BoneDecimateTestSupport >&2
echo "$PWD/build/$preset/BoneDecimateTests.cmake"
