# SPDX-License-Identifier: Apache-2.0
# Fails when words leave the program for a terminal by another way than cli/say.h, which escapes what others have put
# into them. Run as: cmake -DSOURCE_DIR=.../src -P terminal_words.cmake

cmake_minimum_required(VERSION 3.24)

# Who may write to a stream: words, the line of progress, whole files.
set(writers cli/say.cpp cli/progress.cpp cli/tally_input.cpp cli/text_output.cpp picture/atomic_file.cpp
  view/chart.cpp)

set(problems "")
set(count 0)
file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/*.h ${SOURCE_DIR}/*.cpp)
foreach(source IN LISTS sources)
  math(EXPR count "${count} + 1")
  if(source IN_LIST writers)
    continue()
  endif()
  file(STRINGS ${SOURCE_DIR}/${source} lines
       REGEX "(std::|[^a-z_:])(printf|fprintf|vfprintf|puts|fputs|fputc|putchar|perror|fwrite)\\(|std::(cout|cerr|clog)")
  list(FILTER lines EXCLUDE REGEX "^ *//")
  foreach(line IN LISTS lines)
    string(APPEND problems "${source}: ${line}\n")
  endforeach()
endforeach()

if(count LESS 20)
  message(FATAL_ERROR "found only ${count} source files in ${SOURCE_DIR}")
endif()
if(problems)
  message(FATAL_ERROR "\nwords for people go through cli/say.h:\n${problems}")
endif()
message(STATUS "${count} files speak through cli/say.h")
