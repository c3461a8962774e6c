#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# A short film of a program of examples/gallery as an animated WebP picture: film.sh BUILD NAME FRAMES FILE.webp
# 320 x 192, every second frame of 25 a second, 4 samples a pixel.
set -euo pipefail
build=$1 name=$2 frames=$3 file=$4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
env -u DISPLAY RAYCORE_SAMPLES="${RAYCORE_SAMPLES:-4}" RAYCORE_FRAMES="$frames" \
  RAYCORE_CAPTURE="$scratch/%04d.png" "$build/examples/gallery/$name" film 320 192 2>/dev/null
/usr/bin/python3 - "$scratch" "$file" <<'PYTHON'
import pathlib
import sys

from PIL import Image

frames = [Image.open(path).convert("RGB") for path in sorted(pathlib.Path(sys.argv[1]).glob("*.png"))[::2]]
frames[0].save(sys.argv[2], save_all=True, append_images=frames[1:], duration=80, loop=0, quality=55, method=4)
PYTHON
