# The packages of the build for browsers, by Emscripten (preset browser), whose tests run in node. The system's libraries
# are for its own processor: of a package there is what its headers hold.

# Single headers out of /usr/include. The folder itself would bring those of the system's C library.
set(mirrorball_package_headers "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${mirrorball_package_headers}")
foreach(header glm hwy kissfft nlohmann stb tl xxh3.h xxhash.h)
  find_path(MIRRORBALL_FOLDER_OF_${header} ${header} PATHS /usr/include REQUIRED NO_CMAKE_FIND_ROOT_PATH)
  file(CREATE_LINK "${MIRRORBALL_FOLDER_OF_${header}}/${header}" "${mirrorball_package_headers}/${header}" SYMBOLIC)
endforeach()

# mirrorball_headers(TARGET [FOLDER …])
#
# The package TARGET, which is headers alone, in these folders.
function(mirrorball_headers target)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${mirrorball_package_headers}" ${ARGN})
endfunction()

mirrorball_headers(glm::glm)
mirrorball_headers(tl::expected)
mirrorball_headers(nlohmann_json::nlohmann_json)
mirrorball_headers(PkgConfig::hwy)  # with one kind of vectors, it chooses none when the program runs
mirrorball_headers(PkgConfig::kissfft "${PROJECT_SOURCE_DIR}/cmake/browser" "${mirrorball_package_headers}/kissfft")
add_library(mirrorball_xxhash STATIC "${PROJECT_SOURCE_DIR}/cmake/browser/xxhash.cpp")
target_include_directories(mirrorball_xxhash SYSTEM PUBLIC "${mirrorball_package_headers}")
add_library(PkgConfig::xxhash ALIAS mirrorball_xxhash)

set(MIRRORBALL_STB_FOLDER "${mirrorball_package_headers}")
include(MirrorballParts)  # of which the preset leaves all out

if(MIRRORBALL_TESTS)
  enable_testing()
  # Debian's package has GoogleTest's source, too. It is of an older CMake's policies, whose option() sees the cache alone.
  set(gtest_disable_pthreads ON CACHE INTERNAL "")
  set(INSTALL_GTEST OFF CACHE INTERNAL "")
  add_subdirectory(/usr/src/googletest "${PROJECT_BINARY_DIR}/googletest" EXCLUDE_FROM_ALL)
endif()
