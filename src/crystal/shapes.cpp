// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes.h"

#include "crystal/isometry.h"

namespace parhelion {

namespace {

using What = ShapeLength;

void setSides(const ShapeSpread& spread, double value, Sides& sides) {
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (spread.sides[k]) sides[k] = value;
}

void set(const ShapeSpread& spread, double value, PrismSettings& prism) {
  if (spread.what == ShapeLength::aspect)
    prism.aspect = FixedValue{value};
  else
    setSides(spread, value, prism.sides);
}

void set(const ShapeSpread& spread, double value, PyramidSettings& pyramid) {
  switch (spread.what) {
    case What::aspect:
      pyramid.aspect = value;
      break;
    case What::upper:
      pyramid.upper = value;
      break;
    case What::lower:
      pyramid.lower = value;
      break;
    case What::slope:
      pyramid.slope = value;
      break;
    case What::upperSlope:
      pyramid.upperSlope = value;
      break;
    case What::lowerSlope:
      pyramid.lowerSlope = value;
      break;
    case What::sides:
      setSides(spread, value, pyramid.sides);
      break;
  }
}

void set(const ShapeSpread&, double, PlanesSettings&) {}
void set(const ShapeSpread&, double, MeshSettings&) {}
void set(const ShapeSpread&, double, RosetteSettings&) {}

template <class Shape>
void setOrSpread(Shape& shape, const ShapeSpread& spread) {
  if (const auto* fixed = std::get_if<FixedValue>(&spread.distribution))
    set(spread, fixed->value, shape);
  else
    shape.spreads.push_back(spread);
}

}  // namespace

void setLength(PrismSettings& prism, const ShapeSpread& spread) { setOrSpread(prism, spread); }
void setLength(PyramidSettings& pyramid, const ShapeSpread& spread) { setOrSpread(pyramid, spread); }

ShapeSettings drawnShape(const ShapeSettings& shape, std::span<const LengthSampler> samplers,
                         std::span<const double> u) {
  ShapeSettings drawn = shape;
  const auto spreads = spreadsOf(shape);
  for (std::size_t i = 0; i < spreads.size(); ++i)
    std::visit([&](auto& own) { set(spreads[i], samplers[i].at(u[i]), own); }, drawn);
  return drawn;
}

ShapeSettings typicalShape(const ShapeSettings& shape) {
  constexpr double kFraction = 0.45;
  const auto spreads = spreadsOf(shape);
  const std::vector<LengthSampler> samplers(spreads.begin(), spreads.end());
  return drawnShape(shape, samplers, std::vector<double>(spreads.size(), kFraction));
}

bool hasHalfTurn(const ShapeSettings& shape) {
  if (std::visit([](const auto& own) { return isHexagonal(own); }, shape)) return true;
  return faceImages(meshOf(typicalShape(shape)), {.sixths = 3}).has_value();
}

std::span<const ShapeSpread> spreadsOf(const ShapeSettings& shape) {
  return std::visit(
      [](const auto& own) {
        if constexpr (requires { own.spreads; })
          return std::span<const ShapeSpread>(own.spreads);
        else
          return std::span<const ShapeSpread>();
      },
      shape);
}

}  // namespace parhelion
