#!/bin/sh
# usage: browser_test.sh MIRRORBALL SOURCE_DIR SCRATCH_DIR CHECK ARGUMENT …
#
# Runs CHECK.mjs, which has a web engine show maps that the program wrote for it, in Chromium. Exit code 77 (skipped)
# where Node, npm, npm's registry, Chromium or an OpenGL driver is absent.

set -eu
mirrorball=$1
source_dir=$2
scratch=$3
check=$4
shift 4

chromium=$(command -v chromium) || {
  echo "skipped: chromium is not installed"
  exit 77
}
sh "$source_dir/../npm_packages.sh" "$source_dir" "$scratch"

# Our own pictures of the same views need a driver.
if ! "$mirrorball" render none -e white --size 8x8 -o "$scratch/probe.png" 2>"$scratch/probe.log"; then
  cat "$scratch/probe.log"
  grep -q GL "$scratch/probe.log" || exit 1
  echo "skipped: no OpenGL driver"
  exit 77
fi

cp "$source_dir"/*.mjs "$source_dir"/*.html "$scratch/"
node "$scratch/$check.mjs" "$mirrorball" "$chromium" "$scratch" "$@"
