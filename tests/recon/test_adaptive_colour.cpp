// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "picture/colour_space.h"
#include "synthetic_tally.h"

namespace parhelion {
namespace {

constexpr int kSide = 128;

/// Poisson hits of a density and a colour (CIE XYZ) for each column.
template <class Density, class Colour>
Tally colouredTally(const Density& density, const Colour& colour, std::uint64_t seed) {
  TallyInfo info = fullSky(kSide);
  info.white = {0.95, 1.0, 1.09};
  Tally tally(info, 3);
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    RandomStream random(seed, static_cast<std::uint64_t>(pixel), RandomPurpose::path);
    const int count = poisson(density(pixel % kSide), random);
    for (int i = 0; i < count; ++i) tally.add(pixel, colour(pixel % kSide), random.next() < 0.5);
  }
  return tally;
}

}  // namespace

TEST_CASE("white light on arcs and edges stays white, and its luminance is that of one colour") {
  const auto arc = [](int x) { return std::abs(x - 64) < 3 ? 4.0 : x < 64 ? 0.05 : 0.5; };
  const Vec3 white{0.95, 1.0, 1.09};
  const Tally tally = colouredTally(
      arc, [&](int) { return white; }, 21);
  Tally grey(tally.info, 1);
  for (int pixel = 0; pixel < tally.pixels(); ++pixel)
    for (int slot = 0; slot < grey.slots(); ++slot) grey.setRaw(pixel, slot, tally.raw(pixel, slot));
  const Image image = adaptive(tally), one = adaptive(grey);
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    for (const auto* plane : image.rgb()) REQUIRE((*plane)[i] == doctest::Approx((*one.find("G"))[i]).epsilon(1e-4));
    REQUIRE(image.channels[3].samples[i] == doctest::Approx(one.channels[3].samples[i]).epsilon(1e-4));
  }
}

TEST_CASE("a red and a blue half keep their colours, and nothing is redder or bluer than either") {
  const Vec3 red{0.6, 0.5, 0.2}, blue{0.7, 0.5, 1.6};
  const Tally tally = colouredTally([](int) { return 1.0; }, [&](int x) { return x < kSide / 2 ? red : blue; }, 22);
  const Image image = adaptive(tally);
  const Mat3 toRgb = xyzToRec709(tally.info.white);
  const auto blueness = [](const Vec3& rgb) { return rgb.z / (rgb.x + rgb.y + rgb.z); };
  const double least = blueness(toRgb * red), most = blueness(toRgb * blue);
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    const auto i = static_cast<std::size_t>(pixel);
    const double b =
        blueness({image.channels[0].samples[i], image.channels[1].samples[i], image.channels[2].samples[i]});
    // But for the factors that keep all light of X, Y and Z.
    REQUIRE(b > least - 1e-3);
    REQUIRE(b < most + 1e-3);
    if (pixel % kSide < 32) REQUIRE(b < least + 0.05 * (most - least));
    if (pixel % kSide >= 96) REQUIRE(b > most - 0.05 * (most - least));
  }
}

TEST_CASE("white dots of coloured hits stay whiter than their own hits are") {
  TallyInfo info = fullSky(kSide);
  info.white = {0.95, 1.0, 1.09};
  Tally tally(info, 3);
  const auto isDot = [](int pixel) { return std::hypot(pixel % kSide % 16 - 8, pixel / kSide % 16 - 8) < 2.5; };
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    RandomStream random(23, static_cast<std::uint64_t>(pixel), RandomPurpose::path);
    const int count = poisson(isDot(pixel) ? 40.0 : 0.2, random);
    for (int i = 0; i < count; ++i) {
      const bool red = random.next() < 0.5;
      tally.add(pixel, red ? Vec3(1.4, 1.0, 0.1) : Vec3(0.5, 1.0, 2.08), random.next() < 0.5);
    }
  }
  const Image image = adaptive(tally), plain = reconstruct(tally, NoSettings{}).image;
  const auto colour = [&](const Image& sky) {
    const auto [red, green, blue] = sky.rgb();
    double sum = 0.0;
    for (std::size_t i = 0; i < sky.pixels(); ++i) {
      if (isDot(static_cast<int>(i))) sum += std::pow(static_cast<double>(((*red)[i] - (*blue)[i]) / (*green)[i]), 2);
    }
    return std::sqrt(sum);
  };
  CHECK(colour(image) < 0.4 * colour(plain));
}

TEST_CASE("a sky keeps its red, green and blue light") {
  const Vec3 red{0.6, 0.5, 0.2}, blue{0.3, 0.2, 1.6};
  const Tally tally = colouredTally([](int x) { return std::abs(x - 60) < 3 ? 5.0 : 0.1; },
                                    [&](int x) { return x < 60 ? red : blue; }, 25);
  const Image image = adaptive(tally), plain = reconstruct(tally, NoSettings{}).image;
  for (std::size_t c = 0; c < 3; ++c) {
    double kept = 0.0, given = 0.0;
    for (std::size_t i = 0; i < image.pixels(); ++i) {
      kept += static_cast<double>(image.channels[c].samples[i]);
      given += static_cast<double>(plain.channels[c].samples[i]);
    }
    CHECK(kept == doctest::Approx(given).epsilon(1e-5));
  }
}

}  // namespace parhelion
