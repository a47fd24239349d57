# SPDX-License-Identifier: Apache-2.0
# The three kinds of target the project has.

include(GoogleTest)

# What users run is optimised, kernels are vectorised too; the code of tests, which runs once, is not: that saves a third of its
# compilation.
set(kernel_options $<$<CONFIG:Release>:-O3>)
set(test_code_options -O0)

# Half of the time it takes to compile a file of ours goes into Eigen and the standard library.
if(ENFILADE_PCH)
  set(common_headers <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <stdexcept> <string>
      <string_view> <utility> <vector> <Eigen/Core>)
  foreach(pch enfilade_pch enfilade_kernel_pch enfilade_test_pch)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/${pch}.cpp CONTENT "")
    add_library(${pch} OBJECT ${CMAKE_BINARY_DIR}/${pch}.cpp)
    target_link_libraries(${pch} PRIVATE enfilade_instrumentation Eigen3::Eigen)
    target_compile_options(${pch} PRIVATE -fpch-preprocess)
  endforeach()
  target_link_libraries(enfilade_test_pch PRIVATE GTest::gtest)
  target_compile_options(enfilade_kernel_pch PRIVATE ${kernel_options})
  target_compile_options(enfilade_test_pch PRIVATE ${test_code_options})
  target_precompile_headers(enfilade_pch PRIVATE ${common_headers})
  target_precompile_headers(enfilade_kernel_pch PRIVATE ${common_headers})
  target_precompile_headers(enfilade_test_pch PRIVATE ${common_headers} <gtest/gtest.h>)
endif()

function(enfilade_use_pch name pch)
  if(ENFILADE_PCH)
    target_compile_options(${name} PRIVATE -fpch-preprocess)
    target_precompile_headers(${name} REUSE_FROM ${pch})
  endif()
endfunction()

# enfilade_library(NAME SOURCES a.cpp … [DEPENDS lib …] [SYSTEM_INCLUDES dir …] [KERNEL])
# Headers are included from the repository root. KERNEL: most of the time of a running system goes by in here.
function(enfilade_library name)
  cmake_parse_arguments(arg "KERNEL" "" "SOURCES;DEPENDS;SYSTEM_INCLUDES" ${ARGN})
  if(arg_SOURCES)
    add_library(${name} STATIC ${arg_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(${name} PRIVATE enfilade_warnings)
    if(arg_KERNEL)
      target_compile_options(${name} PRIVATE ${kernel_options})
      enfilade_use_pch(${name} enfilade_kernel_pch)
    else()
      enfilade_use_pch(${name} enfilade_pch)
    endif()
  else()
    add_library(${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${name} ${scope} ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} ${scope} enfilade_instrumentation ${arg_DEPENDS})
  if(arg_SYSTEM_INCLUDES)
    target_include_directories(${name} SYSTEM ${scope} ${arg_SYSTEM_INCLUDES})
  endif()
endfunction()

# enfilade_executable(NAME SOURCES main.cpp … [DEPENDS lib …]): lands in <build>/bin.
function(enfilade_executable name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE enfilade_warnings enfilade_instrumentation ${arg_DEPENDS})
  enfilade_use_pch(${name} enfilade_pch)
endfunction()

# enfilade_test(NAME LABEL unit|interfaces|threads|integration … SOURCES x_test.cpp … [DEPENDS lib …] [TIMEOUT seconds] [OPTIMISED])
# OPTIMISED: tests that compute a lot themselves.
# Target tests_<label> builds all tests of one label.
function(enfilade_test name)
  cmake_parse_arguments(arg "OPTIMISED" "TIMEOUT" "LABEL;SOURCES;DEPENDS" ${ARGN})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 180)  # sanitizers take ten times as long
  endif()
  add_executable(${name} ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE enfilade_warnings enfilade_instrumentation enfilade_etc_folder
                        ${arg_DEPENDS} GTest::gtest GTest::gtest_main)
  if(arg_OPTIMISED)
    enfilade_use_pch(${name} enfilade_pch)
  else()
    target_compile_options(${name} PRIVATE ${test_code_options})
    enfilade_use_pch(${name} enfilade_test_pch)
  endif()
  foreach(label ${arg_LABEL})
    if(NOT TARGET tests_${label})
      add_custom_target(tests_${label})
    endif()
    add_dependencies(tests_${label} ${name})
  endforeach()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 TEST_LIST ${name}_cases PROPERTIES TIMEOUT ${arg_TIMEOUT}
                       ENVIRONMENT "TSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/support/tsan.supp")
  # A list does not survive the PROPERTIES of gtest_discover_tests.
  set(labels_file ${CMAKE_CURRENT_BINARY_DIR}/${name}_labels.cmake)
  file(WRITE ${labels_file} "if(${name}_cases)\n  set_tests_properties(\${${name}_cases} PROPERTIES LABELS \"${arg_LABEL}\")\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${labels_file})
endfunction()
