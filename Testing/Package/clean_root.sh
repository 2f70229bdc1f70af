#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The Debian package on a Debian that has nothing else: installed with what it depends on, run, imported, built against.
#
#   Testing/Package/clean_root.sh [BUILD]     with the package of BUILD, by default build/release, in BUILD/clean-root
#
# As root, with debootstrap and the sources of this system's apt; takes 3 GB and some minutes; not part of the tests.
set -euo pipefail
# In its own mount namespace: what is mounted in the root is gone with this script.
[ -n "${CLEAN_ROOT_MOUNTS:-}" ] || CLEAN_ROOT_MOUNTS=own exec unshare --mount "${BASH_SOURCE[0]}" "$@"
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(cd "${1:-$project/build/release}" && pwd)
root=$build/clean-root
there=/srv/trial # in the root
work=$root$there

say() { printf '\n== %s\n' "$*"; }
inside() {
  chroot "$root" /usr/bin/env -i HOME=/srv LC_ALL=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"
}
add() {
  if ! inside DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install "$@" > "$root/apt.log"; then
    tail -n 30 "$root/apt.log"
    return 1
  fi
}
# Usage: printed PAGE LANGUAGE [SECTION]: the first block in that language on the page of Documentation, from the section on.
printed() {
  awk -v opening="^\`\`\`$2\$" -v section="## ${3:-}" '
    !below { below = index($0, section) == 1 || section == "## " }
    below && $0 ~ opening { on = 1; next } on && /^```$/ { exit } on' "$project/Documentation/$1.md"
}

say "A clean root"
sources=$(apt-get indextargets --format 'deb $(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian')
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
mirror=$(awk -v suite="$suite" '$3 == suite { print $2; exit }' <<< "$sources")
rm -rf "$root"
debootstrap --variant=minbase "$suite" "$root" "$mirror" > /dev/null
mount -t proc proc "$root/proc"
sort -u <<< "$sources" > "$root/etc/apt/sources.list"
settings=$root/etc/apt/apt.conf.d/90outside
(echo 'Dpkg::Use-Pty "0";'; apt-config dump | sed -nE '/^Acquire::(https?|Check-)/p') > "$settings"
inside apt-get -q update > /dev/null
echo "Debian $(cat "$root/etc/debian_version"), $(inside dpkg-query -f '.\n' -W | wc -l) packages"

say "The package with what it depends on"
mkdir -p "$work"
cpack --config "$build/CPackConfig.cmake" -B "$work/cpack" > /dev/null 2>&1
mv "$work"/cpack/*.deb "$work/package.deb"
add $there/package.deb
inside dpkg-query -f '${Package} ${Version} ${Architecture}, ${Installed-Size} kB\n' -W vtkbonedecimate
echo "$(inside dpkg-query -f '.\n' -W | wc -l) packages in all"

say "The program"
# A wavy patch of 3200 triangles.
awk 'function corner(i, j) { printf "vertex %g %g %.9g\n", i, j, 2 * sin(i / 7) * cos(j / 5) }
  function triangle(a, b, c, d, e, f) {
    print "facet normal 0 0 0\nouter loop"; corner(a, b); corner(c, d); corner(e, f); print "endloop\nendfacet" }
  BEGIN { print "solid patch"
    for (i = 0; i < 40; ++i) for (j = 0; j < 40; ++j) {
      triangle(i, j, i + 1, j, i + 1, j + 1); triangle(i, j, i + 1, j + 1, i, j + 1) }
    print "endsolid patch" }' > "$work/patch.stl"
inside bonedecimate --version
inside bonedecimate $there/patch.stl $there/small.stl --max-error 0.1

say "The Python package"
add python3-vtk9
printed how-to/python python VTK > "$work/example.py"
inside python3 $there/example.py

say "A project of its own against the headers"
add cmake g++ ninja-build libvtk9-dev
printed tutorials/cpp cpp > "$work/bones.cxx"
printed tutorials/cpp cmake > "$work/CMakeLists.txt"
"$build/bin/bonedecimate-phantom" "$work/labels.mha" --size small --labels
inside cmake -G Ninja -S $there -B $there/build > /dev/null
inside cmake --build $there/build | tail -n 1
inside $there/build/bones $there/labels.mha $there/bones.vtp
inside bonedecimate diagnose $there/bones.vtp

say "Removed again"
inside apt-get -q -y remove vtkbonedecimate > "$root/apt.log"
if inside find /usr -iname '*bonedecimate*' | grep .; then
  echo "That is left behind."
  exit 1
fi
echo "Nothing is left behind."
