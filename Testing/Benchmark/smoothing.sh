#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The benchmark of smoothing and label maps: our filters and other programs on the same segmentations.
#
#   Testing/Benchmark/smoothing.sh                       everything (half an hour)
#   Testing/Benchmark/smoothing.sh --compare vault cube  some label maps
#   Testing/Benchmark/smoothing.sh --growth --threads    time and memory, and bytes for several numbers of threads
#   Testing/Benchmark/smoothing.sh --help
#
# Builds the filters with their Python package (preset release, or --build FOLDER), installs the peers of requirements.txt into
# FOLDER/benchmark/venv and leaves figures, page and pictures in FOLDER/benchmark/smoothing. A peer that cannot be installed is left
# out. MeshLib only takes part with --with-meshlib: its license is for non-commercial use.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=common.sh
. "$here/common.sh"

prepare "$@"
own=$(sed -n 's/^_Python3_EXECUTABLE:INTERNAL=//p' "$build/CMakeCache.txt") # that the package is built for
"$python" -c 'import vtkmodules' 2> /dev/null || python=$own
export PYTHONPATH=$here PYTHONDONTWRITEBYTECODE=1
exec "$python" -m smoothingbench --programs "$build/bin" --python "$build/lib/python3/dist-packages:$own" \
  --work "$build/benchmark/smoothing" ${arguments[@]+"${arguments[@]}"}
