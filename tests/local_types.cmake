# SPDX-License-Identifier: Apache-2.0
# Two types of one name in two source files break the program without a word from the compiler or the linker. So this
# fails unless every type that a .cpp file defines is in an unnamed namespace, or is announced by a header that the file
# includes. That headers do not clash is shown by compiling all of them in one file.
# Run as: cmake -DSOURCE_DIR=.../src -P local_types.cmake

cmake_minimum_required(VERSION 3.24)

set(type "(class|struct|union|enum class|enum) ([A-Za-z0-9_]+)")
set(problems "")
set(count 0)
file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/*.cpp)
foreach(source IN LISTS sources)
  # What namespaces hold is not indented, and each end of a namespace says so.
  file(STRINGS ${SOURCE_DIR}/${source} lines REGEX "^(namespace |}  // namespace|class |struct |union |enum |#include \")")
  set(unnamed 0)  # how deep inside a namespace without a name
  set(announced "")
  foreach(line IN LISTS lines)
    if(line MATCHES "^#include \"(.*)\"")
      if(EXISTS ${SOURCE_DIR}/${CMAKE_MATCH_1})
        file(STRINGS ${SOURCE_DIR}/${CMAKE_MATCH_1} declarations REGEX "^ *${type};")
        list(TRANSFORM declarations REPLACE "^ *${type};.*" "\\2")
        list(APPEND announced ${declarations})
      endif()
    elseif(line MATCHES "^namespace {" OR (line MATCHES "^namespace " AND unnamed))
      math(EXPR unnamed "${unnamed} + 1")
    elseif(line MATCHES "^}  // namespace" AND unnamed)
      math(EXPR unnamed "${unnamed} - 1")
    elseif(NOT unnamed AND NOT line MATCHES ";" AND line MATCHES "^${type}( |$)")
      if(NOT CMAKE_MATCH_2 IN_LIST announced)
        string(APPEND problems "${source}: ${CMAKE_MATCH_2} belongs into an unnamed namespace\n")
      endif()
    endif()
  endforeach()
  math(EXPR count "${count} + 1")
endforeach()

if(count LESS 20)
  message(FATAL_ERROR "found only ${count} source files in ${SOURCE_DIR}")
endif()
if(problems)
  message(FATAL_ERROR "\n${problems}")
endif()
message(STATUS "the types of ${count} files are their own")
