#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The audit of tolerances: each program gets a largest distance in mm, and its result is measured.
#
#   Testing/Benchmark/audit.sh [--bone FILE ...] [--with-meshlib] [--write-docs]
#
# Builds and installs as run.sh does, with requirements-audit.txt and the package meshoptimizer of npm if there is Node.js; OpenMesh
# is Debian's libopenmesh-apps. What is missing is left out, with a line that says so. Results stay in FOLDER/benchmark/audit.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=common.sh
. "$here/common.sh"

prepare "$@"
[ "$python" = python3 ] || install_peers "$here/requirements-audit.txt"
export NODE_PACKAGES=$build/benchmark/node PYTHONPATH=$here PYTHONDONTWRITEBYTECODE=1
npm install --silent --prefix "$NODE_PACKAGES" meshoptimizer@1.3.0 || echo "meshoptimizer of npm could not be installed"
cmake --build "$build" --target bonedecimate > "$build/benchmark-build.log" 2>&1 || { tail -n 40 "$build/benchmark-build.log"; exit 1; }
exec "$python" -m bonebench.audit --programs "$build/bin" --work "$build/benchmark" ${arguments[@]+"${arguments[@]}"}
