// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "picture/transfer.h"

namespace parhelion {

TEST_CASE("each code of 8 and of 16 bits comes back from linear light as it was") {
  int wrong = 0;
  for (int code = 0; code < 256; ++code) wrong += toSrgb8(srgbDecode8()[static_cast<std::size_t>(code)]) != code;
  for (int code = 0; code < 65536; ++code) wrong += toSrgb16(srgbDecode16()[static_cast<std::size_t>(code)]) != code;
  CHECK(wrong == 0);
}

TEST_CASE("linear light is encoded to the nearest code") {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> exponent(-26.0F, 0.5F);
  constexpr double kTie = 1e-9;  // codes; nearer to the middle the reference's own rounding decides
  int wrong = 0;
  for (int i = 0; i < 200'000; ++i) {
    const float linear = std::exp2(exponent(random));
    for (const int most : {255, 65535}) {
      const double code = std::min(srgbEncode(linear), 1.0) * most;
      const int encoded = most == 255 ? toSrgb8(linear) : toSrgb16(linear);
      wrong += std::abs(encoded - code) > 0.5 + kTie ? 1 : 0;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("the border between two codes is where it should be to the last bit") {
  int wrong = 0;
  for (int code = 1; code < 65536; ++code) {
    const double border = srgbDecode((code - 0.5) / 65535);
    auto above = static_cast<float>(border);
    if (above < border) above = std::nextafter(above, 1.0F);
    wrong += toSrgb16(above) != code || toSrgb16(std::nextafter(above, 0.0F)) != code - 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("light outside of black and white is clipped, and what is no number is black") {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float dark : {-1.0F, -0.0F, 0.0F, 1e-30F, -kInfinity, kInfinity, std::nanf("")}) {
    CHECK(toSrgb8(dark) == 0);
    CHECK(toSrgb16(dark) == 0);
  }
  for (const float bright : {1.0F, 1.5F, 3e38F}) {
    CHECK(toSrgb8(bright) == 255);
    CHECK(toSrgb16(bright) == 65535);
  }
}

TEST_CASE("decoding undoes encoding") {
  CHECK(srgbDecode(0.0) == 0.0);
  CHECK(srgbDecode(1.0) == doctest::Approx(1.0).epsilon(1e-14));
  CHECK(srgbDecode(0.5) == doctest::Approx(0.2140411405).epsilon(1e-9));
  // The standard's two pieces meet within 1e-7 of the joint only.
  for (int i = 0; i <= 1000; ++i) {
    CHECK(srgbDecode(srgbEncode(i / 1000.0)) == doctest::Approx(i / 1000.0).epsilon(1e-12));
  }
}

}  // namespace parhelion
