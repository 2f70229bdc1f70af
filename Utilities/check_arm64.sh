#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The core for arm64, compiled with Debian's cross compiler and run in qemu-user: the table of checksums, and tests of the core.
#   Utilities/check_arm64.sh [--checksums]     --checksums: the table alone
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# What depends on the processor, the compiler or the standard library.
suites='Kernel*:*KernelReference*:ExactPredicates*:Text*:Option*:BoundingTree*:LabelSurface*:LabelTypes*:PointRounding*:LogBytes*:CertificateFoot*:ColumnCrossings*'

Utilities/install_packages.sh arm64
cmake --preset arm64
targets=(bonedecimate-checksums)
[ "${1:-}" = --checksums ] || targets+=(BoneDecimateCoreTests)
cmake --build --preset arm64 --target "${targets[@]}"
run=(qemu-aarch64 -L /usr/aarch64-linux-gnu)
echo "Checksums"
diff <("${run[@]}" build/arm64/bin/bonedecimate-checksums --short) Testing/Checksums/short.txt
if [ "${1:-}" != --checksums ]; then
  echo "Core"
  "${run[@]}" build/arm64/bin/BoneDecimateCoreTests --gtest_brief=1 --gtest_filter="$suites"
fi
