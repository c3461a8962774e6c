#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# The book: every picture can be made and shows something, each change that a chapter tells makes another picture, code
# in pages compiles and runs, diffs apply, and MkDocs finds every page, link and snippet. book.sh SOURCE BUILD CC CXX
set -euo pipefail
source=$1 build=$2 cc=$3 cxx=$4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$source"

CXX=$cxx RAYCORE_SAMPLES=1 bash scripts/pictures.sh "$build" "$scratch/docs/pictures"
failed=0
for picture in "$scratch"/docs/pictures/*.png; do
  changed=${picture%.png}-changed.png
  if [ -e "$changed" ] && cmp -s "$picture" "$changed"; then
    echo "$(basename "$changed"): the change is not to be seen"
    failed=1
  fi
done
[ "$(find "$scratch/docs/pictures" -name '*.png' | wc -l)" = "$(grep -vc '^#' docs/pictures.tsv)" ]
bash scripts/book_parts.sh --check || failed=1

if [ -x /usr/bin/python3 ]; then
  /usr/bin/python3 tests/docs/code_blocks.py "$build" "$cc" "$cxx" || failed=1
else
  echo "python3 is not here: code in pages is not tried"
fi

if [ -x /usr/bin/python3 ] && /usr/bin/python3 -c 'import mkdocs, material' 2>/dev/null; then
  cp -r docs examples include scripts mkdocs.yml "$scratch/"
  (cd "$scratch" && /usr/bin/python3 -m mkdocs build --quiet --strict --site-dir "$scratch/site") || failed=1
  [ -s "$scratch/site/learn/10_egl.html" ]
  if grep -rl 'SPDX-' "$scratch"/site/learn/*.html; then
    echo "licence lines are left in these pages"
    failed=1
  fi
else
  echo "mkdocs-material is not here (bash scripts/setup.sh docs): the book is not built"
fi
exit $failed
