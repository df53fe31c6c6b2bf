#!/bin/sh
# usage: bench/convert.sh PROGRAM RUNS [PANORAMA [TASK…]]
#
# Times whole processes that turn a 4096 x 2048 .hdr (made from PANORAMA, else from the built-in studio, which compresses
# better than any photograph) into a cube of 6 x 1024² half floats in .ktx2, beside a plain copy of
# the same bytes, which is the floor, and beside what other programs that are installed need for as near a task as they
# have. One run of each after the other, RUNS times, so that a busy moment hits all alike. Prints the fastest, the median
# and the slowest in milliseconds, and for ours and the copy the bytes read and written a second at the median. TASKs,
# such as "copy ours", leave out the others.
set -eu
# shellcheck source=bench/rounds.sh
. "$(dirname -- "$0")/rounds.sh"
program=$1
runs=$2
panorama=$(realpath -- "${3-studio}" 2>/dev/null || echo studio)
[ -e "$panorama" ] || panorama=studio
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

"$program" convert "$panorama" --to equirect --size 2048 -o in.hdr
"$program" convert in.hdr --to equirect -o in.exr --format half
"$program" convert in.hdr --to equirect -o in.png
"$program" convert in.hdr --to cube --size 1024 -o cube.ktx2
bytes=$(($(wc -c <in.hdr) + $(wc -c <cube.ktx2)))

# What is timed: each prints nothing and overwrites what it wrote before.
copy() { cat in.hdr >copy.hdr && cat cube.ktx2 >copy.ktx2; }
ours() { "$program" convert in.hdr --to cube --size 1024 -o out.ktx2; }
ours_bilinear() { "$program" convert in.hdr --to cube --size 1024 --filter bilinear -o out.ktx2; }
oiiotool_decode() { oiiotool in.hdr --stats >/dev/null; }
exrenvmap_cube() { exrenvmap -c -w 1024 in.exr out.exr; }
ffmpeg_v360() { ffmpeg -loglevel error -y -i in.png -vf v360=e:c3x2:w=3072:h=2048 -pix_fmt rgb48be -c:v rawvideo -f rawvideo out.raw; }
cmgen_cube() { cmgen --quiet --format=ktx --size=1024 --no-mirror --ibl-no-prefilter --extract=cmgen_out in.hdr; }
cmft_cube() { cmft --input in.hdr --filter none --dstFaceSize 1024 --outputNum 1 --output0 cmft_out --output0params ktx,rgba16f,cubemap; }
texturec_cube() { texturec -f in.hdr -o out_texturec.ktx -t RGBA16F --max 1024 --equirect; }
envutil_cube() { envutil --input in.exr --output out_envutil.exr --projection cubemap --width 1024; }

tasks="copy ours ours_bilinear"
has oiiotool && tasks="$tasks oiiotool_decode"
has exrenvmap && tasks="$tasks exrenvmap_cube"
has ffmpeg && tasks="$tasks ffmpeg_v360"
has cmgen && tasks="$tasks cmgen_cube"
has cmft && tasks="$tasks cmft_cube"
has texturec && tasks="$tasks texturec_cube"
has envutil && tasks="$tasks envutil_cube"
[ $# -le 3 ] || { shift 3 && tasks=$*; }

runTask() { "$1"; }
# shellcheck disable=SC2086 # tasks are words
timeInRounds "$runs" $tasks

for task in $tasks; do
  sort -n "$task.times" | awk -v name="$task" -v bytes="$bytes" '{ t[NR] = $1 / 10 } END {
    median = t[int((NR + 1) / 2)]
    printf "%-16s fastest %7.1f  median %7.1f  slowest %7.1f ms", name, t[1], median, t[NR]
    if (name == "copy" || name ~ /^ours/) printf "   %.2f GB/s", bytes / median / 1e6
    printf "\n" }'
done
