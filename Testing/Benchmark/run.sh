#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The benchmark: our modes and other programs on the same bones.
#
#   Testing/Benchmark/run.sh               everything: rows, growth, threads (an hour or two)
#   Testing/Benchmark/run.sh --quick       one round of two rows
#   Testing/Benchmark/run.sh --bone skull.stl 50000 0.02
#   Testing/Benchmark/run.sh --help
#
# Builds the programs (preset release, or --build FOLDER), installs the peers of requirements.txt into FOLDER/benchmark/venv
# and leaves figures, page and plots in FOLDER/benchmark/results. A peer that cannot be installed is left out, with a line
# that says so. MeshLib only takes part with --with-meshlib: its license is for non-commercial use.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build/release
with_meshlib=no
arguments=()
while [ $# -gt 0 ]; do
  case $1 in
    --build) build=$(cd "$2" && pwd); shift ;;
    --with-meshlib) with_meshlib=yes; arguments+=("$1") ;;
    *) arguments+=("$1") ;;
  esac
  shift
done
venv=$build/benchmark/venv

build_programs()
{
  [ -f "$build/CMakeCache.txt" ] || (cd "$root" && cmake --preset release > /dev/null)
  cmake --build "$build" --target BenchmarkPrograms > "$build/benchmark-build.log" 2>&1 ||
    { tail -n 40 "$build/benchmark-build.log"; return 1; }
}

# One package after the other, so that one that is not to be had keeps no other away.
install_peers()
{
  local list=$1 line stamp
  stamp=$venv/.$(basename "$list").installed
  if [ -f "$stamp" ] && cmp -s "$list" "$stamp"; then
    return
  fi
  local failed=no
  while read -r line; do
    case $line in '' | '#'*) continue ;; esac
    "$venv/bin/pip" --disable-pip-version-check install --quiet "$line" > "$venv/pip.log" 2>&1 ||
      { echo "$line could not be installed: $(tail -n 1 "$venv/pip.log")"; failed=yes; }
  done < "$list"
  [ $failed = yes ] || cp "$list" "$stamp" # else it is tried again next time
}

build_programs
python=python3
if [ ! -x "$venv/bin/pip" ] && ! python3 -m venv "$venv" > /dev/null 2>&1; then
  echo "python3 -m venv does not work here (Debian: python3-venv): no peers from PyPI, no plots."
else
  install_peers "$here/requirements.txt"
  [ $with_meshlib = no ] || install_peers "$here/requirements-meshlib.txt"
  python=$venv/bin/python
fi
export PYTHONPATH=$here PYTHONDONTWRITEBYTECODE=1
exec "$python" -m bonebench --programs "$build/bin" --work "$build/benchmark" ${arguments[@]+"${arguments[@]}"}
