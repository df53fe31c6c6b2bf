#!/bin/sh
# usage: check_words.sh SOURCE_DIR [--update]
#
# Counts the words that are to be avoided (docs/glossary.md), each row of words_to_avoid.txt an extended regular
# expression, whatever its letters' case. Fails where one occurs more often than its row allows, and where it occurs less
# often, so that the counts are lowered: --update does that, and raises none.

set -eu
cd -- "$1"
export LC_ALL=C.UTF-8
rows=tests/house/words_to_avoid.txt
new=$(mktemp)
trap 'rm -f "$new"' EXIT

countOf() {
  grep -rIoiE --exclude=glossary.md --exclude=words_to_avoid.txt --exclude=check_words.sh --exclude-dir=node_modules \
    -- "$1" README.md apps bench cmake docs examples formula fuzz mirrorball shaders src test tests | wc -l
}

grep '^#' $rows >"$new"
code=0
grep -v '^#' $rows | {
  while read -r allowed pattern; do
    count=$(countOf "$pattern")
    [ "$count" -le "$allowed" ] || {
      printf '%s occurs %d times, and %d are allowed: docs/glossary.md says what to write instead\n' \
        "$pattern" "$count" "$allowed"
      code=1
    }
    if [ "$count" -lt "$allowed" ] && [ "${2-}" != --update ]; then
      printf '%s occurs %d times only: lower its count by sh tests/house/check_words.sh . --update\n' "$pattern" "$count"
      code=1
    fi
    [ "$count" -lt "$allowed" ] || count=$allowed
    printf '%5d %s\n' "$count" "$pattern" >>"$new"
  done
  exit $code
} || code=1
[ "${2-}" != --update ] || cat "$new" >$rows
exit $code
