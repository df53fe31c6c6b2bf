# What `cmake --install` puts where, besides the program (apps/cli): one static library a room, the public headers and the
# formulas under include/mirrorball, the licence, and the CMake package that find_package(mirrorball) reads, whose components
# are the rooms. docs/building.md shows how it is used, tests/consumer uses it.

include(CMakePackageConfigHelpers)

set(mirrorball_include_dir "${CMAKE_INSTALL_INCLUDEDIR}/mirrorball")
set(mirrorball_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/mirrorball")

# Each component has a file of targets of its own, so that who asks for the formulas needs no OpenEXR. Which components and
# packages each needs stands in mirrorballComponents.cmake.
get_property(mirrorball_components GLOBAL PROPERTY MIRRORBALL_COMPONENTS)
set(mirrorball_needs "set(mirrorball_left_out \"${mirrorball_left_out_text}\")\nset(mirrorball_components ${mirrorball_components})\n")
foreach(component IN LISTS mirrorball_components)
  install(TARGETS mirrorball_${component} EXPORT mirrorball_${component} ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(EXPORT mirrorball_${component} NAMESPACE mirrorball:: FILE mirrorball_${component}.cmake
          DESTINATION "${mirrorball_package_dir}")
  get_property(needs GLOBAL PROPERTY MIRRORBALL_NEEDS_${component})
  string(APPEND mirrorball_needs "set(mirrorball_needs_${component} ${needs})\n")

  # #include "mirrorball/base/result.h" and "formula/formula.h" read the same inside and outside.
  get_property(headers GLOBAL PROPERTY MIRRORBALL_HEADERS_${component})
  foreach(header IN LISTS headers)
    cmake_path(GET header PARENT_PATH closet)
    install(FILES "${PROJECT_SOURCE_DIR}/src/mirrorball/${component}/${header}"
            DESTINATION "${mirrorball_include_dir}/mirrorball/${component}/${closet}")
  endforeach()
endforeach()
string(REPLACE ";" " " mirrorball_needs "${mirrorball_needs}")

install(FILES "${PROJECT_SOURCE_DIR}/src/mirrorball/mirrorball.h" DESTINATION "${mirrorball_include_dir}/mirrorball")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/formula" DESTINATION "${mirrorball_include_dir}"
        FILES_MATCHING PATTERN "*.h" PATTERN "*.inc" PATTERN "*.glsl")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/mirrorballComponents.cmake" CONTENT "@mirrorball_needs@" @ONLY)
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/mirrorballConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/mirrorballConfig.cmake"
                              INSTALL_DESTINATION "${mirrorball_package_dir}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/mirrorballConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/mirrorballConfig.cmake" "${PROJECT_BINARY_DIR}/mirrorballConfigVersion.cmake"
              "${PROJECT_BINARY_DIR}/mirrorballComponents.cmake"
        DESTINATION "${mirrorball_package_dir}")
