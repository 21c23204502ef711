// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes/prism.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "crystal/shapes/hexagon_stack.h"

namespace parhelion {

CrystalMesh hexagonalPrism(double aspect) {
  HexagonStack stack;
  const int lower = stack.addRing(1.0, -aspect), upper = stack.addRing(1.0, aspect);
  stack.addTop(upper);
  stack.addBottom(lower);
  stack.addBelt(3, lower, false, upper, false);
  return CrystalMesh(stack.vertices, stack.faces);
}

CrystalMesh meshOf(const PrismSettings& prism) {
  const auto* fixed = std::get_if<FixedValue>(&prism.aspect);
  const double aspect = fixed ? fixed->value : 1.0;
  if (!prism.isPlain()) {
    if (!fixed || !isHexagonal(prism))
      throw std::invalid_argument("a prism with pits, caps or notches has regular sides and one aspect");
    if (!prism.notch.isThere()) return prismWithEnds(aspect, prism.upper, prism.lower);
    if (prism.upper.isThere() || prism.lower.isThere())
      throw std::invalid_argument("a prism with notches has neither pits nor caps");
    return notchedPrism(aspect, prism.notch);
  }
  if (isHexagonal(prism)) return hexagonalPrism(aspect);
  std::vector<FacePlane> planes = endPlanes(aspect, -aspect);
  std::ranges::copy(sidePlanes(prism.sides), std::back_inserter(planes));
  return convexBody(planes, !prism.spreads.empty());
}

std::optional<AngleDistribution> stretchOf(const PrismSettings& prism) {
  if (std::holds_alternative<FixedValue>(prism.aspect)) return std::nullopt;
  return std::visit([](const auto& d) -> AngleDistribution { return d; }, prism.aspect);
}

}  // namespace parhelion
