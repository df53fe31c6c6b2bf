#!/bin/sh
# usage: bench/reference.sh PROGRAM RUNS [SAMPLES]
#
# Times the path tracer against Blender's Cycles on the CPU: the built-in showcase (mirror, glass, rough metal), written
# to a .glb with its camera, in one environment file. Neither denoises or stops early; bounces are each one's default.
# Needs Debian's packages blender and python3-numpy, which nothing else here needs; without them it says so, and times
# ours alone.
#
# 1. Paths a second at 1280x720 with SAMPLES (8) paths a pixel, RUNS runs of each in turns, so that a busy moment hits both
#    alike: medians of the whole process, of the render alone (as each program says), and of the most memory. A path is one
#    camera sample to its end, the background counted. The processors' time for a path, which waiting for other programs
#    does not lengthen, is that of SAMPLES paths without that of one.
# 2. Effort for equal error at 320x180, in the studio and under a sun (sky): each program's pictures against its own
#    converged one, by the RMSE of the displayed picture.
set -eu
# shellcheck source=bench/rounds.sh
. "$(dirname -- "$0")/rounds.sh"
program=$(realpath -- "$1")
runs=$2
samples=${3-8}
cycles_script=$(realpath -- "$(dirname -- "$0")/reference_cycles.py")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

tasks=ours
if has blender && blender --background --python-exit-code 1 --python-expr 'import numpy' >/dev/null 2>&1; then
  tasks="ours cycles"
else
  echo "Cycles is not there (apt-get install blender python3-numpy): ours alone is timed, against nothing" >&2
fi
has /usr/bin/time || {
  echo "reference.sh: needs /usr/bin/time (apt-get install time)" >&2
  exit 1
}

# usage: ours SIZE SAMPLES ENVIRONMENT OUT
# Prints the seconds of the render alone, those of the processors for the whole process, and the most memory in MB.
ours() {
  /usr/bin/time -f '%U %S %M' -o usage "$program" render showcase.glb -e "$3" --reference --size "$1" --samples "$2" \
    --timings -o "$4" 2>log >&2
  awk '/picture: trace/ { print $4 / 1000 }' log | withUsage
}

cycles() {
  /usr/bin/time -f '%U %S %M' -o usage blender --background --factory-startup --python-exit-code 1 --debug-cycles \
    --python "$cycles_script" -- showcase.glb "$3" "$4" --size "$1" --samples "$2" >log 2>&1
  sed -n 's/.*Render time (without synchronization): //p' log | withUsage
}

withUsage() {
  read -r render
  read -r user system kilobytes <usage
  echo "$render $user $system $kilobytes" | awk '{ print $1, $2 + $3, $4 / 1024 }'
}

# Without dispersion, which Cycles has not: it makes glass noisier.
"$program" export showcase --set dispersion=0 --size 1280x720 -o showcase.glb --quiet
for light in studio sky; do "$program" convert "$light" --to equirect --size 1024 --for blender -o "$light.exr"; done

runTask() {
  case $1 in
    *_start) "${1%_start}" 1280x720 1 studio.exr "$1.exr" >spent ;;
    *) "$1" 1280x720 "$samples" studio.exr "$1.exr" >spent ;;
  esac
}
all_tasks=
for task in $tasks; do all_tasks="$all_tasks $task ${task}_start"; done
# shellcheck disable=SC2086 # tasks are words
timeInRounds "$runs" $all_tasks

# The middle of a column of a task's runs.
median() { awk -v column="$2" '{ print $column }' "$1.times" | sort -n | awk '{ t[NR] = $1 } END { print t[int((NR + 1) / 2)] }'; }
echo "1280x720, $samples paths a pixel, $runs runs in turns, medians; million paths a second of the whole, of the render,"
echo "and of the processors' time:"
for task in $tasks; do
  echo "$task $(median "$task" 1) $(median "$task" 2) $(median "$task" 3) $(median "${task}_start" 3) $(median "$task" 4)" |
    awk -v pixels="$((1280 * 720))" -v samples="$samples" '{
      paths = pixels * samples / 1e6
      printf "%-7s whole %6.2f s (%.2f)  render %6.2f s (%.2f)  processors %6.2f s (%.2f for each)  memory %4.0f MB\n",
        $1, $2 / 1e4, paths / ($2 / 1e4), $3, paths / $3, $4, pixels * (samples - 1) / 1e6 / ($4 - $5), $6 }'
done

# usage: equalError LIGHT
# Prints for each task its error and time with 4 … 64 paths a pixel, and how many paths and how much of the processors'
# time have the error that the second task has with 32.
equalError() {
  echo "error of the displayed picture against one of 512 paths a pixel, in $1:"
  for task in $tasks; do
    "$task" 320x180 512 "$1.exr" "$task-converged.exr" >/dev/null
    : >"$task.errors"
  done
  for count in 4 8 16 32 64; do
    for task in $tasks; do
      spent=$("$task" 320x180 "$count" "$1.exr" picture.exr)
      psnr=$("$program" compare picture.exr "$task-converged.exr" --json | sed -n 's/.*"psnr": *\([0-9.]*\).*/\1/p')
      echo "$count $(awk -v psnr="$psnr" 'BEGIN { print 10 ^ (-psnr / 20) }') $spent" >>"$task.errors"
      tail -n 1 "$task.errors" | awk -v name="$task" '{
        printf "  %-7s %4d paths  error %.5f  render %6.2f s  processors of the whole %6.2f s\n", name, $1, $2, $3, $4 }'
    done
  done
  [ "$tasks" != ours ] || return 0
  wanted=$(awk '$1 == 32 { print $2 }' cycles.errors)
  for task in $tasks; do
    # The error is a power of the number of paths between two counts; the time grows by as much with each path.
    awk -v wanted="$wanted" -v name="$task" '{ n[NR] = $1; e[NR] = log($2)
      sx += $1; sy += $4; sxx += $1 * $1; sxy += $1 * $4 } END {
      i = 2
      while (i < NR && e[i] > log(wanted)) ++i
      paths = exp(log(n[i - 1]) + (log(wanted) - e[i - 1]) * log(n[i] / n[i - 1]) / (e[i] - e[i - 1]))
      seconds = (NR * sxy - sx * sy) / (NR * sxx - sx * sx)
      printf "  %-7s has an error of %.5f with %.1f paths a pixel: %.2f s of the processors\n", name, wanted, paths, paths * seconds }' \
      "$task.errors"
  done
}
equalError studio
equalError sky
