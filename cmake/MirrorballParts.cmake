# The parts that a build may leave out, in one table. Each has an option, ON unless told, and a package that is looked
# for only then. What is left out is told when CMake configures, and by `mirrorball --version`.
#
# mirrorball_part(OPTION NAME WHAT find_package|pkg_check_modules ARGUMENTS…)
#
# WHAT is done with it stands in the option's help. A macro, since find_package leaves variables behind.
macro(mirrorball_part part name what how package)
  option(MIRRORBALL_${part} "${what}" ON)
  if(MIRRORBALL_${part})
    if("${how}" STREQUAL pkg_check_modules)
      pkg_check_modules(${package} QUIET IMPORTED_TARGET ${ARGN})
    else()
      find_package(${package} QUIET ${ARGN})
    endif()
    if(NOT ${package}_FOUND)
      message(FATAL_ERROR "${name} is not found: install it, or leave it out by -DMIRRORBALL_${part}=OFF")
    endif()
  else()
    list(APPEND mirrorball_left_out "${name}")
  endif()
endmacro()

set(mirrorball_left_out)
mirrorball_part(PNG PNG "Read and write .png" find_package PNG)
mirrorball_part(TIFF TIFF "Read .tif" find_package TIFF 4.5)
mirrorball_part(WEBP WebP "Read .webp" pkg_check_modules webp libwebp libwebpdemux)
mirrorball_part(AVIF AVIF "Read .avif" pkg_check_modules avif libavif)
mirrorball_part(JXL JPEG-XL "Read .jxl" pkg_check_modules jxl libjxl)
mirrorball_part(JPEG JPEG "Read and write .jpg" find_package JPEG)
mirrorball_part(EXR OpenEXR "Read and write .exr; the built-in environment sunset" find_package OpenEXR)
mirrorball_part(ZSTD Zstandard "Read and write .ktx2 under Zstandard" pkg_check_modules zstd libzstd)
mirrorball_part(EMBREE Embree "Trace rays by Embree, which is faster" find_package embree 3 CONFIG)
mirrorball_part(DRACO Draco "Read meshes that Draco has compressed" find_package draco CONFIG)
mirrorball_part(MESHOPTIMIZER meshoptimizer "Read meshes that meshoptimizer has compressed, and simplify meshes"
                find_package meshoptimizer CONFIG)
mirrorball_part(CLI11 CLI11 "Build the program, and not the library alone" find_package CLI11)

list(JOIN mirrorball_left_out ", " mirrorball_left_out_text)
if(mirrorball_left_out)
  message(STATUS "Mirrorball is built without ${mirrorball_left_out_text}")
endif()
