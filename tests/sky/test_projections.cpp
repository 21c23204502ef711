// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <string>

#include "math/names.h"
#include "sky/projections.h"

using namespace parhelion;

TEST_CASE("the projections are all there, each of one name that reads back") {
  CHECK(kMembersOf<Projection>.size() == 11);
  CHECK(kMembersOf<Projection>.front() == Projection::rectilinear);
  CHECK(kMembersOf<Projection>.back() == Projection::globe);
  std::set<std::string_view> names;
  for (const Projection projection : kMembersOf<Projection>) {
    CHECK(memberNamed<Projection>(nameOf(projection)) == projection);
    names.insert(nameOf(projection));
  }
  CHECK(names.size() == kMembersOf<Projection>.size());
  CHECK(!memberNamed<Projection>("round"));
  CHECK(!memberNamed<Projection>(""));
}

TEST_CASE("radius and angle are each other's inverse up to the limit of the projection") {
  for (const Projection projection : kMembersOf<Projection>) {
    CAPTURE(std::string(nameOf(projection)));
    visitProjection(projection, [](auto facts) {
      const double limit = 0.5 * radians(facts.fieldOfView.hi);
      for (const double share : {0.001, 0.1, 0.5, 0.9, 1.0}) {
        if (share == 1.0 && facts.fieldOfView.hiOpen) continue;
        CAPTURE(share);
        const double angle = share * limit, radius = facts.radiusAt(angle);
        // Near the rim of an equal-area or orthographic picture the angle hangs on the root of what rounding leaves.
        const double tolerance = share == 1.0 ? 1e-7 : 1e-13;
        REQUIRE(facts.angleAt(radius));
        CHECK(std::abs(*facts.angleAt(radius) - angle) < tolerance);
        if constexpr (facts.isAzimuthal) {
          const AxisAngle found = facts.atSquaredRadius(radius * radius);
          CHECK(found.cosine == doctest::Approx(std::cos(angle)).epsilon(1e-7));
          CHECK(found.sinePerRadius * radius == doctest::Approx(std::sin(angle)).epsilon(1e-7));
          const Triple<double> v{std::sin(angle), 0.0, std::cos(angle)};
          CHECK(facts.radiusPerSine(v) * v.x == doctest::Approx(radius).epsilon(1e-7));
          CHECK(facts.circleHeight(radius * radius) == doctest::Approx(1.0 - std::cos(angle)).epsilon(1e-7));
        }
      }
    });
  }
}
