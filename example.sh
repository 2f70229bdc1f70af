#!/usr/bin/env bash
# The main job from nothing: a CT, its bone surface, a fifth of the triangles, and what that cost in mm.
# Usage: ./example.sh [FOLDER FOR THE RESULTS]     (bone-output if none is given)
set -euo pipefail
root=$(cd "$(dirname "$0")" && pwd)
output=${1:-$root/bone-output}
program=$root/build/release/bin/bonedecimate

# The CT lies in InVesalius' own format: a tar with the voxels, their number and their spacing. InVesalius keeps the
# rows of a slice from back to front and turns y round in its surfaces, as the one in the same tar shows; so do we.
unpack_cranium()
{
  local project=$1 folder=$2
  tar -xzf "$project" -C "$folder" --strip-components=1 --wildcards '*/matrix.dat' '*/main.plist'
  local numbers='s/.*<(integer|real)>(.*)<.*/\2/p'
  local size spacing
  size=$(sed -n '/<key>shape</,/<\/array>/p' "$folder/main.plist" | sed -nE "$numbers" | tac | xargs)
  spacing=$(sed -n '/<key>spacing</,/<\/array>/p' "$folder/main.plist" | sed -nE "$numbers" | xargs)
  cat > "$folder/cranium.mhd" << HEADER
ObjectType = Image
NDims = 3
DimSize = $size
TransformMatrix = 1 0 0 0 -1 0 0 0 1
ElementSpacing = $spacing
ElementType = MET_SHORT
ElementByteOrderMSB = False
ElementDataFile = matrix.dat
HEADER
}

# The file of the package; systems that install no documentation have to download it.
find_cranium()
{
  local inside=usr/share/doc/invesalius-examples/examples/Cranium.inv3 folder=$1
  if [ ! -e "/$inside" ] && command -v apt-get > /dev/null; then
    (cd "$folder" && apt-get -q download invesalius-examples && dpkg-deb -x invesalius-examples_*.deb .) \
      > /dev/null 2>&1 || true
  fi
  for candidate in "/$inside" "$folder/$inside"; do
    if [ -e "$candidate" ]; then
      echo "$candidate"
      break
    fi
  done
}

"$root/Utilities/build_program.sh"
mkdir -p "$output/ct"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

project=$(find_cranium "$scratch")
if [ -n "$project" ]; then
  name=cranium ct=$output/ct/cranium.mhd triangles=134000
  unpack_cranium "$project" "$output/ct"
else
  echo "The CT of Debian's package invesalius-examples is not here: making a phantom of a fractured bone."
  name=phantom ct=$output/ct/phantom.mha triangles=60000
  "$root/build/release/bin/bonedecimate-phantom" "$ct"
fi

echo "From the CT to the surface: a quarter of a minute"
"$program" "$ct" "$output/$name.vtp" --iso 226 --target-triangles "$triangles" \
  --also "$output/$name.stl" --heatmap "$output/heatmap.vtp" --report "$output/report.json" \
  --page "$output/report.html" --picture "$output/picture.png"
echo "Look at $output/picture.png and $output/report.html"
