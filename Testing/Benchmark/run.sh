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
# shellcheck source=common.sh
. "$here/common.sh"

prepare "$@"
export PYTHONPATH=$here PYTHONDONTWRITEBYTECODE=1
exec "$python" -m bonebench --programs "$build/bin" --work "$build/benchmark" ${arguments[@]+"${arguments[@]}"}
