#!/bin/sh
# usage: bench/bake.sh PROGRAM RUNS [PANORAMA [TASK…]]
#
# Times whole processes that prefilter PANORAMA (else the built-in sky) to a chain of 256², with what else each program
# makes for an engine on the way, in our program and in others that are installed. One run of each after the other, RUNS
# times, so that a busy moment hits all alike. Prints the median time, that of the processor (user + system, all cores
# together: what depends less on what else runs), both as multiples of ours, and the most memory. TASKs, such as "ours
# cmgen", leave out the others. Needs GNU time (Debian's package `time`).
set -eu
# shellcheck source=bench/rounds.sh
. "$(dirname -- "$0")/rounds.sh"
program=$(realpath -- "$1")
runs=$2
panorama=$(realpath -- "${3-sky}" 2>/dev/null || echo sky)
[ -e "$panorama" ] || panorama=sky
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# Others do not read every compression of OpenEXR; what a map was compressed with is not what is timed.
"$program" convert "$panorama" --to equirect -o in.exr
"$program" convert "$panorama" --to equirect -o in.hdr

# The command line of each task; what it does is written beside it in docs/performance/prefiltering.md.
commandOf() {
  case $1 in
    ours) echo "$program bake in.exr -o ours" ;;
    ours_chain) echo "$program bake in.exr -o ours.ktx2" ;;
    cmgen) echo "cmgen --quiet --format=exr --size=256 --no-mirror -x cmgen in.exr" ;;
    cmgen_4096) echo "cmgen --quiet --format=exr --size=256 --no-mirror --ibl-samples=4096 -x cmgen in.exr" ;;
    cmgen_irradiance) echo "cmgen --quiet --format=exr --size=64 --no-mirror --ibl-irradiance=cmgen in.exr" ;;
    cmgen_brdf) echo "cmgen --quiet --size=128 --ibl-dfg-multiscatter --ibl-dfg=cmgen_brdf.exr" ;;
    cmft) echo "cmft --silent --input in.hdr --filter radiance --srcFaceSize 256 --dstFaceSize 256 --mipCount 7 --useOpenCL false --numCpuProcessingThreads $(nproc) --outputNum 1 --output0 cmft --output0params ktx,rgba16f,cubemap" ;;
    cmft_irradiance) echo "cmft --silent --input in.hdr --filter irradiance --dstFaceSize 64 --outputNum 1 --output0 cmft --output0params ktx,rgba16f,cubemap" ;;
    texturec) echo "texturec -f in.hdr -o texturec.ktx -t RGBA16F --max 256 --equirect --radiance GGX" ;;
  esac
}

tasks="ours ours_chain"
has cmgen && tasks="$tasks cmgen cmgen_4096 cmgen_irradiance cmgen_brdf"
has cmft && tasks="$tasks cmft cmft_irradiance"
has texturec && tasks="$tasks texturec"
[ $# -le 3 ] || { shift 3 && tasks=$*; }

# shellcheck disable=SC2046 # a command line of words without spaces
runTask() { command time -q -f '%U %S %M' -o spent $(commandOf "$1"); }
# shellcheck disable=SC2086 # tasks are words
timeInRounds "$runs" $tasks

for task in $tasks; do
  wall=$(awk '{ print $1 / 10 }' "$task.times" | median)
  processor=$(awk '{ print ($2 + $3) * 1000 }' "$task.times" | median)
  memory=$(awk '{ print $4 / 1024 }' "$task.times" | median)
  [ -n "${wall_of_first-}" ] || { wall_of_first=$wall && processor_of_first=$processor; }
  echo "$task $wall $processor $memory $wall_of_first $processor_of_first" | awk '{
    printf "%-17s median %9.1f ms (%7.2f x)   processor %9.0f ms (%7.2f x)   memory %6.0f MB\n",
      $1, $2, $2 / $5, $3, $3 / $6, $4 }'
done
