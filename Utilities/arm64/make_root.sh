#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# A Debian for arm64 in build/arm64-root, with Python; what is there already is not made again.
# Needs root, and the binary formats of qemu-user-static in the kernel.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
project=$(dirname "$(dirname "$here")")
root=$project/build/arm64-root

if [ ! -e /proc/sys/fs/binfmt_misc/qemu-aarch64 ]; then
  [ -e /proc/sys/fs/binfmt_misc/register ] || mount -t binfmt_misc none /proc/sys/fs/binfmt_misc
  update-binfmts --enable qemu-aarch64
fi
if [ ! -e "$root/etc/debian_version" ] || [ -e "$root/debootstrap" ]; then
  rm -rf "$root"
  . /etc/os-release
  debootstrap --arch=arm64 --variant=minbase --include=ca-certificates "$VERSION_CODENAME" "$root" http://deb.debian.org/debian
  echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/unsafe-io" # much faster, and the folder can be made again
fi
packages="python3-dev python3-venv libgl1-mesa-dri"
if [ "$(cat "$root/packages" 2> /dev/null)" != "$packages" ]; then
  "$here/run" apt-get -q update
  # shellcheck disable=SC2086
  "$here/run" env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install $packages
  echo "$packages" > "$root/packages"
fi
