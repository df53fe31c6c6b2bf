#!/bin/sh
# usage: measured.sh FOLDER NAME COMMAND…
#
# Runs COMMAND, a suite of tests, and writes the processor time that it took into FOLDER, as a file NAME in which each
# "/" is a "-": the shell's own lines of `times`. Exit code of COMMAND.

folder=$1
file=$(echo "$2" | tr / -)
shift 2
"$@"
code=$?
mkdir -p "$folder" && times >"$folder/$file"
exit $code
