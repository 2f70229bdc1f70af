#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Measures every table of Documentation/results and Documentation/paper that has a data file, of one commit on one machine, and writes pages and tables.
#
#   Testing/Benchmark/all.sh [--skull FILE] [FILE ...]     FILE: a surface besides the bones of the CT; --skull: one with non-manifold edges
#
# Takes hours, on a machine that does nothing else. Each part is a command of its own, too: run.sh, audit.sh, features.sh and smoothing.sh.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
results=$here/../../build/release/benchmark

"$here/../../Utilities/install_packages.sh" test benchmark
"$here/../../Utilities/install_paraview.sh" # for several processes
"$here/../../Utilities/check_wasm.sh" --build # for the browser

skull=() bones=()
while [ $# -gt 0 ]; do
  case $1 in
    --skull) skull=(--skull "$2"); shift ;;
    *) bones+=(--bone "$1") ;;
  esac
  shift
done
ct=(--bone maxilla --bone frontal)

"$here/run.sh" --with-meshlib --rows . ${bones[@]+"${bones[@]}"} --output "$results/rows" # --rows: the bones of the CT, too
"$here/run.sh" --thesis --output "$results/thesis"
"$here/run.sh" --from "$results/rows/benchmark.json" "$results/thesis/benchmark.json" --write-docs
"$here/audit.sh" --with-meshlib --certificates --write-docs "${ct[@]}" --bone cranium ${bones[@]+"${bones[@]}"}
"$here/features.sh" --large --with-meshlib --write-docs "${ct[@]}" ${bones[@]+"${bones[@]}"} ${skull[@]+"${skull[@]}"}
"$here/smoothing.sh" --with-meshlib --write-docs
