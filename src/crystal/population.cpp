// SPDX-License-Identifier: Apache-2.0
#include "crystal/population.h"

#include <stdexcept>

#include "crystal/shapes.h"
#include "crystal/symmetry.h"

namespace parhelion {

Population::Population(const PopulationSettings& settings)
    : name_(settings.name),
      weight_(settings.weight),
      mirrorSymmetric_(parhelion::isMirrorSymmetric(settings)),
      fullyRandom_(parhelion::isFullyRandom(settings)),
      orientationSettings_(settings.orientation),
      orientation_(settings.orientation) {
  if (!(weight_ >= 0.0)) throw std::invalid_argument("a population's weight must not be negative");
  mesh_ = std::visit([](const auto& shape) { return std::make_shared<CrystalMesh>(meshOf(shape)); }, settings.shape);
  const auto stretch = std::visit([](const auto& shape) { return stretchOf(shape); }, settings.shape);
  if (!stretch) return;
  if (!mesh_->isPrismatic()) throw std::invalid_argument("only prisms can be stretched");
  aspect_.emplace(*stretch, DensityPer::unit, kThinnestAspect, kLongestAspect);
  if (!(aspect_->sample(0.0) >= kThinnestAspect && aspect_->sample(1.0) <= kLongestAspect))
    throw std::invalid_argument("aspect ratios must lie from 1e-4 to 1e4");
}

}  // namespace parhelion
