// SPDX-License-Identifier: Apache-2.0
#include "crystal/population.h"

#include <span>
#include <stdexcept>

#include "crystal/shapes.h"
#include "crystal/symmetry.h"
#include "math/portable.h"
#include "math/random.h"

namespace parhelion {

namespace {

/// Steps whose multiples fill n dimensions evenly: powers of the root of x^(n + 1) = x + 1 (Roberts 2018), of 2^64, so
/// that no digits are lost.
std::vector<std::uint64_t> evenSteps(std::size_t dimensions) {
  double root = 1.5;
  for (int i = 0; i < 40; ++i) root = portable::exp(portable::log(1.0 + root) / static_cast<double>(dimensions + 1));
  std::vector<std::uint64_t> steps;
  double power = 1.0;
  for (std::size_t d = 0; d < dimensions; ++d) {
    power /= root;
    steps.push_back(static_cast<std::uint64_t>(power * 0x1p64));
  }
  return steps;
}

/// A number in (0, 1) for each step, from a start that the seed draws.
std::vector<double> evenNumbers(std::uint64_t seed, std::uint64_t block, std::span<const std::uint64_t> steps) {
  std::vector<double> numbers;
  for (const std::uint64_t step : steps) {
    const auto dimension = static_cast<std::uint32_t>(numbers.size());
    const auto start = randomWords(seed, RandomPurpose::shape, dimension, std::uint64_t{0});
    numbers.push_back(toUnitInterval(start.first + block * step));
  }
  return numbers;
}

}  // namespace

Population::Population(const PopulationSettings& settings)
    : name_(settings.name),
      weight_(settings.weight),
      mirrorSymmetric_(parhelion::isMirrorSymmetric(settings)),
      fullyRandom_(parhelion::isFullyRandom(settings)),
      shape_(settings.shape),
      orientationSettings_(settings.orientation),
      orientation_(settings.orientation, hasHalfTurn(settings.shape)) {
  if (!(weight_ >= 0.0)) throw std::invalid_argument("a population's weight must not be negative");
  for (const ShapeSpread& spread : spreadsOf(settings.shape)) samplers_.emplace_back(spread);
  steps_ = evenSteps(samplers_.size());
  mesh_ = std::make_shared<CrystalMesh>(meshOf(typicalShape(settings.shape)));
  const auto stretch = std::visit([](const auto& shape) { return stretchOf(shape); }, settings.shape);
  if (!stretch) return;
  if (!mesh_->isPrismatic()) throw std::invalid_argument("only prisms can be stretched");
  aspect_.emplace(*stretch, DensityPer::unit, kThinnestAspect, kLongestAspect);
  if (!(aspect_->sample(0.0) >= kThinnestAspect && aspect_->sample(1.0) <= kLongestAspect))
    throw std::invalid_argument("aspect ratios must lie from 1e-4 to 1e4");
}

std::pair<ShapeSettings, CrystalMesh> Population::crystalOfBlock(std::uint64_t seed, std::uint64_t block) const {
  // Where sides leave nothing of a crystal it is drawn anew, from blocks that no run reaches.
  constexpr std::uint64_t kAttempts = 100, kBeyond = std::uint64_t{1} << 48;
  for (std::uint64_t attempt = 0;; ++attempt) {
    const std::vector<double> numbers = evenNumbers(seed, block + attempt * kBeyond, steps_);
    const ShapeSettings drawn = drawnShape(shape_, samplers_, numbers);
    try {
      return {drawn, meshOf(drawn)};
    } catch (const std::invalid_argument&) {
      if (attempt == kAttempts) throw;
    }
  }
}

std::vector<PopulationSettings> withFixedShapes(const PopulationSettings& settings, int count) {
  if (spreadsOf(settings.shape).empty()) return {settings};
  const Population population(settings);
  std::vector<PopulationSettings> all;
  for (int k = 0; k < count; ++k) {
    PopulationSettings one = settings;
    one.weight /= count;
    one.shape = population.crystalOfBlock(0, static_cast<std::uint64_t>(k)).first;
    const auto fix = [](auto& own) {
      if constexpr (requires { own.spreads; }) own.spreads.clear();
    };
    std::visit(fix, one.shape);
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace parhelion
