// SPDX-License-Identifier: Apache-2.0
#include "photo/editing_pictures.h"

#include <algorithm>

#include "parallel/loops.h"
#include "picture/transfer.h"

namespace parhelion {
namespace {

/// A picture of three channels, each sample by `sampleAt(pixel, channel, light of the halo there)`.
template <class Sample, class F>
Photograph drawn(const AddedHalo& added, const F& sampleAt) {
  Photograph picture;
  picture.width = added.mask.width;
  picture.height = added.mask.height;
  std::vector<Sample> samples(3 * picture.pixels());
  forRows(picture.height, [&](int y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * picture.width + x;
      const Vec3 light = added.mask.sky[pixel] == 0 ? Vec3(0.0) : added.at(x, y).value_or(Vec3(0.0));
      for (int c = 0; c < 3; ++c) samples[3 * pixel + c] = sampleAt(pixel, c, light[c]);
    }
  });
  picture.samples = std::move(samples);
  return picture;
}

}  // namespace

Photograph lightForEditing(const AddedHalo& added) {
  return drawn<float>(added, [](std::size_t, int, double light) { return static_cast<float>(light); });
}

Photograph sumForEditing(const Photograph& photograph, const AddedHalo& added) {
  return drawn<float>(added, [&](std::size_t pixel, int c, double light) {
    return static_cast<float>(linearAt(photograph.samples, pixel * photograph.channels + c) + light);
  });
}

Photograph dodgeForEditing(const Photograph& photograph, const AddedHalo& added) {
  return drawn<std::uint16_t>(added, [&](std::size_t pixel, int c, double light) -> std::uint16_t {
    if (light == 0.0) return 0;
    constexpr double kWhite = 65535.0;
    const double before = std::clamp<double>(linearAt(photograph.samples, pixel * photograph.channels + c), 0.0, 1.0);
    const double step = srgbEncode(std::min(1.0, before + light)) - srgbEncode(before);
    return static_cast<std::uint16_t>(kWhite * std::max(0.0, step) + 0.5);
  });
}

}  // namespace parhelion
