#!/bin/sh
# usage: bench/uastc_hdr.sh PROGRAM SCRATCH SIDE PANORAMA…
#
# Encodes cubes of 6 x SIDE² of PANORAMAs by `--format uastc_hdr`, and by the encoder of Basis Universal as npm's
# ktx2-encoder brings it, at its default effort. Basis Universal's transcoder decodes both to half floats and to BC6H.
# Prints the errors as docs/conventions/files.md defines them, in percent, and how long Basis Universal took; exit code
# 1 where our relative RMSE is more than 1.3 times the other. SCRATCH keeps npm's packages, and gets the files.
set -eu
program=$(realpath -- "$1")
mkdir -p -- "$2"
scratch=$(realpath -- "$2")
here=$(realpath -- "$(dirname -- "$0")")
side=$3
shift 3

sh "$here/../tests/npm_packages.sh" "$here/uastc_hdr" "$scratch"
cp "$here/uastc_hdr/beside_basis.mjs" "$here/../tests/containers/transcoder.mjs" "$scratch/"
node "$scratch/beside_basis.mjs" "$program" "$scratch" "$side" "$@"
