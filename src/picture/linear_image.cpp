// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cassert>
#include <cmath>

#include "picture/photograph.h"
#include "picture/square_means.h"
#include "picture/transfer.h"

namespace parhelion {
namespace {

/// `linearOf` decodes a sample.
template <typename Sample, typename LinearOf>
void reduce(const std::vector<Sample>& samples, const Photograph& photograph, int reduction, Image& image,
            const LinearOf& linearOf) {
  const std::array planes{image.channels[0].samples.data(), image.channels[1].samples.data(),
                          image.channels[2].samples.data()};
  const auto channels = static_cast<std::size_t>(photograph.channels);
  squareMeans(photograph.width, photograph.height, reduction, planes, [&](std::size_t pixel) {
    const Sample* sample = &samples[pixel * channels];
    return std::array<double, 3>{linearOf(sample[0]), linearOf(sample[1]), linearOf(sample[2])};
  });
}

struct Decode {
  const Photograph& photograph;
  int reduction;
  Image& image;

  void operator()(const std::vector<std::uint8_t>& samples) const {
    reduce(samples, photograph, reduction, image, [&table = srgbDecode8()](std::uint8_t code) { return table[code]; });
  }
  void operator()(const std::vector<std::uint16_t>& samples) const {
    reduce(samples, photograph, reduction, image,
           [&table = srgbDecode16()](std::uint16_t code) { return table[code]; });
  }
  void operator()(const std::vector<float>& samples) const {
    reduce(samples, photograph, reduction, image, [](float linear) { return std::isfinite(linear) ? linear : 0.0F; });
  }
};

}  // namespace

Image linearImage(const Photograph& photograph, int reduction) {
  assert(reduction >= 1);
  Image image{squaresOver(photograph.width, reduction), squaresOver(photograph.height, reduction), {}};
  for (const char* name : {"R", "G", "B"}) image.add(name);
  std::visit(Decode{photograph, reduction, image}, photograph.samples);
  return image;
}

}  // namespace parhelion
