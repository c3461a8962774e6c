# One interface target carries what every target of ours is compiled with.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

add_library(raycore_flags INTERFACE)
target_compile_options(raycore_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers)
if(RAYCORE_WERROR)
  target_compile_options(raycore_flags INTERFACE -Werror)
endif()
# The same input gives the same pixels whatever the compiler: no fused multiply-adds of its choice.
target_compile_options(raycore_flags INTERFACE -ffp-contract=off)
target_compile_options(raycore_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-fno-math-errno>)

if(RAYCORE_SANITIZE)
  add_compile_options(-fsanitize=${RAYCORE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${RAYCORE_SANITIZE})
  add_compile_definitions(RAYCORE_FEW_TARGETS)  # src/base/simd_targets.h
  # Instrumented code keeps compilers busy for long: half of the time goes by following variables for debuggers, which
  # reports with lines do without, and a third by what -O2 adds.
  add_compile_options(-O1 -g1)
endif()

# Every file tells libFuzzer which branches an input took; the engine itself is linked to fuzz targets alone.
if(RAYCORE_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

if(RAYCORE_COVERAGE)
  add_compile_options(-fprofile-instr-generate -fcoverage-mapping)
  add_link_options(-fprofile-instr-generate)
  add_compile_definitions(RAYCORE_FEW_TARGETS)
endif()
