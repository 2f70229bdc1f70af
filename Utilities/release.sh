#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds what a release delivers, checks each artifact where it will be used, and lists them with checksums, bills of materials and notes.
#
#   Utilities/release.sh [ARTIFACT...]     into dist/VERSION; by default all of them, several hours
#
# sdist      the sources for pip, built into a wheel again
# wheel      for any x86-64 Linux since glibc 2.17, with the program: its commands and results in an environment of its own
# arm64      the same for arm64: its tests in qemu-user
# windows    the wheel and the zip with the program: their tests in Wine
# npm        the package for npm and the page for browsers: in Node and Chromium
# bookworm   the Debian package: everything is built and tested in a fresh root of that release, and the package installed
# trixie     the same
# site       the documentation: links, anchors, references
#
# The commit has to be clean. What was built before stays, so that artifacts can be made one by one, on several machines.
# Nothing is built for macOS.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

version=$(sed -nE 's/^project\(vtkBoneDecimate VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
readonly version folder=$PWD/dist/$version roots=${RELEASE_ROOTS:-$PWD/build/release-roots}
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH

make_sdist()
{
  local tools=build/release-tools
  [ -x "$tools/bin/python" ] || python3 -m venv "$tools"
  PIP_CONSTRAINT=Utilities/wheel_constraints.txt "$tools/bin/pip" -q install --disable-pip-version-check build
  "$tools/bin/python" -m build --sdist --outdir "$folder" .
  "$tools/bin/pip" wheel -q --no-deps --disable-pip-version-check -w build/release-tools/wheel "$folder/bonedecimate-$version.tar.gz"
}

# The wheels are compared with what this system makes.
make_wheel()
{
  Utilities/build_release.sh
  Utilities/build_wheel.sh --portable "$folder"
  /usr/bin/python3 -B Testing/Wheel/check_program.py "$folder"/bonedecimate-"$version"-*manylinux*x86_64.whl
}

make_arm64()
{
  Utilities/build_release.sh
  Utilities/check_arm64.sh --wheel
  cp build/arm64-wheel/*.whl "$folder"
}

make_windows()
{
  Utilities/build_release.sh
  Utilities/check_windows.sh --wheel
  Utilities/check_windows.sh --program
  cp build/windows-python/wheels/*/*.whl build/windows-program/*.zip "$folder"
}

make_npm()
{
  Utilities/check_wasm.sh
  (cd build/wasm/npm && npm pack --silent --pack-destination "$folder")
  cp build/wasm/bonedecimate.html "$folder"
}

make_deb()
{
  Utilities/check_debian.sh "$1" "$roots/$1"
  local package
  for package in "$roots/$1"/project/build/package/*.deb; do
    cp "$package" "$folder/$(basename "$package" .deb)_$1.deb"
  done
}

make_site()
{
  Utilities/build_site.sh
  tar -C build/site -czf "$folder/bonedecimate-$version-site.tar.gz" html
}

# Bills of materials, the notes of the version, and the checksums of all that lies there.
list_artifacts()
{
  local product
  for product in deb wheel wheel-windows wheel-program page browser; do
    python3 -B Utilities/third_party.py --sbom "$product" "$folder/bonedecimate-$version-$product.cdx.json"
  done
  awk '/^## / { ++sections } sections == 1' CHANGELOG.md > "$folder/NOTES.md"
  (cd "$folder" && find . -type f ! -name SHA256SUMS -printf '%P\0' | LC_ALL=C sort -z | xargs -0 sha256sum > SHA256SUMS)
  cat "$folder/SHA256SUMS"
}

if [ -n "$(git status --porcelain)" ]; then
  echo "The tree is not clean: a release is that of a commit." >&2
  exit 1
fi
Utilities/install_packages.sh core build run site
Utilities/check_release.py
if grep -q '^## .* (unreleased)$' CHANGELOG.md; then
  echo "The changelog has no date for this version." >&2
  exit 1
fi
mkdir -p "$folder" "$roots"
[ $# -gt 0 ] || set -- sdist wheel arm64 windows npm bookworm trixie site
for artifact in "$@"; do
  echo "== $artifact"
  case $artifact in
    bookworm | trixie) make_deb "$artifact" ;;
    sdist | wheel | arm64 | windows | npm | site) "make_$artifact" ;;
    *)
      echo "'$artifact' is no artifact: sdist, wheel, arm64, windows, npm, bookworm, trixie, site" >&2
      exit 1
      ;;
  esac
done
list_artifacts
