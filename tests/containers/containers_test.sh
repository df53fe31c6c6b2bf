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
cp "$source_dir/check_containers.mjs" "$scratch/"

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
cp "$scratch/files/half_cube.ktx2" "$scratch/kept"
size=$(wc -c <"$scratch/kept")
printf '\377' | dd of="$scratch/files/half_cube.ktx2" bs=1 seek=$((size - 10)) conv=notrunc 2>/dev/null
fails "a wrong texel"
cp "$scratch/kept" "$scratch/files/half_cube.ktx2"
printf '\007' | dd of="$scratch/files/half_cube.ktx2" bs=1 seek=20 conv=notrunc 2>/dev/null
fails "a wrong width"
cp "$scratch/kept" "$scratch/files/half_cube.ktx2"
# OpenGL's own number, which Filament does not know.
printf '\073' | dd of="$scratch/files/b10g11r11_cube.ktx" bs=1 seek=16 conv=notrunc 2>/dev/null
fails "a glType that Filament does not take"
