// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <tbb/global_control.h>

#include <cmath>

#include "photo/added_halo.h"
#include "photo/editing_pictures.h"
#include "photo/sky_match.h"
#include "picture/colour_space.h"
#include "picture/transfer.h"

using namespace parhelion;

namespace {

CameraSettings camera(int width, int height) {
  CameraSettings settings;
  settings.projection = Projection::rectilinear;
  settings.fieldOfView = radians(50.0);
  settings.elevation = radians(15.0);
  settings.width = width;
  settings.height = height;
  return settings;
}

/// One light all over the sky, in the colours given.
Image even(int width, int height, const Vec3& rgb) {
  Image image{width, height, {}};
  for (int c = 0; c < 3; ++c)
    for (float& sample : image.add(std::string(1, "RGB"[c]))) sample = static_cast<float>(rgb[c]);
  return image;
}

template <class Sample>
Photograph plain(int width, int height, int channels, Sample value) {
  Photograph photograph;
  photograph.width = width;
  photograph.height = height;
  photograph.channels = channels;
  photograph.samples = std::vector<Sample>(photograph.pixels() * static_cast<std::size_t>(channels), value);
  return photograph;
}

SkyMask mask(int width, int height, std::uint8_t sky) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height, sky)};
}

constexpr int kWidth = 80, kHeight = 60;

/// Mean linear value of a channel.
double mean(const Photograph& photograph, int channel) {
  double sum = 0.0;
  for (std::size_t i = 0; i < photograph.pixels(); ++i) {
    const std::size_t k = i * photograph.channels + static_cast<std::size_t>(channel);
    sum += std::visit(
        [k](const auto& samples) -> double {
          if constexpr (sizeof samples[0] == 1)
            return srgbDecode8()[samples[k]];
          else if constexpr (sizeof samples[0] == 2)
            return srgbDecode16()[samples[k]];
          else
            return samples[k];
        },
        photograph.samples);
  }
  return sum / static_cast<double>(photograph.pixels());
}

}  // namespace

TEST_CASE("light is added to the linear samples of every kind, in proportion to the mask") {
  const CameraSettings settings = camera(kWidth, kHeight);
  const HaloLookup halo(even(kWidth, kHeight, {2.0, 1.0, 0.5}), settings, settings);
  const SkyMask half = mask(kWidth, kHeight, 51);  // a fifth of the sky
  const AddedHalo added{halo, half, Vec3(0.1, 0.1, 0.2)};
  const Vec3 expected(0.2 * 0.2, 0.2 * 0.1, 0.2 * 0.1);
  // Dithering 4800 samples between two codes: half a code, 0.004 at most here, over sqrt(4800), five times.
  constexpr double kBounds[] = {3e-4, 2e-6, 1e-7};
  Photograph pictures[] = {plain<std::uint8_t>(kWidth, kHeight, 3, 128),
                           plain<std::uint16_t>(kWidth, kHeight, 4, 30000), plain<float>(kWidth, kHeight, 3, 0.25f)};
  for (std::size_t i = 0; i < 3; ++i) {
    Photograph after = pictures[i];
    const AddedHaloReport report = addHalo(after, added);
    CHECK(report.touched == after.pixels());
    CHECK(report.clipped == 0);
    for (int c = 0; c < 3; ++c) CHECK(std::abs(mean(after, c) - mean(pictures[i], c) - expected[c]) < kBounds[i]);
  }
}

TEST_CASE("alpha, what is masked and what gets no light stay as they are") {
  const CameraSettings settings = camera(kWidth, kHeight);
  const HaloLookup halo(even(kWidth, kHeight, {1.0, 1.0, 1.0}), settings, settings);
  const HaloLookup none(even(kWidth, kHeight, {0.0, 0.0, 0.0}), settings, settings);
  SkyMask upper = mask(kWidth, kHeight, 255);
  for (std::size_t i = upper.sky.size() / 2; i < upper.sky.size(); ++i) upper.sky[i] = 0;
  const Photograph before = plain<std::uint16_t>(kWidth, kHeight, 4, 12345);
  Photograph after = before;
  CHECK(addHalo(after, {none, upper, Vec3(1.0)}).touched == 0);
  CHECK(after.samples == before.samples);
  CHECK(addHalo(after, {halo, upper, Vec3(0.1)}).touched == before.pixels() / 2);
  const auto& samples = std::get<std::vector<std::uint16_t>>(after.samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool changes = i % 4 < 3 && i / 4 < before.pixels() / 2;
    REQUIRE((samples[i] != 12345) == changes);
  }
}

TEST_CASE("light beyond white is clipped and counted") {
  const CameraSettings settings = camera(kWidth, kHeight);
  const HaloLookup halo(even(kWidth, kHeight, {1.0, 0.0, 0.0}), settings, settings);
  Photograph photograph = plain<std::uint8_t>(kWidth, kHeight, 3, 200);
  const AddedHaloReport report = addHalo(photograph, {halo, mask(kWidth, kHeight, 255), Vec3(1.0)});
  CHECK(report.clipped == photograph.pixels());
  const auto& samples = std::get<std::vector<std::uint8_t>>(photograph.samples);
  CHECK(samples[0] == 255);
  CHECK(samples[1] == 200);
}

TEST_CASE("a composite has the same bits for any number of threads") {
  const CameraSettings settings = camera(kWidth, kHeight);
  const HaloLookup halo(even(kWidth, kHeight, {0.013, 0.01, 0.007}), settings, settings);
  const SkyMask all = mask(kWidth, kHeight, 255);
  Photograph one = plain<std::uint8_t>(kWidth, kHeight, 3, 90), four = one;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    addHalo(one, {halo, all, Vec3(0.1)});
  }
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 4);
  addHalo(four, {halo, all, Vec3(0.1)});
  CHECK(one.samples == four.samples);
}

TEST_CASE("linear dodge of its layer over the photograph is the composite") {
  const CameraSettings settings = camera(kWidth, kHeight);
  const HaloLookup halo(even(kWidth, kHeight, {0.3, 0.2, 0.1}), settings, settings);
  const SkyMask all = mask(kWidth, kHeight, 255);
  const AddedHalo added{halo, all, Vec3(1.0)};
  const Photograph before = plain<std::uint16_t>(kWidth, kHeight, 3, 20000);
  Photograph after = before;
  addHalo(after, added);
  const Photograph dodge = dodgeForEditing(before, added), sum = sumForEditing(before, added);
  const auto& layer = std::get<std::vector<std::uint16_t>>(dodge.samples);
  const auto& whole = std::get<std::vector<std::uint16_t>>(after.samples);
  for (std::size_t i = 0; i < layer.size(); ++i) REQUIRE(std::abs(20000 + layer[i] - whole[i]) <= 1);
  CHECK(std::get<std::vector<float>>(sum.samples)[0] == doctest::Approx(srgbDecode16()[20000] + 0.3).epsilon(1e-6));
}

TEST_CASE("the sky's brightness is measured around the sun, without clipped pixels and land") {
  const CameraSettings settings = camera(kWidth, kHeight);
  Photograph photograph = plain<float>(kWidth, kHeight, 3, 0.0f);
  SkyMask sky = mask(kWidth, kHeight, 255);
  auto& samples = std::get<std::vector<float>>(photograph.samples);
  for (std::size_t i = 0; i < photograph.pixels(); ++i) {
    const bool land = i >= photograph.pixels() / 2;
    if (land) sky.sky[i] = 0;
    for (std::size_t c = 0; c < 3; ++c) samples[3 * i + c] = land ? 7.0f : c == 0 ? 0.4f : 0.2f;
  }
  const SkyTone tone = skyTone(photograph, sky, settings, radians(15.0));
  CHECK(tone.aroundSun);
  CHECK(tone.luminance == doctest::Approx(0.2 + 0.2 * 0.2126390).epsilon(1e-6));
  CHECK(tone.colour.x / tone.colour.y == doctest::Approx(2.0).epsilon(1e-6));
  CHECK_FALSE(skyTone(photograph, sky, settings, radians(-70.0)).aroundSun);
  CHECK_THROWS_AS(skyTone(photograph, mask(kWidth, kHeight, 0), settings, 0.2), std::invalid_argument);
}

TEST_CASE("a mask of another size is refused") {
  const CameraSettings settings = camera(kWidth, kHeight);
  const HaloLookup halo(even(kWidth, kHeight, {1.0, 1.0, 1.0}), settings, settings);
  Photograph photograph = plain<std::uint8_t>(kWidth, kHeight, 3, 90);
  CHECK_THROWS_AS(addHalo(photograph, {halo, mask(kWidth, kHeight - 1, 255), Vec3(0.1)}), std::invalid_argument);
}

TEST_CASE("a halo's strength follows from its contrast with the sky, and its white from the sky where that is asked") {
  const CameraSettings lens = camera(kWidth, kHeight);
  const HaloLookup halo(even(kWidth, kHeight, {2.0, 2.0, 2.0}), lens, lens);
  Photograph sky = plain<float>(kWidth, kHeight, 3, 0.25F);
  const SkyMask all = mask(kWidth, kHeight, 255);

  const HaloStrength usual = haloStrength({}, sky, all, lens, radians(20.0), halo);
  CHECK(usual.perRadiance.y == doctest::Approx(0.5 * 0.25 / 2.0).epsilon(1e-9));
  CHECK(usual.perRadiance.x == doctest::Approx(usual.perRadiance.z).epsilon(1e-12));
  CHECK(usual.remarks.size() == 1);

  std::vector<float>& samples = std::get<std::vector<float>>(sky.samples);
  for (std::size_t i = 2; i < samples.size(); i += 3) samples[i] = 0.5F;
  HaloStrengthSettings settings;
  settings.strength = 3.0;
  settings.white.reset();
  const HaloStrength blue = haloStrength(settings, sky, all, lens, radians(20.0), halo);
  CHECK(blue.perRadiance.z == doctest::Approx(2.0 * blue.perRadiance.y).epsilon(1e-6));
  CHECK(glm::dot(blue.perRadiance, kRec709Luminance) == doctest::Approx(3.0).epsilon(1e-12));
  CHECK(blue.remarks.empty());

  const HaloLookup dark(even(kWidth, kHeight, Vec3(0.0)), lens, lens);
  const HaloStrength none = haloStrength({}, sky, all, lens, radians(20.0), dark);
  CHECK(none.perRadiance == Vec3(0.0));
  CHECK(none.remarks.size() == 2);
}
