#!/bin/sh
# usage: docs/make_pictures.sh [DATA]
#
# Makes every picture of README.md and of the pages under docs/ by the commands that are printed in them: each of their
# lines that begins with "./mirrorball" and writes to docs/pictures/ is run as it stands, so that the text cannot say
# another command than the one that made the picture. So are those that write to $MADE/, a folder for what later ones
# read.
#
#   DATA                  the folder with the real inputs, which the commands call $DATA;
#                         else $DATA, else $MIRRORBALL_DATA, else ../shared/data beside the checkout
#   MIRRORBALL_PROGRAM=…  runs another program than ./mirrorball
#
# A window needs a display, even one that nobody sees: without one xvfb-run makes it (Debian: xvfb).
#
# Plots (.svg) are made by the benchmarks that the pages name, and hidden_before.jpg by `hidden_light sheet` before a
# technique was changed; only their sizes are looked at here.
#
# Exit code 1 if a command fails, a picture is shown that no command makes or made and not shown, or one is larger than
# 300 KB (all together: 5 MB).
set -eu
given=${1:-${DATA:-${MIRRORBALL_DATA:-}}}
if [ -n "$given" ]; then
  given=$(cd -- "$given" && pwd -P) || exit 1
fi
cd -P -- "$(dirname -- "$0")/.."
DATA=${given:-$(cd ../shared/data && pwd -P)}
export DATA
program=${MIRRORBALL_PROGRAM:-./mirrorball}
largest_bytes=307200
all_bytes=5242880

exit_code=0
complain() {
  echo "make_pictures: $*" >&2
  exit_code=1
}

MADE=$(mktemp -d)
trap 'rm -rf "$MADE"' EXIT
export MADE

# The arguments of each command, once. The commands are this repository's own text: the shell may read them.
commands=$(sed -n 's#^\./mirrorball \(.* \(docs/pictures\|\$MADE\)/.*\)$#\1#p' README.md docs/*.md docs/*/*.md | awk '!seen[$0]++')
# What a command writes is named last: after -o, --screenshot of `view`, or --heat-map of `compare`, which reads others.
made=$(echo "$commands" | sed -n 's|.* docs/pictures/\([^ ]*\).*|\1|p' | sort)
shown=$(cat README.md docs/*.md docs/*/*.md | grep -o '[("][a-z./]*pictures/[A-Za-z0-9_]*\.[a-z]*' | sed 's|.*/||' | sort -u)
is_plot() { [ "${1##*.}" = svg ] || [ "$1" = hidden_before.jpg ]; }

for name in $(echo "$made" | uniq -d); do complain "two commands make $name"; done
for name in $shown; do
  is_plot "$name" || echo "$made" | grep -qx "$name" || complain "no command makes $name"
done

display=
[ -n "${DISPLAY-}" ] || display="xvfb-run -a"

mkdir -p docs/pictures
while IFS= read -r arguments; do
  echo "$program $arguments"
  case $arguments in view*) on=$display ;; *) on= ;; esac
  eval "$on \"\$program\" $arguments" </dev/null || complain "failed: $arguments"
done <<END
$commands
END

total=0
for path in docs/pictures/*; do
  name=${path##*/}
  bytes=$(wc -c <"$path")
  total=$((total + bytes))
  is_plot "$name" || echo "$made" | grep -qx "$name" || complain "no command makes $name any more; remove it"
  echo "$shown" | grep -qx "$name" || complain "no page shows $name"
  [ "$bytes" -le "$largest_bytes" ] || complain "$name has $bytes bytes, more than $largest_bytes"
done
[ "$total" -le "$all_bytes" ] || complain "the pictures have $total bytes, more than $all_bytes"
echo "$(echo "$made" | wc -l) pictures, $((total / 1024)) KB"
exit "$exit_code"
