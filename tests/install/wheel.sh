#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# The wheel: built by meson-python against an installed library, unpacked elsewhere, and used. wheel.sh BUILD SOURCE
set -euo pipefail
build=$1 source=$2 python=/usr/bin/python3
for module in mesonpy pybind11 numpy; do
  [ "$module" = pybind11 ] && [ -e /usr/include/pybind11/pybind11.h ] && continue
  "$python" -c "import $module" 2>/dev/null || {
    echo "skipped: $module is not here (bash scripts/setup.sh docs)"
    exit 77
  }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
DESTDIR='' cmake --install "$build" --prefix "$scratch/prefix" --component runtime >/dev/null
DESTDIR='' cmake --install "$build" --prefix "$scratch/prefix" --component dev >/dev/null
libdir=$(dirname "$(find "$scratch/prefix" -name libRayCoreAPI.so)")
cp -r "$source/python" "$scratch/python"
cd "$scratch/python"
PKG_CONFIG_PATH=$libdir/pkgconfig "$python" -c 'import mesonpy; print(mesonpy.build_wheel("'"$scratch"'"))' \
  >"$scratch/log" 2>&1 || {
  tail -n 30 "$scratch/log"
  exit 1
}
cd "$scratch"
"$python" -m zipfile -e raycore-*.whl wheel
for file in __init__.py __init__.pyi _core.pyi py.typed; do [ -e "wheel/raycore/$file" ]; done
env -u DISPLAY LD_LIBRARY_PATH="$libdir" PYTHONPATH=wheel "$python" -c '
import raycore
assert raycore.__file__.startswith("'"$scratch"'"), raycore.__file__
picture = raycore.render([[-1, -1, 0], [1, -1, 0], [0, 1, 0]], size=(80, 48))
assert picture.shape == (48, 80, 3) and (picture != picture[0, 0]).any()
'
echo "$(basename raycore-*.whl): built, unpacked, used"
