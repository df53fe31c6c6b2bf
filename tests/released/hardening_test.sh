#!/bin/sh
# usage: hardening_test.sh
#
# Checks that the program at MIRRORBALL_PROGRAM was built as distributions build programs that read files of strangers
# (cmake/MirrorballSettings.cmake). Skipped where that is not set, as outside of `./test --all`.

set -u
[ -n "${MIRRORBALL_PROGRAM-}" ] || exit 77

status=0

# usage: expect WHAT PATTERN OUTPUT
expect() {
  printf '%s\n' "$3" | grep -q -- "$2" && return
  echo "$MIRRORBALL_PROGRAM: has no $1" >&2
  status=1
}

dynamic=$(readelf -dW "$MIRRORBALL_PROGRAM") || exit 1
symbols=$(readelf --dyn-syms -W "$MIRRORBALL_PROGRAM") || exit 1
segments=$(readelf -lW "$MIRRORBALL_PROGRAM") || exit 1
expect 'table of calls that is locked before the first one (-z now)' 'BIND_NOW\|NOW' "$dynamic"
expect 'tables that are read-only (-z relro)' 'GNU_RELRO' "$segments"
expect 'addresses that change from run to run (PIE)' 'PIE' "$dynamic"
expect 'guards on its stacks (-fstack-protector-strong)' '__stack_chk_fail' "$symbols"
expect 'copies that know the size of their place (_FORTIFY_SOURCE)' '__mem[a-z]*_chk\|_chk@' "$symbols"
exit $status
