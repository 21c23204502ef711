// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes/pyramid.h"

#include <cmath>
#include <stdexcept>

#include "crystal/shapes/hexagon_stack.h"
#include "math/portable.h"

namespace parhelion {

namespace {

/// Of a full pyramid. The hexagon's face normals stand at the apothem from the axis; a pyramid face climbs from there
/// to the apex.
double apexHeightOf(const PyramidSettings& settings) { return 0.5 * std::sqrt(3.0) / portable::tan(settings.slope); }

}  // namespace

double lengthOverWidth(const PyramidSettings& settings) {
  return settings.aspect + 0.5 * (settings.upper + settings.lower) * apexHeightOf(settings);
}

CrystalMesh hexagonalPyramid(const PyramidSettings& settings) {
  const double aspect = lengthOverWidth(settings);
  if (!(aspect >= kThinnestAspect && aspect <= kLongestAspect))
    throw std::invalid_argument("a pyramid crystal's length over its width must lie from 1e-4 to 1e4");
  const double apexHeight = apexHeightOf(settings);

  HexagonStack stack;
  const int lower = stack.addRing(1.0, -settings.aspect);
  const int upper = settings.aspect > 0.0 ? stack.addRing(1.0, settings.aspect) : lower;
  if (settings.aspect > 0.0) stack.addBelt(3, lower, false, upper, false);

  int top = upper, bottom = lower;
  if (settings.upper > 0.0) {
    top = stack.addRing(1.0 - settings.upper, settings.aspect + settings.upper * apexHeight);
    stack.addBelt(13, upper, false, top, settings.upper == 1.0);
  }
  if (settings.lower > 0.0) {
    bottom = stack.addRing(1.0 - settings.lower, -settings.aspect - settings.lower * apexHeight);
    stack.addBelt(23, bottom, settings.lower == 1.0, lower, false);
  }
  if (settings.upper < 1.0) stack.addTop(top);
  if (settings.lower < 1.0) stack.addBottom(bottom);
  return CrystalMesh(stack.vertices, stack.faces);
}

}  // namespace parhelion
