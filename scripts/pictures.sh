#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Makes the pictures of docs/pictures.tsv. pictures.sh BUILD FOLDER [NAME...]: those named, or all.
# BUILD is a built tree; programs that a row changes are compiled for it. RAYCORE_SAMPLES, 4 unless it is set.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd) folder=$2
shift 2
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset DISPLAY
export RAYCORE_SAMPLES=${RAYCORE_SAMPLES:-4} RAYCORE_LOG=error
status=0

# The program with its change, compiled. The change must find something.
changed() {  # source file, substitution, program
  sed -e "$2" "$1" >"$scratch/changed.cpp"
  if cmp -s "$1" "$scratch/changed.cpp"; then
    echo "pictures: '$2' changes nothing in $1" >&2
    return 1
  fi
  ${CXX:-c++} -std=c++20 -O1 "$scratch/changed.cpp" -I"$source/include" -I"$source/examples" \
    "$build/src/framework/libRCFramework.a" -L"$build/src/egl" -lRayCoreAPI -lX11 -Wl,-rpath,"$build/src/egl" -o "$3"
}

while IFS=$'\t' read -r picture program frame arguments change; do
  case $picture in '#'* | '') continue ;; esac
  [ $# -eq 0 ] || [[ " $* " == *" $picture "* ]] || continue
  run=$build/examples/$program
  if [ "$change" != - ]; then
    run=$scratch/$picture
    changed "$source/examples/$program.cpp" "$change" "$run" || { status=1; continue; }
  fi
  [ "$arguments" = - ] && arguments=
  # shellcheck disable=SC2086
  RAYCORE_FRAMES=$frame RAYCORE_CAPTURE=$folder/$picture.png "$run" $arguments >"$scratch/log" 2>&1 &&
    ! grep -q ': RC_' "$scratch/log" || {
    cat "$scratch/log" >&2
    echo "pictures: $picture failed" >&2
    status=1
  }
done <"$source/docs/pictures.tsv"
exit $status
