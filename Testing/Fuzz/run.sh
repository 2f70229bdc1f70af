#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Fuzzes the core, the readers, the replay of logs and the exact predicates with clang's libFuzzer, address and undefined-behavior sanitizers.
#
#   run.sh [RUNS [FOLDER]]     so many runs of each, by default 1000000; corpora and finds into FOLDER, by default build/fuzz
#
# Needs clang and its run-time library (Debian: clang-14 libclang-rt-14-dev). CXX chooses another clang.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
runs=${1:-1000000}
folder=$(realpath -m "${2:-$root/build/fuzz}")

cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER="${CXX:-clang++-14}" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DBONEDECIMATE_CORE_ONLY=ON -DBONEDECIMATE_FUZZ=ON -DBONEDECIMATE_SANITIZE=address,undefined,fuzzer-no-link
for name in core files logs predicates; do
  cmake --build "$folder" --target "bonedecimate-fuzz-$name"
done
status=0
for name in core files logs predicates; do
  inputs="$folder/corpus-$name"
  python3 "$root/Testing/Fuzz/corpus.py" unpack "$root/Testing/Fuzz/corpus/$name.txt" "$inputs"
  echo "$name: $runs runs"
  # A find stops its harness; an input of a minute or of a gibibyte is one, too.
  "$folder/bin/bonedecimate-fuzz-$name" -runs="$runs" -timeout=60 -rss_limit_mb=2048 -malloc_limit_mb=1024 \
    -artifact_prefix="$folder/find-$name-" -print_final_stats=1 -verbosity=0 "$inputs" 2>&1 |
    grep -v "dictionary\|# Uses" || status=1
  echo "$name: $(find "$inputs" -type f | wc -l) inputs in its corpus now"
done
exit $status
