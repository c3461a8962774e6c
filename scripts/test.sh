#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Sets up, builds, and runs every test; the quick ones once more with the address and undefined-behaviour sanitizers, and
# those of threads with theirs.
set -eu
cd "$(dirname "$0")/.."
bash scripts/setup.sh

build() {  # preset, arguments of the build
  local preset=$1
  shift
  echo "== $preset: build"
  cmake --preset "$preset" >/dev/null
  cmake --build --preset "$preset" "$@" -- --quiet
  echo "== $preset: tests"
}

build asan
ctest --preset asan --label-regex quick -j "$(nproc)"

# EGL with its contexts, workers and forks, the device.
build tsan --target base_test egl_test rcddi_test
for test in base_test egl_test "rcddi_test --gtest_filter=Devices.*"; do
  DISPLAY='' timeout 600 build/tsan/tests/$test --gtest_brief=1
done

build release
ctest --preset release -j "$(nproc)"
