// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "math/conventions.h"

namespace parhelion {

/// How crystals stand, by which observers tell halos apart; of those in all orientations, what their faces make.
enum class HaloFamily { plates, columns, parry, lowitz, random, pyramids };

constexpr std::string_view nameOf(HaloFamily family) {
  switch (family) {
    case HaloFamily::plates:
      return "plates";
    case HaloFamily::columns:
      return "columns";
    case HaloFamily::parry:
      return "parry";
    case HaloFamily::lowitz:
      return "lowitz";
    case HaloFamily::random:
      return "random";
    case HaloFamily::pyramids:
      return "pyramids";
  }
  return {};
}

/// Crystals that stand alike: all that the places of halos depend on, besides sun and ice.
struct HaloMaker {
  HaloFamily family;        // of pyramids in all orientations: random
  std::vector<Vec3> faces;  // outward unit normals, in the crystal's frame

  /// Whether there are faces across the c axis, and along it.
  bool hasEnds() const;
  bool hasSides() const;

  /// Whether two faces along the c axis make a wedge of 60 degrees, which the light of parhelia and of most arcs of
  /// columns goes through.
  bool hasWedge() const;
};

/// Whether a face with this normal lies across the c axis, or along it.
bool isEnd(const Vec3& normal);
bool isSide(const Vec3& normal);

/// The outward normals of a regular hexagonal prism's faces 1-8.
std::vector<Vec3> prismFaces();

/// The same with faces 13-18 and 23-28, which stand at `slope` (rad) to the c axis; {10-11} at 28 degrees.
std::vector<Vec3> pyramidFaces(double slope = radians(28.0));

/// Prisms in every way that has a name, and pyramids in all orientations.
std::vector<HaloMaker> allHaloMakers();

}  // namespace parhelion
