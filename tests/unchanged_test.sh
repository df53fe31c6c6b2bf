#!/bin/sh
# usage: unchanged_test.sh SOURCE_DIR SCRATCH_DIR
#
# Which suites unchanged.sh leaves out, in a small tree of its own, where a suite writes a line into build/runs each time.

set -u
script=$1/tests/unchanged.sh
rm -rf "$2"
mkdir -p "$2/tree/build"
cd "$2/tree" || exit 1
export GIT_DIR=/nonexistent  # the tree is no repository, though it may stand in one
unset MIRRORBALL_LEAVE_OUT
failures=0
: >build/runs
echo one >build/a_test
echo two >build/mirrorball
chmod u+x build/a_test build/mirrorball
echo three >data.txt
echo four >code.cpp

# usage: expect RUNS WHY [COMMAND EXIT_CODE]; calls it twice, and expects so many runs of the suite, which is COMMAND
expect() {
  expectOnce "$@"
  expectOnce "$@"
  runs=$(wc -l <build/runs)
  : >build/runs
  [ "$runs" = "$1" ] || complain "$2: run $runs times instead of $1"
}

expectOnce() {
  sh "$script" run build a.All/Suite a_test mirrorball -- sh -c "echo >>build/runs; ${3-:}" >/dev/null
  code=$?
  [ $code = "${4-0}" ] || complain "$2: exit code $code instead of ${4-0}"
}

complain() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}

keys() {
  sh "$script" keys build
}

expect 2 "without keys"
keys
expect 2 "not asked to leave anything out"
export MIRRORBALL_LEAVE_OUT=1
expect 1 "new"
expect 0 "unchanged"
keys
expect 0 "unchanged, by new keys"
echo other >>build/a_test
keys
expect 1 "another program"
echo other >>build/mirrorball
keys
expect 1 "another program that it starts"
mkdir build/another
cp build/mirrorball build/another/
echo other >>build/mirrorball
keys
expect 1 "one of two programs of a name"
echo other >>code.cpp
keys
expect 0 "other C++, of which its programs are not made"
echo other >>data.txt
keys
expect 1 "another file"
export MIRRORBALL_OTHER=1
keys
expect 1 "another environment"
rm build/mirrorball
keys
expect 2 "a program that is not there"
echo two >build/mirrorball
chmod u+x build/mirrorball
keys
expect 2 "fails" "exit 3" 3
# shellcheck disable=SC2016  # the suite expands it
expect 2 "crashes" 'kill -SEGV $$' 139 2>/dev/null
# shellcheck disable=SC2016
expect 2 "skips a test" ': >"$MIRRORBALL_SKIPPED_FILE"'
expect 1 "skips none any more"
unset MIRRORBALL_LEAVE_OUT
expect 2 "fails where nothing is left out" "exit 3" 3
export MIRRORBALL_LEAVE_OUT=1
expect 1 "was forgotten"
cd / && rm -rf "$2"
[ "$failures" = 0 ]
