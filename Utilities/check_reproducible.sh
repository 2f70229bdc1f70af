#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds packages twice, in folders with different names, and compares them byte by byte.
#
#   check_reproducible.sh [wheel] [deb]     by default both; each is two builds from nothing
#
# FOLDER    where the builds go and stay; by default a new one, removed at the end
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[ $# -gt 0 ] || set -- wheel deb
folder=${FOLDER:-}
if [ -z "$folder" ]; then
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
fi
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -c safe.directory="$root" -C "$root" log -1 --format=%ct)}
export SOURCE_DATE_EPOCH

# What git knows or would know, as a fresh clone has it.
copy_tree()
{
  mkdir -p "$1"
  (cd "$root" && git -c safe.directory="$root" ls-files -z --cached --others --exclude-standard |
    tar --null --ignore-failed-read -T - -cf - 2>/dev/null) | tar -xf - -C "$1"
}

build_wheel() { "$1/Utilities/build_wheel.sh" "$2" >"$2.log" 2>&1; }

build_deb()
{
  cmake -S "$1" -B "$1/out" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF >"$2.log" 2>&1 &&
    cmake --build "$1/out" >>"$2.log" 2>&1 && cpack --config "$1/out/CPackConfig.cmake" -B "$2" >>"$2.log" 2>&1
}

failed=0
for kind in "$@"; do
  sums=()
  for name in first the-second-folder; do
    copy_tree "$folder/$kind/$name/tree"
    if ! "build_$kind" "$folder/$kind/$name/tree" "$folder/$kind/$name/made"; then
      tail -n 30 "$folder/$kind/$name/made.log"
      exit 1
    fi
    files=("$folder/$kind/$name"/made/*."${kind/wheel/whl}")
    sums+=("$(sha256sum <"${files[0]}" | cut -d ' ' -f 1)")
    echo "$(basename "${files[0]}") in $name: ${sums[-1]}"
    rm -rf "$folder/$kind/$name/tree"
  done
  if [ "${sums[0]}" = "${sums[1]}" ]; then
    echo "$kind: the same bytes"
  else
    echo "$kind: DIFFERENT bytes"
    failed=1
  fi
done
exit $failed
