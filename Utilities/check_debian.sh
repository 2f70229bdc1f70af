#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Clones the commit into a root of another release of Debian and runs all tests there; then the package is built and installed.
# Needs root, debootstrap and about 6 GB.
#   Utilities/check_debian.sh RELEASE [FOLDER]     for example: trixie; FOLDER keeps the root, otherwise it is removed at the end
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

release=${1:?a release of Debian, for example trixie}
root=${2:-$(mktemp -d)}
project=$root/project

unmount()
{
  local folder
  for folder in sys dev proc; do
    mountpoint -q "$root/$folder" && umount --lazy "$root/$folder"
  done
  [ -n "${2:-}" ] || rm -rf --one-file-system "$root"
}

trap 'unmount "$@"' EXIT
# debootstrap removes its own folder when it is done.
[ -e "$root/etc/debian_version" ] && [ ! -e "$root/debootstrap" ] ||
  debootstrap --variant=minbase --include=ca-certificates,git "$release" "$root" http://deb.debian.org/debian \
    /usr/share/debootstrap/scripts/sid # knows releases that are newer than debootstrap, too
for folder in proc dev sys; do
  mount --bind "/$folder" "$root/$folder"
done
rm -rf "$project"
git clone --quiet . "$project"
chroot "$root" env -C /project LC_ALL=C.UTF-8 bash -c '
  set -euo pipefail
  ./test.sh
  apt-get -q -y --no-install-recommends install dpkg-dev file # for cpack
  cpack --config build/release/CPackConfig.cmake -B build/package
  apt-get -q -y --no-install-recommends install ./build/package/*.deb
  /usr/bin/bonedecimate --version'
