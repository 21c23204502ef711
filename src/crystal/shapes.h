// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "crystal/shapes/prism.h"
#include "crystal/shapes/pyramid.h"

namespace parhelion {

/// The shapes of crystals. Each is a struct of settings in a file of its own, which also says what it is like:
///
///   CrystalMesh meshOf(const Settings&)                            at its only stretch, or at 1 to be stretched
///   std::optional<AngleDistribution> stretchOf(const Settings&)    along c; empty when all crystals are alike
///   bool hasEndsAlike(const Settings&)                             its own mirror image in the plane across c
using ShapeSettings = std::variant<PrismSettings, PyramidSettings>;

}  // namespace parhelion
