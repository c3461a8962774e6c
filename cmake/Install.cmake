# What an installed RayCore is: libraries, headers, a CMake package, a pkg-config file.
include(CMakePackageConfigHelpers)

install(TARGETS RayCoreAPI RCFramework EXPORT RayCoreTargets)
if(RAYCORE_TOOLS)
  install(TARGETS raycore)
  set(generated ${PROJECT_BINARY_DIR}/tools/raycore/generated)
  install(FILES ${generated}/raycore.bash RENAME raycore DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${generated}/raycore.zsh RENAME _raycore DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
  install(FILES ${generated}/raycore.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  install(FILES ${generated}/raycore.man RENAME raycore.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
install(CODE "file(CREATE_LINK libRCFramework.a
  \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/RCFramework.a\" SYMBOLIC)")
if(TARGET raycore_vendor)
  install(TARGETS raycore_vendor LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  # Not where libglvnd looks: only programs that name the file in __EGL_VENDOR_LIBRARY_FILENAMES get it.
  install(CODE "set(RAYCORE_VENDOR_LIBRARY \${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/libEGL_raycore.so.0)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/50_raycore.json.in
    \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/raycore/egl_vendor.d/50_raycore.json @ONLY)")
endif()

# The guide's link line names the original's inner libraries too. Linkers take these texts for them; no program needs
# the names when it runs. [G D 1.1; reference 1.1]
foreach(name RCDDK RCHAL RCDDIArriaV)
  set(script $<TARGET_FILE_DIR:RayCoreAPI>/lib${name}.so)
  file(GENERATE OUTPUT ${script} CONTENT "/* GNU ld script: lib${name} is part of libRayCoreAPI */\nINPUT ( AS_NEEDED ( -lRayCoreAPI ) )\n")
  install(FILES ${script} DESTINATION ${CMAKE_INSTALL_LIBDIR})
endforeach()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/RayCore)
install(EXPORT RayCoreTargets NAMESPACE RayCore:: DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/RayCoreConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/RayCoreConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/RayCoreConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/RayCoreConfig.cmake ${PROJECT_BINARY_DIR}/RayCoreConfigVersion.cmake
        DESTINATION ${package_dir})

# Found from the file's own place, so that the tree can be moved.
file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${PROJECT_SOURCE_DIR}/cmake/raycore.pc.in ${PROJECT_BINARY_DIR}/raycore.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/raycore.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
