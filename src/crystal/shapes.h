// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <variant>

#include "crystal/shape_spread.h"
#include "crystal/shapes/mesh.h"
#include "crystal/shapes/planes.h"
#include "crystal/shapes/prism.h"
#include "crystal/shapes/pyramid.h"
#include "crystal/shapes/rosette.h"

namespace parhelion {

/// The shapes of crystals. Each is a struct of settings in a file of its own, which also says what it is like:
///
///   CrystalMesh meshOf(const Settings&)                            at its only stretch, or at 1 to be stretched
///   std::optional<AngleDistribution> stretchOf(const Settings&)    along c; empty when all crystals are alike
///   bool isHexagonal(const Settings&)                              all turns and mirrors of a regular prism about c
///   bool hasEndsAlike(const Settings&)                             of such: its own mirror image in the plane across c
using ShapeSettings = std::variant<PrismSettings, PyramidSettings, PlanesSettings, MeshSettings, RosetteSettings>;

/// Sets a length of a shape that has it to the fixed value of a distribution, or has it drawn.
void setLength(PrismSettings& prism, const ShapeSpread& spread);
void setLength(PyramidSettings& pyramid, const ShapeSpread& spread);

/// A shape with all that is spread set to the values below which the fractions `u` of what is drawn lie. `samplers` and
/// `u` are by the shape's spreads.
ShapeSettings drawnShape(const ShapeSettings& shape, std::span<const LengthSampler> samplers,
                         std::span<const double> u);

/// The same with one fraction for all that is spread, at which different distributions have different values: a crystal
/// that has the symmetries that the shape has on average.
ShapeSettings typicalShape(const ShapeSettings& shape);

/// Whether the shape is the same, on average, after half a turn about c.
bool hasHalfTurn(const ShapeSettings& shape);

/// What is spread of a shape.
std::span<const ShapeSpread> spreadsOf(const ShapeSettings& shape);

/// The mesh of any of them.
inline CrystalMesh meshOf(const ShapeSettings& shape) {
  return std::visit([](const auto& own) { return meshOf(own); }, shape);
}

}  // namespace parhelion
