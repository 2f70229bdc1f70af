#!/usr/bin/env bash
# Installs what is missing of the Debian packages in packages.txt.
# Usage: install_packages.sh [--check] [SECTION...]     --check: installs nothing, and ends with 1 if something is missing
#        (core, build, run, test, checks, site, pictures, benchmark, wasm, arm64, wheel, windows; without one: all but the last four)
set -euo pipefail
list="$(dirname "$0")/packages.txt"
is_check=false
if [ "${1:-}" = --check ]; then
  is_check=true
  shift
fi

wanted=$(awk -v sections=" $* " '
  /^\[/ { name = substr($1, 2, length($1) - 2) }
  /^[a-z]/ && ((sections == "  " && name !~ /^(wasm|arm64|wheel|windows)$/) || index(sections, " " name " ")) { print $1 }' "$list")

if ! command -v apt-get > /dev/null; then
  echo "This system has no apt-get. Please install what corresponds to these Debian packages:"
  echo "$wanted" | paste -sd ' '
  exit 0
fi

missing=()
for package in $wanted; do
  # Node.js that is not Debian's has npm in it and conflicts with the package.
  [ "$package" = npm ] && command -v npm > /dev/null && continue
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null || true)
  [ "$state" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0
! $is_check || exit 1

echo "Installing: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo > /dev/null; then
    echo "That needs root and there is no sudo. As root: apt-get install ${missing[*]}"
    exit 0
  fi
  as_root=(sudo)
fi
"${as_root[@]}" apt-get -q update
# Other releases lack some of them; where one is necessary, CMake says so.
known=()
for package in "${missing[@]}"; do
  # Its record may be there without a version that can be installed.
  if [[ $(LC_ALL=C apt-cache policy "$package") == *"Candidate: "[0-9]* ]]; then
    known+=("$package")
  else
    echo "Not in this release of Debian: $package"
  fi
done
[ ${#known[@]} -gt 0 ] || exit 0
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get -q -y --no-install-recommends install "${known[@]}"
