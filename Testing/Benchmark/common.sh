# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# What the benchmarks have in common: arguments, programs and peers. To be sourced, with $here set to this folder.

root=$(cd "$here/../.." && pwd)

# Sets $build, $venv, $with_meshlib and $arguments, those of the Python program.
read_arguments()
{
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
}

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

# Sets $python: that of the peers, or the system's.
prepare_python()
{
  python=python3
  if [ ! -x "$venv/bin/pip" ] && ! python3 -m venv "$venv" > /dev/null 2>&1; then
    echo "python3 -m venv does not work here (Debian: python3-venv): no peers from PyPI, no plots."
  else
    install_peers "$here/requirements.txt"
    [ $with_meshlib = no ] || install_peers "$here/requirements-meshlib.txt"
    python=$venv/bin/python
  fi
}

# Reads the arguments of the script, builds, and sets what the functions above set.
prepare()
{
  read_arguments "$@"
  build_programs
  prepare_python
}
