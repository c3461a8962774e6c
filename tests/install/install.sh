#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Installs the built project into a scratch prefix and uses it from there as others do: find_package, pkg-config,
# RCFramework.a as in the guide's makefiles and its appendix D, and a program with a main of its own.
set -eu
build=$1 source=$2 cc=$3 cxx=$4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix=$scratch/prefix
cmake --install "$build" --prefix "$prefix" >/dev/null
libdir=$(dirname "$(find "$prefix" -name libRayCoreAPI.so)")
export LD_LIBRARY_PATH=$libdir
unset DISPLAY

expect() {  # program: two frames, a picture, exit code 0
  RAYCORE_FRAMES=2 RAYCORE_CAPTURE="$scratch/picture.ppm" "$@" 2>/dev/null
  [ "$(head -c 11 "$scratch/picture.ppm" | tr '\n' ' ')" = "P6 800 480 " ]
  rm "$scratch/picture.ppm"
}

# find_package(RayCore)
cmake -S "$source" -B "$scratch/consumer" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_C_COMPILER="$cc" \
  -DCMAKE_CXX_COMPILER="$cxx" >/dev/null
cmake --build "$scratch/consumer" >/dev/null
expect "$scratch/consumer/framework_program"
expect "$scratch/consumer/own_main"
expect "$scratch/consumer/c_program"

# pkg-config
export PKG_CONFIG_PATH=$libdir/pkgconfig
read -r -a flags <<<"$(pkg-config --cflags --libs raycore)"
"$cc" -std=c99 "$source/c_program.c" "${flags[@]}" -o "$scratch/with_pkg_config"
expect "$scratch/with_pkg_config"

# as in the guide's makefiles
"$cxx" -o "$scratch/by_hand" "$source/framework_program.cpp" -I"$prefix/include" "$libdir/RCFramework.a" -L"$libdir" \
  -lstdc++ -lpthread -lm -lX11 -lRayCoreAPI
expect "$scratch/by_hand"

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
  env -u LD_LIBRARY_PATH "$prefix/bin/raycore" --version >/dev/null
  for file in bash-completion/completions/raycore zsh/site-functions/_raycore fish/vendor_completions.d/raycore.fish \
    man/man1/raycore.1; do
    [ -s "$prefix/share/$file" ]
  done
fi

# the line of the guide's appendix D, which names the original's inner libraries
mkdir "$scratch/appendix_d"
cd "$scratch/appendix_d"
cp "$source/own_main.cpp" main.cpp
ln -s "$libdir/RCFramework.a" .
"$cxx" main.cpp -I"$prefix/include" -L"$libdir" RCFramework.a -lRayCoreAPI -lRCDDK -lRCHAL -lRCDDIArriaV -lX11 -lpthread
RAYCORE_FRAMES=1 ./a.out 2>/dev/null
expect ./a.out

# old programs ask for this name, without a version, and for none of the inner ones
for program in "$scratch/by_hand" ./a.out; do
  readelf -d "$program" | grep -q 'NEEDED.*\[libRayCoreAPI.so\]'
  if readelf -d "$program" | grep 'NEEDED.*\[libRC'; then exit 1; fi
done
echo "installed, found and used in six ways"
