// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes/pyramid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "crystal/shapes/hexagon_stack.h"
#include "math/portable.h"

namespace parhelion {

namespace {

/// Of a full pyramid. The hexagon's face normals stand at the apothem from the axis; a pyramid face climbs from there
/// to the apex.
double apexHeightOf(double slope) { return 0.5 * std::sqrt(3.0) / portable::tan(slope); }

struct Ends {
  double upper, lower;
};
Ends slopesOf(const PyramidSettings& p) { return {p.upperSlope.value_or(p.slope), p.lowerSlope.value_or(p.slope)}; }

/// Lengths along c of both pyramids.
Ends heightsOf(const PyramidSettings& p) {
  const auto [upper, lower] = slopesOf(p);
  return {p.upper * apexHeightOf(upper), p.lower * apexHeightOf(lower)};
}

void checkLength(const PyramidSettings& pyramid) {
  const double aspect = lengthOverWidth(pyramid);
  if (!(aspect >= kThinnestAspect && aspect <= kLongestAspect))
    throw std::invalid_argument("a pyramid crystal's length over its width must lie from 1e-4 to 1e4");
}

}  // namespace

double slopeOfMiller(int h, int l) {
  constexpr double kAxes = 1.6288;  // c/a
  return portable::atan2(0.5 * std::sqrt(3.0) * l, kAxes * h);
}

double lengthOverWidth(const PyramidSettings& settings) {
  if (slopesOf(settings).upper == slopesOf(settings).lower)
    return settings.aspect + 0.5 * (settings.upper + settings.lower) * apexHeightOf(slopesOf(settings).upper);
  const auto [upper, lower] = heightsOf(settings);
  return settings.aspect + 0.5 * (upper + lower);
}

CrystalMesh meshOf(const PyramidSettings& pyramid) {
  if (isHexagonal(pyramid)) return hexagonalPyramid(pyramid);
  checkLength(pyramid);
  const auto [upperSlope, lowerSlope] = slopesOf(pyramid);
  const auto [upper, lower] = heightsOf(pyramid);
  std::vector<FacePlane> planes = endPlanes(pyramid.aspect + upper, -pyramid.aspect - lower);
  const auto add = [&](const std::vector<FacePlane>& more) { std::ranges::copy(more, std::back_inserter(planes)); };
  add(sidePlanes(pyramid.sides));
  add(sidePlanes(pyramid.sides, 13, upperSlope, pyramid.aspect));
  add(sidePlanes(pyramid.sides, 23, -lowerSlope, -pyramid.aspect));
  return convexBody(planes, !pyramid.spreads.empty());
}

CrystalMesh hexagonalPyramid(const PyramidSettings& settings) {
  checkLength(settings);
  const auto [upperHeight, lowerHeight] = heightsOf(settings);

  HexagonStack stack;
  const int lower = stack.addRing(1.0, -settings.aspect);
  const int upper = settings.aspect > 0.0 ? stack.addRing(1.0, settings.aspect) : lower;
  if (settings.aspect > 0.0) stack.addBelt(3, lower, false, upper, false);

  int top = upper, bottom = lower;
  if (settings.upper > 0.0) {
    top = stack.addRing(1.0 - settings.upper, settings.aspect + upperHeight);
    stack.addBelt(13, upper, false, top, settings.upper == 1.0);
  }
  if (settings.lower > 0.0) {
    bottom = stack.addRing(1.0 - settings.lower, -settings.aspect - lowerHeight);
    stack.addBelt(23, bottom, settings.lower == 1.0, lower, false);
  }
  if (settings.upper < 1.0) stack.addTop(top);
  if (settings.lower < 1.0) stack.addBottom(bottom);
  return CrystalMesh(stack.vertices, stack.faces);
}

}  // namespace parhelion
