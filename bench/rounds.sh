# shellcheck shell=sh
# Sourced by the scripts beside it that time several programs on one task.

has() { command -v "$1" >/dev/null; }

# Of numbers, a line each.
median() { sort -n | awk '{ t[NR] = $1 } END { print t[int((NR + 1) / 2)] }'; }

# usage: timeInRounds RUNS TASK…
#
# Runs each TASK once after the other by `runTask TASK`, RUNS times, so that a busy moment hits all alike. Each run adds a
# line to TASK.times: its time in tenths of a millisecond, and what it left in the file `spent`.
timeInRounds() {
  rounds=$1
  shift
  : >spent
  round=0
  while [ "$round" -le "$rounds" ]; do
    for task; do
      begin=$(date +%s%N)
      runTask "$task" >/dev/null 2>"$task.log" || echo "$task failed: $(head -n 1 "$task.log")" >&2
      end=$(date +%s%N)
      # The first round only brings files and programs into the system's cache.
      [ "$round" -eq 0 ] || echo "$(((end - begin) / 100000)) $(cat spent)" >>"$task.times"
    done
    round=$((round + 1))
  done
}
