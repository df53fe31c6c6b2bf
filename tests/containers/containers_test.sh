#!/bin/sh
# usage: containers_test.sh WRITE_CONTAINERS SOURCE_DIR SCRATCH_DIR
#
# Writes texture files, and has the readers of package.json check them. Exit code 77 (skipped) where Node, npm or npm's
# registry is absent.

set -eu
write_containers=$1
source_dir=$2
scratch=$3

sh "$source_dir/../npm_packages.sh" "$source_dir" "$scratch"
# Node looks for packages beside the script.
cp "$source_dir/check_containers.mjs" "$source_dir/transcoder.mjs" "$scratch/"

rm -rf "$scratch/files"
mkdir "$scratch/files"
"$write_containers" "$scratch/files"
node "$scratch/check_containers.mjs" "$scratch/files"

# A check that cannot fail would be none: one wrong texel, and one wrong header, must be seen.
fails() {
  if node "$scratch/check_containers.mjs" "$scratch/files" >/dev/null 2>&1; then
    echo "FAILED: the readers did not notice $1"
    exit 1
  fi
}
# usage: spoil FILE AT BYTE WHAT: one byte of a file is another, so many bytes from its beginning or, if AT is negative,
# from its end.
spoil() {
  cp "$scratch/files/$1" "$scratch/kept"
  at=$2
  if [ "$at" -lt 0 ]; then at=$(($(wc -c <"$scratch/kept") + at)); fi
  printf "$3" | dd of="$scratch/files/$1" bs=1 seek="$at" conv=notrunc 2>/dev/null
  fails "$4"
  cp "$scratch/kept" "$scratch/files/$1"
}
spoil half_cube.ktx2 -10 '\377' "a wrong texel"
spoil half_cube.ktx2 20 '\007' "a wrong width"
# OpenGL's own number, which Filament does not know.
spoil b10g11r11_cube.ktx 16 '\073' "a glType that Filament does not take"
# Of the first of 64 × 24 blocks: two planes of weights; of the last: another colour.
spoil uastc_hdr_kinds.ktx2 $((1 - 64 * 24 * 16)) '\004' "a block that cannot become BC6H"
spoil uastc_hdr_kinds.ktx2 -4 '\001' "a wrong colour in a block"
