#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Uses an installed RayCore as others do: find_package, pkg-config, Meson, RCFramework.a as in the guide's makefiles and its
# appendix D, and a program with a main of its own. use.sh PREFIX LIBDIR SOURCES CC CXX SCRATCH
set -eu
prefix=$1 libdir=$2 source=$3 cc=$4 cxx=$5 scratch=$6
mkdir -p "$scratch"
export LD_LIBRARY_PATH=$libdir
unset DISPLAY

expect() {  # program: two frames, a picture, exit code 0
  RAYCORE_FRAMES=2 RAYCORE_CAPTURE="$scratch/picture.ppm" "$@" 2>/dev/null
  [ "$(head -c 11 "$scratch/picture.ppm" | tr '\n' ' ')" = "P6 800 480 " ]
  rm "$scratch/picture.ppm"
}

# find_package(RayCore)
cmake -S "$source" -B "$scratch/consumer" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_C_COMPILER="$cc" \
  -DCMAKE_CXX_COMPILER="$cxx" >/dev/null
cmake --build "$scratch/consumer" >/dev/null
expect "$scratch/consumer/framework_program"
expect "$scratch/consumer/own_main"
expect "$scratch/consumer/c_program"

# its components, by name; one that does not exist is an error
mkdir "$scratch/components"
cat >"$scratch/components/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.22)
project(Components C)
find_package(RayCore REQUIRED COMPONENTS ${wanted})
END
components() {
  rm -rf "$scratch/components/build"
  cmake -S "$scratch/components" -B "$scratch/components/build" -DCMAKE_PREFIX_PATH="$prefix" -Dwanted="$1" "${@:2}"
}
components RayCoreAPI -DCMAKE_DISABLE_FIND_PACKAGE_X11=ON >/dev/null
components "RayCoreAPI;RCFramework" >/dev/null
if components Nonsense >/dev/null 2>&1; then exit 1; fi

# pkg-config
export PKG_CONFIG_PATH=$libdir/pkgconfig
read -r -a flags <<<"$(pkg-config --cflags --libs raycore)"
"$cc" -std=c99 "$source/c_program.c" "${flags[@]}" -o "$scratch/with_pkg_config"
expect "$scratch/with_pkg_config"

# Meson, where it is
ways=six
if command -v meson >/dev/null; then
  ways=seven
  CC=$cc CXX=$cxx meson setup "$scratch/meson" "$source" >/dev/null
  ninja -C "$scratch/meson" >/dev/null
  expect "$scratch/meson/framework_program"
  expect "$scratch/meson/c_program"
fi

# as in the guide's makefiles
"$cxx" -o "$scratch/by_hand" "$source/framework_program.cpp" -I"$prefix/include" "$libdir/RCFramework.a" -L"$libdir" \
  -lstdc++ -lpthread -lm -lX11 -lRayCoreAPI
expect "$scratch/by_hand"

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
echo "found and used in $ways ways"
