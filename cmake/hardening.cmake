# SPDX-License-Identifier: Apache-2.0
# What makes a fault in code that reads foreign files harder to use. tests/hardening.cmake looks for it in the program.

include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# The third level checks writes whose size is known at run time only; GCC has it from 12 on, Clang from 9 on.
set(fortify 3)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 12)
  set(fortify 2)
endif()
# Only optimised code can be fortified.
add_compile_options("$<$<CONFIG:Release>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=${fortify};-fstack-protector-strong>")
add_link_options(LINKER:-z,relro LINKER:-z,now LINKER:-z,noexecstack)
