# cmake -DPROGRAM=… -DNAME=… -DLABELS=… -DENVIRONMENT=… -DEXCEPT=… -DTIER=… -DSERIAL=… -DROWS=… -DMEASURE=…
#       -DUNCHANGED=… -DPROGRAMS=… -DALWAYS=… -DOUTPUT=… -P DiscoverSuites.cmake
#
# Writes the file from which CTest learns the suites of a GoogleTest program: each is one test, NAME.Suite, in a process of
# its own. Suites and not single tests, since a process of its own costs more than most tests do (a GL driver is started,
# shaders are compiled), and so that the tests of a suite can share what is expensive to make.
#
# PROGRAM is a list of words: a program for another system has its emulator first (cmake/MirrorballBrowser.cmake).
# EXCEPT is a list of tests that are left out, as GoogleTest's filter has them. A suite's tier is one of its labels: that
# of its row in the file ROWS (the program's rows of tests/suites.txt), else TIER. The most expensive suites start first,
# so that all cores are busy to the end; with SERIAL nothing runs beside them. MEASURE is a list of words that comes
# before the suite's name and its command (tests/measured.sh), and UNCHANGED another, which comes before a suite that
# depends on PROGRAMS, and is not one of the list ALWAYS (tests/unchanged.sh).
cmake_minimum_required(VERSION 3.25)

list(JOIN EXCEPT ":" except)
function(quote_words words result)
  list(TRANSFORM words REPLACE "(.+)" "[==[\\1]==]")
  list(JOIN words " " words)
  set(${result} "${words}" PARENT_SCOPE)
endfunction()
quote_words("${PROGRAM}" program)
quote_words("${MEASURE}" measure)
quote_words("${UNCHANGED}" unchanged)
quote_words("${PROGRAMS}" programs)
execute_process(COMMAND ${PROGRAM} --gtest_list_tests "--gtest_filter=*-${except}"
  OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)

# Lines that are not indented name a suite, "Suite." or "Suite.  # TypeParam = …".
string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${listing}")
if(NOT suites)
  message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()

file(STRINGS "${ROWS}" rows)
foreach(row IN LISTS rows)
  string(REGEX MATCH "^([a-z]+) +([0-9.]+) .*\\.(.+)$" matched "${row}")
  set(tier_of_${CMAKE_MATCH_3} ${CMAKE_MATCH_1})
  set(cost_of_${CMAKE_MATCH_3} ${CMAKE_MATCH_2})
endforeach()

set(properties "ENVIRONMENT [==[${ENVIRONMENT}]==] TIMEOUT 600 SKIP_RETURN_CODE 77")
if(SERIAL)
  string(APPEND properties " RUN_SERIAL ON")
endif()
set(tests "")
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  string(REGEX REPLACE "\\.$" "" suite "${suite}")
  set(test "[==[${NAME}.${suite}]==]")
  set(command "${measure} ${test} ${program} [==[--gtest_filter=${suite}.*-${except}]==]")
  if(PROGRAMS AND NOT suite IN_LIST ALWAYS)
    set(command "${unchanged} ${test} ${programs} -- ${command}")
  endif()
  set(tier ${TIER})
  set(cost 0)
  if(DEFINED tier_of_${suite})
    set(tier ${tier_of_${suite}})
    set(cost ${cost_of_${suite}})
  endif()
  string(APPEND tests
    "add_test(${test} ${command})\n"
    "set_tests_properties(${test} PROPERTIES LABELS [==[${tier};${LABELS}]==] COST ${cost} ${properties})\n")
endforeach()
file(WRITE "${OUTPUT}" "${tests}")
