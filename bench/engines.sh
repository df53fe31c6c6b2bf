#!/bin/sh
# usage: bench/engines.sh PROGRAM SCRATCH [MODEL.glb…] PANORAMA.hdr…
#
# Shows balls of metal and of plastic, and models, in web engines: once in an environment that the engine filters by
# itself, and once in what `bake --for` wrote. Compares both with the path tracer's pictures. Writes SCRATCH/engines.md, a
# table of errors, and SCRATCH/engines.html, a page of the pictures. Needs Node, npm with its registry, and Chromium, as
# the test Browser.EnginesShowTheLightThatWasBaked does, whose packages are taken. SCRATCH keeps them, and gets the files.
set -eu
program=$(realpath -- "$1")
mkdir -p -- "$2"
scratch=$(realpath -- "$2")
root=$(realpath -- "$(dirname -- "$0")/..")
shift 2
chromium=$(command -v chromium) || {
  echo "engines.sh: needs Chromium (apt-get install chromium)" >&2
  exit 1
}

sh "$root/tests/npm_packages.sh" "$root/tests/browser" "$scratch"
cp "$root"/tests/browser/*.mjs "$root/tests/browser/engines.html" "$root"/bench/engines/* \
  "$root/examples/three/lobe_rows.mjs" "$scratch/"
sed -n '/<script type="importmap">/,/<\/script>/p' "$root/tests/browser/engines.html" >"$scratch/imports"
for page in balls models; do
  sed "/<!-- imports -->/r $scratch/imports" "$root/bench/engines/$page.html" >"$scratch/$page.html"
done
node "$scratch/compare_engines.mjs" "$program" "$chromium" "$scratch" "$root/docs" "$@"
