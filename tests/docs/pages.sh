#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# No row of api/functions.inc without its prototype, letter by letter, in a page of docs/reference; and every link
# from a document to a file of the tree leads somewhere.
set -euo pipefail
cd "$1"
failed=0

pages=$(cat docs/reference/*.md | tr -s ' \n' ' ')
while read -r prototype; do
  case "$pages" in
    *"$prototype;"*) ;;
    *)
      echo "docs/reference: there is no '$prototype'"
      failed=1
      ;;
  esac
done < <(sed -nE 's/^RC_FUNCTION\(([^,]*[^,*]) ?(\*?), (rc[A-Za-z0-9_]+), (\(.*\)), (Acts|Stored|Accepted), ".*$/\1 \2\3\4/p' \
  src/api/functions.inc | tr -s ' ')

while IFS=: read -r document link; do
  target=${link#*](}
  target=${target%)}
  target=${target%%#*}
  case "$target" in
    http*) continue ;;
    '') continue ;;
  esac
  case "$target" in
    *pictures/*.png)  # made by scripts/pictures.sh
      name=$(basename "$target" .png)
      grep -q "^$name	" docs/pictures.tsv && continue
      ;;
  esac
  if [ ! -e "$(dirname "$document")/$target" ]; then
    echo "$document: $target does not exist"
    failed=1
  fi
done < <(grep -roHE --include='*.md' '\]\([^)]+\)' ./*.md docs)
exit $failed
