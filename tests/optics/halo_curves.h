// SPDX-License-Identifier: Apache-2.0
#pragma once

// What tests ask of the curves of halo_forms.h, and light refracted by two faces to compare them with.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "optics/halo_forms.h"

namespace parhelion {

inline constexpr double kIndex = 1.31;

inline const HaloCurve* find(const HaloForms& forms, const std::string& name) {
  for (const HaloCurve& curve : forms.curves)
    if (curve.name == name) return &curve;
  return nullptr;
}

inline const HaloCurve& curveAt(const HaloForms& forms, const std::string& name) {
  const HaloCurve* curve = find(forms, name);
  REQUIRE_MESSAGE(curve != nullptr, name);
  return *curve;
}

/// Azimuths (degrees, right of the sun) at which a curve crosses an elevation, or elevations at which it crosses an
/// azimuth.
inline std::vector<double> crossings(const HaloCurve& curve, double degreesAt, bool ofElevation) {
  std::vector<double> found;
  for (const SkyLine& line : curve.lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const SkyPoint a = skyPoint(line[i - 1]), b = skyPoint(line[i]);
      const double from = degrees(ofElevation ? a.elevation : a.azimuth) - degreesAt;
      const double to = degrees(ofElevation ? b.elevation : b.azimuth) - degreesAt;
      if (from * to > 0.0 || std::abs(from - to) > 90.0 || from == to) continue;
      const double share = from / (from - to);
      const double other =
          ofElevation ? a.azimuth + share * (b.azimuth - a.azimuth) : a.elevation + share * (b.elevation - a.elevation);
      if (!ofElevation || other >= 0.0) found.push_back(degrees(other));
    }
  return found;
}

/// Where light from the sun is seen after two faces with these outward normals. Snell's law with angles, for a check of
/// what the code does with vectors.
inline std::optional<Vec3> refracted(const Vec3& toSun, const Vec3& in, const Vec3& out) {
  const auto bend = [](const Vec3& v, const Vec3& normal, double ratio) -> std::optional<Vec3> {
    const Vec3 along = v - glm::dot(v, normal) * normal;
    const double sine = glm::length(along), bent = sine * ratio;
    if (bent > 1.0) return std::nullopt;
    if (sine == 0.0) return v;
    const double angle = std::asin(bent);
    return std::cos(angle) * normal + std::sin(angle) / sine * along;
  };
  if (glm::dot(toSun, in) <= 0.0) return std::nullopt;
  const std::optional<Vec3> inside = bend(toSun, in, 1.0 / kIndex);
  if (glm::dot(*inside, out) >= 0.0) return std::nullopt;
  return bend(*inside, -out, kIndex);
}

}  // namespace parhelion
