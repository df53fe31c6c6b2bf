# cmake -DPROGRAM=… -DNAME=… -DLABELS=… -DENVIRONMENT=… -DEXCEPT=… -DLONG=… -DLONG_CONFIGURATION=… -DSERIAL=…
#       -DOUTPUT=… -P DiscoverSuites.cmake
#
# Writes the file from which CTest learns the suites of a GoogleTest program: each is one test, NAME.Suite, in a process of
# its own. Suites and not single tests, since a process of its own costs more than most tests do (a GL driver is started,
# shaders are compiled), and so that the tests of a suite can share what is dear to make.
#
# PROGRAM is a list of words: a program for another system has its emulator first (cmake/MirrorballBrowser.cmake).
# EXCEPT is a list of tests that are left out, as GoogleTest's filter has them. LONG is one of suites that only
# `ctest -C LONG_CONFIGURATION` knows, under the label `long`; "*" is all. With SERIAL nothing runs beside them.
cmake_minimum_required(VERSION 3.25)

list(JOIN EXCEPT ":" except)
list(TRANSFORM PROGRAM REPLACE "(.+)" "[==[\\1]==]" OUTPUT_VARIABLE program)
list(JOIN program " " program)
execute_process(COMMAND ${PROGRAM} --gtest_list_tests "--gtest_filter=*-${except}"
  OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)

# Lines that are not indented name a suite, "Suite." or "Suite.  # TypeParam = …".
string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${listing}")
if(NOT suites)
  message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()

set(properties "ENVIRONMENT [==[${ENVIRONMENT}]==] TIMEOUT 600 SKIP_RETURN_CODE 77")
if(SERIAL)
  string(APPEND properties " RUN_SERIAL ON")
endif()
set(tests "")
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  string(REGEX REPLACE "\\.$" "" suite "${suite}")
  set(test "[==[${NAME}.${suite}]==]")
  set(labels ${LABELS})
  set(begin "")
  set(end "")
  if(suite IN_LIST LONG OR LONG STREQUAL "*")
    list(REMOVE_ITEM LONG ${suite})
    list(APPEND labels long)
    set(begin "if(CTEST_CONFIGURATION_TYPE STREQUAL ${LONG_CONFIGURATION})\n")
    set(end "endif()\n")
  endif()
  string(APPEND tests "${begin}"
    "add_test(${test} ${program} [==[--gtest_filter=${suite}.*-${except}]==])\n"
    "set_tests_properties(${test} PROPERTIES LABELS [==[${labels}]==] ${properties})\n"
    "${end}")
endforeach()
if(LONG AND NOT LONG STREQUAL "*")
  message(FATAL_ERROR "${PROGRAM} has no suites ${LONG}, which are said to be long")
endif()
file(WRITE "${OUTPUT}" "${tests}")
