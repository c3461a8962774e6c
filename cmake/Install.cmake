# What an installed RayCore is: libraries, headers, a CMake package, a pkg-config file. Components are packages of their
# own (Packages.cmake): runtime, dev, tools, doc. Rules elsewhere that name none belong to tools.
include(CMakePackageConfigHelpers)

# libRayCoreAPI.so is no mere name for linkers: programs of the vendor's library ask for it when they run.
install(TARGETS RayCoreAPI EXPORT RayCoreTargets LIBRARY COMPONENT runtime)
install(TARGETS RCFramework EXPORT RayCoreTargets ARCHIVE COMPONENT dev)
if(RAYCORE_TOOLS)
  install(TARGETS raycore COMPONENT tools)
  install(TARGETS raycore_pictures LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/raycore COMPONENT tools)
  set(generated ${PROJECT_BINARY_DIR}/tools/raycore/generated)
  install(FILES ${generated}/raycore.bash RENAME raycore DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tools)
  install(FILES ${generated}/raycore.zsh RENAME _raycore DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT tools)
  install(FILES ${generated}/raycore.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT tools)
  install(FILES ${generated}/raycore.man RENAME raycore.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
endif()
install(CODE "file(CREATE_LINK libRCFramework.a
  \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/RCFramework.a\" SYMBOLIC)
  list(APPEND CMAKE_INSTALL_MANIFEST_FILES \${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/RCFramework.a)" COMPONENT dev)
if(TARGET raycore_vendor)
  install(TARGETS raycore_vendor LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime)
  # Not where libglvnd looks: only programs that name the file in __EGL_VENDOR_LIBRARY_FILENAMES get it.
  set(vendor_json ${CMAKE_INSTALL_DATADIR}/raycore/egl_vendor.d/50_raycore.json)
  install(CODE "set(RAYCORE_VENDOR_LIBRARY \${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/libEGL_raycore.so.0)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/50_raycore.json.in
    \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${vendor_json} @ONLY)
  list(APPEND CMAKE_INSTALL_MANIFEST_FILES \${CMAKE_INSTALL_PREFIX}/${vendor_json})" COMPONENT runtime)
endif()

# The guide's link line names the original's inner libraries too. Linkers take these texts for them; no program needs
# the names when it runs. [G D 1.1; reference 1.1]
foreach(name RCDDK RCHAL RCDDIArriaV)
  set(script $<TARGET_FILE_DIR:RayCoreAPI>/lib${name}.so)
  file(GENERATE OUTPUT ${script} CONTENT "/* GNU ld script: lib${name} is part of libRayCoreAPI */\nINPUT ( AS_NEEDED ( -lRayCoreAPI ) )\n")
  install(FILES ${script} DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
endforeach()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/RayCore)
install(EXPORT RayCoreTargets NAMESPACE RayCore:: DESTINATION ${package_dir} COMPONENT dev)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/RayCoreConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/RayCoreConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/RayCoreConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/RayCoreConfig.cmake ${PROJECT_BINARY_DIR}/RayCoreConfigVersion.cmake
        DESTINATION ${package_dir} COMPONENT dev)

# Found from the file's own place, so that the tree can be moved.
file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${PROJECT_SOURCE_DIR}/cmake/raycore.pc.in ${PROJECT_BINARY_DIR}/raycore.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/raycore.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)

# cmake --build build/release --target uninstall: what the last installation of this build tree wrote, and the folders
# it leaves empty.
add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt
                                    -P ${PROJECT_SOURCE_DIR}/cmake/Uninstall.cmake VERBATIM)
