# SPDX-License-Identifier: Apache-2.0
# What the thread sanitizer looks at: the tests of what runs in parallel, and the program with its signals and
# checkpoints. All else of the suite has one thread, and would only take its time.

parhelion_test(math USES parhelion_math)  # its precompiled header serves the others
parhelion_test(sky USES parhelion_sky)
parhelion_test(trace USES parhelion_trace)
parhelion_test(recon USES parhelion_recon)
parhelion_test(render USES parhelion_render)
parhelion_test(cli USES parhelion_cli FILES "test_long_runs|test_signals|test_recon")
target_compile_definitions(test_cli PRIVATE
  PARHELION_BINARY="$<TARGET_FILE:parhelion>" PARHELION_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
add_dependencies(test_cli parhelion)

# A race must be found, and where there is none, none.
add_executable(racing_loop racing_loop.cpp)
target_link_libraries(racing_loop PRIVATE parhelion_parallel)
add_test(NAME "races: calls of a loop that write to one place are found" COMMAND racing_loop)
set_tests_properties("races: calls of a loop that write to one place are found" PROPERTIES
  ENVIRONMENT ${suppressions}
  PASS_REGULAR_EXPRESSION "ThreadSanitizer: data race [^\n]*\n[^\n]*\n *#0 operator[^\n]*/racing_loop.cpp")
add_test(NAME "races: a loop comes after what is before it and before what is behind it" COMMAND racing_loop ordered)
set_tests_properties("races: a loop comes after what is before it and before what is behind it" PROPERTIES
  ENVIRONMENT ${suppressions})
