#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Clones the commit into a root of another release of Debian, builds everything there, the plugin for ParaView too, and runs all tests.
# Then the Debian package is built and installed, and the examples of the README and of other pages run with what it installed.
# The last line is a row for the table of systems in Documentation/results/systems.md.
# Needs root, debootstrap and about 10 GB.
#   Utilities/check_debian.sh RELEASE [FOLDER]     for example: trixie
# FOLDER keeps the root with its packages and its build, and the next run continues from there; otherwise the root is removed at the end.
set -euo pipefail
# In its own mount namespace: what is mounted in the root is gone with this script.
[ -n "${CHECK_DEBIAN_MOUNTS:-}" ] || CHECK_DEBIAN_MOUNTS=own exec unshare --mount "${BASH_SOURCE[0]}" "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

release=${1:?a release of Debian, for example trixie}
root=${2:-$(mktemp -d)}
project=$root/project

remove()
{
  for folder in sys dev proc; do
    umount --recursive --lazy "$root/$folder" || true
  done
  rm -rf --one-file-system "$root"
}

[ -n "${2:-}" ] || trap remove EXIT
# debootstrap removes its own folder when it is done.
[ -e "$root/etc/debian_version" ] && [ ! -e "$root/debootstrap" ] ||
  debootstrap --variant=minbase --include=ca-certificates,git "$release" "$root" http://deb.debian.org/debian \
    /usr/share/debootstrap/scripts/sid # knows releases that are newer than debootstrap, too
for folder in proc dev sys; do
  mount --rbind "/$folder" "$root/$folder" # with the shared memory in /dev/shm
done
if [ -e "$project/.git" ]; then
  git -C "$project" fetch --quiet "$PWD" HEAD
  git -C "$project" checkout --quiet --force FETCH_HEAD
else
  git clone --quiet . "$project"
fi
# shellcheck disable=SC2016
chroot "$root" env -C /project LC_ALL=C.UTF-8 bash -c '
  set -euo pipefail
  mkdir -p build
  Utilities/install_paraview.sh
  apt-get -q -y --no-install-recommends install dpkg-dev file # for the test of the package and for cpack
  ./test.sh 2>&1 | tee build/tests.log

  rm -rf build/package
  cpack --config build/release/CPackConfig.cmake -B build/package
  apt-get -q -y --no-install-recommends --reinstall install ./build/package/*.deb
  SOURCE_DIR=$PWD PROGRAM=/usr/bin/bonedecimate PHANTOM=$PWD/build/release/bin/bonedecimate-phantom \
    python3 -B Testing/Readme/test_readme.py
  PROGRAMS=$PWD/build/release/bin python3 -B Testing/Readme/run_tutorial.py Documentation/tutorials/cpp.md

  version() { dpkg-query -W -f "\${Version}" "$1" | sed -E "s/^[0-9]+://; s/[-+].*//"; }
  paraview=$(LD_LIBRARY_PATH=$(echo "$PWD"/build/paraview/usr/lib/*-linux-gnu) build/paraview/usr/bin/pvpython --version)
  echo "| Debian $(cat /etc/debian_version) | $(gcc -dumpfullversion) | $(version cmake) | $(version libvtk9-dev) |" \
    "${paraview##* } | $(version libinsighttoolkit5-dev) | $(version libcgal-dev) | $(version libeigen3-dev) | $(python3 -V | cut -d" " -f2) |" \
    "$(sed -nE "s/^.* tests passed, ([0-9]+) tests failed out of ([0-9]+)/\2, \1 failed/p" build/tests.log) |"'
