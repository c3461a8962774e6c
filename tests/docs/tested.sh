#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# No row of api/functions.inc without a test: each function is called in tests/api, and each error it lists is
# expected of it there by EXPECT_RAISES, but for RC_OUT_OF_MEMORY, which few calls can be driven to. Calls without a
# context do not count.
set -euo pipefail
cd "$1"

# "name errors" of each row; errors as in the table.
rows() {
  sed -nE 's/^RC_FUNCTION\([^,]+, (rc[A-Za-z0-9_]+), \(.*\), (Acts|Stored|Accepted), "[^"]*", "([^"]*)", ".*"\)$/\1 \3/p' \
    src/api/functions.inc
}

# The tests without comments, a statement a line.
statements() {
  local file
  for file in tests/api/*_test.cpp; do
    [ "$file" = tests/api/no_context_test.cpp ] || sed 's@//.*@@' "$file"
  done | tr '\n' ' ' | tr ';' '\n'
}

table=$(mktemp)
trap 'rm -f "$table"' EXIT
rows >"$table"
if [ "$(wc -l <"$table")" != "$(grep -c '^RC_FUNCTION(' src/api/functions.inc)" ]; then
  echo "a row of src/api/functions.inc is not understood"
  exit 1
fi

statements | awk -v rows="$table" '
  BEGIN {
    split("IE RC_INVALID_ENUM IV RC_INVALID_VALUE IO RC_INVALID_OPERATION OOM RC_OUT_OF_MEMORY " \
          "SO RC_STACK_OVERFLOW SU RC_STACK_UNDERFLOW", words, " ")
    for (i = 1; i in words; i += 2) tokens[words[i]] = words[i + 1]
  }
  {
    error = ""
    if (match($0, /EXPECT_RAISES\(RC_[A-Z_]+,/)) error = substr($0, RSTART + 14, RLENGTH - 15)
    rest = $0
    while (match(rest, /[A-Za-z0-9_]+\(/)) {
      name = substr(rest, RSTART, RLENGTH - 1)
      called[name] = 1
      if (error != "") raised[name, error] = 1
      rest = substr(rest, RSTART + RLENGTH)
    }
  }
  END {
    while ((getline row < rows) > 0) {
      ++count
      n = split(row, fields, " ")
      name = fields[1]
      if (!(name in called)) {
        print name ": no test calls it"
        ++missing
      }
      for (i = 2; i <= n; ++i) {
        if (!(fields[i] in tokens)) {
          print name ": " fields[i] " is no error"
          ++missing
        } else if (fields[i] != "OOM" && !((name, tokens[fields[i]]) in raised)) {
          print name ": no EXPECT_RAISES(" tokens[fields[i]] ", " name "(...))"
          ++missing
        }
      }
    }
    print count " functions, " missing + 0 " tests missing"
    exit missing > 0
  }'
