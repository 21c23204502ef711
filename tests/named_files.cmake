# SPDX-License-Identifier: Apache-2.0
# Fails when a document names, in backticks, a source file or folder that does not exist: seen from the top of the
# repository or from src/. A star, or NAME, stands for any part of a name. Blocks of code are not looked at.
# Run as: cmake -DSOURCE_DIR=... -DDOCUMENTS=CONTRIBUTING.md,docs/model.md -P named_files.cmake

cmake_minimum_required(VERSION 3.24)

# What looks like a file of the repository: one that ends as sources do, a folder, or whatever is in one of ours.
set(name_of_file "^[A-Za-z0-9_][A-Za-z0-9_./*-]*(\\.(h|cpp|cmake|toml|md)|/)$")
set(name_in_folder "^(src|tests|docs|scenes|scripts|bench|cmake)/[A-Za-z0-9_./*-]+$")

set(problems "")
set(count 0)
string(REPLACE "," ";" documents ${DOCUMENTS})
foreach(document IN LISTS documents)
  file(READ ${SOURCE_DIR}/${document} text)
  string(REGEX REPLACE "[][;\\]" " " text "${text}")  # they mean something else in CMake's lists
  string(REGEX REPLACE "```[^`]*```" "" text "${text}")
  string(REGEX MATCHALL "`[^`\n]+`" quoted "${text}")
  foreach(name IN LISTS quoted)
    string(REPLACE "`" "" name "${name}")
    if(NOT name MATCHES "${name_of_file}" AND NOT name MATCHES "${name_in_folder}")
      continue()
    endif()
    math(EXPR count "${count} + 1")
    string(REGEX REPLACE "/$" "" pattern "${name}")
    string(REPLACE "NAME" "*" pattern "${pattern}")
    file(GLOB found ${SOURCE_DIR}/${pattern} ${SOURCE_DIR}/src/${pattern})
    if(NOT found)
      string(APPEND problems "${document}: there is no ${name}\n")
    endif()
  endforeach()
endforeach()

if(count LESS 20)
  message(FATAL_ERROR "found only ${count} names of files in ${DOCUMENTS}")
endif()
if(problems)
  message(FATAL_ERROR "\n${problems}")
endif()
message(STATUS "${count} names of files, all of them there")
