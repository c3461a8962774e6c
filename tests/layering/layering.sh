#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Reads every #include of src/, examples/ and tools/ against the picture of the layers in docs/data_path.md.
set -u
cd "$1" || exit 2
failed=0

# check ROOT: the lines of standard input are folders of it, each with those that it may include besides its own.
check() {
  local root=$1 layer allowed file line include other folder
  while IFS=: read -r layer allowed; do
    [ -d "$root/$layer" ] || { echo "$root/$layer is gone" && failed=1; }
    while IFS=: read -r file line include; do
      other=${include#*\"}
      other=${other%%\"*}
      folder=${other%%/*}
      [ -d "$root/$folder" ] && [ "$folder" != "$other" ] || continue  # a public header, or beside the file
      [ "$folder" = "$layer" ] && continue
      case " $allowed " in
        *" $folder "*) ;;
        *)
          echo "$file:$line: $layer must not include $other"
          failed=1
          ;;
      esac
    done < <(grep -rnE '^#include "' "$root/$layer" || true)
  done
}

check src <<<"base:
rchal:base
rcddi:base rchal
rcddk:base rchal
api:base rchal rcddk
egl:base rchal rcddk api gl
gl:
framework:"
check tools/raycore <<<"input:
scene:
codec:input scene
gltf:input scene codec
foreign:input scene codec
load:input scene codec gltf foreign
draw:input scene load
output:input scene codec
bench:scene draw
measure:draw output
doctor:input codec draw output
view:input scene load draw output
commands:input scene load draw output bench measure doctor view"

# A device is a sibling of the others, found by name; only the registry knows them.
while IFS= read -r match; do
  file=${match%%:*}
  own=${file#src/rcddi/}
  own=${own%%/*}
  case "$match" in
    *"\"rcddi/$own/"*) ;;
    *registry.cpp*) ;;
    *)
      echo "$match: a device must not include another"
      failed=1
      ;;
  esac
done < <(grep -rnE '^#include "rcddi/' src || true)

# Programs see the public headers alone.
if grep -rnE '^#include "(base|rchal|rcddi|rcddk|api|egl|framework)/' examples tools; then
  echo "examples and tools must use the public API alone"
  failed=1
fi
# One file knows oneTBB.
if grep -rlE '^#include <tbb/' src | grep -v '^src/base/parallel.cpp$'; then
  echo "only base/parallel.cpp includes oneTBB"
  failed=1
fi
exit $failed
