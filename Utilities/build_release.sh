#!/usr/bin/env bash
# Installs what is missing, configures the preset "release" and builds it.
# Usage: build_release.sh [ARGUMENTS FOR cmake --build...]
set -euo pipefail
cd "$(dirname "$0")/.."

Utilities/install_packages.sh core build run
for tool in cmake ninja; do
  if ! command -v "$tool" > /dev/null; then
    echo "$tool is not there, so nothing can be built: install the packages in Utilities/packages.txt." >&2
    exit 1
  fi
done
cmake --preset release
cmake --build --preset release "$@"
