#!/bin/sh
# usage: npm_packages.sh SOURCE_DIR SCRATCH_DIR
#
# Installs the packages of SOURCE_DIR/package.json into SCRATCH_DIR/node_modules; what was installed for the same
# versions is kept. Exit code 77 (skipped) where Node, npm or npm's registry is absent.

set -eu
source_dir=$1
scratch=$2

for program in node npm; do
  if ! command -v "$program" >/dev/null; then
    echo "skipped: $program is not installed"
    exit 77
  fi
done

mkdir -p "$scratch"
cmp -s "$source_dir/package.json" "$scratch/installed.json" && exit 0
cp "$source_dir/package.json" "$scratch/package.json"
if ! (cd "$scratch" && npm install --no-audit --no-fund --no-package-lock --ignore-scripts >npm.log 2>&1); then
  echo "skipped: npm could not install the packages; $scratch/npm.log tells why"
  exit 77
fi
cp "$source_dir/package.json" "$scratch/installed.json"
