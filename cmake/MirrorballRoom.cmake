# mirrorball_room(NAME SOURCES … DEPENDS … [TESTS …] [TEST_DEPENDS …] [LABELS …])
#
# One room of the house (docs/architecture.md): the static library mirrorball_NAME, aliased
# mirrorball::NAME, with one test program beside it. DEPENDS are the targets that the room's own
# headers or sources use.
function(mirrorball_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS;TESTS;TEST_DEPENDS" ${ARGN})
  set(target mirrorball_${name})
  add_library(${target} STATIC ${ROOM_SOURCES})
  add_library(mirrorball::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/mirrorball>")
  target_link_libraries(${target} PUBLIC ${ROOM_DEPENDS})
  target_compile_features(${target} PUBLIC cxx_std_20)
  mirrorball_use_precompiled_headers(${target})
  set_property(GLOBAL APPEND PROPERTY MIRRORBALL_ROOMS ${target})
  if(MIRRORBALL_TESTS AND ROOM_TESTS)
    mirrorball_test(${name}_test SOURCES ${ROOM_TESTS} DEPENDS ${target} ${ROOM_TEST_DEPENDS})
  endif()
endfunction()

# mirrorball_test(NAME SOURCES … DEPENDS … [LABELS …])
#
# A GoogleTest program, each of whose tests CTest runs by name, under the labels given (unit unless told).
# A test that GoogleTest skips (no GL driver, no shared data) is counted by CTest as skipped.
function(mirrorball_test name)
  cmake_parse_arguments(TEST "" "" "SOURCES;DEPENDS;LABELS" ${ARGN})
  if(NOT TEST_LABELS)
    set(TEST_LABELS unit)
  endif()
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE ${TEST_DEPENDS} GTest::gtest_main GTest::gmock)
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  mirrorball_use_precompiled_headers(${name} TEST)
  target_compile_definitions(${name} PRIVATE
    MIRRORBALL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(MIRRORBALL_SANITIZE)
    target_sources(${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests/keep_drivers_loaded.cpp")
  endif()
  gtest_discover_tests(${name} NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60 PROPERTIES LABELS "${TEST_LABELS}" TIMEOUT 600)
endfunction()
