#!/bin/sh
# usage: seconds.sh FILE…
#
# Prints a line "SECONDS FILE" for each file that tests/measured.sh has written: the CPU time, user and system, of the
# second line of the shell's `times`, "1m2.5s 0m0.2s", which counts all processes that it has waited for.

export LC_ALL=C
exec awk 'FNR == 2 {
    sum = 0
    for (i = 1; i <= 2; i++) { split($i, part, /[ms]/); sum += 60 * part[1] + part[2] }
    printf "%.2f %s\n", sum, FILENAME
  }' "$@"
