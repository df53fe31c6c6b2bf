#!/bin/sh
# usage: tests/optional_parts.sh [--quick] BUILD_DIR [PART…]
#
# Builds Mirrorball without each of its optional parts alone, and without all of them, in one folder whose objects are
# kept from one to the next, and runs the tests that are left. PART is the name of an option without MIRRORBALL_, or
# "all"; without any, it is each and then all. Prints a row for the table of docs/building.md for each, and exits with 1
# if one of them failed. It is run by hand: it takes hours at first, where ./test takes minutes.
#
#   --quick   only the rooms that know of parts, and tests/parts
#   JOBS=N    in the environment: number of compilers at a time

set -u
quick=false
if [ "${1-}" = --quick ]; then
  quick=true
  shift
fi
build=${1:?usage: tests/optional_parts.sh [--quick] BUILD_DIR [PART…]}
shift
source=$(cd -P -- "$(dirname -- "$0")/.." && pwd) || exit 1

# The table of the parts is the one that CMake reads.
parts=$(sed -n 's/^mirrorball_part(\([A-Z0-9]*\) .*/\1/p' "$source/cmake/MirrorballParts.cmake")
[ $# -gt 0 ] || set -- $parts all

targets="tests_default tier_all"
tests=.
if $quick; then
  targets="codec_suites environment_suites photo_suites output_suites scene_suites gltf_absent_suites parts_suites"
  tests='^(codec|environment|photo|output|scene|gltf_absent|parts)\.'
fi

# usage: without PART; the options of a build that has all parts but that, or none for "all"
without() {
  for part in $parts; do
    if [ "$1" = all ] || [ "$1" = "$part" ]; then
      printf ' -DMIRRORBALL_%s=OFF' "$part"
    else
      printf ' -DMIRRORBALL_%s=ON' "$part"
    fi
  done
}

# usage: check PART; says what came of it
check() {
  # shellcheck disable=SC2046  # several words, on purpose
  cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DMIRRORBALL_BENCH=OFF \
    -DMIRRORBALL_WARNINGS_AS_ERRORS=ON $(without "$1") >"$build.log" 2>&1 || {
    echo "does not configure"
    return 1
  }
  there=
  for target in $targets; do
    # A part that is left out has no tests.
    if ninja -C "$build" -t query "$target" >/dev/null 2>&1; then there="$there $target"; fi
  done
  # shellcheck disable=SC2086
  nice ninja -C "$build" ${JOBS:+-j "$JOBS"} $there >>"$build.log" 2>&1 || {
    echo "does not build"
    return 1
  }
  ctest --test-dir "$build" --no-tests=error -R "$tests" -LE '^long$' >>"$build.log" 2>&1
  outcome=$?
  sed -n 's/^\([0-9]*% tests passed, .*\)/\1/p' "$build.log" | tail -n 1
  return $outcome
}

exit_code=0
for part; do
  result=$(check "$part") || {
    exit_code=1
    cp "$build.log" "$build.$part.log"
    result="$result (see $build.$part.log)"
  }
  echo "| $part | $result |"
done
exit $exit_code
