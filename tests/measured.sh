#!/bin/sh
# usage: measured.sh FOLDER NAME COMMAND…
#
# Runs COMMAND, and if it succeeds writes the CPU time that it took into FOLDER, as a file NAME in which each "/" is a "-":
# the shell's own lines of `times`. Ends as COMMAND does, by its exit code or its signal.

folder=$1
file=$(echo "$2" | tr / -)
shift 2
"$@"
code=$?
[ $code -le 128 ] || kill -"$((code - 128))" $$
[ $code -ne 0 ] || { mkdir -p "$folder" && times >"$folder/$file"; }
exit $code
