# mirrorball_compile_alone(SOURCE…)
#
# Leaves files of this folder out of all groups that are made later.
function(mirrorball_compile_alone)
  list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  set_property(GLOBAL APPEND PROPERTY MIRRORBALL_ALONE ${ARGN})
endfunction()

# mirrorball_group_sources(TARGET SIZE SOURCE…)
#
# Compiles neighbours together: the files of one folder, as many at a time as have SIZE characters. What
# they include is read once for all of them, and what their templates make is made once, which is more than half of a
# compiler's work here. A changed file takes its group along, so a group is a fraction of a room. Private names, those in
# anonymous namespaces, must therefore be unique in a folder. A file that Highway includes once for each kind of
# processor stays alone, and so does one with options of its own (CMake sees to that).
#
# CMake 3.25 has groups (UNITY_BUILD_MODE GROUP), but does not make them by folder and size.
function(mirrorball_group_sources target size_of_group)
  if(NOT size_of_group)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_property(alone GLOBAL PROPERTY MIRRORBALL_ALONE)
  set(last_folder)
  foreach(source IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH source)
    # What does not exist yet is made by the build, and its size is not known.
    if(source IN_LIST alone OR NOT EXISTS "${source}")
      continue()
    endif()
    file(STRINGS "${source}" includes_itself REGEX "HWY_TARGET_INCLUDE" LIMIT_COUNT 1)
    if(includes_itself)
      continue()
    endif()
    cmake_path(GET source PARENT_PATH folder)
    file(SIZE "${source}" bytes)
    if(NOT folder STREQUAL last_folder)
      cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${PROJECT_SOURCE_DIR}" OUTPUT_VARIABLE name)
      string(MAKE_C_IDENTIFIER "${name}" name)
      set(last_folder "${folder}")
      set(number 0)
      set(size 0)
    endif()
    math(EXPR size "${size} + ${bytes}")
    if(size GREATER size_of_group)
      math(EXPR number "${number} + 1")
      set(size ${bytes})
    endif()
    set_property(SOURCE "${source}" TARGET_DIRECTORY ${target} PROPERTY UNITY_GROUP "${name}_${number}")
  endforeach()
endfunction()
