# Tests, and the tier that each suite is in: the one of its row in tests/suites.txt, which says what tiers there are.
# A suite without a row is in the tier that its program was declared with.
#
# The tier is one of the suite's labels for CTest, and the target tier_NAME builds the programs that have suites in it.
set(mirrorball_suite_rows "${PROJECT_SOURCE_DIR}/tests/suites.txt")
set(mirrorball_measure sh "${PROJECT_SOURCE_DIR}/tests/measured.sh" "${PROJECT_BINARY_DIR}/times")
set(mirrorball_unchanged sh "${PROJECT_SOURCE_DIR}/tests/unchanged.sh" run "${PROJECT_BINARY_DIR}")
file(STRINGS "${mirrorball_suite_rows}" mirrorball_rows REGEX "^[a-z]+ +[0-9.]+ +[^ ]+$")
set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${mirrorball_suite_rows}")
foreach(tier quick standard all sanitized browser long)
  add_custom_target(tier_${tier})
endforeach()
add_custom_target(tests_default DEPENDS tier_quick tier_standard)  # what ./test runs

# mirrorball_default(VARIABLE VALUE)
#
# Gives the variable this value where it has none.
macro(mirrorball_default variable value)
  if(NOT ${variable})
    set(${variable} ${value})
  endif()
endmacro()

# mirrorball_test(NAME [COMPUTES] [REPLACES] [TIER tier] SOURCES … DEPENDS … [STARTS …] [ALWAYS …] [LABELS …] [SERIAL])
#
# A GoogleTest program, NAME_test, of which CTest runs each suite as NAME.Suite under the labels given (unit unless told),
# in the tier given (standard unless told); with SERIAL while nothing else runs. A suite all of whose tests skip themselves
# (no GL driver, no shared data) is counted by CTest as skipped. Its code is an object library, NAME_test_code, which is
# optimised a little where it COMPUTES. With REPLACES its sources define functions of a room once more.
#
# STARTS are the targets of programs that its tests start. ./test leaves out a suite that has passed if neither its program
# nor these have changed since (tests/unchanged.sh), except the suites ALWAYS, which read C++ sources.
function(mirrorball_test name)
  cmake_parse_arguments(TEST "COMPUTES;REPLACES;SERIAL" "TIER" "SOURCES;DEPENDS;STARTS;ALWAYS;LABELS" ${ARGN})
  mirrorball_default(TEST_LABELS unit)
  mirrorball_default(TEST_TIER standard)
  if(EMSCRIPTEN AND NOT TEST_TIER STREQUAL long)
    set(TEST_TIER browser)
  endif()
  add_library(${name}_test_code OBJECT ${TEST_SOURCES})
  target_link_libraries(${name}_test_code PUBLIC ${TEST_DEPENDS} GTest::gmock)
  target_include_directories(${name}_test_code PUBLIC "${PROJECT_SOURCE_DIR}/tests")
  target_compile_definitions(${name}_test_code PRIVATE MIRRORBALL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  mirrorball_group_sources(${name}_test_code ${MIRRORBALL_TEST_GROUP_SIZE} ${TEST_SOURCES})
  if(TEST_COMPUTES)
    mirrorball_compile_as(${name}_test_code COMPUTING_TEST)
  else()
    mirrorball_compile_as(${name}_test_code TEST)
  endif()
  set(optimised)
  if(NOT TEST_REPLACES)
    mirrorball_optimised_objects(optimised ${TEST_DEPENDS})
  endif()
  add_executable(${name}_test ${optimised} $<TARGET_OBJECTS:mirrorball_test_main>)
  target_link_libraries(${name}_test PRIVATE ${name}_test_code)
  set(programs)
  foreach(target IN ITEMS ${name}_test LISTS TEST_STARTS)
    list(APPEND programs "$<PATH:RELATIVE_PATH,$<TARGET_FILE:${target}>,${PROJECT_BINARY_DIR}>")
  endforeach()
  foreach(target IN LISTS TEST_STARTS)
    add_dependencies(${name}_test ${target})
  endforeach()
  mirrorball_discover_suites(${name}_test ${name} TIER ${TEST_TIER} LABELS ${TEST_LABELS} SERIAL ${TEST_SERIAL}
                             PROGRAMS ${programs} ALWAYS ${TEST_ALWAYS})
endfunction()

# mirrorball_discover_suites(PROGRAM NAME TIER tier LABELS … [ENVIRONMENT …] [EXCEPT …] [SERIAL ON|OFF]
#                            [PROGRAMS …] [ALWAYS …])
#
# Tells CTest the suites of a GoogleTest program, as NAME.Suite: the target NAME_suites lists them anew when the program has
# changed. EXCEPT leaves tests out, as GoogleTest's filter has them. PROGRAMS are all on which its suites depend; without any
# they are always run, as the suites ALWAYS are.
function(mirrorball_discover_suites program name)
  cmake_parse_arguments(SUITES "" "TIER;SERIAL" "LABELS;ENVIRONMENT;EXCEPT;PROGRAMS;ALWAYS" ${ARGN})
  # The program's own rows in a file of their own, which is written only when they change: others do not list it anew. The
  # build for browsers has none, since the rows are those of the machine's own build.
  set(own_rows)
  if(NOT EMSCRIPTEN)
    string(REPLACE "." "\\." pattern "${name}")
    set(own_rows ${mirrorball_rows})
    list(FILTER own_rows INCLUDE REGEX " ${pattern}\\.[^. ]+$")
  endif()
  list(JOIN own_rows "\n" text)
  set(rows "${CMAKE_CURRENT_BINARY_DIR}/${name}_rows.txt")
  file(CONFIGURE OUTPUT "${rows}" CONTENT "${text}\n" @ONLY)
  list(TRANSFORM own_rows REPLACE " .*" "")
  set(tiers ${SUITES_TIER} ${own_rows})
  list(REMOVE_DUPLICATES tiers)
  set(suites "${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake")
  set(script "${PROJECT_SOURCE_DIR}/cmake/DiscoverSuites.cmake")
  add_custom_command(OUTPUT "${suites}"
    COMMAND ${CMAKE_COMMAND} "-DPROGRAM=${CMAKE_CROSSCOMPILING_EMULATOR};$<TARGET_FILE:${program}>" -DNAME=${name}
            "-DLABELS=${SUITES_LABELS}" "-DENVIRONMENT=${SUITES_ENVIRONMENT}" "-DEXCEPT=${SUITES_EXCEPT}"
            -DTIER=${SUITES_TIER} "-DSERIAL=${SUITES_SERIAL}" "-DROWS=${rows}" "-DMEASURE=${mirrorball_measure}"
            "-DUNCHANGED=${mirrorball_unchanged}" "-DPROGRAMS=${SUITES_PROGRAMS}" "-DALWAYS=${SUITES_ALWAYS}"
            "-DOUTPUT=${suites}" -P "${script}"
    DEPENDS ${program} "${script}" "${rows}"
    COMMENT "Listing the tests of ${program}"
    VERBATIM)
  add_custom_target(${name}_suites DEPENDS "${suites}")
  foreach(tier IN LISTS tiers)
    add_dependencies(tier_${tier} ${name}_suites)
  endforeach()
  # A program that is not built has no suites; that is a failed test, not none.
  set(include "${CMAKE_CURRENT_BINARY_DIR}/${name}_include.cmake")
  file(CONFIGURE OUTPUT "${include}" @ONLY CONTENT [=[
if(EXISTS "@suites@")
  include("@suites@")
else()
  add_test(@name@.IsNotBuilt @program@)
  set_tests_properties(@name@.IsNotBuilt PROPERTIES LABELS "@SUITES_LABELS@;@tiers@")
endif()
]=])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${include}")
endfunction()

# mirrorball_script_test(NAME [TIER tier] LABELS … [TARGETS …] [TIMEOUT s] [PROPERTIES …] COMMAND …)
#
# A test that is no GoogleTest program, as one suite of that name, in the tier of its row, else the one given (standard
# unless told). TARGETS are what must be built before; exit code 77 is a skipped test.
function(mirrorball_script_test name)
  cmake_parse_arguments(SCRIPT "" "TIER;TIMEOUT" "LABELS;TARGETS;PROPERTIES;COMMAND" ${ARGN})
  mirrorball_default(SCRIPT_TIER standard)
  mirrorball_default(SCRIPT_TIMEOUT 300)
  string(REPLACE "." "\\." pattern "${name}")
  set(own_rows ${mirrorball_rows})
  list(FILTER own_rows INCLUDE REGEX " ${pattern}$")
  set(cost 0)
  if(own_rows)
    string(REGEX MATCH "^([a-z]+) +([0-9.]+) " matched "${own_rows}")
    set(SCRIPT_TIER ${CMAKE_MATCH_1})
    set(cost ${CMAKE_MATCH_2})
  endif()
  add_test(NAME ${name} COMMAND ${mirrorball_measure} ${name} ${SCRIPT_COMMAND})
  set_tests_properties(${name} PROPERTIES LABELS "${SCRIPT_TIER};${SCRIPT_LABELS}" TIMEOUT ${SCRIPT_TIMEOUT}
                       SKIP_RETURN_CODE 77 COST ${cost} ${SCRIPT_PROPERTIES})
  foreach(target IN LISTS SCRIPT_TARGETS)
    add_dependencies(tier_${SCRIPT_TIER} ${target})
  endforeach()
endfunction()
