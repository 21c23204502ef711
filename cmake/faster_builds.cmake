# SPDX-License-Identifier: Apache-2.0
# What makes a build cost less and changes nothing of what it makes.

# Compilations done before come from ccache where that is installed. It may take a precompiled header for what it was
# made from.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

# Code that no ray and no pixel goes through: read and compiled far more often than run. Templates of command lines, JSON
# and test cases take the compiler twice as long with full optimisation.
function(parhelion_rarely_run target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # With so little optimisation GCC 12 sees strings longer than they are (its bug 105329).
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
endfunction()

# The same for a whole library of such code, whose files are then compiled several at a time: each of them alone would
# take the compiler through the same templates again.
function(parhelion_compile_together target)
  parhelion_rarely_run(${target})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 9)
endfunction()
