#!/bin/sh
# usage: exr_tools_test.sh MIRRORBALL SCRATCH_DIR
#
# OpenEXR's own tools read what --for openexr writes, and we read what they write: exrheader tells the envmap attribute,
# exrenvmap turns our cube into a panorama and our panorama into a cube, and light still comes from where it came. Exit
# code 77 (skipped) where the tools are absent.

set -eu
mirrorball=$1
scratch=$2

for program in exrheader exrenvmap; do
  if ! command -v "$program" >/dev/null; then
    echo "skipped: $program is not installed (Debian: openexr)"
    exit 77
  fi
done
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"

# No two of these directions see the same light, and none looks into the sun.
directions="1,0.2,0.1 -1,0.3,0.2 0.1,1,0.2 0.2,0.1,1 -0.3,0.2,-1 0.7,0.4,-0.6 -0.5,0.6,0.4"

# The radiance that a map has from a direction.
radiance() { "$mirrorball" info "$1" --direction "$2" | awk '$1 == "radiance" { print $2, $3, $4 }'; }

# Fails unless a map's light agrees with the sky's within 3 %: what two resamplings at this size leave.
check() {
  for direction in $directions; do
    echo "$(radiance sky "$direction") $(radiance "$1" "$direction")" | awk -v map="$1" -v direction="$direction" '
      function differs(a, b) { return a - b > 0.03 * a || b - a > 0.03 * a }
      NF != 6 || differs($1, $4) || differs($2, $5) || differs($3, $6) {
        print map " from " direction ": the sky has " $1 " " $2 " " $3 ", the map " $4 " " $5 " " $6; exit 1 }'
  done
}

"$mirrorball" convert sky --to cube --size 128 --for openexr -o cube.exr
"$mirrorball" convert sky --to equirect --size 256 --for openexr -o panorama.exr
exrheader cube.exr | grep -q 'envmap.*cube'
exrheader panorama.exr | grep -q 'envmap.*latitude-longitude'
exrenvmap -l cube.exr panorama_of_theirs.exr
exrenvmap -c panorama.exr cube_of_theirs.exr
for map in cube.exr panorama.exr panorama_of_theirs.exr cube_of_theirs.exr; do check "$map"; done

# A check that cannot fail would be none: a map that is turned must be seen.
"$mirrorball" convert sky --to equirect --size 256 --rotate 20 -o turned.exr
if check turned.exr >/dev/null; then
  echo "FAILED: a turned map was not noticed"
  exit 1
fi
