#!/bin/sh
# usage: suite_times.sh list          prints all suites of suites.txt, the most expensive first, and the sums of the tiers
#        suite_times.sh record        writes what the last runs took into suites.txt and docs/performance/build.md
#        suite_times.sh left WHAT     prints what `./test WHAT` did not run, and how long that takes here
#
# The costs in suites.txt are seconds of the processor in the unit of cost/unit.sh, so that they are much the same on any
# machine. Those of the last runs are in build/dev/times, a file a suite (measured.sh).

set -eu
export LC_ALL=C
cd -P -- "$(dirname -- "$0")/.."
rows=tests/suites.txt
page=docs/performance/build.md
times=build/dev/times
tiers="quick standard all sanitized long"

isRow='/^[a-z]+ +[0-9.]+ +[^ ]+$/'

list() {
  awk "$isRow"' { printf "%-10s %8.2f  %s\n", $1, $2, $3 }' $rows | sort -k2,2nr -k3
  echo
  sums
}

sums() {
  awk "$isRow"' { cost[$1] += $2; count[$1]++ }
    END { for (tier in cost) printf "%-10s %8.1f  in all, %d suites\n", tier, cost[tier], count[tier] }' $rows | sort -k2,2n
}

# Lines "SUITE SECONDS" of the last runs.
measured() {
  [ -d "$times" ] || return 0
  find "$times" -type f -exec sh tests/cost/seconds.sh {} + |
    awk '{ seconds = $1; sub(/^[^ ]+ .*\//, ""); gsub(/-/, "/"); print $0, seconds }'
}

# Lines "TIER SUITE" of all that are built.
known() {
  for tier in $tiers; do
    ctest --test-dir build/dev -N -L "^$tier\$" | awk -v tier="$tier" '/Test +#/ { print tier, $NF }'
  done
}

record() {
  unit=$(sh tests/cost/unit.sh)
  [ -n "$unit" ] || {
    echo "the source of GoogleTest, which is the unit, is not installed" >&2
    exit 1
  }
  new=$(mktemp)
  awk "$isRow"' { exit } { print }' $rows >"$new"
  { awk "$isRow"' { print "row", $1, $2, $3 }' $rows && known | sed 's/^/known /' && measured | sed 's/^/took /'; } |
    awk -v unit="$unit" '
      $1 == "row" { tier[$4] = $2; cost[$4] = $3 }
      $1 == "known" { program = $3; sub(/\.[^.]*$/, "", program); built[program] = 1 }
      $1 == "known" && $3 ~ /\.IsNotBuilt$/ { absent[program] = 1; next }
      $1 == "known" { now[$3] = $2 }
      $1 == "took" { seconds[$2] = $3 }
      END {
        # A program that is not built keeps its rows; of one that is, the suites that are gone lose theirs.
        for (suite in tier) { program = suite; sub(/\.[^.]*$/, "", program); if (!built[program] || absent[program]) now[suite] = tier[suite] }
        for (suite in now)
          printf "%-9s %8.3f  %s\n", now[suite], suite in seconds ? seconds[suite] / unit : cost[suite] + 0, suite
      }' | sort -k3 >>"$new"
  cat "$new" >$rows
  rm -f "$new"
  writeTables
  sums
}

# The tables of the page, between the comments that begin and end them.
writeTables() {
  tables=$(mktemp)
  {
    echo "| tier | suites | cost |"
    echo "| --- | --: | --: |"
    sums | awk '{ printf "| `%s` | %d | %.1f |\n", $1, $5, $2 }'
    echo
    echo "| the most expensive suites | tier | cost |"
    echo "| --- | --- | --: |"
    awk "$isRow" $rows | sort -k2,2nr -k3 | head -20 | awk '{ printf "| `%s` | `%s` | %.2f |\n", $3, $1, $2 }'
  } >"$tables"
  new=$(mktemp)
  awk -v tables="$tables" '/^<!-- end of the tables/ { skipping = 0 } !skipping { print }
    /^<!-- tables made by/ { skipping = 1; while ((getline line <tables) > 0) print line }' $page >"$new"
  cat "$new" >$page
  rm -f "$new" "$tables"
}

left() {
  case $1 in
    default) mine="quick standard" ;;
    quick) mine=quick ;;
  esac
  { measured | sed 's/^/took /' && awk "$isRow"' { print "row", $1, $2, $3 }' $rows; } |
    awk -v mine=" $mine " -v cores="$(nproc)" '
      $1 == "took" { seconds[$2] = $3 }
      $1 == "row" {
        if ($4 in seconds && $3 > 0) { spent += seconds[$4]; worth += $3 }
        if (index(mine, " " $2 " ") == 0) { count++; cost += $2 == "long" ? $3 / 10 : $3 }
      }
      END {
        unit = worth > 0 ? spent / worth : 10
        printf "Not run: %d suites; ./test --all runs them (a tenth of the tier long)", count
        printf ", which takes about %d minutes here, besides their build.\n", cost * unit / cores / 60 + 1
      }'
}

"$@"
