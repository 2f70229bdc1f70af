#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Tables of single features: least angles, edge lengths, voxels, tunnels, levels, slabs, non-manifold edges, sharp edges; remeshers, volume meshers,
# label maps and strokes of a brush, in which other programs take part.
#
#   Testing/Benchmark/features.sh [TABLE ...] [--bone FILE ...] [--skull FILE] [--large] [--with-meshlib] [--write-docs]
#
# Builds as run.sh does, and installs the other programs into FOLDER/benchmark/venv. Files stay in FOLDER/benchmark/features. --help explains the options.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=common.sh
. "$here/common.sh"

prepare "$@"
[ "$python" = python3 ] || install_peers "$here/requirements-meshers.txt"
npm install --silent --prefix "$build/benchmark/node" gltfpack@1.3.0 || echo "gltfpack of npm could not be installed"
cmake --build "$build" >> "$build/benchmark-build.log" 2>&1
own=$(sed -n 's/^_Python3_EXECUTABLE:INTERNAL=//p' "$build/CMakeCache.txt") # that the filters are built for
export NODE_PACKAGES=$build/benchmark/node PYTHONPATH=$here PYTHONDONTWRITEBYTECODE=1
exec "$python" -m bonebench.features --programs "$build/bin" --python "$own" --work "$build/benchmark" ${arguments[@]+"${arguments[@]}"}
