// SPDX-License-Identifier: Apache-2.0
#include "optics/halo_makers.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"

namespace parhelion {
namespace {

// A normal counts as along or across the c axis in spite of rounding.
constexpr double kSameWay = 1e-9;
// Cosines of the angles between faces that differ by less are of the same wedge: half a degree.
constexpr double kSameWedge = 0.0075;

}  // namespace

bool isEnd(const Vec3& normal) { return std::abs(normal.z) > 1.0 - kSameWay; }
bool isSide(const Vec3& normal) { return std::abs(normal.z) < kSameWay; }

bool HaloMaker::hasEnds() const { return std::any_of(faces.begin(), faces.end(), isEnd); }
bool HaloMaker::hasSides() const { return std::any_of(faces.begin(), faces.end(), isSide); }

bool HaloMaker::hasWedge() const {
  // The outward normals are 120 degrees apart.
  const auto makeOne = [](const Vec3& a, const Vec3& b) { return std::abs(a.x * b.x + a.y * b.y + 0.5) < kSameWedge; };
  for (const Vec3& one : faces)
    for (const Vec3& other : faces)
      if (isSide(one) && isSide(other) && makeOne(one, other)) return true;
  return false;
}

std::vector<Vec3> prismFaces() {
  std::vector<Vec3> faces{{0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}};
  for (int k = 0; k < 6; ++k) {
    const auto [s, c] = portable::sincos(k * kPi / 3.0);
    faces.emplace_back(c, s, 0.0);
  }
  return faces;
}

std::vector<Vec3> pyramidFaces(double slope) {
  std::vector<Vec3> faces = prismFaces();
  const auto [rise, out] = portable::sincos(slope);
  for (const double side : {1.0, -1.0})
    for (std::size_t k = 2; k < 8; ++k) faces.push_back(out * faces[k] + Vec3(0.0, 0.0, side * rise));
  return faces;
}

std::vector<HaloMaker> allHaloMakers() {
  std::vector<HaloMaker> makers;
  for (const HaloFamily family : {HaloFamily::plates, HaloFamily::columns, HaloFamily::parry, HaloFamily::lowitz})
    makers.push_back({family, prismFaces()});
  makers.push_back({HaloFamily::random, pyramidFaces()});
  return makers;
}

}  // namespace parhelion
