#!/bin/sh
# usage: unchanged.sh keys BUILD
#        unchanged.sh run BUILD SUITE PROGRAM… -- COMMAND…
#
# Leaves out a suite of tests that has passed before, if nothing that it depends on has changed since: its programs; the
# files of the repository that are not C++, which tests may read; the real inputs in ../shared; the libraries and drivers
# that are installed; the machine; the variables of the environment that programs, shells and drivers know.
#
#   keys   writes a hash of all that into BUILD/keys, a file for each program that is built
#   run    runs COMMAND, which is SUITE and depends on these programs, given by their paths in BUILD. Where
#          MIRRORBALL_LEAVE_OUT=1, which ./test sets once it has written the keys, a suite that has passed with the same keys
#          only says so, and is not run; one that passes without skipping any of its tests is remembered in BUILD/passed.
#          However it is run, one that fails is forgotten.

set -u

# Hashes of all files but C++, which reaches a suite through its programs; suites that read it are always run
# (ALWAYS in cmake/MirrorballTests.cmake).
hashFiles() {
  if git rev-parse --git-dir >/dev/null 2>&1; then
    git ls-files -z --cached --others --exclude-standard
  else
    find . -name build -prune -o -type f -print0
  fi | grep -zvE '\.(cpp|h)$' | LC_ALL=C sort -zu | xargs -0r sha1sum 2>/dev/null
}

describeMachine() {
  find -L ../shared ${MIRRORBALL_DATA:+"$MIRRORBALL_DATA"} -type f -printf '%p %s %T@\n' 2>/dev/null | sort
  stat -c '%n %s %Y' /etc/ld.so.cache /var/lib/dpkg/status 2>/dev/null
  [ -z "${MIRRORBALL_PROGRAM-}" ] || sha1sum "$MIRRORBALL_PROGRAM"
  uname -mr
  nproc
  id -u
  grep -m 2 -E '^(model name|flags)' /proc/cpuinfo
  ls /dev/dri 2>/dev/null
  env | grep -vE '^(MIRRORBALL_LEAVE_OUT|OLDPWD|PWD|SHLVL|_)=' |
    grep -E '^(COLUMNS|DISPLAY|DRI|EGL|GALLIUM|GALLIVM|GTEST|HOME|LANG|LC_|LD_|LIBGL|LP|MESA|MIRRORBALL|NIR|PATH|ST_|TMPDIR|VK_|XDG_|ZINK|__EGL|__GLX)' |
    sort
}

# The name of the file of keys of a program with this path.
keyFile() {
  echo "$1" | tr / -
}

writeKeys() {
  build=$1
  rm -rf "$build/keys"
  mkdir -p "$build/keys"
  # Where the tools are others than GNU's nothing can be said, and every suite is run.
  find "$build/keys" -printf '' 2>/dev/null || return 0
  hashFiles >"$build/keys/files"
  [ -s "$build/keys/files" ] || return 0
  # The locale orders names; suites are run in the user's own.
  shared=$({ cat "$build/keys/files" && describeMachine; } | LC_ALL=C sort | sha1sum)
  find "$build" -type f -perm -u+x \( -name '*_test' -o -name 'mirrorball*' \) -printf '%P\n' | while read -r program; do
    own=$(sha1sum <"$build/$program")
    echo "${shared%% *} ${own%% *}" >"$build/keys/$(keyFile "$program")"
  done
}

run() {
  passed=$1/passed/$2
  keys=$1/keys
  shift 2
  key=
  leaves_out=false
  [ "${MIRRORBALL_LEAVE_OUT-}" != 1 ] || leaves_out=true
  while [ "$1" != -- ]; do
    file=$keys/$(keyFile "$1")
    if [ -r "$file" ] && read -r program_key <"$file"; then
      key="$key $1 $program_key"
    else
      leaves_out=false
    fi
    shift
  done
  shift
  if $leaves_out && [ -r "$passed" ] && read -r key_before <"$passed" && [ " $key_before" = "$key" ]; then
    echo "unchanged since it passed: not run"
    exit 0
  fi
  if $leaves_out; then
    mkdir -p "${passed%/*}"
    rm -f "$passed" "$passed.skipped"
    # The program makes this file where it skips a test (tests/main.cpp).
    export MIRRORBALL_SKIPPED_FILE="$passed.skipped"
  fi
  "$@"
  code=$?
  [ $code -eq 0 ] || rm -f "$passed"
  [ $code -le 128 ] || kill -"$((code - 128))" $$
  if $leaves_out && [ $code -eq 0 ] && [ ! -e "$passed.skipped" ]; then
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
