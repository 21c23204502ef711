// SPDX-License-Identifier: Apache-2.0
#include "view/display.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "math/portable.h"

namespace parhelion {
namespace {

template <class Sample>
Display shownSamples(const Photograph& photograph, const std::vector<Sample>& samples) {
  constexpr float kWhite = std::numeric_limits<Sample>::max();
  const auto channels = static_cast<std::size_t>(photograph.channels);
  Display display{photograph.width, photograph.height, {}};
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float>& plane = display.planes[c];
    plane.resize(display.pixels());
    for (std::size_t i = 0; i < plane.size(); ++i) {
      plane[i] = static_cast<float>(samples[channels * i + c]) / kWhite;
      if (channels == 4) plane[i] *= static_cast<float>(samples[4 * i + 3]) / kWhite;
    }
  }
  return display;
}

}  // namespace

Display shown(const Photograph& photograph) {
  return std::visit(
      [&photograph](const auto& samples) -> Display {
        if constexpr (std::is_floating_point_v<typename std::decay_t<decltype(samples)>::value_type>)
          throw std::invalid_argument("linear light must be developed to be shown");
        else
          return shownSamples(photograph, samples);
      },
      photograph.samples);
}

Display developed(const Image& image, const ToneSettings& settings) {
  const auto light = image.rgb();
  const double exposure = portable::exp(settings.exposureStops * portable::log(2.0));
  Display display{image.width, image.height, {}};
  for (std::vector<float>& plane : display.planes) plane.resize(image.pixels());
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    const Vec3 radiance{(*light[0])[i], (*light[1])[i], (*light[2])[i]};
    const Vec3 linear = toneCurve(exposure * radiance, settings.curve);
    for (int c = 0; c < 3; ++c)
      display.planes[static_cast<std::size_t>(c)][i] = static_cast<float>(srgbEncode(linear[c]));
  }
  return display;
}

Preview quantised(const Display& display) {
  Preview preview{display.width, display.height, std::vector<std::uint8_t>(3 * display.pixels()), 0};
  std::size_t i = 0;
  for (int y = 0; y < display.height; ++y)
    for (int x = 0; x < display.width; ++x, ++i)
      for (std::size_t c = 0; c < 3; ++c) preview.rgb[3 * i + c] = ditheredStep(display.planes[c][i], x, y);
  return preview;
}

std::vector<std::uint16_t> quantised16(const Display& display) {
  std::vector<std::uint16_t> samples(3 * display.pixels());
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<std::uint16_t>(65535.0 * std::clamp(display.planes[i % 3][i / 3], 0.0F, 1.0F) + 0.5);
  return samples;
}

}  // namespace parhelion
