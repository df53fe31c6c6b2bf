# The target `reference`: Doxygen's pages of the public headers, those that are installed, in build/…/reference/html. A
# warning of Doxygen's is an error.
find_program(MIRRORBALL_DOXYGEN doxygen)
mark_as_advanced(MIRRORBALL_DOXYGEN)
if(NOT MIRRORBALL_DOXYGEN)
  return()
endif()

set(mirrorball_reference_input "\"${PROJECT_SOURCE_DIR}/src/mirrorball/mirrorball.h\" \"${PROJECT_SOURCE_DIR}/formula\"")
get_property(mirrorball_components GLOBAL PROPERTY MIRRORBALL_COMPONENTS)
foreach(component IN LISTS mirrorball_components)
  get_property(headers GLOBAL PROPERTY MIRRORBALL_HEADERS_${component})
  foreach(header IN LISTS headers)
    string(APPEND mirrorball_reference_input " \"${PROJECT_SOURCE_DIR}/src/mirrorball/${component}/${header}\"")
  endforeach()
endforeach()
configure_file("${PROJECT_SOURCE_DIR}/cmake/Doxyfile.in" "${PROJECT_BINARY_DIR}/Doxyfile" @ONLY)
add_custom_target(reference COMMAND "${MIRRORBALL_DOXYGEN}" "${PROJECT_BINARY_DIR}/Doxyfile"
                  COMMENT "Writing ${PROJECT_BINARY_DIR}/reference/html/index.html" VERBATIM)
if(MIRRORBALL_TESTS)
  mirrorball_script_test(Reference.HasNoWarnings TIER all LABELS house
    COMMAND "${MIRRORBALL_DOXYGEN}" "${PROJECT_BINARY_DIR}/Doxyfile")
endif()
