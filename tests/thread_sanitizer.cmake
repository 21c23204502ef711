# SPDX-License-Identifier: Apache-2.0
# What the thread sanitizer looks at: what runs in parallel, and the program with its signals and checkpoints. Of most
# folders these are the tests that compare numbers of threads. The others take the same ways through our code and, for
# the sake of their statistics, many times as long.

parhelion_test(math USES parhelion_math CASES "*thread*")  # its precompiled header serves the others
parhelion_test(sky USES parhelion_sky FILES "test_(deposit_buffer|tally).cpp" CASES "*thread*")
parhelion_test(trace USES parhelion_trace FILES "test_(radial_film|ray_source|symmetry|trace|tracer).cpp"
  CASES "*thread*,*stop*,*parts*")
parhelion_test(recon USES parhelion_recon CASES "*thread*")
parhelion_test(photo USES parhelion_photo FILES "/(test_added_halo|test_find_sky|landscapes|painting).cpp"
  CASES "*thread*")
parhelion_test(render USES parhelion_render)
parhelion_test(cli USES parhelion_cli FILES "test_(long_runs|recon|signals).cpp")
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
