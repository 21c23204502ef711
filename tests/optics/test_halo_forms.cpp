// SPDX-License-Identifier: Apache-2.0
#include "optics/halo_forms.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "halos/closed_forms.h"
#include "math/rotation.h"
#include "optics/halo_curves.h"
#include "optics/ice.h"

using namespace parhelion;

namespace {

// Published positions are given to 0.001 degrees.
constexpr double kPublished = 0.0006;

// A line is sampled in steps: the nearest point is off its least distance by up to (half a step)^2 / 2 / tan 22,
// degrees.
constexpr double kSampled = 0.001;

bool has(double sunDegrees, const std::string& name) { return find(haloForms(radians(sunDegrees), kIndex), name); }

/// Those spots of a name that lie right of the sun's vertical or in it, degrees.
std::vector<Vec2> spotsAt(double sunDegrees, const std::string& name) {
  std::vector<Vec2> found;
  for (const HaloPoint& point : haloForms(radians(sunDegrees), kIndex).points) {
    const SkyPoint at = skyPoint(point.toSky);
    if (point.name == name && at.azimuth >= 0.0) found.push_back({degrees(at.azimuth), degrees(at.elevation)});
  }
  return found;
}

/// Least and largest distance (degrees) of a curve's points from the sun.
struct Distances {
  double least = 180.0, largest = 0.0;
};
Distances fromSun(const HaloCurve& curve, double sunDegrees) {
  Distances d;
  for (const SkyLine& line : curve.lines)
    for (const Vec3& p : line) {
      const double angle = degrees(angleBetween(p, skyDirection(0.0, radians(sunDegrees))));
      d.least = std::min(d.least, angle);
      d.largest = std::max(d.largest, angle);
    }
  return d;
}

double highestOverSun(const HaloCurve& curve) {
  const std::vector<double> all = crossings(curve, 0.0, false);
  REQUIRE(!all.empty());
  return *std::max_element(all.begin(), all.end());
}

}  // namespace

TEST_CASE("the rings of haloForms lie at the least deviations of their wedges") {
  const HaloForms forms = haloForms(radians(30), kIndex);
  for (const auto& [name, wedge] : {std::pair{"22° halo", 60.0}, std::pair{"46° halo", 90.0}}) {
    const Distances d = fromSun(curveAt(forms, name), 30);
    const double expected = degrees(theory::leastDeviation(radians(wedge), kIndex));
    CHECK(std::abs(d.least - expected) < 1e-10);
    CHECK(std::abs(d.largest - expected) < 1e-10);
  }
  CHECK(degrees(leastDeviation(radians(60), iceIndex(550))) == doctest::Approx(21.915).epsilon(3e-5));
}

TEST_CASE("the rings of pyramids lie where physics has them") {
  const std::pair<std::string, double> published[] = {{"9° halo", 8.953},   {"18° halo", 18.271}, {"20° halo", 19.905},
                                                      {"23° halo", 22.862}, {"24° halo", 23.819}, {"35° halo", 34.929}};
  const HaloMaker pyramids{HaloFamily::random, pyramidFaces()};
  const HaloForms rings = haloForms(radians(30), kIndex, {&pyramids, 1});
  CHECK(rings.curves.size() == std::size(published) + 2);  // those of prisms, too
  for (const auto& [name, radius] : published) {
    const HaloCurve& ring = curveAt(rings, name);
    CHECK(std::abs(fromSun(ring, 30).least - radius) < kPublished);
    CHECK(ring.family == HaloFamily::pyramids);
  }
}

TEST_CASE("crystals make only what their faces and their stance let them") {
  const auto namesOf = [](HaloFamily family, std::vector<Vec3> faces, double sun) {
    const HaloMaker maker{family, std::move(faces)};
    std::set<std::string> names;
    const HaloForms forms = haloForms(radians(sun), kIndex, {&maker, 1});
    for (const HaloCurve& curve : forms.curves) names.insert(curve.name);
    for (const HaloPoint& point : forms.points) names.insert(point.name);
    return names;
  };
  using Names = std::set<std::string>;
  CHECK(namesOf(HaloFamily::random, prismFaces(), 20) == Names{"22° halo", "46° halo"});
  CHECK(namesOf(HaloFamily::plates, prismFaces(), 25) == Names{"parhelion", "subparhelion", "120° parhelion", "subsun",
                                                               "parhelic circle", "circumzenithal arc", "Kern arc"});
  // Basal faces alone mirror, prism faces alone have no arcs of 90 degree wedges.
  CHECK(namesOf(HaloFamily::plates, {{0, 0, 1}, {0, 0, -1}}, 25) == Names{"subsun"});
  std::vector<Vec3> sides = prismFaces();
  sides.erase(sides.begin(), sides.begin() + 2);
  CHECK(namesOf(HaloFamily::random, sides, 20) == Names{"22° halo"});
  CHECK(namesOf(HaloFamily::columns, sides, 25) ==
        Names{"upper tangent arc", "lower tangent arc", "subsun", "subhelic arc"});
  CHECK(namesOf(HaloFamily::parry, prismFaces(), 50).count("lower suncave Parry arc") == 1);
  CHECK(namesOf(HaloFamily::parry, prismFaces(), 5).count("lower suncave Parry arc") == 0);
  CHECK(namesOf(HaloFamily::parry, prismFaces(), 5).count("upper sunvex Parry arc") == 1);
  CHECK(namesOf(HaloFamily::parry, prismFaces(), 50).count("upper sunvex Parry arc") == 0);
  CHECK(namesOf(HaloFamily::lowitz, prismFaces(), 20) == Names{"Lowitz arc"});
}

TEST_CASE("crystals with square sections make no halos of 60 degree wedges") {
  const std::vector<Vec3> cube{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const auto namesOf = [&](HaloFamily family, const std::vector<Vec3>& faces) {
    const HaloMaker maker{family, faces};
    const HaloForms forms = haloForms(radians(20), kIndex, std::span(&maker, 1));
    std::set<std::string> names;
    for (const HaloCurve& curve : forms.curves) names.insert(curve.name);
    for (const HaloPoint& point : forms.points) names.insert(point.name);
    return names;
  };
  using Names = std::set<std::string>;
  CHECK(namesOf(HaloFamily::plates, cube) == Names{"subsun", "parhelic circle", "circumzenithal arc"});
  for (const char* of60 : {"upper tangent arc", "lower tangent arc", "Wegener arc", "subhelic arc"}) {
    CHECK_FALSE(namesOf(HaloFamily::columns, cube).contains(of60));
    CHECK(namesOf(HaloFamily::columns, prismFaces()).contains(of60));
  }
  CHECK(namesOf(HaloFamily::columns, cube).contains("supralateral arc"));
  for (const std::string& name : namesOf(HaloFamily::parry, cube)) CHECK(name.find("Parry") == std::string::npos);
  CHECK(namesOf(HaloFamily::plates, prismFaces()).contains("parhelion"));
}

TEST_CASE("parhelia and subparhelia lie at Bravais' azimuth, and there are none with a sun above 60.75 degrees") {
  struct Case {
    double sun, azimuth;
  };
  for (const Case& c : {Case{0, 21.839}, Case{20, 24.576}, Case{40, 36.324}}) {
    CAPTURE(c.sun);
    for (const auto& [name, elevation] : {std::pair{"parhelion", c.sun}, std::pair{"subparhelion", -c.sun}}) {
      const std::vector<Vec2> at = spotsAt(c.sun, name);
      REQUIRE(at.size() == 1);
      CHECK(std::abs(at[0].x - c.azimuth) < kPublished);
      CHECK(std::abs(at[0].x - degrees(theory::leastTurn(kIndex, radians(c.sun)))) < 1e-10);
      CHECK(std::abs(at[0].y - elevation) < 1e-10);
    }
  }
  const double last = degrees(theory::lastParhelion(kIndex));
  CHECK(spotsAt(last - 0.01, "parhelion").size() == 1);
  CHECK(spotsAt(last + 0.01, "parhelion").empty());
}

TEST_CASE("subsun, anthelion and 120 degree parhelia lie at their azimuths") {
  const std::tuple<std::string, double, double> expected[] = {
      {"subsun", 0.0, -20.0}, {"anthelion", 180.0, 20.0}, {"120° parhelion", 120.0, 20.0}};
  for (const auto& [name, azimuth, elevation] : expected) {
    const std::vector<Vec2> at = spotsAt(20, name);
    REQUIRE(at.size() == 1);
    CHECK(std::abs(at[0].x - azimuth) < 1e-10);
    CHECK(std::abs(at[0].y - elevation) < 1e-10);
  }
}

TEST_CASE("the arcs of plates lie at their elevations and come and go with the sun") {
  for (const double sun : {5.0, 20.0}) {
    CAPTURE(sun);
    const HaloForms forms = haloForms(radians(sun), kIndex);
    CHECK(std::abs(highestOverSun(curveAt(forms, "circumzenithal arc")) -
                   degrees(theory::circumzenithal(kIndex, radians(sun)))) < 1e-6);
  }
  CHECK(std::abs(highestOverSun(curveAt(haloForms(radians(20), kIndex), "circumzenithal arc")) - 65.886) < kPublished);
  CHECK(std::abs(highestOverSun(curveAt(haloForms(radians(70), kIndex), "circumhorizontal arc")) - 24.114) <
        kPublished);
  CHECK(has(32.19, "circumzenithal arc"));
  CHECK(!has(32.20, "circumzenithal arc"));
  CHECK(has(57.81, "circumhorizontal arc"));
  CHECK(!has(57.80, "circumhorizontal arc"));
  CHECK(has(10, "sun pillar"));
  CHECK(!has(40, "sun pillar"));
}

TEST_CASE("the circumzenithal arc ends where light grazes the plates' sides") {
  const HaloForms forms = haloForms(radians(20), kIndex);
  double farthest = 0.0;
  const Vec3 toSun = skyDirection(0.0, radians(20));
  for (int i = 0; i < 36'000; ++i) {
    const Vec3 side = skyDirection(radians(0.01 * i), 0.0);
    if (const auto seen = refracted(toSun, Vec3(0.0, 0.0, 1.0), side))
      farthest = std::max(farthest, degrees(skyPoint(*seen).azimuth));
  }
  const SkyLine& arc = curveAt(forms, "circumzenithal arc").lines.front();
  // Near grazing incidence the light's azimuth goes with the square root of the side's: 0.01 degrees leave 0.8.
  CHECK(std::abs(degrees(skyPoint(arc.back()).azimuth) - farthest) < 0.8);
  CHECK(farthest > 50.0);
}

TEST_CASE("the tangent arcs touch the 22 degree ring above and below the sun and meet from 29.247 degrees on") {
  const double ring = degrees(theory::leastDeviation(radians(60), kIndex));
  const HaloForms low = haloForms(radians(20), kIndex);
  CHECK(std::abs(highestOverSun(curveAt(low, "upper tangent arc")) - (20 + ring)) < kSampled);
  for (const char* name : {"upper tangent arc", "lower tangent arc"})
    CHECK(std::abs(fromSun(curveAt(low, name), 20).least - ring) < kSampled);
  CHECK(has(29.24, "upper tangent arc"));
  CHECK(!has(29.24, "circumscribed halo"));
  CHECK(!has(29.25, "upper tangent arc"));
  CHECK(has(29.25, "circumscribed halo"));

  const HaloCurve high = curveAt(haloForms(radians(45), kIndex), "circumscribed halo");
  CHECK(std::abs(highestOverSun(high) - (45 + ring)) < kSampled);
  CHECK(high.lines.size() == 2);
  CHECK(glm::length(high.lines[0].front() - high.lines[1].back()) < kSkyLineStep);
  CHECK(glm::length(high.lines[0].back() - high.lines[1].front()) < kSkyLineStep);
}

TEST_CASE("the suncave Parry arc crosses the sun's vertical where Snell's law puts it") {
  for (const double sun : {1.0, 20.0, 40.0}) {
    CAPTURE(sun);
    CHECK(std::abs(highestOverSun(curveAt(haloForms(radians(sun), kIndex), "upper suncave Parry arc")) -
                   degrees(theory::suncaveParry(kIndex, radians(sun)))) < kSampled);
  }
}

TEST_CASE("supralateral and infralateral arcs touch the 46 degree ring, the supralateral the circumzenithal arc too") {
  const double ring = degrees(theory::leastDeviation(radians(90), kIndex));
  for (const double sun : {5.0, 20.0}) {
    CAPTURE(sun);
    const HaloForms forms = haloForms(radians(sun), kIndex);
    CHECK(std::abs(fromSun(curveAt(forms, "supralateral arc"), sun).least - ring) < kSampled);
    CHECK(std::abs(fromSun(curveAt(forms, "infralateral arc"), sun).least - ring) < kSampled);
    CHECK(std::abs(highestOverSun(curveAt(forms, "supralateral arc")) -
                   degrees(theory::circumzenithal(kIndex, radians(sun)))) < kSampled);
  }
  CHECK(has(32.19, "supralateral arc"));
  CHECK(!has(32.20, "supralateral arc"));
  CHECK(has(50, "infralateral arc"));
}

TEST_CASE("lines of haloForms are unit vectors in small steps, labelled on the line") {
  for (double sun = -5.0; sun <= 90.0; sun += 5.0) {
    CAPTURE(sun);
    for (const HaloCurve& curve : haloForms(radians(sun), kIndex).curves) {
      CAPTURE(curve.name);
      double longest = 0.0, offUnit = 0.0;
      bool labelled = false;
      for (const SkyLine& line : curve.lines) {
        REQUIRE(line.size() >= 2);
        for (std::size_t i = 0; i < line.size(); ++i) {
          offUnit = std::max(offUnit, std::abs(glm::length(line[i]) - 1.0));
          if (i > 0) longest = std::max(longest, glm::length(line[i] - line[i - 1]));
          labelled = labelled || line[i] == curve.labelAt;
        }
      }
      CHECK(longest <= kSkyLineStep * (1.0 + 1e-6));
      CHECK(offUnit < 1e-14);
      CHECK(labelled);
    }
  }
}
