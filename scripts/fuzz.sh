#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Fuzzes the library and the command's readers: builds the preset fuzz and runs each target, one after the other, at
# the lowest priority.
#
#   fuzz.sh [seconds] [target...]     60 seconds, all targets: fuzz_api, fuzz_texture, fuzz_geometry, ...
#
# Inputs that reached something new stay in build/fuzz/found/TARGET and are used again the next time; inputs that broke
# something are in build/fuzz/broken. RAYCORE_SCENES names a folder of models, whose small ones fuzz_scene begins with.
# fuzz.sh merge TARGET puts the inputs that matter into the corpus of the tree.
set -eu
cd "$(dirname "$0")/.."
bash scripts/setup.sh fuzz

merge=0
seconds=60
case ${1:-} in
  merge) merge=1 && shift ;;
  [0-9]*) seconds=$1 && shift ;;
esac
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(fuzz_api fuzz_accel fuzz_geometry fuzz_texture fuzz_scene)

build=build/fuzz corpora=tests/fuzz/corpus
cmake --preset fuzz >/dev/null
nice -n 19 cmake --build --preset fuzz --target "${targets[@]}" -- --quiet
mkdir -p "$build/broken"

export DISPLAY='' RAYCORE_THREADS=1 RAYCORE_LOG=off
export ASAN_OPTIONS=allocator_may_return_null=1:detect_stack_use_after_return=0 UBSAN_OPTIONS=print_stacktrace=1

bash tests/fuzz/api_dictionary.sh >"$build/fuzz_api.dict"
cp tests/fuzz/gltf.dict "$build/fuzz_scene.dict"

# Models by the byte that names their reader, see fuzz_scene.cpp.
seed_models() {
  local model code
  find "${RAYCORE_SCENES:-../shared/scenes}" -type f -size -64k 2>/dev/null | while read -r model; do
    case $model in
      *.glb | *.gltf) code='\000' ;;
      *.obj) code='\001' ;;
      *) continue ;;
    esac
    { printf "$code" && cat "$model"; } >"$1/model_$(echo "$model" | cksum | cut -d ' ' -f 1)"
  done
}

for target in "${targets[@]}"; do
  found=$build/found/$target
  mkdir -p "$found" "$corpora/$target"
  if [ $merge = 1 ]; then
    merged=$(mktemp -d)
    nice -n 19 "$build/tests/fuzz/$target" -merge=1 -max_len=4096 "$merged" "$corpora/$target" "$found"
    mv -n "$merged"/* "$corpora/$target"
    continue
  fi
  [ "$target" != fuzz_scene ] || seed_models "$found"
  options=(-timeout=60 -rss_limit_mb=4096 -print_final_stats=1
    -artifact_prefix="$build/broken/$target-")
  [ ! -f "$build/$target.dict" ] || options+=(-dict="$build/$target.dict")
  # What the libraries that read pictures leave behind when they give one up is gone with the loader's process.
  leaks=1
  [ "$target" != fuzz_scene ] || leaks=0
  # Half of the time calls are traced, which reads all their arguments once more.
  traces=('')
  [ "$target" != fuzz_api ] || traces=('' /dev/null)
  for trace in "${traces[@]}"; do
    echo "== $target ${trace:+traced}"
    RAYCORE_TRACE=$trace ASAN_OPTIONS=$ASAN_OPTIONS:detect_leaks=$leaks nice -n 19 "$build/tests/fuzz/$target" \
      -max_total_time=$((seconds / ${#traces[@]})) "${options[@]}" "$found" "$corpora/$target" 2>"$build/$target.log" || {
      tail -n 60 "$build/$target.log"
      exit 1
    }
    grep -E '^(Done|stat::)' "$build/$target.log"
  done
done
