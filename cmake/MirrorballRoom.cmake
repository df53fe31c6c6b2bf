# mirrorball_room(NAME [COMPUTES | READS] [HEADERS …] SOURCES … DEPENDS … [PACKAGES …]
#                 [TESTS …] [TESTS_COMPUTE] [TIER tier] [ACCURACY_TESTS …])
#
# One room of the house (docs/architecture.md): the static library mirrorball_NAME, aliased
# mirrorball::NAME, with its test programs beside it. HEADERS are those that are installed: what a program outside may
# include. DEPENDS are the targets that the room's own headers or sources use, PACKAGES those of packages that its sources
# and tests alone use: who uses the room is compiled without their headers. Files of one folder are compiled in groups
# (MirrorballGroups.cmake); how far a room that COMPUTES, or READS files, is optimised stands in
# MirrorballCompilation.cmake. TESTS are of the tier given, quick unless told (MirrorballTests.cmake), and compiled for
# speed if TESTS_COMPUTE. ACCURACY_TESTS compare results with brute force, over many inputs: TESTS have the same with few,
# and `./test --long` alone runs them.
#
# What is in the rooms, their tests, and the packages that they use are collected in the properties MIRRORBALL_…, for the
# package (MirrorballInstall.cmake) and for the sanitizers (tests/sanitized).
function(mirrorball_room name)
  cmake_parse_arguments(ROOM "COMPUTES;READS;TESTS_COMPUTE" "TIER"
                        "HEADERS;SOURCES;DEPENDS;PACKAGES;TESTS;ACCURACY_TESTS" ${ARGN})
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
    mirrorball_compile_as(${target} COMPUTING)
  elseif(ROOM_READS)
    mirrorball_compile_as(${target} READING)
  else()
    mirrorball_compile_as(${target} PLAIN)
  endif()

  mirrorball_component(${name} DEPENDS ${ROOM_DEPENDS} ${ROOM_PACKAGES})
  set_property(GLOBAL PROPERTY MIRRORBALL_HEADERS_${name} ${ROOM_HEADERS})
  list(TRANSFORM ROOM_SOURCES PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" REGEX "^[^/]")
  list(FILTER ROOM_DEPENDS EXCLUDE REGEX "^mirrorball::")
  if(ROOM_COMPUTES OR ROOM_READS)
    set_property(GLOBAL APPEND PROPERTY MIRRORBALL_OPTIMISED_ROOMS ${name})
    set_property(GLOBAL APPEND PROPERTY MIRRORBALL_OPTIMISED_SOURCES ${ROOM_SOURCES})
  else()
    set_property(GLOBAL APPEND PROPERTY MIRRORBALL_ROOM_SOURCES ${ROOM_SOURCES})
  endif()
  set_property(GLOBAL APPEND PROPERTY MIRRORBALL_ROOM_PACKAGES ${ROOM_DEPENDS} ${ROOM_PACKAGES})
  if(MIRRORBALL_TESTS AND ROOM_TESTS)
    mirrorball_default(ROOM_TIER quick)
    set(computes)
    if(ROOM_TESTS_COMPUTE)
      set(computes COMPUTES)
    endif()
    mirrorball_test(${name} ${computes} TIER ${ROOM_TIER} SOURCES ${ROOM_TESTS} DEPENDS ${target} ${ROOM_PACKAGES})
    set_property(GLOBAL APPEND PROPERTY MIRRORBALL_ROOM_TESTS ${name}_test_code)
  endif()
  if(MIRRORBALL_TESTS AND ROOM_ACCURACY_TESTS)
    mirrorball_test(${name}_accuracy COMPUTES TIER long LABELS accuracy SOURCES ${ROOM_ACCURACY_TESTS}
                    DEPENDS ${target} ${ROOM_PACKAGES})
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
