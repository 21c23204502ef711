// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "optics/halo_curves.h"

using namespace parhelion;

namespace {

/// Azimuth (degrees, right of the sun) in which most light of columns is seen near an elevation, of all orientations
/// about the vertical and about their horizontal axes; `faces` gives the two normals from the axis and from the
/// directions across.
template <class Faces>
double brightestAzimuth(double sunDegrees, double elevation, double from, double to, Faces&& faces) {
  constexpr int kAxes = 1200, kRolls = 1200;
  constexpr double kBin = 0.1, kBand = 0.15;  // degrees
  std::vector<int> bins(static_cast<std::size_t>((to - from) / kBin));
  const Vec3 toSun = skyDirection(0.0, radians(sunDegrees));
  for (int i = 0; i < kAxes; ++i) {
    const Vec3 axis = skyDirection(2.0 * kPi * (i + 0.5) / kAxes, 0.0);
    const Vec3 level = glm::cross(Vec3(0.0, 0.0, 1.0), axis);
    for (int k = 0; k < kRolls; ++k) {
      const double roll = 2.0 * kPi * (k + 0.5) / kRolls;
      const auto across = [&](double turn) {
        return std::cos(roll + turn) * Vec3(0.0, 0.0, 1.0) + std::sin(roll + turn) * level;
      };
      const auto [in, out] = faces(axis, across);
      const std::optional<Vec3> seen = refracted(toSun, in, out);
      if (!seen) continue;
      const SkyPoint at = skyPoint(*seen);
      const double azimuth = degrees(at.azimuth);
      if (std::abs(degrees(at.elevation) - elevation) < kBand && azimuth > from && azimuth < to - kBin)
        ++bins[static_cast<std::size_t>((azimuth - from) / kBin)];
    }
  }
  const auto most = std::max_element(bins.begin(), bins.end());
  REQUIRE(*most > 0);
  return from + (static_cast<double>(most - bins.begin()) + 0.5) * kBin;
}

struct Faces {
  Vec3 in, out;
};

}  // namespace

TEST_CASE("light refracted by columns in all orientations is brightest on the arcs of haloForms") {
  struct Case {
    const char* name;
    double sun, elevation, from, to;  // degrees
  };
  const auto check = [](const Case& c, auto&& faces) {
    CAPTURE(c.name);
    const std::vector<double> at = crossings(curveAt(haloForms(radians(c.sun), kIndex), c.name), c.elevation, true);
    const double bright = brightestAzimuth(c.sun, c.elevation, c.from, c.to, faces);
    double nearest = std::numeric_limits<double>::infinity();
    for (const double azimuth : at) nearest = std::min(nearest, std::abs(azimuth - bright));
    // Half a bin, and what the slant of the arc makes of the band's width.
    CHECK(nearest < 0.25);
  };
  const auto wedge60 = [](const Vec3&, const auto& across) { return Faces{across(0.0), across(radians(120))}; };
  const auto intoSide = [](const Vec3& axis, const auto& across) { return Faces{across(0.0), axis}; };
  const auto intoEnd = [](const Vec3& axis, const auto& across) { return Faces{axis, across(0.0)}; };
  check({"upper tangent arc", 20, 39, 1, 60}, wedge60);
  check({"circumscribed halo", 45, 45, 1, 60}, wedge60);
  check({"supralateral arc", 20, 50, 1, 90}, intoSide);
  check({"supralateral arc", 10, 30, 1, 90}, intoSide);
  check({"infralateral arc", 20, 15, 30, 90}, intoEnd);
  check({"infralateral arc", 50, 20, 20, 90}, intoEnd);
}

TEST_CASE("columns do send light to every point of the supralateral and infralateral arcs") {
  constexpr int kSteps = 360;
  // Axes and rolls a degree apart leave gaps of less than this where light is spread widest, degrees.
  constexpr double kGap = 2.0;
  const Vec3 toSun = skyDirection(0.0, radians(20));
  std::vector<Vec3> intoSide, intoEnd;
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 axis = skyDirection(radians(i), 0.0), level = glm::cross(Vec3(0.0, 0.0, 1.0), axis);
    for (int k = 0; k < kSteps; ++k) {
      const Vec3 side = std::cos(radians(k)) * Vec3(0.0, 0.0, 1.0) + std::sin(radians(k)) * level;
      if (const auto seen = refracted(toSun, side, axis)) intoSide.push_back(*seen);
      if (const auto seen = refracted(toSun, axis, side)) intoEnd.push_back(*seen);
    }
  }
  const HaloForms forms = haloForms(radians(20), kIndex);
  for (const auto& [name, light] :
       {std::pair{"supralateral arc", &intoSide}, std::pair{"infralateral arc", &intoEnd}}) {
    double loneliest = 0.0;
    for (const SkyLine& line : curveAt(forms, name).lines)
      for (std::size_t i = 0; i < line.size(); i += 8) {
        double nearest = -1.0;  // cosine
        for (const Vec3& seen : *light) nearest = std::max(nearest, glm::dot(line[i], seen));
        loneliest = std::max(loneliest, degrees(std::acos(std::min(1.0, nearest))));
      }
    CAPTURE(name);
    CHECK(loneliest < kGap);
  }
}
