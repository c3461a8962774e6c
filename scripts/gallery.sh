#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Measures the programs of examples/gallery: gallery.sh [BUILD]. One frame at 800 x 480 with one sample a pixel on one
# thread; the time is the processor's, start of the program and its textures included, so that a busy machine tells
# nearly the same as a quiet one. The best of three runs, as a table on stdout.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}
TIMEFORMAT='%U %S'

# "triangles rays milliseconds"
run_once() {
  local log
  log=$(mktemp)
  { time env -u DISPLAY RAYCORE_THREADS=1 RAYCORE_SAMPLES=1 RAYCORE_LOG=frame RAYCORE_FRAMES=1 "$1" 2>"$log"; } 2>"$log.time"
  grep '^raycore: frame ' "$log" | sed 's/([^)]*)//g' | awk -v times="$(cat "$log.time")" '{
    for (i = 2; i <= NF; ++i) {
      if ($i ~ /^triangles/) triangles = $(i - 1)
      if ($i ~ /^rays/) rays = $(i - 1)
    }
    split(times, seconds, " ")
    print triangles, rays, 1000 * (seconds[1] + seconds[2]) }'
  rm -f "$log" "$log.time"
}

echo '| picture | triangles | rays | ms |'
echo '|---|---:|---:|---:|'
for source in examples/gallery/*.cpp; do
  name=$(basename "$source" .cpp)
  for _ in 1 2 3; do run_once "$build/examples/gallery/$name"; done | sort -k3n | head -n 1 |
    awk -v name="$name" '{ printf "| %s | %d | %d | %.0f |\n", name, $1, $2, $3 }'
done
