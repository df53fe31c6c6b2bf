#!/bin/sh
# usage: unchanged.sh keys BUILD
#        unchanged.sh run BUILD SUITE PROGRAM… -- COMMAND…
#
# Leaves out a suite of tests that has passed before, if nothing that it depends on has changed since: its programs; the
# files of the repository that are not C++, which tests may read; the real inputs in ../shared; the libraries and drivers
# that are installed; the variables of the environment that programs and drivers know.
#
#   keys   writes a hash of all that into BUILD/keys, a file for each program that is built
#   run    runs COMMAND, which is SUITE and depends on these programs, given by their names. Where MIRRORBALL_LEAVE_OUT=1,
#          which ./test sets once it has written the keys, a suite that has passed with the same keys only says so, and is
#          not run; one that passes without skipping any of its tests is remembered in BUILD/passed.

set -u
export LC_ALL=C

# Hashes of all files but C++, which reaches a suite through its programs; suites that read it are always run
# (ALWAYS in cmake/MirrorballTests.cmake).
hashFiles() {
  if git rev-parse --git-dir >/dev/null 2>&1; then
    git ls-files -z --cached --others --exclude-standard
  else
    find . -name build -prune -o -type f -print0
  fi | grep -zvE '\.(cpp|h)$' | sort -zu | xargs -0r sha1sum 2>/dev/null
}

describeMachine() {
  find -L ../shared ${MIRRORBALL_DATA:+"$MIRRORBALL_DATA"} -type f -printf '%p %s %T@\n' 2>/dev/null | sort
  stat -c '%n %s %Y' /etc/ld.so.cache /var/lib/dpkg/status 2>/dev/null
  env | grep -E '^(DISPLAY|EGL|GALLIUM|GALLIVM|GTEST|HOME|LIBGL|LP|MESA|MIRRORBALL|TMPDIR|__EGL|__GLX)' |
    grep -v '^MIRRORBALL_LEAVE_OUT=' | sort
}

writeKeys() {
  build=$1
  rm -rf "$build/keys"
  mkdir -p "$build/keys"
  hashFiles >"$build/keys/files"
  # Where the tools are others than GNU's nothing can be said, and every suite is run.
  [ -s "$build/keys/files" ] || return 0
  shared=$({ cat "$build/keys/files" && describeMachine; } | sha1sum)
  find "$build" -type f -perm -u+x \( -name '*_test' -o -name 'mirrorball*' \) | while read -r program; do
    own=$(sha1sum <"$program")
    echo "${shared%% *} ${own%% *}" >"$build/keys/${program##*/}"
  done
}

run() {
  passed=$1/passed/$2
  keys=$1/keys
  shift 2
  key=
  is_known=true
  while [ "$1" != -- ]; do
    if [ -r "$keys/$1" ] && read -r program_key <"$keys/$1"; then
      key="$key $1 $program_key"
    else
      is_known=false
    fi
    shift
  done
  shift
  if [ "${MIRRORBALL_LEAVE_OUT-}" != 1 ] || ! $is_known; then
    exec "$@"
  fi
  if [ -r "$passed" ] && read -r key_before <"$passed" && [ " $key_before" = "$key" ]; then
    echo "unchanged since it passed: not run"
    exit 0
  fi
  mkdir -p "${passed%/*}"
  rm -f "$passed" "$passed.skipped"
  # The program makes this file where it skips a test (tests/main.cpp).
  export MIRRORBALL_SKIPPED_FILE="$passed.skipped"
  "$@"
  code=$?
  [ $code -le 128 ] || kill -"$((code - 128))" $$
  if [ $code -eq 0 ] && [ ! -e "$passed.skipped" ]; then
    echo "$key" >"$passed"
  fi
  exit $code
}

case ${1-} in
  keys) writeKeys "$2" ;;
  run)
    shift
    run "$@"
    ;;
  *) exit 2 ;;
esac
