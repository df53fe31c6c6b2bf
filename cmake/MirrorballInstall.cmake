# What `cmake --install` puts where, besides the program (apps/cli): one static library a room, the headers and formulas
# under include/mirrorball, the licence, and the CMake package that find_package(mirrorball) reads. docs/building.md
# shows how it is used, tests/consumer uses it.

include(CMakePackageConfigHelpers)

set(mirrorball_include_dir "${CMAKE_INSTALL_INCLUDEDIR}/mirrorball")
set(mirrorball_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/mirrorball")

get_property(mirrorball_rooms GLOBAL PROPERTY MIRRORBALL_ROOMS)
install(TARGETS ${mirrorball_rooms} EXPORT mirrorballTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")

# #include "mirrorball/base/result.h" and "formula/formula.h" read the same inside and outside.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/mirrorball" DESTINATION "${mirrorball_include_dir}"
        FILES_MATCHING PATTERN "*.h" PATTERN "*_testing.h" EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/formula" DESTINATION "${mirrorball_include_dir}"
        FILES_MATCHING PATTERN "*.h" PATTERN "*.inc" PATTERN "*.glsl")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

install(EXPORT mirrorballTargets NAMESPACE mirrorball:: DESTINATION "${mirrorball_package_dir}")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/mirrorballConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/mirrorballConfig.cmake"
                              INSTALL_DESTINATION "${mirrorball_package_dir}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/mirrorballConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/mirrorballConfig.cmake" "${PROJECT_BINARY_DIR}/mirrorballConfigVersion.cmake"
        DESTINATION "${mirrorball_package_dir}")
