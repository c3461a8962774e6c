#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Sets up, builds, and renders every picture of the guide into out/, a line for each. With a display the Cornell
# box opens in a window at the end; Esc closes it.
set -eu
cd "$(dirname "$0")/.."
bash scripts/setup.sh
[ -x build/release/examples/09_4_cornell_box ] || echo "Building: some minutes, the first time."
cmake --preset release >/dev/null
cmake --build --preset release -- --quiet
mkdir -p out

# The frame that is kept where things move, and the arguments that make the guide's picture.
frame_of() {
  case $1 in
    04_2_lights) echo 5 ;;
    06_5b_reflection | 09_4_cornell_box) echo 15 ;;
    06_5c_refraction) echo 12 ;;
    b_cube) echo 13 ;;
    c_earth) echo 22 ;;
    d_1_5_egl) echo 9 ;;
    *) echo 1 ;;
  esac
}
arguments_of() {
  case $1 in
    09_4_cornell_box) echo 0.2 ;;
    b_cube) echo figure ;;
  esac
}

printf '%-34s %-10s %10s %10s %10s\n' picture size triangles rays 'ms'
for source in examples/*.cpp; do
  name=$(basename "$source" .cpp)
  read -r -a arguments <<<"$(arguments_of "$name")"
  output=$(env -u DISPLAY RAYCORE_LOG=frame RAYCORE_FRAMES="$(frame_of "$name")" RAYCORE_CAPTURE="out/$name.png" \
    "build/release/examples/$name" ${arguments[@]+"${arguments[@]}"} 2>&1) || {
    echo "$output" >&2
    echo "demo: $name failed" >&2
    exit 1
  }
  # raycore: frame 1: 800 x 480, 12 triangles (...), 345 rays (...), build 0.10 ms, trace 9.90 ms
  grep '^raycore: frame ' <<<"$output" | tail -n 1 | sed 's/([^)]*)//g' | awk -v name="out/$name.png" '{
    for (i = 1; i < NF; ++i) if ($(i + 1) == "x") size = $i "x" $(i + 2) + 0
    for (i = 2; i <= NF; ++i) {
      if ($i ~ /^triangles/) triangles = $(i - 1)
      if ($i ~ /^rays/) rays = $(i - 1)
      if ($(i - 1) == "build" || $(i - 1) == "trace") milliseconds += $i
    }
    printf "%-34s %-10s %10d %10d %10.1f\n", name, size, triangles, rays, milliseconds }'
done

if [ -n "${DISPLAY:-}" ] && [ -z "${CI:-}" ]; then
  echo "The Cornell box in a window: Esc ends it."
  exec build/release/examples/09_4_cornell_box 0.2
fi
