# Sources that are compiled as one read the large headers once, which is most of what compiling them takes; a whole
# build is a third shorter. Off, each is compiled alone: quicker while one file is worked on (the preset dev), and what
# editors that run clang-tidy want.

# raycore_join(target group source...): groups are themes; names of file scope must differ within one.
function(raycore_join target group)
  if(RAYCORE_JOIN_SOURCES)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
  endif()
endfunction()

# All of a target's, so many at once.
function(raycore_join_all target count)
  if(RAYCORE_JOIN_SOURCES)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${count})
  endif()
endfunction()
