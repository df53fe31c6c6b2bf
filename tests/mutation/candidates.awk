# usage: git grep -n '' COMMIT -- FILE… | LC_ALL=C awk -v seed=1 -f candidates.awk | sort -k1,1n
#
# Reads lines "COMMIT:path:number:text" and writes one mutation for each line of code that has any, in columns with a
# tab between: a random key to sort by, group, path, line, column (from 1, in bytes), old token, new token, text of the
# line. The group is 0 for a formula, 1 for a core module, 2 for a reader.
#
# Nothing but the text is known here, no types: a few of the mutations do not compile.

BEGIN {
  # Park and Miller's generator: its products are exact in any awk, and awk's own rand() differs from one to another.
  # The seed is a power of another multiplier: seeds side by side, taken as they are, choose much the same lines.
  state = 12345
  for (i = 0; i < seed + 10; i++) state = state * 48271 % 2147483647
  count = split("< <= > >= == != && || + - * / % << >> & | ^", from, " ")
  split("<= < >= > != == || && - + / * / >> << | & |", to, " ")
  for (i = 1; i <= count; i++) replacement[from[i]] = to[i]
  digits = "0123456789abcdef"
}

function random() {
  state = state * 16807 % 2147483647
  return state / 2147483647
}

function spaces(length_, character,    text) {
  text = sprintf("%" length_ "s", "")
  if (character != " ") gsub(/ /, character, text)
  return text
}

# How many characters a literal in quotes has from `start` on; a raw string may end in a later line.
function literalLength(text, start, quote,    i, c) {
  for (i = start + 1; i <= length(text); i++) {
    c = substr(text, i, 1)
    if (c == "\\") i++
    else if (c == quote) return i - start + 1
  }
  return length(text) - start + 1
}

# The text with comments as spaces and literals as quotes, of the same length. `until` is what ends a comment or a raw
# string that began in an earlier line.
function codeOf(text,    code, at, c, n, filler) {
  code = ""
  while (text != "") {
    if (until != "") {
      at = index(text, until)
      n = at ? at + length(until) - 1 : length(text)
      filler = until == "*/" ? " " : "\""
      if (at) until = ""
    } else if (!match(text, /["'\/]/)) {
      return code text
    } else {
      n = RSTART - 1
      code = code substr(text, 1, n)
      text = substr(text, n + 1)
      c = substr(text, 1, 1)
      filler = c
      n = 1
      if (substr(text, 1, 2) == "//") {
        return code spaces(length(text), " ")
      } else if (substr(text, 1, 2) == "/*") {
        until = "*/"
        continue
      } else if (c == "\"" && code ~ /(^|[^A-Za-z0-9_])R$/) {
        at = index(text, "(")
        until = ")" substr(text, 2, at - 2) "\""
        continue
      } else if (c == "\"" || (c == "'" && code !~ /[0-9A-Fa-f]$/)) {
        n = literalLength(text, 1, c)
      }
    }
    # A slash, and a quote between the digits of a number, stay.
    code = code (n == 1 ? substr(text, 1, 1) : spaces(n, filler))
    text = substr(text, n + 1)
  }
  return code
}

# Lines in which a changed token says nothing about tests: it does not compile, or has no effect.
function isLeftOut(code) {
  if (waiting) {
    if (code ~ /;/) waiting = 0
    return 1
  }
  if (code ~ /^ *#/) return 1
  if (code ~ /(^|[^A-Za-z_])(static_assert|assert) *\(/) {
    waiting = code !~ /;/
    return 1
  }
  return code ~ /(^|[^A-Za-z_])(template|operator|requires|concept|using|alignas|typename)([^A-Za-z_]|$)/ ||
         code ~ /(reserve|to_string|parallelFor[A-Za-z]*)\(|std::(hash|format)/
}

# Words of code that joins strings, paths or streams with the operators of numbers.
function joinsText(code) {
  return code ~ /"|string|text|Text|path|Path|name|folder|[Ff]ile|message|suffix|fs::|stream|std::cout|key/
}

function add(column, old, new, is_number) {
  found[is_number]++
  place[is_number, found[is_number]] = column
  olds[is_number, found[is_number]] = old
  news[is_number, found[is_number]] = new
}

# Operators stand between spaces, or at the end of the line; a unary minus has none behind it.
function findOperators(code,    rest, before, old) {
  rest = code " "
  before = 0
  while (match(rest, / [-<>=!&|+*\/%^]+ /)) {
    old = substr(rest, RSTART + 1, RLENGTH - 2)
    if (old in replacement && substr(rest, 1, RSTART) ~ /[^ ]/ &&
        !(old ~ /^([+\/]|<<|>>)$/ && joinsText(code)))
      add(before + RSTART + 1, old, replacement[old], 0)
    before += RSTART + RLENGTH - 2
    rest = substr(rest, RSTART + RLENGTH - 1)
  }
}

function nextHexadecimal(number,    body, suffix, last, at) {
  match(number, /[uUlLzZ]*$/)
  suffix = substr(number, RSTART)
  body = substr(number, 1, RSTART - 1)
  last = tolower(substr(body, length(body)))
  at = index(digits, last)
  return substr(body, 1, length(body) - 1) (at == 16 ? "e" : substr(digits, at + 1, 1)) suffix
}

# Integers are one more, others a tenth more. "" where that has no effect that a test could see: powers of ten that only
# keep a division or a search from running away.
function changed(number,    plain, suffix, value) {
  if (number ~ /^0[xX]/) return nextHexadecimal(number)
  if (number ~ /^0[bB0-9]/) return ""
  match(number, /[fFuUlLzZ]*$/)
  suffix = substr(number, RSTART)
  plain = substr(number, 1, RSTART - 1)
  gsub(/'/, "", plain)
  if (plain !~ /[.eE]/ && suffix !~ /[fF]/)
    return length(plain) > 15 ? "" : sprintf("%.0f", plain + 1) suffix
  value = plain + 0
  if (value != 0 && (value < 1e-5 || value > 1e5)) return ""
  plain = sprintf(suffix ~ /[fF]/ ? "%.9g" : "%.15g", value == 0 ? 0.1 : 1.1 * value)
  return (plain ~ /[.e]/ ? plain : plain ".0") suffix
}

# Not within names, nor as arguments of templates.
function findNumbers(code,    rest, before, old, new, behind, front) {
  rest = code
  before = 0
  while (match(rest, /[0-9][0-9A-Za-z_.']*([eE][-+][0-9]+[fF]?)?/)) {
    front = before + RSTART > 1 ? substr(code, before + RSTART - 1, 1) : " "
    old = substr(rest, RSTART, RLENGTH)
    before += RSTART + RLENGTH - 1
    rest = substr(rest, RSTART + RLENGTH)
    behind = substr(rest, 1, 1)
    if (front ~ /[A-Za-z0-9_.<"]/ || behind == ">" || behind == "\"") continue
    if (old !~ /^(0[xX][0-9A-Fa-f']+[uUlLzZ]*|[0-9][0-9']*[uUlLzZ]*|[0-9]+\.?[0-9]*([eE][-+]?[0-9]+)?[fF]?)$/) continue
    new = changed(old)
    if (new != "") add(before - length(old) + 1, old, new, 1)
  }
}

function groupOf(path) {
  if (path ~ /^formula\//) return 0
  return path ~ /^src\/mirrorball\/(codec|scene\/gltf|scene\/mesh_file)\// ? 2 : 1
}

{
  text = substr($0, index($0, ":") + 1)
  path = substr(text, 1, index(text, ":") - 1)
  text = substr(text, length(path) + 2)
  line = substr(text, 1, index(text, ":") - 1)
  text = substr(text, length(line) + 2)
  if (line == 1) {
    until = ""
    waiting = 0
    rows_of_table = 0
  }
  code = codeOf(text)
  if (isLeftOut(code) || text ~ /\t/) next
  # Of a table of numbers, the first rows: there are hundreds, all alike.
  rows_of_table = code ~ /^[-0-9A-Fa-fxXuU., {}()+]+;?$/ && code ~ /[0-9]/ ? rows_of_table + 1 : 0
  if (rows_of_table > 3) next

  found[0] = found[1] = 0
  findOperators(code)
  findNumbers(code)
  if (!found[0] && !found[1]) next
  kind = !found[0] ? 1 : !found[1] ? 0 : random() < 0.5
  chosen = kind SUBSEP (int(random() * found[kind]) + 1)
  printf "%.0f\t%d\t%s\t%d\t%d\t%s\t%s\t%s\n", random() * 2147483647, groupOf(path), path, line,
    place[chosen], olds[chosen], news[chosen], text
}
