#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Help, exit codes and messages: usage.sh TOOL.
set -u
tool=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
unset DISPLAY
model=$(dirname "$(realpath "$0")" 2>/dev/null)/models/triangle.gltf
failed=0

# expect CODE PATTERN command...: exit code, and a pattern in what it says
expect() {
  local code=$1 pattern=$2
  shift 2
  "$@" >said 2>&1 </dev/null
  local got=$?
  if [ $got -ne "$code" ] || { [ -n "$pattern" ] && ! grep -qE -- "$pattern" said; }; then
    echo "$* gave $got instead of $code, or no \"$pattern\":"
    head -5 said
    failed=1
  fi
}

expect 0 'Examples:' "$tool" --help
for command in render view info stats bench doctor devices version generate; do expect 0 'Example' "$tool" "$command" --help; done
expect 0 '^raycore [0-9]+\.[0-9]' "$tool" --version
expect 0 '"materials": 512' "$tool" devices --json
expect 2 '^raycore: A subcommand is required' "$tool"
expect 2 '^raycore --help tells more' "$tool"
expect 2 '^raycore: there is no command "nothing"' "$tool" nothing
expect 2 '^raycore render: model is required' "$tool" render
expect 2 '^raycore render --help tells more' "$tool" render
expect 2 '^raycore info: not understood: --nowhere$' "$tool" --nowhere info "$model"
expect 2 '^raycore info: not understood: --nothing 4' "$tool" info "$model" --nothing 4
expect 2 '^raycore render: not understood: --outptu a.png; --output is required$' "$tool" render "$model" --outptu a.png
expect 2 'size.*0x10.* is not two whole numbers from 1 to 16384' "$tool" render "$model" -o a.png --size 0x10
expect 2 'samples' "$tool" render "$model" -o a.png --samples 65
expect 1 '^raycore: missing.glb: cannot be opened: No such file' "$tool" info missing.glb
expect 1 'no model format' "$tool" info said
expect 2 'extension is none of' "$tool" render "$model" -o a.tga
expect 2 'heat.tga: the extension' "$tool" stats "$model" --heatmap heat.tga
expect 2 'frames: "abc" is not a range' "$tool" render "$model" -o a.png --frames abc
expect 2 'there is no such scene' "$tool" bench --only nothing
expect 1 'camera "7"' "$tool" render "$model" -o a.png --camera 7
expect 1 'animation "Walk"' "$tool" render "$model" -o a.png --animation Walk
expect 1 'the file has none' "$tool" render "$model" -o a.png --lights file
expect 1 'neither a colour nor a picture' "$tool" render "$model" -o a.png --background mauve
expect 2 'ground: "nope" is none of checker,matte,mirror,none' "$tool" render "$model" -o a.png --ground nope
expect 2 'camera excludes --eye' "$tool" render "$model" -o a.png --camera 0 --eye 1,2,3
expect 2 'not finite' "$tool" render "$model" -o a.png --fov nan
expect 2 '^raycore: --json and the picture would both go to standard output' "$tool" render "$model" -o - --json
expect 2 'the picture needs a file' "$tool" stats "$model" --heatmap -
expect 1 'standard output cannot be written' bash -c '"$1" info "$2" >/dev/full' - "$tool" "$model"
expect 1 'cannot be written' "$tool" render "$model" -o /proc/a.png --size 16x16
expect 1 'no X server' env DISPLAY=:9999 "$tool" view "$model"
expect 1 'no X server' "$tool" view "$model"
expect 2 'kind' "$tool" generate tcsh
expect 1 'ffmpeg' env PATH=/nowhere "$(realpath "$tool")" render "$model" -o a.mp4
[ -e a.png ] && echo "a failed command left a picture" && failed=1
expect 0 '' "$tool" render "$model" -o a.png --size 20x10 -q
for extension in jpg bmp ppm exr; do
  expect 0 '' "$tool" render "$model" -o "a.$extension" --size 20x10 -q
  [ -s "a.$extension" ] || { echo "no a.$extension"; failed=1; }
done
"$tool" render - -o - --size 20x10 -q <"$model" >from_pipe.png
cmp -s a.png from_pipe.png || { echo "the picture through pipes differs"; failed=1; }
"$tool" info "$model" --json | grep -q '"triangles_drawn": 1,' || { echo "info counts wrongly"; failed=1; }
"$tool" stats "$model" --json --size 20x10 --repeat 2 | grep -qE '"rays": [1-9][0-9]+,' || { echo "stats counts no rays"; failed=1; }
# What is left out of a model is told
printf 'mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4\n' >lost.obj
expect 0 'line 1: the materials of "gone.mtl" cannot be opened' "$tool" info lost.obj
expect 0 '1 of 2 triangles have a corner that is not finite' "$tool" render lost.obj -v -o a.png --size 8x8
expect 0 '2 things dropped' "$tool" stats lost.obj --size 8x8

# A name with a place for the number, and no range: the whole animation
expect 0 '' "$tool" render "$(dirname "$model")/slide.gltf" -o whole-%02d.png --fps 5 --size 8x8
[ -s whole-04.png ] && [ ! -e whole-05.png ] || { echo "not the frames of a second: $(echo whole-*)"; failed=1; }
exit $failed
