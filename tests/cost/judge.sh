#!/bin/sh
# usage: compare.sh NAME FILE
#
# Compares what measure.sh wrote into FILE with what costs.txt says of the build NAME. Fails when it became dearer by more
# than 30 %, until costs.txt has the new figure and its reason.
#
#   MIRRORBALL_UPDATE_COSTS=1   writes the figure into costs.txt instead

set -u
name=$1
cost=$(cat "$2") || exit
costs=$(dirname -- "$0")/costs.txt
recorded=$(awk -v name="$name" '$1 == name { print $2; exit }' "$costs")
echo "The build $name took $cost times the processor time of compiling GoogleTest; costs.txt says ${recorded:-nothing}."
if [ -n "${MIRRORBALL_UPDATE_COSTS-}" ]; then
  updated=$(awk -v name="$name" '$1 != name' "$costs")
  printf '%s\n%s\t%s\n' "$updated" "$name" "$cost" >"$costs"
elif ! awk -v cost="$cost" -v recorded="$recorded" 'BEGIN { exit !(cost > 0 && cost <= 1.3 * recorded) }'; then
  echo "More than 30 % dearer: mend it, or write the figure and its reason into $costs." >&2
  exit 1
fi
