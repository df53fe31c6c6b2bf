# mirrorball_use_precompiled_headers(TARGET [TEST | COMPUTES])
#
# What most files include of the standard library and of GLM takes longer to read than the files themselves: it is
# compiled once; once more for those that are optimised otherwise, since GCC 12 crashes on a header that was compiled with
# another -O. TEST has GoogleTest besides. Only headers from outside are among them, since a change of one of them
# compiles everything again. -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON shows where a file has forgotten an #include.
set(mirrorball_common_headers
  <algorithm> <array> <cmath> <cstddef> <cstdint> <cstdio> <cstdlib> <cstring> <filesystem> <functional> <limits> <map>
  <memory> <numbers> <numeric> <optional> <random> <set> <span> <string> <string_view> <utility> <variant> <vector>
  <glm/glm.hpp> <tl/expected.hpp>)
set(mirrorball_test_headers ${mirrorball_common_headers} <fstream> <sstream> <gmock/gmock.h> <gtest/gtest.h>)

# Without a source a library has no compiler that would make its header.
set(mirrorball_empty_source "${PROJECT_BINARY_DIR}/empty.cpp")
file(CONFIGURE OUTPUT "${mirrorball_empty_source}" CONTENT "")

function(mirrorball_precompile_headers name)
  add_library(${name} OBJECT "${mirrorball_empty_source}")
  target_compile_options(${name} PRIVATE ${ARGN})
  target_link_libraries(${name} PRIVATE glm::glm tl::expected)
  target_precompile_headers(${name} PRIVATE ${mirrorball_common_headers})
endfunction()

mirrorball_precompile_headers(mirrorball_headers)
if(CMAKE_BUILD_TYPE STREQUAL Release)
  mirrorball_precompile_headers(mirrorball_computing_headers -O3)
endif()
if(MIRRORBALL_TESTS)
  add_library(mirrorball_test_main OBJECT "${PROJECT_SOURCE_DIR}/tests/main.cpp")
  target_link_libraries(mirrorball_test_main PRIVATE glm::glm tl::expected GTest::gmock)
  target_compile_options(mirrorball_test_main PRIVATE ${mirrorball_test_options})
  target_precompile_headers(mirrorball_test_main PRIVATE ${mirrorball_test_headers})
endif()

function(mirrorball_use_precompiled_headers target)
  if("TEST" IN_LIST ARGN)
    target_precompile_headers(${target} REUSE_FROM mirrorball_test_main)
  elseif("COMPUTES" IN_LIST ARGN AND TARGET mirrorball_computing_headers)
    target_precompile_headers(${target} REUSE_FROM mirrorball_computing_headers)
  else()
    target_precompile_headers(${target} REUSE_FROM mirrorball_headers)
  endif()
endfunction()
