#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# The Debian packages: two builds give the same bytes; lintian finds nothing; the binary interface holds what the last
# release had; installed into a folder of their own they are found and used as install.sh does it; removed, they leave
# nothing there.
set -euo pipefail
source=$1 tests=$1/tests/install
shift
for tool in dpkg dpkg-deb dpkg-shlibdeps fakeroot; do
  command -v $tool >/dev/null || {
    echo "skipped: $tool is not here (bash scripts/setup.sh docs)"
    exit 77
  }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset DISPLAY
for variable in $(env | sed -nE 's/^(RAYCORE_[A-Z_]*)=.*/\1/p'); do unset "$variable"; done  # doctor would see them
# Not the clock: the time of the last entry of the changelog.
SOURCE_DATE_EPOCH=$(date -d "$(sed -n 's/^ -- .*>  //p' "$source/packaging/changelog" | head -n 1)" +%s)
export SOURCE_DATE_EPOCH

# packages.sh SOURCE [ARGUMENT OF CMAKE...]
make_packages() {  # build folder beside those of the presets, so that ccache knows the objects
  cmake -S "$source" --preset package -B "$source/build/$1" "${@:2}" >"$scratch/log" 2>&1 &&
    cmake --build "$source/build/$1" >>"$scratch/log" 2>&1 &&
    rm -f "$source/build/$1"/*.deb &&
    (cd "$source/build/$1" && cpack -G DEB) >>"$scratch/log" 2>&1 || {
    tail -n 30 "$scratch/log"
    exit 1
  }
}
make_packages package "$@"
make_packages package-again "$@"
for deb in "$source"/build/package/*.deb; do
  cmp "$deb" "$source/build/package-again/$(basename "$deb")"
done
rm -rf "$source/build/package-again"
debs=("$source"/build/package/*.deb)
[ ${#debs[@]} -ge 3 ]
echo "${#debs[@]} packages, the same bytes twice"

if command -v lintian >/dev/null; then
  lintian --allow-root --tag-display-limit 0 --fail-on error,warning "${debs[@]}"
  echo "lintian: nothing"
else
  echo "lintian is not here: not asked"
fi

if command -v abidiff >/dev/null; then
  newest=$(find "$source/abi" -name '*.abi' | sort -V | tail -n 1)
  abidiff --no-added-syms "$newest" "$source/build/package/src/egl/libRayCoreAPI.so"
  echo "abidiff: nothing of $(basename "$newest") is missing"
else
  echo "abidiff is not here: not asked"
fi

# A system of its own for dpkg: only these packages, whatever they need.
root=$scratch/root
mkdir -p "$root/var/lib/dpkg/updates" "$root/var/lib/dpkg/info"
touch "$root/var/lib/dpkg/status" "$root/var/lib/dpkg/available"
own_dpkg() {
  fakeroot dpkg --root="$root" --force-depends --force-script-chrootless --force-not-root --log="$scratch/dpkg.log" \
    "$@" >"$scratch/log" 2>&1 || {
    cat "$scratch/log"
    exit 1
  }
}
own_dpkg --install "${debs[@]}"
libdir=$(dirname "$(find "$root/usr/lib" -name libRayCoreAPI.so)")
bash "$tests/use.sh" "$root/usr" "$libdir" "$tests" cc c++ "$scratch/use"
if [ -x "$root/usr/bin/raycore" ]; then LD_LIBRARY_PATH=$libdir "$root/usr/bin/raycore" doctor; fi

names=()
for deb in "${debs[@]}"; do names+=("$(dpkg-deb -f "$deb" Package)"); done
own_dpkg --purge "${names[@]}"
if [ -n "$(find "$root" -path "$root/var" -prune -o -type f -print -o -type l -print)" ]; then
  echo "these are left:"
  find "$root" -path "$root/var" -prune -o -type f -print -o -type l -print
  exit 1
fi
echo "installed, used, removed without a trace"
