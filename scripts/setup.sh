#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Installs what is missing to build, run and test the project, from the distribution's packages (names of Debian 12
# and Ubuntu 24.04). Says nothing where nothing is missing. As root or through sudo; with neither it names the
# packages and ends with code 1.
#
#   setup.sh        what the library, the command and their tests need
#   setup.sh docs   what the book, the packages and the Python package need besides; tests skip what is missing
#   setup.sh fuzz   Clang and its tools, for the presets fuzz and coverage and for tidy.sh; no test needs them
set -eu

packages=(
  g++ cmake ninja-build pkg-config ccache
  libtbb-dev libhwy-dev libglm-dev libpng-dev libx11-dev libxext-dev libegl-dev libglvnd-core-dev
  libassimp-dev libjpeg-dev libopenimageio-dev libcli11-dev libfmt-dev nlohmann-json3-dev
  libgtest-dev xvfb xdotool libgles-dev libegl-mesa0 mesa-utils-bin
)

[ "${1:-}" = docs ] && packages+=(
  mkdocs-material python3-pil
  pybind11-dev python3-dev python3-numpy python3-pytest python3-mesonpy
  abigail-tools dpkg-dev fakeroot lintian
)
[ "${1:-}" = fuzz ] && packages+=(clang clang-tidy llvm libclang-rt-dev)

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

if [ "$(id -u)" -eq 0 ]; then
  as_root=()
elif command -v sudo >/dev/null && sudo -n true 2>/dev/null || { [ -t 0 ] && command -v sudo >/dev/null; }; then
  as_root=(sudo)
else
  echo "setup: these packages are missing and there is neither root nor sudo to install them:" >&2
  echo "  apt-get install ${missing[*]}" >&2
  exit 1
fi

echo "setup: installing ${missing[*]}"
log=$(mktemp)
install() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "$@" >>"$log" 2>&1
}
if ! { install -qq update && install -qq install -y --no-install-recommends "${missing[@]}"; }; then
  echo "setup: the packages could not be installed:" >&2
  tail -n 20 "$log" >&2
  exit 1
fi
rm -f "$log"
