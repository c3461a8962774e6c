#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Parts of pages that are made from other files: what the port of examples/port needed besides renaming.
# book_parts.sh writes them; book_parts.sh --check fails where a file is not what it would write.
set -euo pipefail
cd "$(dirname "$0")/.."

port() {
  sed -e 's/\bgl\([A-Z]\)/rc\1/g; s/\bGL_/RC_/g; s/\bGL\(uint\)/RC\1/g; s|<GLES/gl.h>|<RC/rcu.h>|' examples/port/before.c |
    diff -U1 --label 'before.c, renamed' --label after.c - examples/port/after.c | sed 's/ @@.*/ @@/' || true
}

if [ "${1:-}" = --check ]; then
  port | cmp - docs/images/port.diff
else
  port >docs/images/port.diff
fi
