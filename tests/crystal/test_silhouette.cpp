// SPDX-License-Identifier: Apache-2.0
// Silhouettes against closed forms and against those of simpler crystals.
#include "crystal/silhouette.h"

#include <cmath>

#include <doctest/doctest.h>

#include "crystal/mesh/mesh_from_obj.h"
#include "crystal/objs.h"
#include "crystal/shapes.h"
#include "entry_sampler.h"
#include "random_stream.h"

using namespace parhelion;

namespace {

/// Calls f with directions all over the sphere.
template <class F>
void forDirections(int count, const F& f) {
  RandomStream random(7, 0, RandomPurpose::path);
  for (int i = 0; i < count; ++i) {
    const double z = 2.0 * random.next() - 1.0, turn = 2.0 * kPi * random.next(), w = std::sqrt(1.0 - z * z);
    f(Vec3(w * std::cos(turn), w * std::sin(turn), z));
  }
}

}  // namespace

TEST_CASE("the silhouette of a convex crystal is the sum of its lit faces' shadows") {
  for (const CrystalMesh& mesh : {hexagonalPrism(0.3), hexagonalPrism(5.0), meshOf(PyramidSettings{0.4, 0.7, 0.2})}) {
    const EntrySampler shadows(Crystal{&mesh, 1.0});
    forDirections(300, [&](const Vec3& light) {
      CHECK(silhouetteOf(mesh, light) == doctest::Approx(shadows.projectedArea(light)).epsilon(1e-12));
    });
    for (const Vec3& light : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, 1, 0)})
      CHECK(silhouetteOf(mesh, light) == doctest::Approx(shadows.projectedArea(light)).epsilon(1e-12));
  }
}

TEST_CASE("a pit changes no silhouette") {
  PrismSettings hollow{FixedValue{1.0}};
  hollow.upper.cavity = hollow.lower.cavity = {0.8, 0.9};
  const CrystalMesh mesh = meshOf(hollow), plain = hexagonalPrism(1.0);
  forDirections(300, [&](const Vec3& light) {
    CHECK(silhouetteOf(mesh, light) == doctest::Approx(silhouetteOf(plain, light)).epsilon(1e-3));
  });
}

TEST_CASE("two bodies cast one shadow where one hides the other, and two beside each other") {
  const CrystalMesh half = hexagonalPrism(0.5), both = meshFromObj(halvesOf(1.0, 3.0));
  CHECK(silhouetteOf(both, Vec3(0, 0, 1)) == doctest::Approx(silhouetteOf(half, Vec3(0, 0, 1))).epsilon(1e-12));
  CHECK(silhouetteOf(both, Vec3(1, 0, 0)) == doctest::Approx(2.0 * silhouetteOf(half, Vec3(1, 0, 0))).epsilon(1e-12));
}
