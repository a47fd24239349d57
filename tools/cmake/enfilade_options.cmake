# SPDX-License-Identifier: Apache-2.0
# Language level, warnings and instrumentation, the same for every target of the project.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

option(ENFILADE_WERROR "Treat warnings as errors" OFF)
set(ENFILADE_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. 'address,undefined' or 'thread'")
option(ENFILADE_FUZZ "Build the fuzz targets; needs clang" OFF)
option(ENFILADE_COVERAGE "Instrument for gcov" OFF)
option(ENFILADE_PCH "Precompile the headers that nearly every file includes; off, each file shows that it includes what it uses" ON)

option(ENFILADE_UNITY "Compile several files of a target at once: half the time, but a change recompiles them all" OFF)
if(ENFILADE_UNITY)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # The sloppiness is what ccache asks for with precompiled headers; paths below the source folder count as relative, so that
  # another checkout finds what this one compiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE_PROGRAM})
endif()

# What every target of ours compiles with; generated code takes only the instrumentation.
add_library(enfilade_instrumentation INTERFACE)
if(ENFILADE_SANITIZE)
  target_compile_options(enfilade_instrumentation INTERFACE
    -fsanitize=${ENFILADE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(enfilade_instrumentation INTERFACE -fsanitize=${ENFILADE_SANITIZE})
endif()
if(ENFILADE_COVERAGE)
  target_compile_options(enfilade_instrumentation INTERFACE --coverage)
  target_link_options(enfilade_instrumentation INTERFACE --coverage)
endif()

add_library(enfilade_warnings INTERFACE)
target_compile_options(enfilade_warnings INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
                       -Wnon-virtual-dtor -Woverloaded-virtual -Wno-missing-field-initializers)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms of GCC 12 about std::string at -O2 and above.
  target_compile_options(enfilade_warnings INTERFACE -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds
                         -Wno-maybe-uninitialized -Wno-restrict)
endif()
if(ENFILADE_UNITY)
  # Anonymous namespaces of files that are compiled by way of an including one are meant.
  target_compile_options(enfilade_warnings INTERFACE -Wno-subobject-linkage)
endif()
if(ENFILADE_WERROR)
  target_compile_options(enfilade_warnings INTERFACE -Werror)
endif()
