#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Extracts Debian's ParaView, headers and Python into a separate folder, where the build finds it (BONEDECIMATE_PARAVIEW).
# Usage: install_paraview.sh [FOLDER]     by default build/paraview; 155 MB to download, 670 MB there, 250 MB of libraries
#
# Its package of Python modules and that of Debian's VTK exclude each other, so it cannot be installed in the usual way.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=${1:-build/paraview}
packages=(paraview paraview-dev python3-paraview)
icons=(libqt5svg5) # only recommended by Debian: without it the window has none

if [ -x "$folder/usr/bin/pvpython" ]; then
  exit 0
fi
if ! command -v apt-get > /dev/null || [ "$(id -u)" -ne 0 ]; then
  echo "This takes Debian's packages and needs root; to use another ParaView, set -DBONEDECIMATE_PARAVIEW_PREFIX."
  exit 1
fi

apt-get -q update
apt-cache show "${icons[@]}" > /dev/null 2>&1 || icons=() # systems of Qt 6 alone
# What they need, without themselves.
needed=$(apt-get -s --no-install-recommends install paraview paraview-dev "${icons[@]}" | awk '$1 == "Inst" { print $2 }' |
  grep -vxE "$(IFS='|'; echo "${packages[*]}")" || true)
if [ -n "$needed" ]; then
  # shellcheck disable=SC2086
  DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install $needed
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch" # apt downloads as a user of its own
(cd "$scratch" && apt-get -q download "${packages[@]}")
mkdir -p "$folder.part"
for package in "$scratch"/*.deb; do
  dpkg-deb -x "$package" "$folder.part"
done
# Since Debian 13 the names of Python's modules have Python's version in them, but not where ParaView's CMake package lists them.
find "$folder.part" -name '*.cpython-*.so' | while read -r module; do
  [ -e "${module%%.cpython-*}.so" ] || ln -s "$(basename "$module")" "${module%%.cpython-*}.so"
done
rm -rf "$folder"
mv "$folder.part" "$folder"
