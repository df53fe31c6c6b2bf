#!/bin/sh
# usage: judge_test.sh SOURCE_DIR SCRATCH_DIR
#
# Each verdict of judge.sh, on a table of costs of its own.

set -u
unset MIRRORBALL_UPDATE_COSTS
scratch=$2
rm -rf "$scratch"
mkdir -p "$scratch"
cp "$1/judge.sh" "$scratch/"
: >"$scratch/costs.txt"
failures=0

# usage: expect EXIT_CODE TEXT ARGUMENTS OF judge.sh…
expect() {
  expected=$1
  text=$2
  shift 2
  said=$(sh "$scratch/judge.sh" "$@" 2>&1)
  code=$?
  case $code:$said in
    "$expected":*"$text"*) ;;
    *)
      echo "FAILED: judge.sh $*: exit code $code instead of $expected, and no \"$text\" in: $said"
      failures=$((failures + 1))
      ;;
  esac
}

expect 0 "no row of such a machine" build 100 10 10
MIRRORBALL_UPDATE_COSTS=1
export MIRRORBALL_UPDATE_COSTS
expect 0 "10.0 units" build 100 10 10
expect 0 "20.0 units" tests 200 10 10
unset MIRRORBALL_UPDATE_COSTS
expect 0 "costs.txt says 10.0" build 114 10 10
expect 0 "costs.txt says 10.0" build 50 10 10
expect 0 "warning: " build 116 10 10
expect 1 "more than 30 %" build 131 10 10
expect 0 "costs.txt says 20.0" tests 220 10 10
expect 0 "costs.txt says 10.0" build 131 12.5 13.5
expect 0 "unit changed" build 200 10 11.5
expect 0 "unit changed" build 200 11.5 10
expect 0 "could not be measured" build 200 "" 10
[ "$failures" = 0 ]
