#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Examples and quick tests under valgrind's memcheck; ends with an error if it finds one.
# Usage: scripts/valgrind.sh [build folder]; by default build/release.
# Valgrind 3.19 does not know AVX-512: RAYCORE_INSTRUCTION_SET leaves it out.
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/release}
command -v valgrind >/dev/null || { echo "valgrind is not here"; exit 77; }

libraries=$(scripts/valgrind_libraries.py "$build/examples/d_1_5_egl" "$build/valgrind")
export RAYCORE_INSTRUCTION_SET=avx2 RAYCORE_THREADS=2 RAYCORE_FRAMES=1 RAYCORE_LOG=warning DISPLAY=
checked() {
  echo "== $*"
  LD_LIBRARY_PATH=$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} valgrind --quiet --error-exitcode=9 --leak-check=full \
    --errors-for-leak-kinds=definite --suppressions=scripts/valgrind.supp "$@" >/dev/null
}

find "$build/examples" -type f -executable -not -path '*/CMakeFiles/*' | sort | while read -r example; do
  checked "$example"
done
RAYCORE_ACCEL=kdtree checked "$build/examples/02_5a_perspective"
checked "$build/tests/api/symbols/reload" "$build/src/egl/libRayCoreAPI.so" 3
checked "$build/tests/base_test" --gtest_filter='Settings*:MemoryLimit*:ControlGroup*-*WhatTheSystemRefuses*'
# Its allocator, which fails, is to be used, and all of its frames drawn.
unset RAYCORE_FRAMES
checked --soname-synonyms=somalloc=nouserintercepts "$build/tests/shortage_test" --gtest_filter='*Once*'
echo "valgrind: clean"
