#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# For arm64, cross-compiled and run in qemu-user: the core with the table of checksums and tests, or the portable wheel with its tests.
#   Utilities/check_arm64.sh [--checksums]     --checksums: the table alone
#   Utilities/check_arm64.sh --wheel [TEST,...]     needs build/release and root, for the Debian for arm64 that it makes in build/arm64-root
# TEST: of Testing/Wheel, without _test.py; by default those that do not take hours in qemu-user.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# What depends on the processor, the compiler or the standard library.
suites='Kernel*:*KernelReference*:ExactPredicates*:Text*:Option*:BoundingTree*:LabelSurface*:LabelTypes*:PointRounding*:LogBytes*:CertificateFoot*:ColumnCrossings*'

check_core()
{
  cmake --preset arm64
  cmake --build --preset arm64 --target "$@"
  local run=(qemu-aarch64 -L /usr/aarch64-linux-gnu)
  echo "Checksums"
  diff <("${run[@]}" build/arm64/bin/bonedecimate-checksums --short) Testing/Checksums/short.txt
  if [ $# -gt 1 ]; then
    echo "Core"
    "${run[@]}" build/arm64/bin/BoneDecimateCoreTests --gtest_brief=1 --gtest_filter="$suites"
  fi
}

check_wheel()
{
  local folder=$PWD/build/arm64-wheel
  Utilities/arm64/make_root.sh
  rm -rf "$folder"
  PYTHON=/usr/bin/python3 Utilities/build_wheel.sh --arm64 "$folder"
  # What the C++ filter of this system makes. PyVista draws.
  PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3 -B Testing/Wheel/write_reference.py "$folder/reference.json"
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" Utilities/arm64/python -B Testing/Wheel/matrix.py --reference "$folder/reference.json" \
    --wheels "$folder" --build "$folder" --vtk 9.7 --tests "$1" /usr/bin/python3
}

Utilities/install_packages.sh arm64
case "${1:-}" in
  --wheel) check_wheel "${2:-keywords,labelmaps,sameness,voxels}" ;;
  --checksums) check_core bonedecimate-checksums ;;
  *) check_core bonedecimate-checksums BoneDecimateCoreTests ;;
esac
