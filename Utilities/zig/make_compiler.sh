#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The compilers of PyPI's ziglang for any Linux since glibc 2.17, in build/zig: x86_64-cc, x86_64-c++, aarch64-cc, aarch64-c++, ar, ranlib.
# Its version is that of wheel_constraints.txt. What is there already is not made again.
set -euo pipefail
utilities=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=$(dirname "$utilities")/build/zig

if ! cmp -s "$utilities/wheel_constraints.txt" "$folder/constraints.txt"; then
  rm -rf "$folder"
  python3 -m venv "$folder/tools"
  "$folder/tools/bin/pip" -q install --disable-pip-version-check -c "$utilities/wheel_constraints.txt" ziglang
fi
zig=$("$folder/tools/bin/python" -c 'import ziglang; print(ziglang.__path__[0])')/zig
write_tool()
{
  printf '#!/bin/sh\nexport ZIG_GLOBAL_CACHE_DIR="%s" ZIG_LOCAL_CACHE_DIR="%s"\nexec "%s" %s "$@"\n' "$folder/cache" "$folder/cache" "$zig" "$2" > "$folder/$1"
  chmod +x "$folder/$1"
}
for processor in x86_64 aarch64; do
  for compiler in cc c++; do
    write_tool "$processor-$compiler" "$compiler -target $processor-linux-gnu.2.17"
  done
done
write_tool ar ar
write_tool ranlib ranlib
cp "$utilities/wheel_constraints.txt" "$folder/constraints.txt"
