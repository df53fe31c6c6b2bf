#!/bin/sh
# usage: seconds.sh FILE…
#
# Prints the sum of the seconds of the processor, user and system, in files that tests/measured.sh has written: of each,
# the second line of the shell's `times`, "1m2.5s 0m0.2s", which counts all processes that it has waited for.

export LC_ALL=C
exec awk 'FNR == 2 {
    for (i = 1; i <= 2; i++) { split($i, part, /[ms]/); sum += 60 * part[1] + part[2] }
  }
  END { printf "%.2f\n", sum }' "$@"
