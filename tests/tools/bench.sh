#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# raycore bench and stats: bench.sh TOOL MODELS. Numbers that must be there and must agree, small pictures.
set -u
tool=$(realpath "$1") models=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
unset DISPLAY
failed=0
say() {
  echo "$*"
  failed=1
}
number() { sed -nE "s/^ *\"$1\": ([0-9.e+-]+),?$/\1/p" "$2" | head -1; }
bench() { "$tool" bench -q --size 40x24 --repeat 1 "$@"; }

bench --json >first.json || say "bench failed"
[ "$(grep -c '"trace_ms":' first.json)" -eq 6 ] || say "not six scenes"
bench --compare first.json >table || say "the comparison failed"
[ "$(grep -c ' the same$' table)" -eq 6 ] || say "the same version makes other pictures"
bench --only box,knot >table
[ "$(grep -cE '^(box|knot) ' table)" -eq 2 ] || say "--only does not choose"
RAYCORE_ACCEL=kdtree bench --only knot --compare first.json | grep -q '^knot .* the same$' || say "the KD-tree makes another picture"
for wrong in "--compare table" "--only nothing" "--scenes $scratch" "--pictures nowhere"; do
  # shellcheck disable=SC2086  # words are what is wanted
  bench $wrong 2>said >/dev/null && say "$wrong was accepted"
  [ "$(wc -l <said)" -eq 1 ] || say "$wrong: $(wc -l <said) lines"
done

"$tool" stats "$models/room.gltf" --json --size 60x40 --samples 1 --repeat 1 --heatmap heat.ppm >stats || say "stats failed"
sum=0
for kind in primary shadow reflected refracted straight; do sum=$((sum + $(printf %.0f "$(number $kind stats)"))); done
[ "$sum" -eq "$(printf %.0f "$(number rays stats)")" ] || say "kinds of rays do not sum up"
[ "$(printf %.0f "$(number primary stats)")" -eq 2400 ] || say "not a primary ray a pixel"
for name in static_build_ms frame_build_ms trace_ms depth cost nodes boxes_per_ray triangles_per_ray; do
  [ -n "$(number $name stats)" ] || say "stats: no $name"
done
# The heat map: the picture, as wide as its legend needs, and the legend below.
read -r width height < <(sed -n 2p heat.ppm)
[ "$width" -ge 60 ] && [ "$height" -gt 40 ] || say "the heat map is $width x $height"
exit $failed
