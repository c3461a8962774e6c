#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# What an output meets: trouble.sh TOOL MODELS. A full disk, folders that cannot be written, ffmpeg missing or failing,
# a reader that goes away, terminals and pipes. Errors are one line and exit code 1; finished frames are kept.
set -u
tool=$(realpath "$1") model=$2/slide.gltf
scratch=$(mktemp -d)
mounted=
trap '[ -z "$mounted" ] || umount "$mounted"; rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
unset DISPLAY
failed=0
say() {
  echo "$*"
  failed=1
}
# refused PATTERN command...: exit code 1, one line on stderr with the pattern
refused() {
  local pattern=$1 code
  shift
  "$@" 2>said >/dev/null
  code=$?
  [ $code -eq 1 ] || say "$*: exit code $code"
  [ "$(wc -l <said)" -eq 1 ] || say "$*: $(wc -l <said) lines"
  grep -qE -- "$pattern" said || { say "$*: no \"$pattern\" in:"; cat said; }
}
sequence() { "$tool" render "$model" -q -o "$1/f-%02d.ppm" --size 64x48 --samples 1 --frames 0-9 --fps 10; }

mkdir whole full
sequence whole || say "the undisturbed run failed"
# A disk of 64 KiB, where one can be had: pictures of 9 KiB each; else a limit on the size of files, which is the same
# error in the middle of a file.
if [ "$(id -u)" -eq 0 ] && mount -t tmpfs -o size=64k tmpfs full 2>/dev/null; then
  mounted=$scratch/full
  refused 'full/f-0[0-9].ppm: cannot be written' sequence full
  kept=$(ls full | grep -c '^f-')
  [ "$kept" -ge 3 ] || say "only $kept frames were kept"
  for file in full/f-*; do cmp -s "$file" "whole/${file#full/}" || say "$file is not whole"; done
  [ -z "$(ls -A full | grep raycore)" ] || say "a temporary file is left"
  mount -o remount,size=1m full
  sequence full || say "with room, the run did not go on"
  diff -r whole full >/dev/null || say "the second run made other files"
fi
limited() { (trap '' XFSZ; ulimit -f 1; "$tool" render "$model" -q -o "$1" --size 640x480); }
for file in limited.ppm limited.png limited.jpg limited.bmp; do refused "$file: cannot be written" limited $file; done
[ -z "$(ls -A | grep -E 'limited|raycore')" ] || say "part of a picture is left"

refused 'nowhere/a.png: cannot be written' "$tool" render "$model" -q -o nowhere/a.png
refused '/proc/a.png: cannot be written' "$tool" render "$model" -q -o /proc/a.png
if [ "$(id -u)" -ne 0 ]; then
  mkdir -m 555 readonly
  refused 'readonly/a.png: cannot be written' "$tool" render "$model" -q -o readonly/a.png
fi
mkdir folder.png
refused 'folder.png: cannot be written' "$tool" render "$model" -q -o folder.png

# A library without the module of picture formats beside it: PNG is written and read all the same.
"$tool" render "$model" -q -o alone.bmp --size 64x48
mkdir alone
cp "$(ldd "$tool" | sed -n 's/.*libRayCoreAPI.so => \(.*\) (.*/\1/p')" alone
LD_LIBRARY_PATH=$PWD/alone "$tool" render "$model" -q -o alone.png --size 64x48 || say "PNG needs the module of formats"
LD_LIBRARY_PATH=$PWD/alone "$tool" render "$model" -q -o a.png --size 64x48 --background alone.png || say "PNG is not read"
for command in "render -q -o a.exr" "render -q -o a.png --background alone.bmp"; do
  refused 'alone/raycore/pictures.so' env LD_LIBRARY_PATH="$PWD/alone" "$tool" $command "$model"
done
refused 'ffmpeg, which is not installed' env PATH=/nowhere "$tool" render "$model" -o film.mp4
[ ! -e film.mp4.frames ] || say "frames were made although there is no ffmpeg"
mkdir bin
printf '#!/bin/sh\nexit 3\n' >bin/ffmpeg
chmod +x bin/ffmpeg
refused 'film.webm: ffmpeg failed \(exit code 3\); the pictures are kept in film.webm.frames' \
  env PATH="$scratch/bin:$PATH" "$tool" render "$model" -q -o film.webm --size 32x24 --samples 1 --fps 5
[ "$(ls film.webm.frames | wc -l)" -eq 5 ] || say "the film's pictures were not kept"

# A reader that goes away
"$tool" render "$model" -q -o - --size 1200x800 --samples 1 2>said | head -c 10 >/dev/null
code=${PIPESTATUS[0]}
[ "$code" -eq 1 ] || [ "$code" -eq 0 ] || say "a reader that goes away: exit code $code"

# A line of progress on a terminal, silence in a pipe
mkdir pipe terminal
"$tool" render "$model" -o pipe/f.png --size 32x24 --samples 1 --frames 0-2 >said 2>&1
[ ! -s said ] || { say "words in a pipe:"; cat said; }
if command -v script >/dev/null; then
  script -qec "'$tool' render '$model' -o terminal/f.png --size 32x24 --samples 1 --frames 0-2" /dev/null >said </dev/null
  grep -q 'frame 2 of 3, .*Mrays/s, .* s left' said || { say "no progress on a terminal:"; cat said; }
  script -qec "'$tool' render '$model' -q -o terminal/g.png --size 32x24 --samples 1 --frames 0-2" /dev/null >said </dev/null
  [ ! -s said ] || say "words in spite of --quiet"
fi
"$tool" render "$model" -o pipe/j.png --size 32x24 --samples 1 --frames 0-2 --json >lines 2>said
[ "$(grep -cE '^\{"frame":[0-2],"file":"pipe/j-000[0-2].png","triangles":[0-9]+,' lines)" -eq 3 ] || say "no lines of JSON"
"$tool" render "$model" -v -o pipe/v.png --size 32x24 --samples 1 2>said
grep -q 'rays, built in' said || say "no times with --verbose"
exit $failed
