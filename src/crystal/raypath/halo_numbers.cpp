// SPDX-License-Identifier: Apache-2.0
#include "crystal/raypath/halo_numbers.h"

#include <algorithm>
#include <cmath>

#include "crystal/isometry.h"
#include "math/conventions.h"

namespace parhelion {

namespace {

// A face within this angle of where a prism or a pyramid has one is that face to a halo: slopes are known no better.
constexpr double kAlike = radians(1.0);
// Of faces {10-11} to c.
constexpr double kPyramidSlope = radians(28.0);
constexpr double kSixth = kPi / 3.0;
// More turns than crystals of ice have; the faces of any others have no names.
constexpr std::size_t kMostTurns = 12;

/// From face 3 on, the prism face at an azimuth; none where there is none.
int sideAt(double azimuth) {
  const double sixths = azimuth / kSixth, nearest = std::round(sixths);
  if (std::abs(sixths - nearest) * kSixth > kAlike) return -1;
  return ((static_cast<int>(nearest) % 6) + 6) % 6;
}

int haloNumber(const Vec3& normal, double turn) {
  const double across = std::hypot(normal.x, normal.y), slope = std::atan2(std::abs(normal.z), across);
  const int first = normal.z > 0.0 ? 1 : 2;
  if (0.5 * kPi - slope < kAlike) return first;
  const int side = sideAt(std::atan2(normal.y, normal.x) + turn);
  if (side < 0) return 0;
  if (slope < kAlike) return 3 + side;
  return std::abs(slope - kPyramidSlope) < kAlike ? 10 * first + 3 + side : 0;
}

}  // namespace

std::vector<int> haloNumbers(const CrystalMesh& mesh, double turn) {
  std::vector<int> numbers;
  for (const Face& face : mesh.faces()) numbers.push_back(haloNumber(face.normal, turn));
  return numbers;
}

std::vector<double> turnsOf(const CrystalMesh& mesh, bool turnsFreely) {
  std::vector<double> turns{0.0};
  const double same = faceImages(mesh, {.sixths = 1}) ? kSixth : 2.0 * kPi;
  for (const Face& face : mesh.faces()) {
    if (!turnsFreely || turns.size() == kMostTurns) break;
    if (std::hypot(face.normal.x, face.normal.y) < std::sin(kAlike)) continue;
    const double turn = -std::remainder(std::atan2(face.normal.y, face.normal.x), same);
    const auto isAlike = [&](double other) { return std::abs(std::remainder(turn - other, same)) < 2.0 * kAlike; };
    if (std::ranges::none_of(turns, isAlike)) turns.push_back(turn);
  }
  return turns;
}

}  // namespace parhelion
