#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Sets up, builds, and runs every test; the quick ones once more with the address and undefined-behaviour sanitizers.
set -eu
cd "$(dirname "$0")/.."
bash scripts/setup.sh

run() {  # preset, arguments of ctest
  local preset=$1
  shift
  echo "== $preset: build"
  cmake --preset "$preset" >/dev/null
  cmake --build --preset "$preset" -- --quiet
  echo "== $preset: tests"
  ctest --preset "$preset" "$@"
}

run asan --label-regex quick -j "$(nproc)"
run release -j "$(nproc)"
