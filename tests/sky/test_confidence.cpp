// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "sky/confidence.h"
#include "sky/radiance.h"

namespace parhelion {
namespace {

/// A row of grey pixels with a luminance and a relative standard error each.
Image row(const std::vector<double>& luminances, const std::vector<double>& errors) {
  Image image{static_cast<int>(luminances.size()), 1, {}};
  for (const char* name : {"R", "G", "B", kVarianceChannel}) image.add(name);
  for (std::size_t i = 0; i < luminances.size(); ++i) {
    for (int c = 0; c < 3; ++c) image.channels[c].samples[i] = static_cast<float>(luminances[i]);
    image.channels[3].samples[i] = static_cast<float>(luminances[i] * luminances[i] * errors[i] * errors[i]);
  }
  return image;
}

}  // namespace

TEST_CASE("confidence is white to 1 % of error, black from 100 %, and even steps of grey for even ratios between") {
  const Image sky = row({3.0, 1e-6, 1.0, 50.0, 1.0, 1.0, 1.0}, {0.0, 0.009, 0.0316228, 0.1, 0.316228, 1.001, 5.0});
  const Preview view = confidence(sky);
  CHECK(view.width == 7);
  CHECK(view.height == 1);
  const int expected[] = {255, 255, 191, 128, 64, 0, 0};
  for (std::size_t i = 0; i < 7; ++i)
    for (std::size_t c = 0; c < 3; ++c) CHECK(static_cast<int>(view.rgb[3 * i + c]) == expected[i]);
  CHECK(view.badPixels == 0);
}

TEST_CASE("confidence is black without light, below 0 and where numbers are not finite, which are counted") {
  Image sky = row({0.0, -1.0, NAN, INFINITY, 1.0}, {0.0, 0.001, 0.1, 0.1, 0.001});
  sky.channels[3].samples[4] = NAN;
  const Preview view = confidence(sky);
  for (const std::uint8_t value : view.rgb) CHECK(value == 0);
  CHECK(view.badPixels == 3);
  sky.channels.pop_back();
  CHECK_THROWS_AS(confidence(sky), std::invalid_argument);
}

TEST_CASE("confidence counts the bias like noise") {
  Image sky = row({2.0, 2.0}, {0.06, 0.06});
  std::vector<float>& bias = sky.add(kBiasChannel);
  bias[1] = 0.16F;  // 8 % of the luminance: 10 % together
  const Preview view = confidence(sky);
  CHECK(static_cast<int>(view.rgb[0]) == 156);
  CHECK(static_cast<int>(view.rgb[3]) == 128);
}

}  // namespace parhelion
