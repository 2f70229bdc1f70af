#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Slicer's core from PyPI runs the program and the scripted module's logic.
#
#   Testing/Slicer/run.sh [BUILD]      with the programs of BUILD, by default build/release; environment in BUILD/slicer
#   TABLE=1 Testing/Slicer/run.sh      prints the table of Documentation/results/slicer.md and draws its picture, too (the CT is in
#                                      Debian's invesalius-examples)
#
# Takes about 500 MB and some minutes the first time; not part of the test suite.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$(cd "${1:-$root/build/release}" && pwd)
folder=$build/slicer
readonly slicer_core=slicer-core==5.13.31053.0

if [ ! -x "$folder/bin/python" ]; then
  python3 -m venv "$folder"
  "$folder/bin/pip" --disable-pip-version-check -q install "$slicer_core" numpy
fi
PYTHON="$folder/bin/python" "$root/Utilities/build_wheel.sh" "$folder/dist"
"$folder/bin/pip" --disable-pip-version-check -q install --force-reinstall --no-deps "$folder"/dist/bonedecimate-*.whl

libraries=$("$folder/bin/python" -c 'import pathlib, slicer_core; print(pathlib.Path(slicer_core.__file__).parent)')
g++ -std=c++17 -D_GLIBCXX_USE_CXX11_ABI=0 -O1 -shared -fPIC "$here/register_module.cxx" -o "$folder/register_module.so" \
  -L"$libraries" -lMRMLCLI -L"$libraries/third_party.libs" -lModuleDescriptionParser \
  -Wl,-rpath,"$libraries:$libraries/third_party.libs" -Wl,--allow-shlib-undefined
export DUMP_VOLUME=$build/bin/bonedecimate-dump-volume BONEDECIMATE_PROGRAM=$build/bin/bonedecimate
export REGISTER_MODULE=$folder/register_module.so
export SLICER_MODULE=$root/Applications/Slicer/BoneDecimator
for name in slicer_core segmentation panel volume tutorial; do
  "$folder/bin/python" -B "$here/${name}_test.py"
done
if [ -n "${TABLE:-}" ]; then
  "$folder/bin/python" -B "$here/closed_surfaces.py"
  "$folder/bin/python" -B "$here/closed_surfaces.py" --picture "$root/Documentation/images/slicer-segments.png" "phantom, 4"
fi
