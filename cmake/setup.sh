#!/bin/sh
# usage: setup.sh PRESET[:TARGET] GROUP…
#        setup.sh packages GROUP…
#
# Installs the packages of the groups given (packages.txt) that are missing, then configures one preset of
# CMakePresets.json and builds it, or only the target given; for `packages` it only installs. Leaves the stamp
# build/PRESET/.begun, of the time at which the build began. Exit code 0 or 1. Writes to stderr only: stdout belongs to
# the program that is built.
#
#   MIRRORBALL_NO_INSTALL=1      installs nothing: prints the command, and builds if CMake finds all it needs
#   MIRRORBALL_OS_RELEASE=FILE   is read instead of /etc/os-release, to try another system's way

set -eu
exec >&2
preset=${1%%:*}
target=${1#"$preset"}
target=${target#:}
shift
groups=$*
cd -P -- "$(dirname -- "$0")/.."
root=$(pwd -P)
build=$root/build/$preset

say() {
  echo "mirrorball: $*"
}

# Calls `$1 group package library why` for each row of packages.txt in the groups asked for.
forEachPackage() {
  while read -r group package library why; do
    case " $groups " in
      *" $group "*) "$1" "$group" "$package" "$library" "$why" ;;
    esac
  done <cmake/packages.txt
}

isDebian() {
  release=${MIRRORBALL_OS_RELEASE:-/etc/os-release}
  [ -r "$release" ] && command -v apt-get >/dev/null && command -v dpkg-query >/dev/null || return 1
  # shellcheck disable=SC1090
  names=$(. "$release" && echo "${ID-} ${ID_LIKE-}")
  case " $names " in
    *" debian "* | *" ubuntu "*) return 0 ;;
  esac
  return 1
}

addIfMissing() {
  if [ "$(dpkg-query -W -f '${db:Status-Status}' "$2" 2>/dev/null)" != installed ]; then
    missing="$missing $2"
    reasons="$reasons
  $2: $4"
  fi
}

printLibrary() {
  echo "  $3: $4"
}

# Installs $missing. The lists of packages are only fetched where apt cannot resolve the names without, or where the
# lists it has are out of date.
aptInstall() {
  options="-y -q --no-install-recommends -o DPkg::Lock::Timeout=120"
  apt="$as_root env DEBIAN_FRONTEND=noninteractive apt-get"
  # Asks for the password, once; whoever may not is not asked again.
  $as_root true || return 1
  # shellcheck disable=SC2086  # several words each, on purpose
  if apt-get install --simulate $options $missing >/dev/null 2>&1 && $apt install $options $missing; then
    return 0
  fi
  # shellcheck disable=SC2086
  $apt update -q && $apt install $options $missing
}

installMissing() {
  missing=
  reasons=
  forEachPackage addIfMissing
  [ -n "$missing" ] || return 0

  command="apt-get update && apt-get install --no-install-recommends$missing"
  if [ "${MIRRORBALL_NO_INSTALL:-0}" != 0 ]; then
    say "these packages are missing:$reasons"
    say "MIRRORBALL_NO_INSTALL is set, so nothing is installed; as root: $command"
    return 0
  fi
  if [ "$(id -u)" = 0 ]; then
    as_root=
  elif command -v sudo >/dev/null; then
    as_root=sudo
  else
    say "these packages are missing:$reasons"
    say "run this as root, then start again: $command"
    exit 1
  fi
  say "installing (MIRRORBALL_NO_INSTALL=1 forbids it):$reasons"
  if ! aptInstall; then
    say "the packages could not be installed; run this as root, then start again: $command"
    exit 1
  fi
  # CMake finds more now than when it looked before.
  rm -f "$root"/build/*/build.ninja
}

# One build at a time in one folder; the lock ends with this process.
lock() {
  mkdir -p "$build"
  command -v flock >/dev/null || return 0
  exec 9>"$build/.lock"
  if ! flock -n 9; then
    say "waiting for another build in $build"
    flock 9
  fi
}

# Whether the build calls its compiler through a compiler cache that is not installed any more.
lacksLauncher() {
  launcher=$(sed -n 's/^CMAKE_CXX_COMPILER_LAUNCHER:[^=]*=//p' "$build/CMakeCache.txt")
  [ -n "$launcher" ] && ! command -v "${launcher%%;*}" >/dev/null
}

configureIfNeeded() {
  # A tree that was copied or moved brings a cache that names another folder.
  if [ -e "$build/CMakeCache.txt" ] &&
    { ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt" || lacksLauncher; }; then
    rm -f "$build/.configured" "$build/CMakeCache.txt"
  fi
  # Ninja runs CMake again by itself where a CMakeLists.txt has changed, but does not read the presets again.
  # Where a changed preset names another compiler than the cache, CMake would forget all that it says besides. A fresh
  # configuration compiles everything again, so otherwise the cache is kept.
  fresh=
  if [ -e "$build/.configured" ] && [ -n "$(find CMakePresets.json -newer "$build/.configured")" ]; then
    fresh=--fresh
  fi
  if [ -n "$fresh" ] || [ ! -e "$build/build.ninja" ] || [ ! -e "$build/.configured" ]; then
    rm -f "$build/.configured"
    # Without CMake's status lines, among which Debian's Imath has an alarming one that means nothing.
    # shellcheck disable=SC2086  # nothing, or one word
    cmake $fresh --preset "$preset" -DCMAKE_MESSAGE_LOG_LEVEL=NOTICE || return 1
    : >"$build/.configured"
  fi
}

buildPreset() {
  begin=$(date +%s)
  # The stamp has the time at which the build began: a source saved meanwhile is newer than it.
  : >"$build/.begun"
  # Ninja's own choice, two more than there are cores, only makes compilers push each other out of the caches.
  export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
  say "building $build"
  if ! configureIfNeeded; then
    say "CMake could not configure the build; its messages are above"
    exit 1
  fi
  if ! NINJA_STATUS='[%p %es] ' cmake --build --preset "$preset" --target "${target:-all}"; then
    say "the build failed; the compiler's messages are above"
    exit 1
  fi
  say "built in $(($(date +%s) - begin)) s"
}

if isDebian; then
  installMissing
elif [ "$preset" = packages ] || [ ! -e "$build/.configured" ]; then
  say "this is neither Debian nor Ubuntu: the following must be installed, and is used where CMake finds it"
  forEachPackage printLibrary
fi
[ "$preset" != packages ] || exit 0
if ! command -v cmake >/dev/null; then
  say "CMake is not installed"
  exit 1
fi
lock
buildPreset
