#!/bin/sh
# usage: containers_test.sh WRITE_CONTAINERS SOURCE_DIR SCRATCH_DIR
#
# Writes texture files, and has the readers of package.json check them. Exit code 77 (skipped) where Node, npm or npm's
# registry is absent.

set -eu
write_containers=$1
source_dir=$2
scratch=$3

for program in node npm; do
  if ! command -v "$program" >/dev/null; then
    echo "skipped: $program is not installed"
    exit 77
  fi
done

# What was installed for the same versions is kept.
mkdir -p "$scratch"
if ! cmp -s "$source_dir/package.json" "$scratch/installed.json"; then
  cp "$source_dir/package.json" "$scratch/package.json"
  if ! (cd "$scratch" && npm install --no-audit --no-fund --no-package-lock --ignore-scripts >npm.log 2>&1); then
    echo "skipped: npm could not install the readers; $scratch/npm.log tells why"
    exit 77
  fi
  cp "$source_dir/package.json" "$scratch/installed.json"
fi
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
