# SPDX-License-Identifier: Apache-2.0
# Fails unless the program has the guards of cmake/hardening.cmake.
# Run as: cmake -DREADELF=readelf -DPROGRAM=parhelion -P hardening.cmake

cmake_minimum_required(VERSION 3.24)

execute_process(COMMAND ${READELF} --wide --file-header --program-headers --dynamic --dyn-syms ${PROGRAM}
  OUTPUT_VARIABLE elf RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${READELF} cannot read ${PROGRAM}")
endif()

set(missing "")
function(require pattern guard)
  if(NOT elf MATCHES "${pattern}")
    set(missing "${missing} ${guard}," PARENT_SCOPE)
  endif()
endfunction()
require("Type: +DYN" "code at places that change (PIE)")
require("GNU_RELRO" "read-only relocations")
require("BIND_NOW|FLAGS.* NOW" "binding at the start")
require("GNU_STACK[^\n]* RW " "a stack without code")
require("__stack_chk_fail" "the stack protector")
require("__[a-z]+_chk[@ ]" "checked functions of the C library (_FORTIFY_SOURCE)")
if(missing)
  message(FATAL_ERROR "${PROGRAM} lacks${missing} see cmake/hardening.cmake")
endif()
message(STATUS "${PROGRAM} has all guards")
