#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Which lines of src/ the corpora of the fuzz targets run, by file: builds the preset coverage, replays, and prints
# llvm-cov's table. With "tests" the quick tests are run besides.
#
#   coverage.sh [tests]
set -eu
cd "$(dirname "$0")/.."
bash scripts/setup.sh fuzz

build=build/coverage
targets=(fuzz_api fuzz_accel fuzz_geometry fuzz_texture)
tests=(api_test egl_test rcddi_test accel_test rchal_test clip_test base_test)
# One instruction set: kernels compiled for others would count as lines that never run.
# Paths are in what llvm-cov reads: no object may come from another tree.
export CCACHE_DISABLE=1
cmake --preset coverage -DCMAKE_CXX_FLAGS=-DHWY_COMPILE_ONLY_STATIC >/dev/null
programs=("${targets[@]}")
[ "${1:-}" != tests ] || programs+=("${tests[@]}")
nice -n 19 cmake --build --preset coverage --target "${programs[@]}" -- --quiet

# Tools of the compiler's version, under their own names or Debian's.
version=$(clang -dumpversion | cut -d . -f 1)
tool() { command -v "$1-$version" || command -v "$1"; }

rm -rf "$build/profiles"
export DISPLAY='' RAYCORE_THREADS=2 RAYCORE_LOG=off LLVM_PROFILE_FILE="$PWD/$build/profiles/%p.profraw"
objects=()
for target in "${targets[@]}"; do
  for trace in '' /dev/null; do
    RAYCORE_TRACE=$trace nice -n 19 "$build/tests/fuzz/$target" "tests/fuzz/corpus/$target" "build/fuzz/found/$target" >/dev/null
  done
  objects+=(-object "$build/tests/fuzz/$target")
done
if [ "${1:-}" = tests ]; then
  for test in "${tests[@]}"; do
    program=$(find "$build/tests" -name "$test" -type f)
    nice -n 19 "$program" >/dev/null || echo "$test failed" >&2
    objects+=(-object "$program")
  done
fi
"$(tool llvm-profdata)" merge -sparse "$build"/profiles/*.profraw -o "$build/coverage.profdata"
"$(tool llvm-cov)" report -instr-profile "$build/coverage.profdata" "${objects[@]:1}" src \
  -show-functions=0 -show-region-summary=0 -show-branch-summary=0
