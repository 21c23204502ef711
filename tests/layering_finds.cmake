# SPDX-License-Identifier: Apache-2.0
# Fails unless layering.cmake finds every single include against the arrows of the house: one file after the other is
# added to a house in order, each with one include that may not be.
# Run as: cmake -DHOUSE=empty-folder -P layering_finds.cmake

cmake_minimum_required(VERSION 3.24)
include(${CMAKE_CURRENT_LIST_DIR}/house.cmake)

get_cmake_property(variables VARIABLES)
set(folders ${variables})
list(FILTER folders INCLUDE REGEX "^may_")
list(TRANSFORM folders REPLACE "^may_" "")
list(REMOVE_ITEM folders main)

file(REMOVE_RECURSE ${HOUSE})
foreach(folder IN LISTS folders)
  file(WRITE ${HOUSE}/${folder}/a.cpp "")
  file(WRITE ${HOUSE}/${folder}/b.cpp "")
endforeach()

# Sets `found` to whether layering.cmake finds fault with the house while `file` is in it, and names that file.
function(look file content)
  file(WRITE ${HOUSE}/${file} "${content}\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${HOUSE} -P ${CMAKE_CURRENT_LIST_DIR}/layering.cmake
                  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors)
  file(REMOVE ${HOUSE}/${file})
  if(NOT result EQUAL 0 AND errors MATCHES "${file}")
    set(found TRUE PARENT_SCOPE)
  else()
    set(found FALSE PARENT_SCOPE)
  endif()
endfunction()

set(missed "")
set(count 0)
macro(must_be_found file content)
  look(${file} "${content}")
  math(EXPR count "${count} + 1")
  if(NOT found)
    string(APPEND missed "${file}: ${content}\n")
  endif()
endmacro()

look(math/fine.cpp "#include <vector>\n#include \"math/a.h\"")
if(found)
  message(FATAL_ERROR "a house in order is found fault with")
endif()
foreach(folder IN LISTS folders)
  foreach(other IN LISTS folders)
    if(NOT other STREQUAL folder AND NOT other IN_LIST may_${folder})
      must_be_found(${folder}/against.cpp "#include \"${other}/header.h\"")
    endif()
  endforeach()
endforeach()
foreach(rule IN LISTS third_party)
  string(REGEX REPLACE "\\|.*" "" header ${rule})
  string(REGEX REPLACE ".*\\|" "" allowed ${rule})
  string(REPLACE "," ";" allowed ${allowed})
  string(REGEX REPLACE "\\[3?(.)\\]" "\\1" header ${header})  # embree[34] as embree4
  string(REPLACE "\\" "" header ${header})
  foreach(folder IN LISTS folders)
    if(NOT folder IN_LIST allowed)
      must_be_found(${folder}/against.cpp "#include <${header}>")
    endif()
  endforeach()
endforeach()
file(REMOVE_RECURSE ${HOUSE})

if(missed)
  message(FATAL_ERROR "\nnot found:\n${missed}")
endif()
message(STATUS "all of ${count} includes against the arrows were found")
