# What an installed RayCore is: libraries, headers, a CMake package, a pkg-config file.
include(CMakePackageConfigHelpers)

install(TARGETS RayCoreAPI RCFramework EXPORT RayCoreTargets)
if(RAYCORE_TOOLS)
  install(TARGETS raycore)
endif()
install(CODE "file(CREATE_LINK libRCFramework.a
  \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/RCFramework.a\" SYMBOLIC)")
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
