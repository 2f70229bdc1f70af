#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing and builds the programs in build/release/bin, without tests, interfaces for Python and the plugin for ParaView:
# these come with Utilities/build_release.sh in the same folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

export NINJA_STATUS='[%p after %e s] '
programs=(bonedecimate bonedecimate-phantom)

# The core needs few packages: it compiles while the others are installed.
build_core_meanwhile()
{
  echo "Installing CMake and a compiler, then VTK and other libraries while the core compiles: two minutes"
  Utilities/install_packages.sh core > build/packages.log 2>&1 || fail_to_install
  Utilities/install_packages.sh build run >> build/packages.log 2>&1 &
  local installation=$!
  if command -v cmake ninja > /dev/null; then
    cmake --preset release -DBONEDECIMATE_CORE_ONLY=ON -DBUILD_TESTING=OFF > build/configuration.log
    cmake --build --preset release --target BoneDecimateCore
  fi
  wait "$installation" || fail_to_install
}

fail_to_install()
{
  tail -n 20 build/packages.log
  exit 1
}

mkdir -p build
if ! Utilities/install_packages.sh --check core build run > /dev/null; then
  build_core_meanwhile
fi
for tool in cmake ninja; do
  if ! command -v "$tool" > /dev/null; then
    [ ! -e build/packages.log ] || tail -n 5 build/packages.log
    echo "$tool is not there, so nothing can be built: install the packages in Utilities/packages.txt." >&2
    exit 1
  fi
done
echo "Building the programs: one to two minutes"
cmake --preset release -DBONEDECIMATE_CORE_ONLY=OFF -DBUILD_TESTING=ON > build/configuration.log || { tail -n 20 build/configuration.log; exit 1; }
cmake --build --preset release --target "${programs[@]}"
