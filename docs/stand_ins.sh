#!/bin/sh
# usage: docs/stand_ins.sh FOLDER
#
# Makes stand-ins for the real inputs that README.md names, under the same names, from what is built into the program:
# the commands of these pages then run with `export DATA=FOLDER`, and show other pictures. A file that is there already
# is left alone.
#
#   MIRRORBALL_PROGRAM=…  runs another program than ./mirrorball
set -eu
if [ $# -ne 1 ] || [ "$1" = --help ]; then
  sed -n 's/^# \{0,1\}//; 2,8p' "$0" >&2
  exit 2
fi
mkdir -p -- "$1/FlightHelmet"
folder=$(cd -- "$1" && pwd -P)
cd -P -- "$(dirname -- "$0")/.."
program=${MIRRORBALL_PROGRAM:-./mirrorball}

# standIn NAME COMMAND…: runs the command with "-o FILE" of the same extension, and moves what it wrote to that name.
standIn() {
  target=$folder/$1
  shift
  if [ -e "$target" ]; then
    echo "$target is there"
    return
  fi
  # Models are written as .glb, and read as what they are, whatever their name.
  extension=${target##*.}
  [ "$extension" = gltf ] && extension=glb
  part=$target.stand_in.$extension
  "$program" "$@" --quiet -o "$part"
  mv -- "$part" "$target"
  echo "$target"
}

standIn chinese_garden_1k.hdr convert sky:elevation=30,azimuth=143 --to equirect --size 512
standIn lightroom_14b.hdr convert studio --to equirect --size 1024
standIn courtyard.exr convert sunset --to equirect --size 512
standIn studio.exr convert studio --to equirect --size 512
standIn FlightHelmet/FlightHelmet.gltf export teapot --set base_color=0.4,0.22,0.12 --set perceptual_roughness=0.5
standIn lucy.glb export knot
standIn Duck.glb export sphere --material plastic
