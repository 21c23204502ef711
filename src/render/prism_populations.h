// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "beam/ice_light.h"
#include "beam/scatter_scene.h"
#include "beam/sky_integral.h"
#include "scene/scene.h"

namespace parhelion {

// What the integral engine needs to know of a scene.

/// Lengths of a population's prisms, each with its share of the surface; where they are spread, the nodes of so many
/// in a Gauss-Legendre rule over their distribution.
std::vector<PrismShare> prismsOf(const PopulationSettings& settings, int count);

/// How many lengths are enough for a picture's error.
int aspectsFor(double error);

/// The indices that a scene's light meets, by its energy as profiles count it.
IceLight iceLightOf(const Scene& scene);

/// What light counts for: its colour, or its energy, whatever its colour, as profiles and maps have it.
enum class Counted { colour, energy };

/// Light by a number in (0, 1): its index and its colour, which is grey where its energy counts.
class IndexSampler {
 public:
  IndexSampler(const Scene& scene, Counted counted);

  IndexColour at(double u) const;

  /// All light there is, each of its lines as likely; empty if it is continuous.
  const std::vector<IndexColour>& lines() const { return lines_; }

  /// Indices at which light is to be traced: all there are, or three among which the others lie.
  std::vector<double> nodes() const;

 private:
  std::vector<IndexColour> lines_;  // alike likely
  std::vector<IndexColour> continuous_;
};

/// Why crystals of a population cannot be integrated, as a predicate: "has crystals that are no prisms"; empty if they
/// can. `inProfile`: for a profile, which looks at random orientations only.
std::string objectionTo(const Scene& scene, const PopulationSettings& population, bool inProfile);

}  // namespace parhelion
