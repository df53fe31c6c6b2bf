#!/bin/sh
# usage: bench/beside_f3d.sh PROGRAM RUNS MODEL PANORAMA
#
# Times the whole processes of `PROGRAM render MODEL -e PANORAMA` and of F3D with the same model, panorama and size, one
# after the other, RUNS times, and prints the median of each in milliseconds and their ratio. All caches are warm. F3D
# needs a display: where there is none, xvfb-run makes one, whose start (some 0.2 s) counts as its time. It reads no
# Draco: `PROGRAM export MODEL -o plain.glb` writes a model without.
# For example: bench/beside_f3d.sh build/release/apps/cli/mirrorball 5 Duck.glb lightroom_14b.hdr
set -eu
. "$(dirname "$0")/rounds.sh"
program=$(realpath "$1")
runs=$2
model=$(realpath "$3")
panorama=$(realpath "$4")
has f3d || { echo "f3d is not installed" >&2; exit 1; }
display=
[ -n "${DISPLAY:-}" ] || display="xvfb-run -a"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

runTask() {
  case $1 in
    ours) "$program" render "$model" -e "$panorama" --size 1280x720 -o ours.png ;;
    # Each word of $display is one.
    f3d) $display f3d "$model" --hdri="$panorama" --resolution=1280,720 --output=f3d.png ;;
  esac
}

milliseconds() { awk '{ print $1 / 10 }' "$1.times" | median; }

timeInRounds "$runs" ours f3d
[ -s ours.png ] || { echo "ours wrote no picture: $(head -n 1 ours.log)" >&2; exit 1; }
[ -s f3d.png ] || { echo "F3D wrote no picture: $(head -n 1 f3d.log)" >&2; exit 1; }
ours=$(milliseconds ours)
f3d=$(milliseconds f3d)
echo "ours $ours ms, F3D $f3d ms, F3D's time / ours $(awk -v a="$f3d" -v b="$ours" 'BEGIN { printf "%.1f", a / b }')"
