#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# The book: docs.sh builds it into build/site, docs.sh serve shows it on http://127.0.0.1:8000 as well.
# It installs what is missing (setup.sh docs), builds the examples, and makes their pictures.
set -euo pipefail
cd "$(dirname "$0")/.."
bash scripts/setup.sh
bash scripts/setup.sh docs
cmake --preset release >/dev/null
cmake --build --preset release --target RCFramework examples/all -- --quiet
bash scripts/pictures.sh build/release docs/pictures
bash scripts/book_parts.sh
if [ "${1:-}" = serve ]; then
  exec /usr/bin/python3 -m mkdocs serve
fi
/usr/bin/python3 -m mkdocs build --quiet
echo "build/site/index.html"
