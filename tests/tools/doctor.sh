#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# raycore doctor: doctor.sh TOOL SOURCE. What is well, what is wrong, what it says to do, and the exit codes.
set -u
tool=$(realpath "$1") source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
unset DISPLAY
for variable in $(env | sed -nE 's/^(RAYCORE_[A-Z_]*)=.*/\1/p'); do unset "$variable"; done
failed=0
say() {
  echo "$*"
  failed=1
}
# expect CODE PATTERN [VARIABLE=VALUE...]
expect() {
  local code=$1 pattern=$2 got
  shift 2
  env "$@" "$tool" doctor >said 2>errors
  got=$?
  [ $got -eq "$code" ] || say "$*: exit code $got instead of $code"
  grep -qE -- "$pattern" said || say "$*: no \"$pattern\""
  [ ! -s errors ] || say "$*: words on stderr"
  [ $failed -eq 0 ] || cat said errors
}

expect 0 '^note +display +none: .*set DISPLAY'
for line in library settings device instructions threads picture folders films libraries; do
  [ "$(grep -cE "^(ok|note) +$line " said)" -eq 1 ] || say "not one line for $line"
done
expect 1 '^problem +display +:9999: no X server answers' DISPLAY=:9999
expect 1 '^problem +settings .*RAYCORE_DEVICE=gpu is ignored: it is one of cpu, ref, null' RAYCORE_DEVICE=gpu
expect 1 '^problem +settings .*nobody reads RAYCORE_THREAD:' RAYCORE_THREAD=2
expect 0 '^note +device +ref.*unset RAYCORE_DEVICE' RAYCORE_DEVICE=ref
expect 0 '^note +picture +not tried' RAYCORE_DEVICE=null
expect 0 '^note +threads +1000,.*RAYCORE_THREADS=[0-9]+' RAYCORE_THREADS=1000
expect 1 '^problem +folders .*TMPDIR names no folder' TMPDIR=/nowhere
expect 0 '^note +films .*not installed' PATH=/nowhere

"$tool" doctor --json >json || say "--json: exit code $?"
[ "$(grep -cE '"state": "(ok|note)"' json)" -eq 10 ] && grep -q '"ok": true' json || { say "--json:"; cat json; }
DISPLAY=:9999 "$tool" doctor --json | grep -q '"ok": false' || say "--json does not tell of a problem"

# Every variable of the documents is one that doctor knows.
names=$(grep -oE '^\| `RAYCORE_[A-Z_]+' "$source/docs/environment.md" | tr -d '|` ')
[ "$(wc -w <<<"$names")" -ge 10 ] || say "the names of variables are not found"
for name in $names; do expect 0 "^ok +settings +$name=$" "$name="; done

if command -v Xvfb >/dev/null; then
  mkfifo number
  Xvfb -displayfd 9 -nolisten tcp -screen 0 64x64x24 9>number 2>/dev/null &
  server=$!
  read -r number <number
  expect 0 '^ok +display +:[0-9]+, depth 24' "DISPLAY=:$number"
  grep -qE '^(ok|note) +shared memory ' said || say "nothing about shared memory"
  kill $server
  wait $server 2>/dev/null
fi
exit $failed
