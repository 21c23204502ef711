// SPDX-License-Identifier: Apache-2.0
#include "crystal/population.h"

#include <stdexcept>

#include "crystal/shapes.h"
#include "crystal/symmetry.h"

namespace parhelion {

namespace {

AngleDistribution widen(const AspectDistribution& aspect) {
  return std::visit([](const auto& d) -> AngleDistribution { return d; }, aspect);
}

}  // namespace

Population::Population(const PopulationSettings& settings)
    : name_(settings.name),
      weight_(settings.weight),
      mirrorSymmetric_(parhelion::isMirrorSymmetric(settings)),
      fullyRandom_(parhelion::isFullyRandom(settings)),
      orientation_(settings.orientation) {
  if (!(weight_ >= 0.0)) throw std::invalid_argument("a population's weight must not be negative");
  if (const auto* pyramid = std::get_if<PyramidSettings>(&settings.shape)) {
    mesh_ = std::make_shared<CrystalMesh>(hexagonalPyramid(*pyramid));
    return;
  }
  const auto& aspect = std::get<PrismSettings>(settings.shape).aspect;
  const auto* fixed = std::get_if<FixedValue>(&aspect);
  mesh_ = std::make_shared<CrystalMesh>(hexagonalPrism(fixed ? fixed->value : 1.0));
  if (fixed) return;
  aspect_.emplace(widen(aspect), ValueSampler::Measure::linear, kThinnestAspect, kLongestAspect);
  if (!(aspect_->sample(0.0) >= kThinnestAspect && aspect_->sample(1.0) <= kLongestAspect))
    throw std::invalid_argument("aspect ratios must lie from 1e-4 to 1e4");
}

}  // namespace parhelion
