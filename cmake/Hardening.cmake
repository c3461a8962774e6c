# What makes slips of memory harder to use in optimised builds, as far as the compiler has it. Sanitizers find slips
# themselves. [docs/robustness.md, Hardening]
if(RAYCORE_SANITIZE OR NOT RAYCORE_HARDENING)
  return()
endif()
include(CheckCXXCompilerFlag)
include(CheckPIESupported)

check_pie_supported(LANGUAGES C CXX)  # with CMAKE_POSITION_INDEPENDENT_CODE: programs are -pie
foreach(flag -fstack-protector-strong -fstack-clash-protection -fcf-protection)
  string(MAKE_C_IDENTIFIER "RAYCORE_HAS${flag}" has)
  check_cxx_compiler_flag("-Werror ${flag}" ${has})
  if(${has})
    target_compile_options(raycore_flags INTERFACE $<$<NOT:$<CONFIG:Debug>>:${flag}>)
  endif()
endforeach()
# Distributions' compilers set a level of their own.
target_compile_options(raycore_flags INTERFACE $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE>
                                               $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=3>)
add_link_options(LINKER:-z,relro,-z,now,-z,noexecstack)
