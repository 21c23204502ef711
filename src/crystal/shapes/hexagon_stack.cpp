// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes/hexagon_stack.h"

#include <array>
#include <cmath>

namespace parhelion {

int HexagonStack::addRing(double side, double z) {
  const int first = static_cast<int>(vertices.size());
  if (side == 0.0) {
    vertices.emplace_back(0.0, 0.0, z);
    return first;
  }
  const double x = 0.5 * std::sqrt(3.0) * side, y = 0.5 * side;
  for (const auto& [cx, cy] :
       std::array<std::array<double, 2>, 6>{{{x, -y}, {x, y}, {0.0, side}, {-x, y}, {-x, -y}, {0.0, -side}}})
    vertices.emplace_back(cx, cy, z);
  return first;
}

void HexagonStack::addBelt(int firstNumber, int lower, bool lowerIsApex, int upper, bool upperIsApex) {
  for (int k = 0; k < 6; ++k) {
    const int next = (k + 1) % 6;
    std::vector<int> ring{lowerIsApex ? lower : lower + k};
    if (!lowerIsApex) ring.push_back(lower + next);
    ring.push_back(upperIsApex ? upper : upper + next);
    if (!upperIsApex) ring.push_back(upper + k);
    faces.push_back({firstNumber + k, ring});
  }
}

}  // namespace parhelion
