#!/bin/bash
# usage: fuzz/run.sh HARNESS SECONDS [OPTION…]
#
# Runs a harness at the lowest priority until it has had so many seconds of the processor, in pieces of ten minutes by
# the clock at most. What reached new code stays in build/fuzz/corpus/HARNESS, where the next run goes on;
# build/fuzz/corpus/HARNESS.runs has a line a piece, and all of them are summed at the end. It stops at the first
# finding, which is then in build/fuzz/findings. OPTIONs go to libFuzzer.
set -eu
[ $# -ge 2 ] || { sed -n 's/^# usage/usage/p' "$0" >&2; exit 2; }
harness=$1 seconds=$2
shift 2
folder=$(cd "$(dirname "$0")/.." && pwd)
build=$folder/build/fuzz
own=$build/corpus/$harness runs=$build/corpus/$harness.runs log=$build/corpus/$harness.log
seeds=$folder/fuzz/corpus/$harness
[ -d "$seeds" ] || seeds=
mkdir -p "$own" "$build/empty" "$build/findings"
cd "$build/empty"  # a model may name files beside it

TIMEFORMAT="time %U %S"
run_timed() { time nice -n 19 chrt -i 0 "$@"; }

used=0 status=0
while [ $used -lt "$seconds" ] && [ $status -eq 0 ]; do
  piece=$((seconds - used < 600 ? seconds - used : 600))
  # -timeout is by the clock, of which a busy machine may leave this little. -close_fd_mask: what libraries print of
  # damaged files would be gigabytes.
  run_timed "$build/fuzz/fuzz_$harness" "$own" ${seeds:+"$seeds"} \
    -max_total_time=$piece -max_len=4096 -timeout=120 -rss_limit_mb=4096 -close_fd_mask=3 -print_final_stats=1 \
    -artifact_prefix="$build/findings/$harness-" "$@" >"$log" 2>&1 || status=$?
  line=$(awk -v status=$status '
    /^stat::number_of_executed_units/ { inputs = $2 }
    / cov: / { for (i = 1; i < NF; ++i) if ($i == "cov:") edges = $(i + 1) }
    /^time / { used = $2 + $3 }
    END { printf "%d seconds, %d inputs, %d edges, ended with %d\n", used + 1, inputs, edges, status }' "$log")
  echo "$line" >>"$runs"
  used=$((used + ${line%% *}))
done
awk '{ seconds += $1; inputs += $3; edges = $5; findings += $NF > 0 }
     END { printf "%d seconds of the processor, %d inputs, %d edges covered, %d findings\n",
           seconds, inputs, edges, findings }' "$runs"
exit $status
