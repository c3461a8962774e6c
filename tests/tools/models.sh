#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Every model that MANIFEST.md lists as valid loads, with as many triangles as it says: models.sh TOOL SCENES.
set -u
tool=$1 scenes=$2
failed=0 models=0
# file, triangles: those drawn where they differ ("12 (1,500)")
while IFS=$'\t' read -r file triangles; do
  case $file in *.json) continue ;; esac
  if ! about=$("$tool" info "$scenes/$file" --json); then
    failed=1
    continue
  fi
  drawn=$(sed -n 's/.*"triangles_drawn": \([0-9]*\).*/\1/p' <<<"$about")
  [ "$drawn" = "$triangles" ] || { echo "$file: $drawn triangles instead of $triangles"; failed=1; }
  models=$((models + 1))
done < <(sed -n '/^## Scenes/,/^## Pictures/p' "$scenes/MANIFEST.md" |
  sed -nE 's/^\| `([^`]*)` \|[^|]*\|[^|]*\| ([0-9,]+)( \(([0-9,]+)\))? \|.*/\1\t\2\t\4/p' |
  awk -F'\t' '{ n = $3 == "" ? $2 : $3; gsub(",", "", n); print $1 "\t" n }')
echo "$models models"
[ $models -gt 0 ] || failed=1
exit $failed
