#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Sequences: sequence.sh TOOL MODELS. What an interruption leaves, a second run completes to the same bytes.
set -u
tool=$1 model=$2/slide.gltf
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
unset DISPLAY
mkdir whole killed stopped
failed=0
say() {
  echo "$*"
  failed=1
}
# Arguments for the frames of a folder.
frames() { echo "render $model -o $1/f-%03d.png --size 64x48 --samples 1 --frames 0-99 --fps 99 -q"; }
# shellcheck disable=SC2046  # words are what is wanted
render() { "$tool" $(frames "$1") ${2:-}; }

render whole || say "the undisturbed run failed"
[ "$(ls whole | wc -l)" -eq 100 ] || say "not 100 frames"
cmp -s whole/f-000.png whole/f-099.png && say "nothing moves"

# SIGKILL once some frames are there
"$tool" $(frames killed) &
while [ ! -e killed/f-005.png ] && kill -0 $! 2>/dev/null; do sleep 0.01; done
kill -9 $! 2>/dev/null
wait $! 2>/dev/null
head -c 50 whole/f-003.png >killed/f-003.png  # as a crash of the machine leaves it
render killed || say "the second run failed"
rm -f killed/.raycore-*
diff -r whole killed >/dev/null || say "the second run made other files"

# Ctrl-C: the frame is finished, the message says how to go on
"$tool" $(frames stopped) 2>said &
while [ ! -e stopped/f-002.png ] && kill -0 $! 2>/dev/null; do sleep 0.01; done
kill -TERM $!
wait $!
code=$?
if [ $code -eq 130 ]; then
  grep -q 'same command goes on' said || say "no word on how to go on"
elif [ $code -ne 0 ]; then  # it may have been done before the signal came
  say "interrupted: exit code $code"
fi
render stopped && diff -r whole stopped >/dev/null || say "the interrupted run was not completed"

# Frames that are there are left alone
touch -d '2001-01-01' whole/f-050.png
rm whole/f-007.png
"$tool" $(frames whole | sed 's/ -q$//') 2>said
grep -q '^raycore: 99 of 100 frames are there already' said || say "no word that frames were kept"
[ -s whole/f-007.png ] || say "what was missing was not made"
[ "$(date -r whole/f-050.png +%Y)" = 2001 ] || say "a whole frame was made again"
render whole --overwrite
[ "$(date -r whole/f-050.png +%Y)" = 2001 ] && say "--overwrite left a frame"

if command -v ffmpeg >/dev/null; then
  "$tool" render "$model" -o film.mp4 --size 64x48 --samples 1 --fps 10 -q || say "no film"
  [ -s film.mp4 ] && [ ! -e film.mp4.frames ] || say "the film is not whole, or its frames are left"
fi
exit $failed
