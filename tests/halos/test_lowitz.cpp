// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "halos/experiment.h"

using namespace parhelion;

namespace {

constexpr int kSectors = 360;  // of the angle about the sun
using Edges = std::array<double, kSectors>;

/// How far from the sun light is seen (degrees), and in which sector about the sun, clockwise from straight up.
struct AboutSun {
  double angle;
  int sector;
};
AboutSun aboutSun(const Vec3& lightDirBefore, const Vec3& lightDirAfter, double sunElevation) {
  const Vec3 up = skyDirection(0.0, sunElevation + 0.5 * kPi), right(0.0, -1.0, 0.0);
  const double turn = std::atan2(glm::dot(-lightDirAfter, right), glm::dot(-lightDirAfter, up)) / (2.0 * kPi);
  const int sector = static_cast<int>((turn < 0.0 ? turn + 1.0 : turn) * kSectors) % kSectors;
  return {degrees(angleBetween(lightDirBefore, lightDirAfter)), sector};
}

/// Snell's law for a unit normal against the light, by the tangential part; empty where light is totally reflected.
std::optional<Vec3> bent(const Vec3& lightDir, const Vec3& normal, double ratio) {
  const Vec3 tangential = ratio * (lightDir - glm::dot(lightDir, normal) * normal);
  const double rest = 1.0 - glm::dot(tangential, tangential);
  if (rest <= 0.0) return std::nullopt;
  return tangential - std::sqrt(rest) * normal;
}

/// Widens the edges by the light that a crystal with the given outward normals bends through its 60 degree wedges.
void closeIn(Edges& edges, const std::array<Vec3, 6>& normals, const Vec3& lightDir, double sun) {
  for (int in = 0; in < 6; ++in) {
    if (glm::dot(normals[in], lightDir) >= 0.0) continue;
    const Vec3 inside = *bent(lightDir, normals[in], 1.0 / kIndex);
    for (const int out : {(in + 2) % 6, (in + 4) % 6}) {
      if (glm::dot(normals[out], inside) <= 0.0) continue;
      const auto after = bent(inside, -normals[out], kIndex);
      if (!after) continue;
      const AboutSun seen = aboutSun(lightDir, *after, sun);
      edges[seen.sector] = std::min(edges[seen.sector], seen.angle);
    }
  }
}

/// Inner edge of the Lowitz arcs in every sector, from the picture in the books alone: an axis from edge to edge of the
/// prism stays level, the crystal turns about it, and light goes through two faces that meet at 60 degrees.
Edges edgesByScan(double sun, double widestSpin) {
  Edges edges;
  edges.fill(kPi * 180.0);
  const Vec3 lightDir = -skyDirection(0.0, sun);
  constexpr int kAzimuths = 7200, kSpins = 241;
  for (int i = 0; i < kAzimuths; ++i) {
    const double azimuth = 2.0 * kPi * (i + 0.5) / kAzimuths;
    const Vec3 level(std::cos(azimuth), std::sin(azimuth), 0.0), across(-std::sin(azimuth), std::cos(azimuth), 0.0);
    for (int j = 0; j < kSpins; ++j) {
      const double spin = widestSpin * (2.0 * j / (kSpins - 1) - 1.0);
      // Perpendicular to the axis within the crystal's hexagon, whose face normals are 30, 90 ... degrees from the
      // axis.
      const Vec3 side = std::cos(spin) * across + std::sin(spin) * Vec3(0, 0, 1);
      std::array<Vec3, 6> normals;
      for (int k = 0; k < 6; ++k) {
        const double angle = radians(30 + 60 * k);
        normals[k] = std::cos(angle) * level + std::sin(angle) * side;
      }
      closeIn(edges, normals, lightDir, sun);
    }
  }
  return edges;
}

}  // namespace

TEST_CASE("Lowitz arcs have their inner edges where turning the crystal step by step puts them") {
  const double sun = radians(20), widestSpin = radians(40);
  const PopulationSettings crystals =
      prisms(0.5, LowitzOrientation{FixedValue{0.5 * kPi}, UniformRange{-widestSpin, widestSpin}});
  Edges traced;
  traced.fill(kPi * 180.0);
  std::array<int, kSectors> rays{};
  forDirectLight(cloudUnderPointSun(sun, {crystals}), 1'000'000, [&](const DirectLight& light) {
    if (!isWedge60(light.in, light.out)) return;
    const AboutSun seen = aboutSun(light.incident.lightDirWorld, light.lightDirWorld, sun);
    traced[seen.sector] = std::min(traced[seen.sector], seen.angle);
    ++rays[seen.sector];
  });
  const Edges expected = edgesByScan(sun, widestSpin);
  int compared = 0;
  for (int sector = 0; sector < kSectors; ++sector) {
    if (rays[sector] < 500) continue;  // too few to have met the edge
    CAPTURE(sector);
    CHECK(std::abs(traced[sector] - expected[sector]) < 0.1);
    ++compared;
  }
  CHECK(compared > 20);
}
