#!/bin/sh
# usage: unit.sh
#
# Prints the unit that costs are compared in: seconds of the processor, user and system, that compiling GoogleTest
# (gtest-all.cc) by g++ -O2 takes, the mean of one compilation on each core at the same time. Prints nothing where the
# source is absent.

set -u
export LC_ALL=C
source=/usr/src/googletest/googletest
[ -e "$source/src/gtest-all.cc" ] || exit 0
for _ in $(seq "$(nproc)"); do
  g++ -O2 -I"$source/include" -I"$source" -c "$source/src/gtest-all.cc" -o /dev/null &
done
wait
times_file=$(mktemp)
times >"$times_file"
sh "$(dirname -- "$0")/seconds.sh" "$times_file" | awk -v cores="$(nproc)" '{ printf "%.2f\n", $1 / cores }'
rm -f "$times_file"
