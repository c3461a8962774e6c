#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# One file of the malformed set: malformed.sh TOOL FILE reject|tolerate MODEL. Rejected: exit code 1 and one line that
# names the file. Tolerated: that, or a picture. Never a crash, of the reader's process neither, nor more than 1 GiB of
# memory (address space; with the address sanitizer, which reserves terabytes, what ASAN_OPTIONS allows) or 5 seconds of
# a processor. Pictures of the set are given to MODEL as a background.
set -u
tool=$1 file=$2 expected=$3 model=$4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset DISPLAY
[ -n "${ASAN_OPTIONS:-}" ] || ulimit -v 1048576
ulimit -t 5

fail() {
  echo "$file: $*"
  cat "$scratch/errors"
  exit 1
}

case $file in
  *.png | *.jpg | *.jpeg | *.bmp) command=(render "$model" --background "$file") ;;
  *) command=(render "$file") ;;
esac
"$tool" "${command[@]}" -q --size 24x16 --samples 1 -o "$scratch/picture.png" 2>"$scratch/errors"
code=$?
lines=$(wc -l <"$scratch/errors")

grep -qE "the reader (crashed|failed|said)" "$scratch/errors" && fail "the reader crashed"
if [ $code -eq 0 ]; then
  [ "$expected" = tolerate ] || fail "was accepted"
  [ -s "$scratch/picture.png" ] || fail "no picture"
  [ "$lines" -eq 0 ] || fail "$lines lines on stderr in spite of success"
else
  [ $code -eq 1 ] || fail "exit code $code"
  [ "$lines" -eq 1 ] || fail "$lines lines on stderr"
  grep -qF "$file: " "$scratch/errors" || fail "the message does not name the file"
fi
