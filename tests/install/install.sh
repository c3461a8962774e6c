#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Installs the built project into a scratch prefix, uses it from there (use.sh), and takes it away again.
set -eu
build=$1 source=$2 cc=$3 cxx=$4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix=$scratch/prefix
cmake --install "$build" --prefix "$prefix" >/dev/null
libdir=$(dirname "$(find "$prefix" -name libRayCoreAPI.so)")
export LD_LIBRARY_PATH=$libdir
unset DISPLAY
bash "$source/use.sh" "$prefix" "$libdir" "$source" "$cc" "$cxx" "$scratch/use"

# the vendor library, where there is one: complete, and nowhere near libglvnd's own folders
if [ -e "$libdir/libEGL_raycore.so.0" ]; then
  json=$prefix/share/raycore/egl_vendor.d/50_raycore.json
  grep -q "\"$libdir/libEGL_raycore.so.0\"" "$json"
  [ -z "$(find "$prefix" -path '*glvnd*')" ]
  "$cxx" -o "$scratch/beside" "$source/../vendor/raycore_program.cpp" -I"$prefix/include" -L"$libdir" -lEGL -lRayCoreAPI
  RAYCORE_CAPTURE=$scratch/beside.ppm __EGL_VENDOR_LIBRARY_FILENAMES=$json "$scratch/beside" libEGL.so.1
fi

# the command, where it was built, with completions and a manual page
if [ -e "$prefix/bin/raycore" ]; then
  mapfile -t settings < <(env | sed -nE 's/^(RAYCORE_[A-Z_]*)=.*/-u\n\1/p')
  env -u LD_LIBRARY_PATH -u DISPLAY "${settings[@]}" "$prefix/bin/raycore" doctor
  for file in bash-completion/completions/raycore zsh/site-functions/_raycore fish/vendor_completions.d/raycore.fish \
    man/man1/raycore.1; do
    [ -s "$prefix/share/$file" ]
  done
fi

# taken away, nothing is left: the target uninstall, on the manifest of this installation
cmake -DMANIFEST="$build/install_manifest.txt" -P "$source/../../cmake/Uninstall.cmake"
if [ -e "$prefix" ]; then
  echo "these are left:"
  find "$prefix"
  exit 1
fi
