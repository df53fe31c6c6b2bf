# What every target of the project is compiled with, and the options that change it.

option(MIRRORBALL_TESTS "Build the tests" ON)
option(MIRRORBALL_BENCH "Build the benchmarks" ON)
option(MIRRORBALL_THREADS "Compute on all cores, with oneTBB" ON)
option(MIRRORBALL_FUZZ "Build the fuzzers (clang with libFuzzer)" OFF)
option(MIRRORBALL_WARNINGS_AS_ERRORS "Stop at the first compiler warning" OFF)
set(MIRRORBALL_GROUP_SIZE 60000 CACHE STRING
    "Characters of neighbouring files that are compiled together (MirrorballGroups.cmake); 0 for each file alone")
set(MIRRORBALL_TEST_GROUP_SIZE 60000 CACHE STRING "The same of the tests' own code, and of what the sanitizers see")
set(MIRRORBALL_SANITIZE "" CACHE STRING "Sanitizers to build with, for example address,undefined")

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
# How far each target is optimised stands in MirrorballCompilation.cmake; these are the flags that the others have.
if(CMAKE_CXX_FLAGS_RELEASE STREQUAL "-O3 -DNDEBUG")  # CMake's own choice
  set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
endif()
# Dev has assertions and line numbers.
set(CMAKE_CXX_FLAGS_DEV "-O1 -g1")
set(CMAKE_EXE_LINKER_FLAGS_DEV "")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# The rooms may end up in a shared library, so all code is position independent; as much of it is inlined as if it were
# not. In programs too: precompiled headers only serve what is compiled with the same options.
if(NOT EMSCRIPTEN)
  add_compile_options(-fPIC $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
endif()

# Results must not depend on whether a compiler fuses a multiplication with an addition.
add_compile_options(-ffp-contract=off)
# Looking for what deserves a warning is a tenth of the compiler's work. A user of the program cannot mend it; who
# develops builds Dev.
if(NOT CMAKE_BUILD_TYPE STREQUAL Release OR MIRRORBALL_WARNINGS_AS_ERRORS)
  add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor)
endif()
# Clang counts changes of sign among the conversions, which GCC's -Wconversion leaves alone.
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  add_compile_options(-Wno-sign-conversion)
endif()
if(MIRRORBALL_WARNINGS_AS_ERRORS)
  add_compile_options(-Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC 12 sees impossible sizes in std::string and std::variant once it has inlined them (its bugs 105329, 105562), and
  # complains of them where their headers are precompiled.
  if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    add_compile_options(-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
  # In KiB: what a compiler takes before it looks for memory that it no longer needs, which was a fourteenth of its work.
  # A group of files is done with less.
  add_compile_options(--param=ggc-min-heapsize=524288)
endif()
# The program reads files of strangers. So stacks notice when they are overwritten, copies know the size of their target,
# and the table of calls into libraries is filled and locked before the first of them, as distributions ask for.
if(CMAKE_BUILD_TYPE STREQUAL Release AND CMAKE_SYSTEM_NAME STREQUAL Linux)
  add_compile_options(-fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
  add_link_options(LINKER:-z,relro,-z,now)
endif()
if(MIRRORBALL_SANITIZE)
  add_compile_options(-fsanitize=${MIRRORBALL_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${MIRRORBALL_SANITIZE})
endif()
if(EMSCRIPTEN)
  # Vectors of 128 bits, which all browsers have; exceptions, as the standard library and its callers expect them.
  add_compile_options(-msimd128 -fexceptions)
  # Programs, which are the tests, see the files of the machine and wait for their own module to be compiled: where node
  # has a fetch, Emscripten 3.1.6 would ask that for it, which knows no files. Above -O1 their JavaScript is made smaller,
  # by a library that only Debian's own node finds.
  add_link_options(-O1 -fexceptions -sALLOW_MEMORY_GROWTH -sEXIT_RUNTIME -sNODERAWFS -sWASM_ASYNC_COMPILATION=0
                   "SHELL:--pre-js ${PROJECT_SOURCE_DIR}/cmake/browser/node_files.js")
endif()
if(MIRRORBALL_FUZZ)
  # Counts which branches an input takes; the harnesses in fuzz/ link the fuzzer itself.
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
