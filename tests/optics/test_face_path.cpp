// SPDX-License-Identifier: Apache-2.0
#include "optics/face_path.h"

#include <array>

#include "optics/halo_curves.h"
#include "random_stream.h"

using namespace parhelion;

TEST_CASE("light over two faces goes where Snell's law with angles sends it") {
  RandomStream random(7, 0, RandomPurpose::path);
  const auto direction = [&] { return skyDirection(2.0 * kPi * random.next(), std::asin(2.0 * random.next() - 1.0)); };
  int through = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 toSun = direction(), in = direction(), out = direction();
    const auto expected = refracted(toSun, in, out), seen = seenOver(std::array{in, out}, toSun, kIndex);
    REQUIRE(expected.has_value() == seen.has_value());
    if (!seen) continue;
    ++through;
    CHECK(glm::length(*seen - *expected) < 1e-12);
  }
  CHECK(through > 150);
}

TEST_CASE("a face mirrors the sun outside, and between parallel faces inside") {
  const Vec3 toSun = skyDirection(0.0, radians(20)), up(0.0, 0.0, 1.0);
  const Vec3 subsun = skyDirection(0.0, radians(-20));
  CHECK(glm::length(*seenOver(std::array{up}, toSun, kIndex) - subsun) < 1e-15);
  const Vec3 side = skyDirection(radians(30), 0.0);
  CHECK(glm::length(*seenOver(std::array{side, -up, -side}, toSun, kIndex) - subsun) < 1e-14);
  CHECK(!seenOver(std::array{-up}, toSun, kIndex));
  CHECK(!seenOver(std::array{side, up, -side}, toSun, kIndex));  // light that goes down does not meet the upper face
}
