# Debian packages: cmake --preset package && cmake --build --preset package && cpack --preset package.
# The number in libraycore1 is that of the binary interface, RAYCORE_ABI; the library's own name has none, because old
# programs ask for libRayCoreAPI.so. [docs/howto/packages.md]
set(RAYCORE_ABI 1)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME raycore)
set(CPACK_PACKAGE_VENDOR "The raycore authors")
set(CPACK_PACKAGE_CONTACT "The raycore authors <raycore@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Ray tracing for programs in the manner of OpenGL ES 1.1")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL runtime dev doc)
if(RAYCORE_TOOLS)
  list(APPEND CPACK_COMPONENTS_ALL tools)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src/egl)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)

set(name_runtime libraycore${RAYCORE_ABI})
set(name_dev libraycore-dev)
set(name_tools raycore-tools)
set(name_doc raycore-doc)
set(section_runtime libs)
set(section_dev libdevel)
set(section_tools graphics)
set(section_doc doc)
set(depends_runtime "")
set(depends_dev "libraycore${RAYCORE_ABI} (= ${PROJECT_VERSION}), libegl-dev, libx11-dev")
set(depends_tools "libraycore${RAYCORE_ABI} (>= ${PROJECT_VERSION})")
set(depends_doc "")
set(text_runtime "Programs set state and submit triangles much as in OpenGL ES 1.1; each
frame is traced with shadows, reflection and refraction on the processor's
cores, in X11 windows and without a display. This is the library.")
set(text_dev "What programs are compiled with: headers, the class RCFramework, a CMake
package and a file for pkg-config.")
set(text_tools "The command raycore renders glTF, OBJ and other models to pictures and
films, and tells what is in them.")
set(text_doc "The manual as texts, and the programs that it shows.")

# Each package has its copyright and its changelog, as Debian's policy asks.
find_program(GZIP gzip)
foreach(component runtime dev tools doc)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name_${component}})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section_${component}})
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends_${component}}")
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${text_${component}}")
  if(component IN_LIST CPACK_COMPONENTS_ALL)
    set(doc_dir ${CMAKE_INSTALL_DATADIR}/doc/${name_${component}})
    install(FILES ${PROJECT_SOURCE_DIR}/packaging/copyright DESTINATION ${doc_dir} COMPONENT ${component})
    if(GZIP)
      set(changelog ${PROJECT_BINARY_DIR}/changelog.gz)
      install(CODE "execute_process(COMMAND ${GZIP} -9nc ${PROJECT_SOURCE_DIR}/packaging/changelog OUTPUT_FILE ${changelog}
              COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component})
      install(FILES ${changelog} DESTINATION ${doc_dir} COMPONENT ${component})
    endif()
    install(FILES ${PROJECT_SOURCE_DIR}/packaging/lintian-overrides/${name_${component}}
            DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component} OPTIONAL)
  endif()
endforeach()
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DOC_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/triggers)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_STRICT_PERMISSION ON)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/raycore-doc/docs COMPONENT doc
        PATTERN "theme" EXCLUDE PATTERN "pictures" EXCLUDE)
# The book's pages name the sources they show; as texts they hold them.
install(CODE "set(DOCS \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/doc/raycore-doc/docs)
  set(SOURCE ${PROJECT_SOURCE_DIR})
  include(${PROJECT_SOURCE_DIR}/cmake/ExpandSnippets.cmake)" COMPONENT doc)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/raycore-doc/examples
        COMPONENT doc PATTERN "CMakeLists.txt" EXCLUDE)
include(CPack)
