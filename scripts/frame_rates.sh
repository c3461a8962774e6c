#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# How long a frame of each of the guide's programs takes: frame_rates.sh [BUILD]. The median of all frames that five
# runs trace, up to 100 each (a program that stands still traces one): transforming, building, tracing; not showing.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}
[ -x "$build/examples/09_4_cornell_box" ] ||
  { echo "frame_rates.sh: $build/examples holds no programs: build them, or name the build they are in" >&2; exit 1; }

milliseconds() {  # program: a line for each frame
  env -u DISPLAY RAYCORE_FRAMES=100 RAYCORE_LOG=frame "$1" 2>&1 >/dev/null |
    sed -nE 's/^raycore: frame .*transform ([0-9.]+) ms, build ([0-9.]+) ms, trace ([0-9.]+) ms.*/\1 \2 \3/p' |
    awk '{ print $1 + $2 + $3 }'
}

echo '| program | frames | ms | frames a second |'
echo '|---|---:|---:|---:|'
for source in examples/0*.cpp examples/[bcd]_*.cpp; do
  name=$(basename "$source" .cpp)
  [ -x "$build/examples/$name" ] || continue
  for _ in 1 2 3 4 5; do milliseconds "$build/examples/$name"; done | sort -n |
    awk -v name="$name" '{ ms[NR] = $1 } END { m = ms[int((NR + 1) / 2)]; printf "| %s | %d | %.2f | %.0f |\n", name, NR, m, 1000 / m }'
done
