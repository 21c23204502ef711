# SPDX-License-Identifier: Apache-2.0
# Fails when lane code that is compiled for vector registers not all machines have defines a weak function: of
# several of the same name the linker keeps any one, also for the code of machines without those registers.
# Run as: cmake -DNM=nm -DOBJECTS=a.o,b.o -P lane_symbols.cmake

cmake_minimum_required(VERSION 3.24)

string(REPLACE "," ";" objects "${OBJECTS}")
set(problems "")
foreach(object IN LISTS objects)
  execute_process(COMMAND ${NM} --demangle --defined-only ${object}
    OUTPUT_VARIABLE symbols RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${NM} cannot read ${object}")
  endif()
  # The steps' table must be there, or this is not the object that was meant.
  if(NOT symbols MATCHES "laneStepsOf[0-9]")
    message(FATAL_ERROR "${object} has no table of steps")
  endif()
  # W: weak, and no data, which would be V or u and the same for all registers.
  string(REGEX MATCHALL "[0-9a-f]+ W [^\n]*" shared "${symbols}")
  foreach(symbol IN LISTS shared)
    string(REGEX REPLACE "^[0-9a-f]+ " "" symbol "${symbol}")
    string(APPEND problems "${object}: ${symbol}\n")
  endforeach()
endforeach()

if(problems)
  message(FATAL_ERROR "\n${problems}")
endif()
