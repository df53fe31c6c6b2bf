#!/bin/sh
# usage: bench/cold_render.sh PROGRAM RUNS ARGUMENTS OF RENDER…
#
# Times the whole process of one render, RUNS times, first with all caches as they are, then without Mesa's cache of
# compiled shaders, then without the program's own either, and prints the fastest, the median and the slowest in
# milliseconds, and then the stages of one run with nothing cached.
# For example: bench/cold_render.sh build/release/apps/cli/mirrorball 11 sphere -e lightroom_14b.hdr
set -eu
program=$1
runs=$2
shift 2
picture=$(mktemp --suffix=.png)
trap 'rm -f "$picture"' EXIT

milliseconds() { echo $(($(date +%s%N) / 1000000)); }

once() {
  begin=$(milliseconds)
  "$program" render "$@" -o "$picture"
  echo $(($(milliseconds) - begin))
}

measure() {
  name=$1
  shift
  once "$@" >/dev/null # brings the files into the system's cache
  run=0
  while [ "$run" -lt "$runs" ]; do
    once "$@"
    run=$((run + 1))
  done | sort -n | awk -v name="$name" '{ t[NR] = $1 } END {
    printf "%-28s fastest %d ms, median %d ms, slowest %d ms of %d\n", name, t[1], t[int((NR + 1) / 2)], t[NR], NR }'
}

measure "with the shader cache:" "$@"
MESA_SHADER_CACHE_DISABLE=true
export MESA_SHADER_CACHE_DISABLE
measure "without the shader cache:" "$@"
MIRRORBALL_CACHE=
export MIRRORBALL_CACHE
measure "with nothing cached:" "$@"
echo "stages of one run, with nothing cached:"
"$program" render "$@" --timings -o "$picture"
