# Installs the public libraries for find_package(ravel) and for pkg-config. Part `library` of an
# installation: cmake --install BUILD --component library --prefix PLACE.
if(NOT RAVEL_INSTALL)
  return()
endif()
include(CMakePackageConfigHelpers)

set(public_libraries ravel_reader)
set(public_names ravel_decode)
if(RAVEL_ENCODER)
  list(APPEND public_libraries ravel_whole)
  list(APPEND public_names ravel)
endif()
install(TARGETS ${public_libraries} EXPORT ravel_targets COMPONENT library)
install(DIRECTORY include/ravel DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)

set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/ravel)
install(EXPORT ravel_targets NAMESPACE ravel:: DESTINATION ${folder} COMPONENT library)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/ravelConfig.cmake @ONLY CONTENT [[
# Targets: ravel::decode (reads .ravel files), ravel::ravel (reads and writes; not in a build without
# the encoder).
include(CMakeFindDependencyMacro)
if(NOT "@BUILD_SHARED_LIBS@")
  find_dependency(zstd)
  find_dependency(Threads)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/ravel_targets.cmake)
]])
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ravelConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ravelConfig.cmake ${PROJECT_BINARY_DIR}/ravelConfigVersion.cmake
        DESTINATION ${folder} COMPONENT library)

# pkg-config finds the prefix from where the file stands, so that an installation may be moved.
file(RELATIVE_PATH up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
foreach(name ${public_names})
  # A static library brings what it needs; a shared one knows it.
  set(needs "-lstdc++ -lm")
  if(name STREQUAL ravel)
    set(needs "-llemon ${needs} -pthread")
  endif()
  set(libs " ${needs}")
  set(requires "libzstd")
  if(BUILD_SHARED_LIBS)
    set(libs "")
    set(requires "")
  endif()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${name}.pc @ONLY CONTENT [[
prefix=${pcfiledir}/@up@
Name: @name@
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Cflags: -I${prefix}/@CMAKE_INSTALL_INCLUDEDIR@
Libs: -L${prefix}/@CMAKE_INSTALL_LIBDIR@ -l@name@@libs@
Requires: @requires@
]])
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT library)
endforeach()
