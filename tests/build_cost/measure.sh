#!/bin/sh
# usage: measure.sh FILE COMMAND…
#
# Runs COMMAND, a fresh build without a compiler cache whose packages are there, and writes into FILE what it cost: its
# processor time as a multiple of a yardstick's, so that a slower machine changes little. The yardstick is compiling
# GoogleTest with -O2: its mean before and after, on all cores at once as the build is. Exit code of COMMAND.

set -u
file=$1
shift
times_file=$(mktemp)
trap 'rm -f "$times_file"' EXIT

# Sets `seconds`, user and system, of all processes that this shell has waited for: not in a subshell, which has waited
# for none. `times` writes "0m1.5s 0m0.2s" a line, of the shell itself first.
readSeconds() {
  times >"$times_file"
  seconds=$(awk 'NR == 2 {
      for (i = 1; i <= 2; i++) { split($i, part, /[ms]/); sum += 60 * part[1] + part[2] }
      print sum
    }' "$times_file")
}

# Compiles GoogleTest, on each core.
runYardstick() {
  for _ in $(seq "$(nproc)"); do
    c++ -O2 -I/usr/src/googletest/googletest/include -I/usr/src/googletest/googletest \
      -c /usr/src/googletest/googletest/src/gtest-all.cc -o /dev/null &
  done
  wait
}

readSeconds
begin=$seconds
runYardstick
readSeconds
build_begin=$seconds
"$@" || exit
readSeconds
build_end=$seconds
runYardstick
readSeconds

echo "$begin $build_begin $build_end $seconds $((2 * $(nproc)))" |
  awk '{ printf "%.1f\n", ($3 - $2) / (($2 - $1 + $4 - $3) / $5) }' >"$file"
