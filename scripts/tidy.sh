#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# clang-tidy over the sources as they are compiled, several as one, and the kernels for one instruction set.
#
#   tidy.sh [part...]     files of the compile database whose names have one of the parts, as src/api, tests; all without
#
# Remarks are counted once, however many files see them; there is one: exit code 1.
set -eu
cd "$(dirname "$0")/.."
bash scripts/setup.sh fuzz

cmake --preset release >/dev/null
parts=$(IFS='|'; echo "${*:-.}")
mapfile -t files < <(sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' build/release/compile_commands.json |
  grep -vE '/cmake_pch\.|\.c$' | sort -u | grep -E -- "$parts")
[ ${#files[@]} -gt 0 ] || { echo "no file has one of: $*" >&2; exit 1; }
echo "${#files[@]} files" >&2
# Joined sources are included; that is what the check of that name is about.
remarks=$(printf '%s\n' "${files[@]}" | nice -n 19 xargs -P "$(nproc)" -n 1 clang-tidy -p build/release --quiet \
  --checks=-bugprone-suspicious-include --header-filter="$PWD/(src|include|examples|tools|tests|bench|python)/.*" \
  --extra-arg=-DHWY_COMPILE_ONLY_STATIC 2>/dev/null | sort | uniq | grep -E '(warning|error): ' || true)
[ -z "$remarks" ] && exit 0
printf '%s\n' "$remarks"
exit 1
