#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Measures everything in evidence.md and writes its tables, the pages of the results and the tables of the README.
#   reproduce.sh [--bone FILE ...]     FILE: another surface, besides those of the CT
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

results=$PWD/build/release/benchmark
Testing/Benchmark/run.sh --with-meshlib --output "$results/whole"
figures=("$results/whole/benchmark.json")
if [ $# -gt 0 ]; then
  Testing/Benchmark/run.sh --with-meshlib --output "$results/more" "$@"
  figures+=("$results/more/benchmark.json")
fi
Testing/Benchmark/run.sh --from "${figures[@]}" --write-docs
Testing/Benchmark/audit.sh --with-meshlib --certificates --write-docs --bone maxilla --bone frontal "$@"
