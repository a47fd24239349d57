# SPDX-License-Identifier: Apache-2.0
# C++ types from IDL, generated into the build tree.

find_program(FASTDDSGEN fastddsgen REQUIRED)

# enfilade_idl_library(NAME FOLDER folder IDL a.idl …): headers are included as <folder>/a.h.
# All files pass through one call of the generator, which is mostly the start of its virtual machine, and one compilation
# unit: their headers weigh more than their code. Files include each other by bare name, as the generator's flat output asks.
# No folder may be given to the generator twice: it never ends then.
function(enfilade_idl_library name)
  cmake_parse_arguments(arg "" "FOLDER" "IDL" ${ARGN})
  set(root ${CMAKE_CURRENT_BINARY_DIR}/generated)
  set(out ${root}/${arg_FOLDER})
  foreach(file ${arg_IDL})
    cmake_path(ABSOLUTE_PATH file OUTPUT_VARIABLE input)
    cmake_path(GET input PARENT_PATH folder)
    cmake_path(GET input STEM stem)
    list(APPEND inputs ${input})
    list(APPEND folders ${folder})
    list(APPEND sources ${out}/${stem}.cxx)
    list(APPEND headers ${out}/${stem}.h)
  endforeach()
  list(REMOVE_DUPLICATES folders)
  list(TRANSFORM folders PREPEND "-I;" OUTPUT_VARIABLE includes)
  file(MAKE_DIRECTORY ${out})
  add_custom_command(OUTPUT ${sources} ${headers} DEPENDS ${inputs} VERBATIM WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
                     COMMAND ${FASTDDSGEN} -replace -cs ${includes} -d ${out} ${inputs} > ${root}/fastddsgen.log
                     COMMENT "Generating C++ from IDL")
  add_library(${name} STATIC ${sources} ${headers})
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  target_compile_options(${name} PRIVATE -w -O1)
  target_include_directories(${name} SYSTEM PUBLIC ${root})
  target_link_libraries(${name} PUBLIC fastcdr PRIVATE enfilade_instrumentation)
endfunction()
