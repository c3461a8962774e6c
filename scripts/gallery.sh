#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Measures the programs of examples/gallery: gallery.sh [BUILD]. Build and trace of a frame at 800 x 480 with one
# sample a pixel, the best of FRAMES (3) frames, as a table on stdout.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}
echo '| picture | triangles | rays | ms |'
echo '|---|---:|---:|---:|'
for source in examples/gallery/*.cpp; do
  name=$(basename "$source" .cpp)
  env -u DISPLAY RAYCORE_SAMPLES=1 RAYCORE_LOG=frame RAYCORE_FRAMES="${FRAMES:-3}" "$build/examples/gallery/$name" 2>&1 |
    grep '^raycore: frame ' | sed 's/([^)]*)//g' | awk -v name="$name" '{
      milliseconds = 0
      for (i = 2; i <= NF; ++i) {
        if ($i ~ /^triangles/) triangles = $(i - 1)
        if ($i ~ /^rays/) rays = $(i - 1)
        if ($(i - 1) == "build" || $(i - 1) == "trace") milliseconds += $i
      }
      if (NR == 1 || milliseconds < best) best = milliseconds
    } END { printf "| %s | %d | %d | %.0f |\n", name, triangles, rays, best }'
done
