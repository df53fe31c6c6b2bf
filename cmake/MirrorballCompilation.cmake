# mirrorball_compile_as(TARGET COMPUTING | READING | PLAIN | TEST | COMPUTING_TEST)
#
# How far a target is optimised, and its precompiled header.
#
#                   Release  Dev
#   COMPUTING       -O3     -O2   loops over texels and rays
#   READING         -O2     -O1   loops over the bytes, vertices and texels of files
#   PLAIN           -O2     -O0   code that runs once for each start, file or frame
#   TEST            -O0     -O0   tests, most of whose own code runs once
#   COMPUTING_TEST  -O1     -O1   tests that compute what they compare with, texel by texel
#
# In Dev, the tests' build, the optimiser works where that was measured to pay (docs/performance/build.md). For browsers
# all rooms have -O2, and all tests -O1.
#
# What most files include of the standard library and of GLM takes longer to read than the files themselves, so it is
# compiled once for each kind: a compiler refuses a header that was compiled with another -O. Only headers from outside
# are among them, since a change of one of them compiles everything again. -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON shows
# where a file has forgotten an #include.
set(mirrorball_common_headers
  <algorithm> <array> <cmath> <cstddef> <cstdint> <cstdio> <cstdlib> <cstring> <filesystem> <functional> <limits> <map>
  <memory> <numbers> <numeric> <optional> <random> <set> <span> <string> <string_view> <utility> <variant> <vector>
  <glm/glm.hpp> <tl/expected.hpp>)
set(mirrorball_test_headers_list ${mirrorball_common_headers} <fstream> <sstream> <gmock/gmock.h> <gtest/gtest.h>)

set(mirrorball_options_computing $<$<CONFIG:Release>:-O3> $<$<CONFIG:Dev>:-O2>)
set(mirrorball_options_reading "")
set(mirrorball_options_plain $<$<CONFIG:Dev>:-O0>)
# Without a debugger's tables of lines: they are a twelfth of the tests' compilation, and a failed test names its line.
set(mirrorball_options_test $<$<NOT:$<CONFIG:Debug>>:-O0> $<$<CONFIG:Dev>:-g0>)
set(mirrorball_options_computing_test $<$<NOT:$<CONFIG:Debug>>:-O1> $<$<CONFIG:Dev>:-g0>)
if(EMSCRIPTEN)
  # Emscripten 3.1.6's compiler gathers neighbouring floats into vectors wrongly: the texel densities of environment were
  # infinite, and directions on a ball did not come back. To Clang an -O after -fno-slp-vectorize takes that back.
  foreach(kind computing reading plain)
    set(mirrorball_options_${kind} -O2 -fno-slp-vectorize)
  endforeach()
  foreach(kind test computing_test)
    set(mirrorball_options_${kind} -O1 -fno-slp-vectorize)
  endforeach()
elseif(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  # What the header's templates make is compiled with the header, not again in each file that includes it.
  add_compile_options(-fpch-instantiate-templates)
endif()

# Without a source a library has no compiler that would make its header.
set(mirrorball_empty_source "${PROJECT_BINARY_DIR}/empty.cpp")
file(CONFIGURE OUTPUT "${mirrorball_empty_source}" CONTENT "")

function(mirrorball_compile_as target kind)
  string(TOLOWER ${kind} name)
  target_compile_options(${target} PRIVATE ${mirrorball_options_${name}})
  target_precompile_headers(${target} REUSE_FROM mirrorball_${name}_headers)
endfunction()

# The library whose only purpose is the header of one kind.
function(mirrorball_add_precompiled_header name)
  add_library(mirrorball_${name}_headers OBJECT "${mirrorball_empty_source}")
  target_compile_options(mirrorball_${name}_headers PRIVATE ${mirrorball_options_${name}})
  target_link_libraries(mirrorball_${name}_headers PRIVATE glm::glm tl::expected)
  target_precompile_headers(mirrorball_${name}_headers PRIVATE ${ARGN})
endfunction()
foreach(name computing reading plain)
  mirrorball_add_precompiled_header(${name} ${mirrorball_common_headers})
endforeach()
if(MIRRORBALL_TESTS)
  foreach(name test computing_test)
    mirrorball_add_precompiled_header(${name} ${mirrorball_test_headers_list})
    target_link_libraries(mirrorball_${name}_headers PRIVATE GTest::gmock)
  endforeach()
  add_library(mirrorball_test_main OBJECT "${PROJECT_SOURCE_DIR}/tests/main.cpp")
  target_link_libraries(mirrorball_test_main PRIVATE glm::glm tl::expected GTest::gmock)
  mirrorball_compile_as(mirrorball_test_main TEST)
endif()

# mirrorball_optimised_objects(RESULT TARGET…)
#
# The objects of all optimised rooms among these targets and what they need, for the head of a program's list of sources.
# Of an inline function that several objects contain, the linker keeps the first copy: without this, vectors and formulas
# would be those of the tests or the command line, which are not optimised. In Release all are
# optimised alike, and nothing need come first.
function(mirrorball_optimised_objects result)
  set(objects)
  if(CMAKE_BUILD_TYPE STREQUAL Dev AND NOT EMSCRIPTEN)
    get_property(optimised GLOBAL PROPERTY MIRRORBALL_OPTIMISED_ROOMS)
    set(open ${ARGN})
    set(seen)
    while(open)
      list(POP_FRONT open target)
      string(REGEX REPLACE "^mirrorball(::|_)" "" name "${target}")
      if(name STREQUAL target OR name IN_LIST seen)
        continue()
      endif()
      list(APPEND seen ${name})
      get_property(needs GLOBAL PROPERTY MIRRORBALL_NEEDS_${name})
      list(APPEND open ${needs})
      if(name IN_LIST optimised)
        list(APPEND objects $<TARGET_OBJECTS:mirrorball_${name}>)
      endif()
    endwhile()
  endif()
  set(${result} ${objects} PARENT_SCOPE)
endfunction()
