#!/bin/bash
# usage: bench/build.sh ROWS COMMIT…
#
# Times what one waits for who works on Mirrorball, and prints it as a table for docs/performance.md. Each row is measured
# with each commit in turn, in a fresh clone of its own under $TMPDIR, without a compiler cache, with all packages there.
#
#   ROWS    with commas between, or `all`:
#             picture  a fresh clone to mirrorball.png
#             formula  a formula changed, of each topic in turn, to a picture
#             room     a .cpp of each room changed, until that room's tests have run
#             quick    ./test --quick in a fresh clone
#             test     ./test in a fresh clone, which takes the longest
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
    all | picture | formula | room | quick | test) ;;
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
  if grep -q -- --room "$scratch/$3/test"; then
    timed "$3" ./test --room "$1"
  else
    timed "$3" sh -c "cmake --build build/dev --target $1_test && build/dev/src/mirrorball/$1/$1_test"
  fi
}

quick() { clone "$1" && timed "$1" ./test --quick; }
whole() { clone "$1" && timed "$1" ./test; }

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
if wanted quick || wanted room; then row "\`./test --quick\`, fresh clone" quick; fi
if wanted room; then
  for file in base/text image/halve codec/png environment/convert photo/find_ball bake/prefilter scene/gltf gl/texture \
    render/renderer; do
    row "\`$file.cpp\` changed → its room's tests have run" roomChanged "${file%/*}" "${file#*/}.cpp"
  done
fi
if wanted test; then row "\`./test\`, fresh clone" whole; fi
exit "$exit_code"
