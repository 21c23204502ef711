// SPDX-License-Identifier: Apache-2.0
// What crystals take from light, against closed forms.
#include "trace/extinction.h"

#include <cmath>

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "crystal/objs.h"
#include "crystals.h"
#include "math/rotation.h"
#include "trace/concave_crystal.h"
#include "trace/silhouettes.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

PopulationSettings prisms(double aspect, const OrientationSettings& orientation) {
  PopulationSettings settings;
  settings.shape = PrismSettings{FixedValue{aspect}};
  settings.orientation = orientation;
  return settings;
}

Extinction extinctionOf(const std::vector<PopulationSettings>& populations) {
  SunSettings sun;
  sun.spectrum = MonochromaticSpectrum{};
  return {sun, ConstantIndex{1.31}, populations};
}

Vec3 at(double azimuth, double elevation) { return skyDirection(radians(azimuth), radians(elevation)); }

// Of a hexagonal prism of side 1 and length 2 * aspect.
constexpr double kBasal = 2.598076211353316;

}  // namespace

TEST_CASE("crystals in any orientation stand in the way of all light alike") {
  const Extinction random = extinctionOf({prisms(1.0, RandomOrientation{})});
  for (const double elevation : {-30.0, 0.0, 10.0, 90.0}) {
    CHECK(random.at(at(40.0, elevation)).shadow == doctest::Approx(1.0).epsilon(1e-12));
    CHECK(random.at(at(40.0, elevation)).undeviated == doctest::Approx(0.2400).epsilon(0.01));
  }
}

TEST_CASE("plates and columns at rest have the shadows of closed forms") {
  constexpr double kAspect = 0.2;
  const Extinction plates = extinctionOf({prisms(kAspect, AxisOrientation{})});
  const Extinction columns = extinctionOf({prisms(2.0, AxisOrientation{FixedValue{0.5 * kPi}})});
  for (const double elevation : {0.0, 1.0, 5.0, 20.0, 45.0, 70.0, 90.0}) {
    CAPTURE(elevation);
    const double sine = std::sin(radians(elevation)), cosine = std::cos(radians(elevation));
    // Sides turned all ways about c show their surface over pi.
    const double plate = kBasal * sine + 6.0 * 2.0 * kAspect / kPi * cosine;
    CHECK(plates.at(at(0.0, elevation)).shadow == doctest::Approx(plate / kBasal).epsilon(0.003));
    // Mean over the azimuths of the c axis, which makes an angle with the light.
    double column = 0.0;
    for (int k = 0; k < 1000; ++k) {
      const double along = cosine * std::cos(kPi * (k + 0.5) / 1000);
      column += (kBasal * std::abs(along) + 6.0 * 4.0 / kPi * std::sqrt(1.0 - along * along)) / 1000;
    }
    CHECK(columns.at(at(0.0, elevation)).shadow == doctest::Approx(column / (24.0 / kPi)).epsilon(0.003));
  }
}

TEST_CASE("populations count by their surface, and light by what they intercept") {
  std::vector<PopulationSettings> both{prisms(1.0, RandomOrientation{}), prisms(0.2, AxisOrientation{})};
  both[0].weight = 3.0;
  const Extinction random = extinctionOf({both[0]}), plates = extinctionOf({both[1]}), mixed = extinctionOf(both);
  const double surface = 2.0 * kBasal + 6.0 * 0.4, zenith = 3.0 * 0.25 + kBasal / surface;
  for (const double elevation : {3.0, 30.0}) {
    const Vec3 toLight = at(0.0, elevation);
    const double ofRandom = 3.0 * 0.25 / zenith, ofPlates = plates.at(toLight).shadow * kBasal / surface / zenith;
    CHECK(mixed.at(toLight).shadow == doctest::Approx(ofRandom + ofPlates).epsilon(1e-3));
    CHECK(mixed.at(toLight).undeviated ==
          doctest::Approx((ofRandom * random.at(toLight).undeviated + ofPlates * plates.at(toLight).undeviated) /
                          (ofRandom + ofPlates))
              .epsilon(1e-3));
  }
}

TEST_CASE("crystals of fixed azimuth are met by their own sides, the same from opposite directions") {
  // A long column that points 30 degrees to the right of the sun, on a prism face.
  const Extinction columns =
      extinctionOf({prisms(20.0, AxisOrientation{FixedValue{0.5 * kPi}, FixedValue{radians(30.0)}, FixedValue{0.0}})});
  const double along = columns.at(at(30.0, 0.5)).shadow, across = columns.at(at(120.0, 0.5)).shadow;
  CHECK(along < 0.1 * across);
  CHECK(columns.at(at(-150.0, -0.5)).shadow == doctest::Approx(along).epsilon(1e-9));
  CHECK(columns.at(at(30.0, 20.0)).shadow == doctest::Approx(columns.at(at(-150.0, 20.0)).shadow).epsilon(0.01));
}

TEST_CASE("crystals that are not convex take light by their silhouettes, as rays cast at them have it") {
  const CrystalMesh mesh = meshOf(RosetteSettings{6, 1.0});
  const double surface = mesh.surfaceAcrossC() + mesh.surfaceAlongC();
  const EmbreeDevice device;
  const ConcaveCrystal crystal(device, mesh);
  const Silhouettes silhouettes(mesh);
  RandomStream random(3, 0, RandomPurpose::path);
  constexpr int kCast = 100'000, kDirections = 8;
  const double disc = kPi * mesh.radius() * mesh.radius();
  for (int k = 0; k < kDirections; ++k) {
    const Vec3 light = randomDirection(random);
    const Vec3 side = glm::normalize(glm::cross(light, std::abs(light.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
    int met = 0;
    for (int i = 0; i < kCast; ++i) {
      const double r = mesh.radius() * std::sqrt(random.next()), turn = 2.0 * kPi * random.next();
      const Vec3 point =
          r * (std::cos(turn) * side + std::sin(turn) * glm::cross(light, side)) - 2.0 * mesh.radius() * light;
      met += crystal.nextFace(point, light, kNoFace, Side::outside).has_value();
    }
    const double share = static_cast<double>(met) / kCast;
    const double error = disc / surface * std::sqrt(share * (1.0 - share) / kCast);
    CHECK(std::abs(silhouettes.at(light) - disc / surface * share) < 4.0 * error + 1e-3 * silhouettes.at(light));
  }
}

TEST_CASE("a convex crystal that is followed as one that is not takes as much light from all directions") {
  const PyramidSettings pyramid{0.4, 0.7, 0.2};
  for (const OrientationSettings& orientation :
       {OrientationSettings(RandomOrientation{}), OrientationSettings(AxisOrientation{Normal{0.0, radians(3.0)}})}) {
    PopulationSettings own, triangles;
    own.shape = pyramid;
    triangles.shape = asTriangles(meshOf(pyramid));
    own.orientation = triangles.orientation = orientation;
    const Extinction a = extinctionOf({own}), b = extinctionOf({triangles});
    CHECK(a.zenithShadow() == doctest::Approx(b.zenithShadow()).epsilon(1e-3));
    for (const double elevation : {0.0, 2.0, 20.0, 60.0}) {
      CHECK(a.at(at(0.0, elevation)).shadow == doctest::Approx(b.at(at(0.0, elevation)).shadow).epsilon(1e-3));
      CHECK(std::abs(a.at(at(0.0, elevation)).undeviated - b.at(at(0.0, elevation)).undeviated) < 0.01);
    }
  }
}
