#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The libraries of a program that needs nothing else, from Debian's source packages: VTK, ITK and GDCM with what they need, as static libraries
# in build/libraries-TARGET. What is there already is not built again.
#   build_libraries.sh windows|linux-x86_64|linux-arm64     by Debian's mingw-w64, or by zig (Utilities/zig)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

target=$1
prefix=$PWD/build/libraries-$target
case "$target" in
  windows) toolchain=$PWD/Utilities/windows/toolchain.cmake ;;
  *) toolchain=$PWD/Utilities/zig/$target.cmake && Utilities/zig/make_compiler.sh ;;
esac
export CFLAGS="-ffile-prefix-map=$PWD/build/=" CXXFLAGS="-ffile-prefix-map=$PWD/build/=" # the same bytes in any folder
sources=$PWD/build/libraries-src
mkdir -p "$sources/lists/partial"
. /etc/os-release
cat > "$sources/sources.list" << END
deb-src http://deb.debian.org/debian $VERSION_CODENAME main
END
apt=(apt-get -q -o "Dir::Etc::SourceList=$sources/sources.list" -o Dir::Etc::SourceParts=- -o "Dir::State::Lists=$sources/lists" -o APT::Sandbox::User=root)

# Unpacks a source package of Debian, with its patches.
fetch()
{
  if [ ! -d "$sources/$1" ]; then
    [ -n "$(ls "$sources/lists"/*Sources* 2> /dev/null)" ] || "${apt[@]}" update >&2
    (cd "$sources" && "${apt[@]}" source --download-only "$1" >&2 && rm -rf "$1" && dpkg-source --no-check -x "$1"_*.dsc "$1" >&2)
  fi
}

fail()
{
  tail -n 20 "$prefix/$1.log"
  exit 1
}

# build PACKAGE FOLDER OPTION...     FOLDER of its CMakeLists.txt
build()
{
  local package=$1 folder=$2
  shift 2
  [ ! -e "$prefix/done/$package" ] || return 0
  fetch "$package"
  echo "Building $package"
  cmake -G Ninja -S "$sources/$package/$folder" -B "$prefix/work/$package" -DCMAKE_TOOLCHAIN_FILE="$toolchain" \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" -DBUILD_TESTING=OFF -Wno-dev "$@" > "$prefix/$package.log" || fail "$package"
  cmake --build "$prefix/work/$package" --target install >> "$prefix/$package.log" || fail "$package"
  mkdir -p "$prefix/done"
  cp "$sources/$package/debian/copyright" "$prefix/licenses/$package.txt"
  touch "$prefix/done/$package"
}

# Headers alone.
mkdir -p "$prefix/include" "$prefix/licenses" "$prefix/share/cmake"
cp -rL /usr/include/{utf8cpp,CLI,nlohmann} "$prefix/include"
cp -rL /usr/share/cmake/{CLI11,nlohmann_json} "$prefix/share/cmake"
packages=(libeigen3-dev libcli11-dev nlohmann-json3-dev libutfcpp-dev)
[ "$target" != windows ] || packages+=(libz-mingw-w64-dev g++-mingw-w64-x86-64-posix mingw-w64-x86-64-dev)
for package in "${packages[@]}"; do
  cp -L "/usr/share/doc/$package/copyright" "$prefix/licenses/$package.txt"
done

if [ "$target" != windows ]; then
  fetch zlib
  mkdir -p "$sources/zlib/win32"
  touch "$sources/zlib/win32/zlib1.rc" # which Debian leaves out and CMake looks for
  build zlib . -DCMAKE_SHARED_LINKER_FLAGS=-Wl,--undefined-version
  rm -f "$prefix"/lib/libz.so*
fi
build lz4 build/cmake -DLZ4_BUILD_CLI=OFF -DLZ4_BUILD_LEGACY_LZ4C=OFF -DBUILD_STATIC_LIBS=ON
build xz-utils . -DCREATE_{XZ,LZMA}_SYMLINKS=OFF
build expat expat -DEXPAT_BUILD_TOOLS=OFF -DEXPAT_BUILD_EXAMPLES=OFF -DEXPAT_BUILD_TESTS=OFF -DEXPAT_BUILD_DOCS=OFF -DEXPAT_DTD=OFF
build double-conversion .
build libjpeg-turbo . -DENABLE_SHARED=OFF -DWITH_SIMD=OFF -DWITH_TURBOJPEG=OFF
build tiff . -Dtiff-tools=OFF -Dtiff-tests=OFF -Dtiff-contrib=OFF -Dtiff-docs=OFF -Djbig=OFF -Dwebp=OFF -Dzstd=OFF -Dlerc=OFF -Dlzma=OFF -Dcxx=OFF

fetch vtk9
# Layers around a selection, which the program does not use, need the parallel classes of VTK.
sed -i 's/if (layers >= 1 && /if (false \&\& /' "$sources/vtk9/Filters/Extraction/vtkSelector.cxx"
build vtk9 . -DVTK_GROUP_ENABLE_StandAlone=DONT_WANT -DVTK_GROUP_ENABLE_Rendering=DONT_WANT \
  -DVTK_MODULE_ENABLE_VTK_{CommonCore,CommonDataModel,CommonExecutionModel,FiltersCore,FiltersExtraction,ParallelCore,IOCore,IOLegacy,IOXML,IOXMLParser}=YES \
  -DVTK_ENABLE_LOGGING=OFF -DVTK_ENABLE_WRAPPING=OFF -DVTK_ENABLE_REMOTE_MODULES=OFF -DVTK_BUILD_TESTING=OFF -DVTK_LEGACY_REMOVE=ON \
  -DCMAKE_PROJECT_VTK_INCLUDE="$PWD/Utilities/choose_sources.cmake" \
  -DVTK_MODULE_USE_EXTERNAL_VTK_{zlib,lz4,lzma,expat,doubleconversion,utf8,eigen}=ON

fetch gdcm
sed -i 's/^#ifndef _MSC_VER$/#ifndef _WIN32/' "$sources/gdcm/Utilities/gdcmext/mec_mr3_io.c" # there is no iconv
build gdcm . -DGDCM_BUILD_APPLICATIONS=OFF -DGDCM_BUILD_EXAMPLES=OFF -DGDCM_BUILD_TESTING=OFF -DGDCM_DOCUMENTATION=OFF -DGDCM_USE_SYSTEM_ZLIB=ON -DCMAKE_PROJECT_GDCM_INCLUDE="$PWD/Utilities/choose_sources.cmake"
modules=(-DModule_ITK{IOMeta,IONIFTI,IONRRD,IOTIFF,NrrdIO}=ON)
build insighttoolkit5 . -DITK_BUILD_DEFAULT_MODULES=OFF -DITKGroup_Core=OFF "${modules[@]}" -DITK_USE_SYSTEM_{ZLIB,TIFF,JPEG,PNG,EXPAT,EIGEN,GDCM}=ON -DITK_SKIP_PATH_LENGTH_CHECKS=ON -DCMAKE_PROJECT_ITK_INCLUDE="$PWD/Utilities/choose_sources.cmake"
build meshoptimizer . -DMESHOPT_BUILD_SHARED_LIBS=OFF
build libzip . -DBUILD_TOOLS=OFF -DBUILD_REGRESS=OFF -DBUILD_EXAMPLES=OFF -DBUILD_DOC=OFF -DENABLE_{BZIP2,LZMA,ZSTD,OPENSSL,GNUTLS,MBEDTLS,WINDOWS_CRYPTO,COMMONCRYPTO}=OFF
