// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <stdexcept>

#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

TEST_CASE("numbers of rays have the suffixes k, M, G and T and exponents") {
  CHECK(parseRayCount("1") == 1);
  CHECK(parseRayCount("100000") == 100'000);
  CHECK(parseRayCount("10M") == 10'000'000);
  CHECK(parseRayCount("1.5k") == 1500);
  CHECK(parseRayCount("2e6") == 2'000'000);
  CHECK(parseRayCount("0.25G") == 250'000'000);
  CHECK(parseRayCount("30G") == 30'000'000'000);
  CHECK(parseRayCount("1000T") == kMaxRays);
}

TEST_CASE("a decimal fraction with a suffix is exact") {
  for (std::uint64_t tenths = 1; tenths < 10'000; ++tenths) {
    const std::string text = std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10) + 'M';
    CHECK(parseRayCount(text) == tenths * 100'000);
  }
}

TEST_CASE("what is no whole number of rays in range is refused") {
  for (const char* text : {"", "k", "0", "-1", "1.5", "0.0001k", "10X", "1e", "nan", "inf", " 1", "1 ", "2e6k", "0x10",
                           "1000000000000001", "1e300", "1e999", "+1"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parseRayCount(text), std::invalid_argument);
  }
}

TEST_CASE("a scene takes numbers of rays as integer, float and string") {
  CHECK(sceneWith("trace.rays = 100000").trace.rays == 100'000);
  CHECK(sceneWith("trace.rays = 2e6").trace.rays == 2'000'000);
  CHECK(sceneWith("trace.rays = '2e6'").trace.rays == 2'000'000);
  CHECK(sceneWith("trace.rays = 1_000_000_000_000_000").trace.rays == kMaxRays);
  CHECK(errorsOf("trace.rays = 9223372036854775807\n[[population]]").size() == 1);
}
