// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes/prism_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "crystal/mesh/mesh_from_obj.h"

namespace parhelion {

namespace {

constexpr int kSides = 6;

/// A prism with pits and caps, put together from its middle plane outward on both ends.
class BuiltPrism {
 public:
  explicit BuiltPrism(double aspect) : aspect_(aspect) {}

  void add(bool isUpper, const PrismEnd& end) {
    const double sign = isUpper ? 1.0 : -1.0;
    const int rim = addRing(1.0, sign * aspect_);
    rims_[isUpper ? 1 : 0] = rim;
    if (end.cavity.isThere())
      addPit(isUpper, end.cavity, rim);
    else if (end.cap.isThere())
      addCap(isUpper, end.cap, rim);
    else
      addEnd(isUpper, rim);
  }

  CrystalMesh mesh() {
    for (int k = 0; k < kSides; ++k) putBetween(rims_[0], rims_[1], k, 3 + k, true);
    return meshFromObj(mesh_, OneFace::byNumber);
  }

 private:
  void addPit(bool isUpper, const Cavity& cavity, int rim) {
    const double end = isUpper ? aspect_ : -aspect_;
    const int inner = addRing(cavity.width, end);
    const int apex = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.emplace_back(0.0, 0.0, end * (1.0 - cavity.depth));
    for (int k = 0; k < kSides; ++k) {
      putBetween(rim, inner, k, isUpper ? 1 : 2, isUpper);
      put({{inner + k, inner + (k + 1) % kSides, apex}, 0, (isUpper ? 33 : 43) + k}, isUpper);
    }
  }

  void addCap(bool isUpper, const Cap& cap, int rim) {
    const double sign = isUpper ? 1.0 : -1.0, end = sign * aspect_;
    const int own = isUpper ? 50 : 60;
    int inner = rim;
    if (cap.width != 1.0) {
      inner = addRing(cap.width, end);
      const bool facesUp = isUpper == (cap.width < 1.0);
      for (int k = 0; k < kSides; ++k) putBetween(rim, inner, k, own + (facesUp ? 1 : 2), isUpper);
    }
    const int outer = addRing(cap.width, end + sign * 2.0 * cap.width * cap.aspect);
    for (int k = 0; k < kSides; ++k) putBetween(inner, outer, k, (cap.width == 1.0 ? 3 : own + 3) + k, isUpper);
    addEnd(isUpper, outer);
  }

  void addEnd(bool isUpper, int ring) {
    ObjPolygon end{{}, 0, isUpper ? 1 : 2};
    for (int k = 0; k < kSides; ++k) end.corners.push_back(ring + k);
    put(std::move(end), isUpper);
  }

  /// A ring of vertices: that of place k lies between prism faces 2 + k and 3 + k.
  int addRing(double radius, double z) {
    static const double kHeight = 0.5 * std::sqrt(3.0);
    const std::array<std::array<double, 2>, kSides> corners{
        {{kHeight, -0.5}, {kHeight, 0.5}, {0.0, 1.0}, {-kHeight, 0.5}, {-kHeight, -0.5}, {0.0, -1.0}}};
    const int first = static_cast<int>(mesh_.vertices.size());
    for (const auto& [x, y] : corners) mesh_.vertices.emplace_back(radius * x, radius * y, z);
    return first;
  }

  /// Side k between two rings, of which the second is further out along c, or nearer to it at the same height.
  void putBetween(int first, int second, int k, int number, bool isUpper) {
    const int next = (k + 1) % kSides;
    put({{first + k, first + next, second + next, second + k}, 0, number}, isUpper);
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

CrystalMesh prismWithEnds(double aspect, const PrismEnd& upper, const PrismEnd& lower) {
  for (const PrismEnd& end : {upper, lower})
    if (end.cavity.isThere() && end.cap.isThere())
      throw std::invalid_argument("an end of a prism has a pit or a cap, not both");
  if (upper.cavity.isThere() && lower.cavity.isThere() && !(upper.cavity.depth + lower.cavity.depth < 2.0))
    throw std::invalid_argument("the pits of the two ends meet: their depths must add up to less than 2");
  BuiltPrism prism(aspect);
  prism.add(true, upper);
  prism.add(false, lower);
  return prism.mesh();
}

}  // namespace parhelion
