#!/bin/sh
# usage: bench/frame_time.sh PROGRAM RUNS [SIZE [ENVIRONMENT [TECHNIQUE…]]]
#
# Times a frame of each technique: one sample a pixel of a SIZE (1280x720) picture in ENVIRONMENT (the built-in studio),
# without what comes before the first frame (start, reading, compiling shaders). For that each technique is rendered with
# 1 sample and with 1 + SAMPLES, RUNS times, one after the other, so that a busy moment hits all alike; a frame's time is
# the difference of the two medians divided by SAMPLES. Prints it, the processors' time (user + system, which waiting for
# other programs does not lengthen), and both as multiples of the first technique's. Needs GNU time (Debian's package
# `time`).
#
# SAMPLES is 16, and an eighth of it for what is traced. A GPU, whose frames take less than two starts differ by, needs
# more: SAMPLES=1000 bench/frame_time.sh …
set -eu
# shellcheck source=bench/rounds.sh
. "$(dirname -- "$0")/rounds.sh"
program=$(realpath -- "$1")
runs=$2
samples_measured=${SAMPLES-16}
size=${3-1280x720}
environment=$(realpath -- "${4-studio}" 2>/dev/null || echo studio)
[ -e "$environment" ] || environment=${4-studio}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# What is rendered for a technique; all cover about a third of the picture.
argumentsOf() {
  clear="--material glass --set dispersion=0"
  case $1 in
    mirror) echo "sphere --material mirror" ;;
    proxy_box) echo "sphere --material mirror --proxy box:-3,-2,-3,3,2,3" ;;
    proxy_sphere) echo "sphere --material mirror --proxy sphere:0,0,0,3" ;;
    proxy_ground) echo "sphere --material mirror --proxy ground:2" ;;
    ground_mirror) echo "sphere --material mirror --proxy ground:2 --ground-roughness 0" ;;
    ground_rough_mirror) echo "sphere --material mirror --proxy ground:2 --ground-roughness 0.3" ;;
    proxy_mesh) echo "sphere --material mirror --proxy cube" ;;
    probe) echo "sphere --material mirror --probes 1 --probe-size 256" ;;
    rough_metal) echo "sphere --material rough-metal" ;;
    lobe_taps_*) echo "sphere --material rough-metal --lobe-taps ${1#lobe_taps_}" ;;
    flat_look_up) echo "sphere --material mirror --lookup flat" ;;
    thin_wall) echo "sphere $clear --set thin_walled=yes" ;;
    single) echo "sphere $clear" ;;
    single_dispersion) echo "sphere --material glass" ;;
    single_spectral) echo "sphere --material glass --dispersion spectral" ;;
    image_space) echo "sphere $clear --refraction image-space" ;;
    image_space_screen) echo "sphere $clear --refraction image-space --behind screen" ;;
    image_space_dispersion) echo "sphere --material glass --refraction image-space" ;;
    traced_flat_sides) echo "brilliant $clear --refraction traced" ;;
    traced_curved) echo "sphere $clear --refraction traced" ;;
    traced_dispersion) echo "brilliant --material diamond --refraction traced" ;;
    traced_spectral) echo "brilliant --material diamond --refraction traced --dispersion spectral" ;;
    # Relief, on a plane that fills most of the picture.
    relief_*) kind=${1#relief_} && echo "plane --camera 30,45,1.5 --set height=cobbles --relief ${kind%_binary}$(
      [ "$kind" = "${kind%_binary}" ] || echo -binary)" ;;
    *) echo "frame_time.sh: there is no technique '$1'" >&2 && exit 1 ;;
  esac
}

shift "$(($# < 4 ? $# : 4))"
techniques=${*:-mirror proxy_box proxy_sphere proxy_ground ground_mirror ground_rough_mirror proxy_mesh \
  probe rough_metal lobe_taps_1 lobe_taps_2 lobe_taps_6 flat_look_up thin_wall single single_dispersion single_spectral image_space \
  image_space_screen image_space_dispersion traced_flat_sides traced_curved traced_dispersion traced_spectral relief_none relief_bump \
  relief_parallax relief_steep relief_occlusion relief_linear_binary relief_cone relief_exact relief_geometry}

# A software driver needs seconds for what is traced.
samplesOf() { case $1 in traced*) echo $(((samples_measured + 7) / 8)) ;; *) echo "$samples_measured" ;; esac; }

tasks=
for technique in $techniques; do tasks="$tasks $technique.one $technique.more"; done

runTask() {
  technique=${1%.*}
  samples=1
  [ "${1##*.}" = one ] || samples=$((1 + $(samplesOf "$technique")))
  # shellcheck disable=SC2046 # a command line of words without spaces
  command time -q -f '%U %S' -o spent "$program" render $(argumentsOf "$technique") --quality draft -e "$environment" --size "$size" \
    --samples "$samples" --resolve radiance -o frame.exr
}
# shellcheck disable=SC2086 # tasks are words
timeInRounds "$runs" $tasks

median() { sort -n | awk '{ t[NR] = $1 } END { print t[int((NR + 1) / 2)] }'; }
wallOf() { awk '{ print $1 / 10 }' "$1.times" | median; }
processorsOf() { awk '{ print ($2 + $3) * 1000 }' "$1.times" | median; }

for technique in $techniques; do
  echo "$technique $(wallOf "$technique.one") $(wallOf "$technique.more") $(processorsOf "$technique.one") \
    $(processorsOf "$technique.more") $(samplesOf "$technique")"
done | awk '{
  wall = ($3 - $2) / $6; processors = ($5 - $4) / $6
  if (NR == 1) { first_wall = wall; first_processors = processors }
  printf "%-18s frame %9.1f ms (%7.2f x)   processors %9.0f ms (%7.2f x)\n", $1, wall, wall / first_wall, processors,
    processors / first_processors }'
