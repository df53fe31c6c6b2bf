#!/bin/sh
# usage: judge.sh NAME SECONDS UNIT_BEFORE UNIT_AFTER
#
# Compares what a build or a tier of tests took, in seconds of the processor, with its row of costs.txt, in the unit
# measured before and after it (unit.sh). Exit code 0: as before, or no more than 30 % more, with a warning from 15 % on.
# 1: more than 30 % more. Nothing is judged, with exit code 0, where costs.txt has no row of such a machine, and where the
# two units differ by more than 10 %.
#
#   MIRRORBALL_UPDATE_COSTS=1   writes the figure into costs.txt instead

set -u
export LC_ALL=C
name=$1
costs=$(dirname -- "$0")/costs.txt
tab=$(printf '\t')
# The unit does not cancel every difference between processors: a driver that uses wider vectors draws faster.
machine=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)
if grep -qw avx512f /proc/cpuinfo; then machine="$machine, AVX-512"; fi
if [ -z "$3" ] || [ -z "$4" ]; then
  echo "cost of $name: $2 s of the processor; not judged, since the unit could not be measured"
  exit 0
fi
cost=$(awk -v seconds="$2" -v before="$3" -v after="$4" 'BEGIN { printf "%.1f", 2 * seconds / (before + after) }')
said="cost of $name: $cost units ($2 s of the processor) on $machine"
if [ -n "${MIRRORBALL_UPDATE_COSTS-}" ]; then
  updated=$(awk -F "$tab" -v name="$name" -v machine="$machine" '!($1 == name && $3 == machine)' "$costs")
  printf '%s\n%s\t%s\t%s\n' "$updated" "$name" "$cost" "$machine" >"$costs"
  echo "$said: written"
  exit 0
fi
recorded=$(awk -F "$tab" -v name="$name" -v machine="$machine" '$1 == name && $3 == machine { print $2; exit }' "$costs")
if [ -z "$recorded" ]; then
  echo "$said: not judged, since costs.txt has no row of such a machine"
  exit 0
fi
verdict=$(awk -v cost="$cost" -v recorded="$recorded" -v before="$3" -v after="$4" 'BEGIN {
    ratio = before > after ? before / after : after / before
    print (ratio > 1.1 ? "unsteady" : cost > 1.3 * recorded ? "failed" : cost > 1.15 * recorded ? "warned" : "passed")
  }')
case $verdict in
  passed) echo "$said; costs.txt says $recorded" ;;
  unsteady) echo "$said: not judged, since the machine's unit changed from $3 to $4 s meanwhile" ;;
  warned) echo "warning: $said: more than 15 % above the $recorded of costs.txt" ;;
  failed)
    echo "$said: more than 30 % above the $recorded of costs.txt: mend it, or write the figure and its reason there" >&2
    exit 1
    ;;
esac
