#!/bin/sh
# usage: launcher_test.sh SOURCE_DIR SCRATCH_DIR
#
# Copies the launcher beside a program of a few lines and tries what ./mirrorball promises: builds once, then only when
# sources change; passes arguments, stdin, stdout and the exit code through; says what is wrong when a build fails.

set -eu
source_dir=$1
tree=$2
out=$tree.out
err=$tree.err
export MIRRORBALL_NO_INSTALL=1
unset MIRRORBALL_OS_RELEASE

fail() {
  echo "FAILED: $*"
  echo "--- stdout"
  cat "$out"
  echo "--- stderr"
  cat "$err"
  exit 1
}

# Runs the launcher (or another command) and compares its exit code.
expectExit() {
  expected=$1
  shift
  actual=0
  "$@" >"$out" 2>"$err" </dev/null || actual=$?
  [ "$actual" -eq "$expected" ] || fail "exit code $actual instead of $expected from: $*"
}

expectOut() { [ "$(cat "$out")" = "$1" ] || fail "stdout is not: $1"; }
expectErr() { grep -qF -- "$1" "$err" || fail "stderr does not say: $1"; }
expectSilent() { [ ! -s "$err" ] || fail "stderr is not empty"; }
# So that a file written next is newer than the stamp, whatever the file system's clock resolves.
waitForClock() { sleep 0.02; }

makeTree() {
  rm -rf "$tree"
  mkdir -p "$tree/apps/cli" "$tree/src/room" "$tree/formula" "$tree/shaders" "$tree/cmake"
  cp "$source_dir/mirrorball" "$source_dir/CMakePresets.json" "$tree"
  cp "$source_dir/cmake/setup.sh" "$source_dir/cmake/packages.txt" "$tree/cmake"
  cat >"$tree/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(stand_in LANGUAGES CXX)
add_subdirectory(apps/cli)
END
  cat >"$tree/apps/cli/CMakeLists.txt" <<'END'
file(GLOB extra CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/room/*.cpp")
add_executable(mirrorball_cli main.cpp ${extra})
set_target_properties(mirrorball_cli PROPERTIES OUTPUT_NAME mirrorball)
END
  writeProgram first
}

# A program that prints its name, its arguments in brackets and its stdin, and exits with 7 when the first one is "seven".
writeProgram() {
  cat >"$tree/apps/cli/main.cpp" <<END
#include <cstdio>
#include <cstring>
int main(int count, char** words) {
  std::printf("$1");
  for (int i = 1; i < count; ++i) std::printf(" [%s]", words[i]);
  for (int c = std::getchar(); c != EOF; c = std::getchar()) std::putchar(c);
  std::printf("\n");
  return count > 1 && std::strcmp(words[1], "seven") == 0 ? 7 : 0;
}
END
}

makeTree
launcher=$tree/mirrorball

# The first run builds, with progress and time on stderr; stdout is the program's alone.
expectExit 0 "$launcher" render
expectOut 'first [render]'
expectErr '[100%'
expectErr 'built in'

# The second one only runs.
expectExit 0 "$launcher" 'two words' "it's" 'a "quote"' '*' '' '$HOME' '-x'
expectOut "first [two words] [it's] [a \"quote\"] [*] [] [\$HOME] [-x]"
expectSilent
expectExit 7 "$launcher" seven
expectSilent
[ "$(echo ' and input' | "$launcher")" = 'first and input' ] || fail "stdin does not reach the program"

# From another folder, through a symlink, and without a folder in the name.
ln -s "$launcher" "$tree.link"
cd /
expectExit 0 "$tree.link" link
rm "$tree.link"
expectOut 'first [link]'
cd "$tree"
expectExit 0 ./mirrorball here
expectExit 0 sh mirrorball here
expectOut 'first [here]'
expectSilent

# A changed source, a new one, and a removed one.
waitForClock
writeProgram second
expectExit 0 "$launcher"
expectOut 'second'
waitForClock
echo 'int unused;' >src/room/new.cpp
expectExit 0 "$launcher"
expectErr 'new.cpp'
waitForClock
rm src/room/new.cpp
expectExit 0 "$launcher"
expectErr 'Linking'
expectExit 0 "$launcher"
expectSilent

# A build that fails shows why, runs nothing, and is tried again.
waitForClock
echo 'int broken = ;' >src/room/new.cpp
expectExit 1 "$launcher"
expectOut ''
expectErr 'new.cpp:1'
expectErr 'the build failed'
expectExit 1 "$launcher"
expectErr 'new.cpp:1'
rm src/room/new.cpp
expectExit 0 "$launcher"
expectOut 'second'
waitForClock
echo 'message(FATAL_ERROR "no such library")' >>CMakeLists.txt
expectExit 1 "$launcher"
expectErr 'no such library'
sed -i '$d' CMakeLists.txt
expectExit 0 "$launcher"

# Two at once: one builds, the other waits, both run.
waitForClock
writeProgram third
"$launcher" a >"$tree.a" 2>/dev/null </dev/null &
expectExit 0 "$launcher" b
expectOut 'third [b]'
wait $! || fail "the first of two launchers failed"
[ "$(cat "$tree.a")" = 'third [a]' ] || fail "the first of two launchers printed something else"

# A tree that was moved builds again where it is.
cd /
rm -rf "$tree.moved"
mv "$tree" "$tree.moved"
waitForClock
touch "$tree.moved/apps/cli/main.cpp"
expectExit 0 "$tree.moved/mirrorball"
expectOut 'third'
mv "$tree.moved" "$tree"

# A compiler cache that was uninstalled since it configured the build.
mkdir "$tree/bin"
printf '#!/bin/sh\nexec "$@"\n' >"$tree/bin/some_cache"
chmod +x "$tree/bin/some_cache"
rm -rf "$tree/build"
expectExit 0 env "PATH=$tree/bin:$PATH" CMAKE_CXX_COMPILER_LAUNCHER=some_cache "$launcher"
rm -r "$tree/bin"
waitForClock
writeProgram fourth
expectExit 0 "$launcher"
expectOut 'fourth'

# A missing package: what it is for and the command; the build goes on with what is there.
if command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; then
  echo 'ID=debian' >"$tree/os-release"
  echo 'build no-such-package Nothing for the test' >>"$tree/cmake/packages.txt"
  expectExit 0 env "MIRRORBALL_OS_RELEASE=$tree/os-release" "$launcher"
  expectErr 'no-such-package: for the test'
  expectErr 'apt-get install'
fi

# An unknown distribution: the libraries by their upstream names; the build goes on if they are there.
echo 'ID=other' >"$tree/os-release"
rm -rf "$tree/build"
expectExit 0 env "MIRRORBALL_OS_RELEASE=$tree/os-release" "$launcher"
expectErr 'oneTBB: parallel loops'
expectOut 'fourth'

rm -rf "$tree" "$tree.a" "$out" "$err"
echo "the launcher behaves"
