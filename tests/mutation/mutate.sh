#!/bin/bash
# usage: tests/mutation/mutate.sh [--count 40] [--seed 1] [--list] [WORK_FOLDER]
#
# Says how well the tests would notice a mistake: changes one operator or one number of the sources at a time, in a
# clone of HEAD, and looks which suite fails: of the module, else of what is built of it, else of all. A third of the
# changes is in the formulas, a third in the core modules, a third in the readers of files. README.md says how to read
# the results.
#
#   --count N     so many changes that compile
#   --seed N      other changes; those of one seed and one commit are always the same
#   --list        prints the changes, and does nothing else
#   WORK_FOLDER   $TMPDIR/mirrorball_mutation unless told: has the clone, the results (results.tsv) and the logs
#
# It takes many hours. Ctrl-C loses the change under way; started again with the same folder, it goes on. Exit code 0
# when all changes have been run, whatever came of them.

set -u
here=$(cd -P -- "$(dirname -- "$0")" && pwd) || exit 1
source=$(cd -P -- "$here/../.." && pwd) || exit 1

count=40
seed=1
lists=false
work=${TMPDIR:-/tmp}/mirrorball_mutation

fail() {
  echo "mutate: $*" >&2
  exit 1
}

readArguments() {
  while [ $# -gt 0 ]; do
    case $1 in
      --help | -h)
        sed -n '2,/^$/s/^# \{0,1\}//p' "$0"
        exit 0
        ;;
      --count | --seed)
        [[ ${2-} =~ ^[1-9][0-9]{0,5}$ ]] || fail "$1 needs a number from 1 to 999999"
        if [ "$1" = --count ]; then count=$2; else seed=$2; fi
        shift
        ;;
      --list) lists=true ;;
      -*) fail "there is no option $1; --help shows them" ;;
      *) work=$1 ;;
    esac
    shift
  done
}

# usage: chooseCandidates REPOSITORY; rows "number group path line column old new text"
#
# All mutations of HEAD there, in the order in which they are run. The groups take turns, so that the first COUNT rows
# have a third of each: of group 0 rows 1, 4, 7…, of group 1 rows 2, 5, 8…
chooseCandidates() {
  local core='base image height_field environment bake light_edit metric rays trace scene' folders=() folder
  for folder in $core codec; do folders+=("src/mirrorball/$folder/*.cpp" "src/mirrorball/$folder/*.h"); done
  git -C "$1" grep -I -n --no-column --no-color '' HEAD -- 'formula/*.glsl' "${folders[@]}" \
    ':!*_test.cpp' ':!*_testing.*' |
    LC_ALL=C awk -v seed="$seed" -f "$here/candidates.awk" |
    LC_ALL=C sort -t "$(printf '\t')" -k1,1n -k3,3 -k4,4n |
    awk -F '\t' -v OFS='\t' '{ $1 = 3 * taken[$2]++ + $2 + 1; print }'
}

# Of the first COUNT candidates: number, file:line, old line, new line.
list() {
  local repository=$source
  [ ! -d "$clone/.git" ] || repository=$clone
  chooseCandidates "$repository" | LC_ALL=C awk -F '\t' -v count="$count" '$1 <= count' | sort -n |
    LC_ALL=C awk -F '\t' '{
      new = substr($8, 1, $5 - 1) $7 substr($8, $5 + length($6))
      print $1 "  " $3 ":" $4 "\n  - " $8 "\n  + " new
    }'
}

# An interrupted clone is made again.
makeClone() {
  [ ! -d "$clone/.git" ] || return 0
  rm -rf "$clone.part"
  { git clone --quiet "$source" "$clone.part" && mv "$clone.part" "$clone"; } || fail "$clone could not be made"
}

restore() {
  git -C "$clone" checkout --quiet -- .
}

# What an interrupted run has left is put right; the numbers of the results are only good for these candidates.
prepare() {
  exec 8>"$work/lock"
  ! command -v flock >/dev/null || flock -n 8 || fail "another run is at work in $work"
  makeClone
  restore
  if [ ! -e "$work/candidates.tsv" ]; then
    chooseCandidates "$clone" >"$work/candidates.part" || fail "no candidates could be chosen"
    echo "$seed" >"$work/seed"
    mv "$work/candidates.part" "$work/candidates.tsv"
  fi
  [ "$(cat "$work/seed")" = "$seed" ] ||
    fail "the results in $work are those of --seed $(cat "$work/seed"); take another folder"
  touch "$results"
}

# As ./test sets them. The user's cache is neither read nor spoilt by a program that is wrong on purpose.
setEnvironment() {
  if command -v ccache >/dev/null && cache=$(ccache --get-config cache_dir 2>/dev/null) &&
    mkdir -p "$cache" 2>/dev/null && [ -w "$cache" ]; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  export GALLIVM_PERF="${GALLIVM_PERF-nopt}"
  export MIRRORBALL_CACHE="$work/cache"
}

# Caches of earlier mutations hold their wrong pictures.
clearCaches() {
  rm -rf "$work/cache" "$clone"/build/dev/apps/cli/test_cache_*
}

# The packages are those of ./test, so that it has none to install, and thus nothing to configure anew, later.
buildClone() {
  echo "building $clone at $(git -C "$clone" rev-parse --short HEAD)"
  sh "$clone/cmake/setup.sh" dev:tests_default build run test >"$work/logs/build.log" 2>&1 </dev/null ||
    fail "the clone does not build without a mutation; see $work/logs/build.log"
  # What the programs are made of: a file of another system, or of a part that is left out, cannot be tested here.
  {
    ninja -C "$build" -t inputs tests_default
    ninja -C "$build" -t deps
  } 2>/dev/null | sed -n "s|^ *$clone/||p" | grep -v '^build/' | sort -u >"$work/sources.txt"
}

# usage: runSuites LOG ARGUMENTS OF CTEST…
#
# A suite that has passed with the very same programs and files is not run again, as ./test does it (tests/unchanged.sh).
runSuites() {
  local log=$work/logs/$1
  shift
  (cd "$clone" && sh tests/unchanged.sh keys build/dev)
  MIRRORBALL_LEAVE_OUT=1 ctest --test-dir "$build" -L '^(quick|standard)$' -j "$(nproc)" --output-on-failure "$@" \
    >"$log" 2>&1 </dev/null
}

# usage: failedSuites LOG; with the reason where it is another than a failed test, such as "Timeout"
failedSuites() {
  sed -E -n '/^The following tests FAILED:/,$s/^[[:space:]]*[0-9]+ - ([^ ]+) \(([^)]*)\).*/\1 (\2)/p' "$work/logs/$1" |
    sed 's/ (Failed)$//'
}

# Suites that fail without any mutation say nothing about one. Neither do those that judge the sources themselves.
judge_sources='(house|House)\..*|golden\.GoldenTruths'
findLeftOut() {
  if [ ! -e "$work/failing.txt" ]; then
    echo "running all suites without a mutation"
    clearCaches
    runSuites unchanged.log -E "^($judge_sources)\$" || failedSuites unchanged.log | sed 's/ .*//' >"$work/failing.part"
    touch "$work/failing.part"
    grep -q '^100% tests passed' "$work/logs/unchanged.log" || [ -s "$work/failing.part" ] ||
      fail "the suites could not be run; see $work/logs/unchanged.log"
    mv "$work/failing.part" "$work/failing.txt"
  fi
  [ ! -s "$work/failing.txt" ] || sed 's/^/left out, since it fails without a mutation: /' "$work/failing.txt"
  left_out="^($judge_sources$(sed 's/[.[*^$+?()|/]/\\&/g; s/^/|/' "$work/failing.txt" | tr -d '\n'))\$"
}

# usage: applyMutation PATH LINE COLUMN OLD NEW
applyMutation() {
  local file=$clone/$1
  # In the environment, since awk would read escapes in an assigned variable.
  old=$4 new=$5 LC_ALL=C awk -v line="$2" -v column="$3" 'NR == line {
      old = ENVIRON["old"]
      if (substr($0, column, length(old)) != old) exit 1
      $0 = substr($0, 1, column - 1) ENVIRON["new"] substr($0, column + length(old))
    }
    { print }' "$file" >"$work/mutated" || fail "$1:$2 is not as it was when the mutations were chosen"
  cat "$work/mutated" >"$file"
}

# usage: buildMutation LOG TARGET…; 0: it builds, else $result says what came of it
#
# Ninja itself and not `cmake --build`, which would leave it running when its time is up. The build also runs programs
# that it has made, and these may fail or never end.
buildMutation() {
  local log=$work/logs/$1
  shift
  timeout --foreground 3600 ninja -C "$build" -j "$(nproc)" "$@" >"$log" 2>&1 </dev/null && return
  if grep -qE '^[^ ]+:[0-9]+:[0-9]+: (fatal )?error: |clang[^ ]*: error: |undefined reference' "$log"; then
    result="does not compile"
    by=none
  else
    result="caught by the build"
    by=build
  fi
  return 1
}

# The names of test programs among those given by their paths, a line each.
programNames() {
  sed 's|.*/||; s|_test$||' | sort -u
}

# usage: findOwn PATH; sets $own to the names of the test programs of its module; of a formula's, those of formulas
findOwn() {
  local module=${1#src/mirrorball/} folders
  case $1 in
    formula/*) folders=(tests/formula tests/parity) ;;
    *) folders=("src/mirrorball/${module%%/*}") ;;
  esac
  mapfile -t own < <(cd "$build" && find "${folders[@]}" -type f -name '*_test' -perm -u+x | programNames)
}

# Sets $others to the names of all other test programs that were linked anew. Those that the mutation before had changed
# are among them, since its file was restored. That costs time only.
findOthers() {
  mapfile -t others < <(
    {
      find "$build" -type f -name '*_test' -perm -u+x -newer "$work/stamp"
      # These start the program, and are not linked with it.
      [ -z "$(find "$build/apps/cli/mirrorball" -newer "$work/stamp" 2>/dev/null)" ] || printf '%s\n' cli golden
    } | programNames | grep -vxF "$(printf '%s\n' "${own[@]}" none)"
  )
}

# The words, with "|" between.
alternatives() {
  local IFS='|'
  echo "$*"
}

# usage: isCaught LOG WORDS BY COMMAND…; whether COMMAND, which writes LOG, found a failing suite
isCaught() {
  local log=$1 words=$2 suite
  by=$3
  shift 3
  "$@" && return 1
  suite=$(failedSuites "$log" | head -n 1)
  [ -n "$suite" ] || fail "the suites could not be run; see $work/logs/$log"
  result="$words $suite"
}

# usage: judge NUMBER PATH; sets $result and $by: own, others, whole, build, or none
judge() {
  local log=$1.log first=(--stop-on-failure -E "$left_out")
  if ! grep -qxF "$2" "$work/sources.txt"; then
    result="not in this build"
    by=none
    return
  fi
  findOwn "$2"
  if [ ${#own[@]} -gt 0 ]; then
    buildMutation "$log" "${own[@]/%/_suites}" || return 0
    ! isCaught "$log" "caught by" own runSuites "$log" -R "^($(alternatives "${own[@]}"))\\." "${first[@]}" || return 0
  fi
  buildMutation "$log" tests_default || return 0
  findOthers
  if [ ${#others[@]} -gt 0 ]; then
    ! isCaught "$log" "caught by" others runSuites "$log" -R "^($(alternatives "${others[@]}"))\\." "${first[@]}" ||
      return 0
  fi
  # What is left of ./test, whose programs have all been built.
  ! isCaught "$log" "survived modules, caught by ./test:" whole runSuites "$log" "${first[@]}" || return 0
  result=survived
  by=none
}

# usage: runMutation NUMBER GROUP PATH LINE COLUMN OLD NEW TEXT; writes the row of the results
runMutation() {
  local begin line
  begin=$(date +%s)
  line=${8#"${8%%[! ]*}"}
  clearCaches
  # Ninja compares times, and so does findOthers: the file has to be newer than the stamp, and than what was built.
  : >"$work/stamp"
  applyMutation "$3" "$4" "$5" "$6" "$7"
  judge "$1" "$3"
  restore
  printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$1" "$3:$4" "$6 → $7 in: $line" "$result" "$(($(date +%s) - begin))" "$by" \
    >>"$results"
  echo "$(countRun)/$count  $3:$4  $6 → $7: $result, $(($(date +%s) - begin)) s; $(timeLeft) left"
}

# shellcheck disable=SC2016  # the columns are awk's
isRun='$4 != "does not compile" && $4 != "not in this build"'

countRun() {
  awk -F '\t' "$isRun"' { n++ } END { print n + 0 }' "$results"
}

timeLeft() {
  awk -F '\t' -v count="$count" '{ seconds += $5 }
    '"$isRun"' { n++ }
    END {
      left = n ? (count > n ? count - n : 0) * seconds / n / 60 : 0
      if (n) printf "%d h %02d min", left / 60, left % 60
      else print "an unknown time"
    }' "$results"
}

# The row of the candidate to run next; nothing when all groups have theirs. Candidate N is of group (N - 1) % 3; one
# that does not compile is replaced by the next of its group.
nextCandidate() {
  awk -F '\t' -v count="$count" 'FILENAME == ARGV[1] { seen[$1]; if ('"$isRun"') run[($1 - 1) % 3]++; next }
    function wanted(group) { return int((count - group + 2) / 3) }
    !($1 in seen) && run[$2] < wanted($2) && (!best || $1 < best) { best = $1; row = $0 }
    END { if (best) print row }' "$results" "$work/candidates.tsv"
}

# Of all rows, those of an earlier run with a larger COUNT among them.
summarize() {
  awk -F '\t' "$isRun"' { by[$6]++; n++ }
    '"$isRun"' && $6 == "none" { survivors = survivors "\n  " $2 "  " $3 }
    '"!($isRun)"' { replaced++ }
    END {
      print n + 0 " mutations run; " replaced + 0 " others do not compile or are not in this build"
      print "  caught by the suites of their module: " by["own"] + 0
      print "  caught by other suites: " by["others"] + by["whole"] + 0 ", of these by ./test alone: " by["whole"] + 0
      print "  caught by the build: " by["build"] + 0
      print "  survived: " by["none"] + 0 survivors
    }' "$results"
}

interrupted() {
  restore
  echo "mutate: interrupted; started again with the same folder, it goes on" >&2
  exit 130
}

readArguments "$@"
clone=$work/clone
if $lists; then
  list
  exit
fi
mkdir -p "$work/logs" || fail "the folder $work cannot be made"
work=$(cd -P -- "$work" && pwd)
clone=$work/clone
results=$work/results.tsv
prepare
build=$clone/build/dev
trap interrupted INT TERM
setEnvironment
clearCaches
buildClone
findLeftOut
while row=$(nextCandidate) && [ -n "$row" ]; do
  # No column is empty; `read` would take two tabs for one.
  IFS=$'\t' read -r number group path line column old new text <<<"$row"
  runMutation "$number" "$group" "$path" "$line" "$column" "$old" "$new" "$text"
done
summarize
