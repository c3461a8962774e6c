# The project's switches. Everything is on when this is the top project, the library alone otherwise.
option(RAYCORE_EXAMPLES "Build the programs of the guide" ${PROJECT_IS_TOP_LEVEL})
option(RAYCORE_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(RAYCORE_INSTALL "Make install rules" ${PROJECT_IS_TOP_LEVEL})
option(RAYCORE_PACKAGES "Debian packages by cpack: the preset package" OFF)
option(RAYCORE_TOOLS "Build the command raycore, where what it needs is found" ${PROJECT_IS_TOP_LEVEL})
option(RAYCORE_BINDINGS "Build the Python package, where what it needs is found" ${PROJECT_IS_TOP_LEVEL})
option(RAYCORE_JOIN_SOURCES "Compile several sources as one; cmake/Join.cmake" ON)
option(RAYCORE_WERROR "Warnings are errors" ${PROJECT_IS_TOP_LEVEL})
option(RAYCORE_HARDENING "Stack protector, fortified C library, read-only relocations; cmake/Hardening.cmake" ON)
option(RAYCORE_GLVND "Build libEGL_raycore.so.0, the vendor library for libglvnd, where its header is" ON)
set(RAYCORE_SANITIZE "" CACHE STRING "Sanitizers, as -fsanitize= takes them: address,undefined or thread")
option(RAYCORE_FUZZ "Build fuzz targets for libFuzzer instead of replays of their corpora; Clang alone: the preset fuzz" OFF)
option(RAYCORE_COVERAGE "Count which lines are run; Clang alone: the preset coverage" OFF)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # What a precompiled header was made with is part of its bytes, which ccache looks at. Paths within the tree do not
  # matter, so that the preset package finds what release has made.
  set(launcher ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
               ${CCACHE_PROGRAM})
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
endif()

include(GNUInstallDirs)
