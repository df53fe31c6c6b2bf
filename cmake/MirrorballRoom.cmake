# mirrorball_room(NAME [COMPUTES] [HEADERS …] SOURCES … DEPENDS … [PACKAGES …] [TESTS …] [ACCURACY_TESTS …]
#                 [LONG …])
#
# One room of the house (docs/architecture.md): the static library mirrorball_NAME, aliased
# mirrorball::NAME, with its test programs beside it. HEADERS are those that are installed: what a program outside may
# include. DEPENDS are the targets that the room's own headers or sources use, PACKAGES those of packages that its sources
# and tests alone use: who uses the room is compiled without their headers. One that COMPUTES is optimised further. Files
# of one folder are compiled in groups (MirrorballGroups.cmake). ACCURACY_TESTS compare results with brute force, over
# many inputs: TESTS have the same with few, and `./test --long` alone runs them, and those suites of TESTS that stand
# under LONG.
#
# What is in the rooms, their tests, which of these are long, and the packages that they use are collected in the
# properties MIRRORBALL_…, for the package (MirrorballInstall.cmake) and for the sanitizers (tests/sanitized).
function(mirrorball_room name)
  cmake_parse_arguments(ROOM "COMPUTES" "" "HEADERS;SOURCES;DEPENDS;PACKAGES;TESTS;ACCURACY_TESTS;LONG" ${ARGN})
  set(target mirrorball_${name})
  add_library(${target} STATIC ${ROOM_SOURCES})
  add_library(mirrorball::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/mirrorball>")
  target_link_libraries(${target} PUBLIC ${ROOM_DEPENDS} PRIVATE ${ROOM_PACKAGES})
  target_compile_features(${target} PUBLIC cxx_std_20)
  mirrorball_group_sources(${target} ${MIRRORBALL_GROUP_SIZE} ${ROOM_SOURCES})
  if(ROOM_COMPUTES)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O3>)
    mirrorball_use_precompiled_headers(${target} COMPUTES)
  else()
    mirrorball_use_precompiled_headers(${target})
  endif()

  mirrorball_component(${name} DEPENDS ${ROOM_DEPENDS} ${ROOM_PACKAGES})
  set_property(GLOBAL PROPERTY MIRRORBALL_HEADERS_${name} ${ROOM_HEADERS})
  list(TRANSFORM ROOM_SOURCES PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" REGEX "^[^/]")
  list(FILTER ROOM_DEPENDS EXCLUDE REGEX "^mirrorball::")
  if(ROOM_COMPUTES)
    set_property(GLOBAL APPEND PROPERTY MIRRORBALL_COMPUTING_SOURCES ${ROOM_SOURCES})
  else()
    set_property(GLOBAL APPEND PROPERTY MIRRORBALL_ROOM_SOURCES ${ROOM_SOURCES})
  endif()
  set_property(GLOBAL APPEND PROPERTY MIRRORBALL_ROOM_PACKAGES ${ROOM_DEPENDS} ${ROOM_PACKAGES})
  if(MIRRORBALL_TESTS AND ROOM_TESTS)
    mirrorball_test(${name} SOURCES ${ROOM_TESTS} LONG ${ROOM_LONG} DEPENDS ${target} ${ROOM_PACKAGES})
    set_property(GLOBAL APPEND PROPERTY MIRRORBALL_ROOM_TESTS ${name}_test_code)
    set_property(GLOBAL APPEND PROPERTY MIRRORBALL_LONG_SUITES ${ROOM_LONG})
  endif()
  if(MIRRORBALL_TESTS AND ROOM_ACCURACY_TESTS)
    mirrorball_test(${name}_accuracy SOURCES ${ROOM_ACCURACY_TESTS} DEPENDS ${target} ${ROOM_PACKAGES}
                    LABELS accuracy LONG "*")
  endif()
endfunction()

# mirrorball_component(NAME [DEPENDS …])
#
# Makes the target mirrorball_NAME a component of the package (MirrorballInstall.cmake), which needs these targets.
# Components are told of in the order in which one needs another.
function(mirrorball_component name)
  cmake_parse_arguments(COMPONENT "" "" "DEPENDS" ${ARGN})
  set_property(GLOBAL APPEND PROPERTY MIRRORBALL_COMPONENTS ${name})
  set_property(GLOBAL PROPERTY MIRRORBALL_NEEDS_${name} ${COMPONENT_DEPENDS})
endfunction()

# mirrorball_test(NAME SOURCES … DEPENDS … [LABELS …] [LONG …] [SERIAL])
#
# A GoogleTest program, NAME_test, of which CTest runs each suite as NAME.Suite under the labels given (unit unless told);
# those named under LONG ("*" for all) only with `ctest -C long`, as `./test --long` does; with SERIAL while nothing else runs.
# A suite all of whose tests skip themselves (no GL driver, no shared data) is counted by CTest as skipped. Its code is an
# object library, NAME_test_code.
function(mirrorball_test name)
  cmake_parse_arguments(TEST "SERIAL" "" "SOURCES;DEPENDS;LABELS;LONG" ${ARGN})
  if(NOT TEST_LABELS)
    set(TEST_LABELS unit)
  endif()
  if(EMSCRIPTEN)
    list(APPEND TEST_LABELS browser)
  endif()
  add_library(${name}_test_code OBJECT ${TEST_SOURCES})
  target_link_libraries(${name}_test_code PUBLIC ${TEST_DEPENDS} GTest::gmock)
  target_include_directories(${name}_test_code PUBLIC "${PROJECT_SOURCE_DIR}/tests")
  target_compile_definitions(${name}_test_code PRIVATE MIRRORBALL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_compile_options(${name}_test_code PRIVATE ${mirrorball_test_options})
  mirrorball_group_sources(${name}_test_code ${MIRRORBALL_TEST_GROUP_SIZE} ${TEST_SOURCES})
  mirrorball_use_precompiled_headers(${name}_test_code TEST)
  add_executable(${name}_test $<TARGET_OBJECTS:mirrorball_test_main>)
  target_link_libraries(${name}_test PRIVATE ${name}_test_code)
  mirrorball_discover_suites(${name}_test ${name} LABELS ${TEST_LABELS} LONG ${TEST_LONG} SERIAL ${TEST_SERIAL})
endfunction()

# mirrorball_discover_suites(PROGRAM NAME LABELS … [ENVIRONMENT …] [EXCEPT …] [LONG …] [SERIAL ON|OFF]
#                            [CONFIGURATION …])
#
# Tells CTest the suites of a GoogleTest program, as NAME.Suite: the target NAME_suites lists them anew when the program has
# changed. EXCEPT leaves tests out, as GoogleTest's filter has them. With CONFIGURATION only `ctest -C CONFIGURATION` knows
# them, and only what names the target builds them; those under LONG are then known with `-C CONFIGURATION_long`.
function(mirrorball_discover_suites program name)
  cmake_parse_arguments(SUITES "" "CONFIGURATION;SERIAL" "LABELS;ENVIRONMENT;EXCEPT;LONG" ${ARGN})
  set(long_configuration long)
  if(SUITES_CONFIGURATION)
    set(long_configuration ${SUITES_CONFIGURATION}_long)
  endif()
  set(suites "${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake")
  set(script "${PROJECT_SOURCE_DIR}/cmake/DiscoverSuites.cmake")
  add_custom_command(OUTPUT "${suites}"
    COMMAND ${CMAKE_COMMAND} "-DPROGRAM=${CMAKE_CROSSCOMPILING_EMULATOR};$<TARGET_FILE:${program}>" -DNAME=${name}
            "-DLABELS=${SUITES_LABELS}" "-DENVIRONMENT=${SUITES_ENVIRONMENT}" "-DEXCEPT=${SUITES_EXCEPT}"
            "-DLONG=${SUITES_LONG}" -DLONG_CONFIGURATION=${long_configuration} "-DSERIAL=${SUITES_SERIAL}"
            "-DOUTPUT=${suites}" -P "${script}"
    DEPENDS ${program} "${script}"
    COMMENT "Listing the tests of ${program}"
    VERBATIM)
  if(SUITES_CONFIGURATION)
    add_custom_target(${name}_suites DEPENDS "${suites}")
  else()
    add_custom_target(${name}_suites ALL DEPENDS "${suites}")
  endif()
  # A program that is not built has no suites; that is a failed test, not none.
  set(include "${CMAKE_CURRENT_BINARY_DIR}/${name}_include.cmake")
  file(CONFIGURE OUTPUT "${include}" @ONLY CONTENT [=[
if("@SUITES_CONFIGURATION@" STREQUAL "" OR CTEST_CONFIGURATION_TYPE MATCHES "^@SUITES_CONFIGURATION@(_long)?$")
  if(EXISTS "@suites@")
    include("@suites@")
  else()
    add_test(@name@.IsNotBuilt @program@)
    set_tests_properties(@name@.IsNotBuilt PROPERTIES LABELS "@SUITES_LABELS@")
  endif()
endif()
]=])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${include}")
endfunction()
