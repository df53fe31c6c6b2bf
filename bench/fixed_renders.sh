#!/bin/sh
# usage: bench/fixed_renders.sh RUNS DATA ROWS PROGRAM…
#
# Times the fixed renders of docs/performance.md, whole processes at 1280x720, by each PROGRAM in turn, RUNS times, so that
# a busy moment hits all alike. Prints the median of each in seconds, that of the processors (user + system), and what is
# to be reached on two cores without a GPU. To be measured before the first change of some work and after its last.
#
#   DATA    a folder with FlightHelmet/FlightHelmet.gltf and lightroom_14b.hdr; - leaves out the rows that need it
#   ROWS    with commas between, or `all`:
#             draft       FlightHelmet with --quality draft, all caches warm
#             good        the same with --quality good
#             sample      one more whole sample of it: 5 of `good`, less 1, divided by 4
#             cold_draft  `draft` with nothing cached, neither the driver's programs nor the prefiltered light
#             cold_good   the same of `good`
#             sphere      a sphere in the studio
#             showcase    `render` alone
#             reference   the showcase by --reference --samples 16
#
# Beside others: bench/beside_f3d.sh and, for the reference, bench/reference.sh. Needs GNU time (Debian's package `time`).
set -eu
# shellcheck source=bench/rounds.sh
. "$(dirname -- "$0")/rounds.sh"
[ $# -ge 4 ] || {
  sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2
  exit 2
}
runs=$1
data=$([ "$2" = - ] || realpath -- "$2")
rows=$(echo "$3" | tr , ' ')
shift 3
[ "$rows" != all ] || rows="draft good sample cold_draft cold_good sphere showcase reference"
[ -n "$data" ] || rows=$(for row in $rows; do case $row in sphere | showcase | reference) echo "$row" ;; esac done)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
number=0
for program; do
  number=$((number + 1))
  ln -s "$(realpath -- "$program")" "$folder/program_$number"
done
cd "$folder"

for row in $rows; do
  case $row in
    draft | good | sample | cold_draft | cold_good | sphere | showcase | reference) ;;
    *) echo "fixed_renders.sh: there is no row '$row'" >&2 && exit 2 ;;
  esac
done

argumentsOf() {
  helmet="$data/FlightHelmet/FlightHelmet.gltf -e $data/lightroom_14b.hdr"
  case $1 in
    draft | cold_draft) echo "$helmet --quality draft" ;;
    good | cold_good) echo "$helmet" ;;
    sample_one) echo "$helmet --sampling all --samples 1" ;;
    sample_more) echo "$helmet --sampling all --samples 5" ;;
    sphere) echo "sphere -e studio" ;;
    showcase) ;;
    reference) echo "--reference --samples 16" ;;
  esac
}

runTask() {
  row=${1%@*}
  # shellcheck disable=SC2046 # a command line of words without spaces
  set -- command time -q -f '%U %S' -o spent "./program_${1#*@}" render $(argumentsOf "$row") -o "$1.png"
  case $row in
    cold_*) MESA_SHADER_CACHE_DISABLE=true MIRRORBALL_CACHE='' "$@" ;;
    *) "$@" ;;
  esac
}

tasks=
for row in $rows; do
  steps=$row
  [ "$row" != sample ] || steps="sample_one sample_more"
  for step in $steps; do
    for program in $(seq "$number"); do tasks="$tasks $step@$program"; done
  done
done
# shellcheck disable=SC2086 # tasks are words
timeInRounds "$runs" $tasks

toReach() {
  case $1 in
    draft) echo 1.2 ;; good) echo 2 ;; sample) echo 0.15 ;; cold_*) echo 4 ;;
    sphere) echo 0.6 ;; showcase) echo 3.5 ;; reference) echo 9 ;;
  esac
}
wallOf() { awk '{ print $1 / 1e4 }' "$1.times" | median; }
processorsOf() { awk '{ print $2 + $3 }' "$1.times" | median; }
for row in $rows; do
  for program in $(seq "$number"); do
    if [ "$row" = sample ]; then
      one=sample_one@$program more=sample_more@$program
      echo "$(wallOf "$one") $(wallOf "$more") $(processorsOf "$one") $(processorsOf "$more")" |
        awk '{ print ($2 - $1) / 4, ($4 - $3) / 4 }'
    else
      echo "$(wallOf "$row@$program") $(processorsOf "$row@$program")"
    fi | awk -v row="$row" -v program="$program" -v wanted="$(toReach "$row")" '{
      printf "%-10s program %d  %7.2f s   processors %7.2f s   to reach %s s\n", row, program, $1, $2, wanted }'
  done
done
