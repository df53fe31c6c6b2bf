#!/bin/bash
# usage: bench/build.sh ROWS COMMIT…
#
# Times what one waits for who works on Mirrorball, and prints it as a table for docs/performance/build.md. Each row is measured
# with each commit in turn, in a fresh clone of its own under $TMPDIR, without a compiler cache, with all packages there.
#
#   ROWS    with commas between, or `all`:
#             picture  a fresh clone to mirrorball.png
#             formula  a formula changed, of each topic in turn, to a picture
#             room     a .cpp of each room changed, until that room's tests have run
#             quick    ./test --quick in a fresh clone
#             test     ./test in a fresh clone, which takes the longest
#             expensive  instead of a row: the ten files and the ten headers of the last commit that take most of the
#                        compiler's time, after its fresh build
#   COMMIT  as git knows it, for example HEAD~1 HEAD
#
# Each cell is seconds by the clock / seconds of the processor, user and system, on all cores.
set -eu
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
source_dir=$PWD
usage() {
  sed -n '2,/^set/s/^# \{0,1\}//p' "bench/${BASH_SOURCE[0]##*/}" >&2
  exit 2
}
[ $# -ge 2 ] || usage
rows=$1
shift
for name in ${rows//,/ }; do
  case $name in
    all | picture | formula | room | quick | test | expensive) ;;
    *) usage ;;
  esac
done
commits=("$@")
exit_code=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export CCACHE_DISABLE=1 MIRRORBALL_CACHE=
# Real inputs, where there are some, so that as many tests run as can.
if [ -d "$source_dir/../shared/data" ]; then
  export MIRRORBALL_DATA=${MIRRORBALL_DATA:-$(cd "$source_dir/../shared/data" && pwd)}
fi

wanted() { [[ $rows = all || ,$rows, == *,$1,* ]]; }

clone() { # of commit $1, without a build
  rm -rf "${scratch:?}/$1"
  git clone -q "$source_dir" "$scratch/$1"
  git -C "$scratch/$1" checkout -q "$(git rev-parse "$1")"
}

timed() { # runs a command in the clone of commit $1 and sets `cell`
  local commit=$1 TIMEFORMAT='%R %U %S' spent
  shift
  # Only the times go to the variable; what fails is told with the end of what it said.
  if spent=$( { time (cd "$scratch/$commit" && "$@" >"$scratch/log" 2>&1); } 2>&1); then
    cell=$(awk '{ printf "%.1f / %.1f", $1, $2 + $3 }' <<<"$spent")
  else
    cell=failed
    exit_code=1
    { echo "$commit: $* failed:" && tail -n 5 "$scratch/log"; } >&2
  fi
}

row() { # prints a row: $1 its name, then a function that is called with each commit and sets `cell`
  local name=$1 line="| $1 |"
  shift
  for commit in "${commits[@]}"; do
    "$@" "$commit"
    line+=" $cell |"
  done
  echo "$line"
}

picture() { clone "$1" && timed "$1" ./mirrorball render; }

formulaChanged() { # $1 a formula, $2 the commit
  echo "// changed" >>"$scratch/$2/formula/$1"
  timed "$2" ./mirrorball render sphere --size 320x240
}

# Launches that test alone which the commit has a way for.
roomChanged() { # $1 a room, $2 one of its files, $3 the commit
  echo "// changed" >>"$scratch/$3/src/mirrorball/$1/$2"
  if grep -q -e --room "$scratch/$3/test"; then
    timed "$3" ./test --room "$1"
  else
    timed "$3" sh -c "cmake --build build/dev --target $1_test && build/dev/src/mirrorball/$1/$1_test"
  fi
}

quick() { clone "$1" && timed "$1" ./test --quick; }
whole() { clone "$1" && timed "$1" ./test; }

# Prints what takes most of the compiler's time in a build of the release: Ninja's log has the time of each command, and a
# header costs the time of a file that includes it alone, less that of an empty one, once for each file that reads it.
expensive() {
  local build="$scratch/$1/build/release" command empty
  [ -e "$build/.ninja_log" ] || { picture "$1"; }
  echo "Files, seconds:"
  awk 'NR > 1 { printf "%6.1f %s\n", ($2 - $1) / 1000, $4 }' "$build/.ninja_log" | sort -rn | head -n 10
  command=$(sed -n 's/.*"command": "\(.*\) -o .*scene_0_cxx.cxx.*"./\1/p' "$build/compile_commands.json" | head -n 1 | sed 's/\\//g')
  seconds() { # of compiling a file that includes $1
    local TIMEFORMAT='%U'
    echo "${1:+#include \"$1\"}" >"$scratch/header.cpp"
    { time (cd "$build" && $command -w -I"$scratch/$commit/apps" -fsyntax-only "$scratch/header.cpp" 2>/dev/null); } 2>&1
  }
  empty=$(seconds "")
  echo "Headers, seconds × files:"
  ninja -C "$build" -t deps | awk '/^    / { n[$1]++ } END { for (h in n) print n[h], h }' |
    grep -E '/(src|formula|apps)/.*\.h$' | sort -rn | head -n 80 | while read -r files header; do
    header=${header##*/src/}
    header=${header##*/apps/}
    case $header in */formula/*) header=formula/${header##*/formula/} ;; esac
    awk -v all="$(seconds "$header")" -v empty="$empty" -v files="$files" -v header="$header" \
      'BEGIN { printf "%6.1f = %.2f × %d %s\n", (all - empty) * files, all - empty, files, header }'
  done | sort -rn | head -n 10
}

if wanted expensive && [ "$rows" != all ]; then
  commit=${commits[-1]}
  expensive "$commit"
  [ "$rows" != expensive ] || exit "$exit_code"
fi

echo "Seconds by the clock / of the processor; $(nproc) cores of $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(date -I)"
echo
printf '|  |'
printf ' %s |' "${commits[@]}"
printf '\n| --- |'
printf ' --: |%.0s' "${commits[@]}"
echo
if wanted picture || wanted formula; then row "fresh clone to \`mirrorball.png\`" picture; fi
if wanted formula; then
  for formula in color.glsl cube.glsl microfacet.glsl harmonics.glsl sky.glsl shading.glsl; do
    row "\`formula/$formula\` changed → picture" formulaChanged "$formula"
  done
fi
if wanted quick; then row "\`./test --quick\`, fresh clone" quick; fi
# The suites of a room that changed are built in a clone that has the others.
if wanted test || wanted room; then row "\`./test\`, fresh clone" whole; fi
if wanted room; then
  for file in base/text image/halve height_field/slopes metric/ssim codec/ldr/png environment/convert/convert \
    photo/find_ball bake/prefilter/prefilter output/save_map scene/gltf/gltf rays/scene_occlusion trace/path_tracer \
    transfer/detail_transfer gl/texture render/frame/renderer study/study; do
    row "\`$file.cpp\` changed → its room's tests have run" roomChanged "${file%%/*}" "${file#*/}.cpp"
  done
fi
exit "$exit_code"
