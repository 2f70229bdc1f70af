#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Tables of single features: least angles, edge lengths, voxels, tunnels, levels, slabs, non-manifold edges.
#
#   Testing/Benchmark/features.sh [TABLE ...] [--bone FILE ...] [--skull FILE] [--write-docs]
#
# Builds as run.sh does. Files stay in FOLDER/benchmark/features. --help explains the options.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=common.sh
. "$here/common.sh"

read_arguments "$@"
build_programs
cmake --build "$build" --target bonedecimate bonedecimate-phantom >> "$build/benchmark-build.log" 2>&1
export PYTHONPATH=$here PYTHONDONTWRITEBYTECODE=1
exec python3 -m bonebench.features --programs "$build/bin" --work "$build/benchmark" ${arguments[@]+"${arguments[@]}"}
