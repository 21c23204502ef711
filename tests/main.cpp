// SPDX-License-Identifier: Apache-2.0
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdlib>

int main(int count, char** words) {
  // What tests run leaves nothing in the user's cache, and finds nothing there.
  setenv("PARHELION_CACHE_SIZE", "off", 1);
  return doctest::Context(count, words).run();
}
