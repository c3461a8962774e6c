#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# clang-tidy over the sources as they are compiled, several as one, and the kernels for one instruction set.
#
#   tidy.sh [part...]     sources whose names have one of the parts, as src/api or png.cpp, and those that are compiled
#                         with them; all without
#
# Remarks are told once, however many files see them; where there is one, the exit code is 1.
set -eu
cd "$(dirname "$0")/.."
bash scripts/setup.sh fuzz

build=build/tidy  # a tree of its own: Clang cannot read GCC's precompiled headers
cmake --preset release -B $build -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
cp tests/.clang-tidy $build/tests/  # sources that are joined lie there
parts=$(IFS='|'; echo "${*:-.}")
# Joined sources are in a file that includes them.
mapfile -t files < <(sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' $build/compile_commands.json | grep -v '\.c$' | sort -u |
  while read -r file; do
    if grep -qE -- "$parts" <<<"${file#"$PWD"/}" || { [[ $file = *.cxx ]] && grep -qE -- "^#include .*($parts)" "$file"; }; then
      echo "$file"
    fi
  done)
[ ${#files[@]} -gt 0 ] || { echo "no source has one of: $*" >&2; exit 1; }
echo "${#files[@]} files" >&2
said=$(mktemp)
trap 'rm -f "$said"' EXIT
code=0
# That joined sources are included is what the check of that name is about.
printf '%s\n' "${files[@]}" | nice -n 19 xargs -P "$(nproc)" -n 1 clang-tidy -p $build --quiet \
  --checks=-bugprone-suspicious-include --header-filter="$PWD/(src|include|examples|tools|tests|bench|python)/.*" \
  --extra-arg=-DHWY_COMPILE_ONLY_STATIC >"$said" 2>&1 || code=$?
remarks=$(grep -E '(warning|error): ' "$said" | sort -u)
[ -z "$remarks" ] || { echo "$remarks"; exit 1; }
[ $code -eq 0 ] || { tail -n 5 "$said" >&2; exit $code; }
