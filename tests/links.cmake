# SPDX-License-Identifier: Apache-2.0
# Fails when a program needs a shared library that it has no use for.
# Run as: cmake -DOBJDUMP=objdump -DPROGRAM=test_scene -DFORBIDDEN=embree,tbb -P links.cmake

execute_process(COMMAND ${OBJDUMP} -p ${PROGRAM} OUTPUT_VARIABLE headers COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "NEEDED +[^\n]+" needed "${headers}")
if(NOT needed)
  message(FATAL_ERROR "${PROGRAM} needs no library at all: this is not the program that was meant")
endif()
string(REPLACE "," "|" forbidden "${FORBIDDEN}")
foreach(library IN LISTS needed)
  if(library MATCHES "${forbidden}")
    message(FATAL_ERROR "${PROGRAM}: ${library}")
  endif()
endforeach()
