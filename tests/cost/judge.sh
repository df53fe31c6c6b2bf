#!/bin/sh
# usage: judge.sh NAME SECONDS UNIT_BEFORE UNIT_AFTER
#
# Compares what a build or a tier of tests took, in seconds of the processor, with its row of costs.txt, in the unit
# measured before and after it (unit.sh). Exit code 0: as before, or no more than 30 % more, with a warning from 15 % on;
# also where the two units differ by more than 10 %, since on such a machine nothing can be judged. 1: more than 30 %
# more.
#
#   MIRRORBALL_UPDATE_COSTS=1   writes the figure into costs.txt instead

set -u
name=$1
costs=$(dirname -- "$0")/costs.txt
if [ -z "$3" ] || [ -z "$4" ]; then
  echo "cost of $name: $2 s of the processor; not judged, since the unit could not be measured"
  exit 0
fi
cost=$(awk -v seconds="$2" -v before="$3" -v after="$4" 'BEGIN { printf "%.1f", 2 * seconds / (before + after) }')
recorded=$(awk -F '\t' -v name="$name" '$1 == name { print $2; exit }' "$costs")
said="cost of $name: $cost units ($2 s of the processor; costs.txt says ${recorded:-nothing})"
if [ -n "${MIRRORBALL_UPDATE_COSTS-}" ]; then
  updated=$(awk -F '\t' -v name="$name" '$1 != name' "$costs")
  printf '%s\n%s\t%s\n' "$updated" "$name" "$cost" >"$costs"
  echo "$said: written"
  exit 0
fi
verdict=$(awk -v cost="$cost" -v recorded="${recorded:-0}" -v before="$3" -v after="$4" 'BEGIN {
    ratio = before > after ? before / after : after / before
    print ratio > 1.1 ? "unsteady" : cost > 1.3 * recorded ? "failed" : cost > 1.15 * recorded ? "warned" : "passed"
  }')
case $verdict in
  passed) echo "$said" ;;
  unsteady) echo "$said: not judged, since the machine's unit changed from $3 to $4 s meanwhile" ;;
  warned) echo "warning: $said: more than 15 % more" ;;
  failed)
    echo "$said: more than 30 % more: mend it, or write the figure and its reason into $costs" >&2
    exit 1
    ;;
esac
