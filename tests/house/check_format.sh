#!/bin/sh
# usage: check_format.sh CLANG_FORMAT SOURCE_DIR
#
# Fails, and names the lines, where clang-format would change a C++ file. Exit code 77 (skipped) without clang-format.

set -eu
if ! command -v "$1" >/dev/null; then
  echo "skipped: clang-format is not installed"
  exit 77
fi
cd -- "$2"
find . \( -path './.*' -o -path ./build \) -prune -o \( -name '*.h' -o -name '*.inc' -o -name '*.cpp' \) \
  -exec "$1" --dry-run --Werror {} +
