#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# docs/extensions: a document for each name that rcGetString(RC_EXTENSIONS) returns, and no other; each has its
# sections and a line in the index, names tokens with their values, and its example compiles as C99.
set -euo pipefail
cd "$1"
cc=$2 documents=docs/extensions
failed=0
fail() {
  echo "$*"
  failed=1
}

names=$(sed -n '/kExtensions =/,/;/p' src/api/entry_state.cpp | grep -oE 'RC_RCX_[A-Za-z0-9_]+')
[ -n "$names" ] || fail "src/api/entry_state.cpp: kExtensions is not found"

for name in $names; do
  document=$documents/$name.md
  if [ ! -f "$document" ]; then
    fail "$document is missing"
    continue
  fi
  for section in "# $name" '## New tokens' '## Behaviour' '## Errors' '## Interactions' '## Example'; do
    grep -qxF "$section" "$document" || fail "$document: there is no '$section'"
  done
  grep -qF "[$name]($name.md)" $documents/README.md || fail "$documents/README.md does not name $name"
done

for document in "$documents"/RC_*.md; do
  name=$(basename "$document" .md)
  grep -qx "$name" <<<"$names" || fail "$document: RC_EXTENSIONS does not name it"
done

# Tokens of our own block: in a document, with the header's value.
while read -r _ token value _; do
  grep -qE "\`$token\` \| $value " "$documents"/RC_*.md || fail "$token = $value is in no document"
done < <(grep -E '^#define RC_[A-Z_]+ +0x5243' include/RC/rctokens.h)

for document in "$documents"/*.md; do
  code=$(awk '/^```$/ { code = 0 } code; /^```c$/ { code = 1 }' "$document")
  if [ -z "$code" ]; then
    fail "$document: there is no example"
  elif ! "$cc" -std=c99 -Wall -Wextra -Werror -fsyntax-only -Iinclude -x c - <<<"$code"; then
    fail "$document: the example does not compile"
  fi
done
exit $failed
