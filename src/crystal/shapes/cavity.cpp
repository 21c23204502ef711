// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes/cavity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "crystal/mesh/mesh_from_obj.h"

namespace parhelion {

namespace {

constexpr int kSides = 6;

/// A prism with pits, put together from its middle plane outward on both ends.
class HollowPrism {
 public:
  explicit HollowPrism(double aspect) : aspect_(aspect) {}

  void add(bool isUpper, const Cavity& cavity) {
    const double sign = isUpper ? 1.0 : -1.0;
    const int rim = addRing(1.0, sign * aspect_);
    if (!cavity.isThere()) {
      ObjPolygon end{{}, 0, isUpper ? 1 : 2};
      for (int k = 0; k < kSides; ++k) end.corners.push_back(rim + k);
      put(std::move(end), isUpper);
      return;
    }
    const int inner = addRing(cavity.width, sign * aspect_);
    const int apex = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.emplace_back(0.0, 0.0, sign * aspect_ * (1.0 - cavity.depth));
    for (int k = 0; k < kSides; ++k) {
      const int next = (k + 1) % kSides;
      put({{rim + k, rim + next, inner + next, inner + k}, 0, isUpper ? 1 : 2}, isUpper);
      put({{inner + k, inner + next, apex}, 0, (isUpper ? 33 : 43) + k}, isUpper);
    }
  }

  CrystalMesh mesh() {
    for (int k = 0; k < kSides; ++k) {
      const int next = (k + 1) % kSides;
      put({{rims_[0] + k, rims_[0] + next, rims_[1] + next, rims_[1] + k}, 0, 3 + k}, true);
    }
    return meshFromObj(mesh_);
  }

 private:
  /// A ring of vertices: that of place k lies between prism faces 2 + k and 3 + k.
  int addRing(double radius, double z) {
    static const double kHeight = 0.5 * std::sqrt(3.0);
    const std::array<std::array<double, 2>, kSides> corners{
        {{kHeight, -0.5}, {kHeight, 0.5}, {0.0, 1.0}, {-kHeight, 0.5}, {-kHeight, -0.5}, {0.0, -1.0}}};
    const int first = static_cast<int>(mesh_.vertices.size());
    if (radius == 1.0) rims_[z > 0.0 ? 1 : 0] = first;
    for (const auto& [x, y] : corners) mesh_.vertices.emplace_back(radius * x, radius * y, z);
    return first;
  }

  /// A polygon that is counter-clockwise from above; for the lower end it is turned around.
  void put(ObjPolygon polygon, bool isUpper) {
    if (!isUpper) std::ranges::reverse(polygon.corners);
    mesh_.polygons.push_back(std::move(polygon));
  }

  double aspect_;
  ObjMesh mesh_;
  std::array<int, 2> rims_{};  // of the lower and the upper end
};

}  // namespace

CrystalMesh hollowPrism(double aspect, const Cavity& upper, const Cavity& lower) {
  if (upper.isThere() && lower.isThere() && !(upper.depth + lower.depth < 2.0))
    throw std::invalid_argument("the pits of the two ends meet: their depths must add up to less than 2");
  HollowPrism prism(aspect);
  prism.add(true, upper);
  prism.add(false, lower);
  return prism.mesh();
}

}  // namespace parhelion
