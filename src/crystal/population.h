// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "crystal/crystal.h"
#include "crystal/orientation.h"

namespace parhelion {

/// The same crystals as so many populations of one shape each; itself where no shapes are spread.
std::vector<PopulationSettings> withFixedShapes(const PopulationSettings& settings, int count);

/// Crystals of one kind, ready to be drawn from.
class Population {
 public:
  /// Throws std::invalid_argument when the settings describe no crystal.
  explicit Population(const PopulationSettings& settings);

  const std::string& name() const { return name_; }
  double weight() const { return weight_; }
  bool isMirrorSymmetric() const { return mirrorSymmetric_; }
  bool isFullyRandom() const { return fullyRandom_; }

  /// Its crystal; a typical one where shapes are spread. That has all faces which its crystals may have, some of them
  /// without area, and the symmetries that they have on average.
  const CrystalMesh& mesh() const { return *mesh_; }

  /// Whether more than the length along c differs from crystal to crystal.
  bool isSpread() const { return !samplers_.empty(); }

  /// The crystal of a block of rays where shapes are spread. Any few hundred blocks in a row fill the distributions
  /// evenly. Faces are in the order of mesh(). Throws std::invalid_argument where hardly any crystal encloses anything.
  std::pair<ShapeSettings, CrystalMesh> crystalOfBlock(std::uint64_t seed, std::uint64_t block) const;

  /// What the mesh is stretched by along c, spread over shares of surface; none when all crystals are alike.
  const AngleQuantile* stretch() const { return aspect_ ? &aspect_->quantile() : nullptr; }

  /// How the crystals stand, and the same for lanes.
  const OrientationSettings& orientation() const { return orientationSettings_; }
  const OrientationQuantile& orientationQuantile() const { return orientation_.quantile(); }

 private:
  std::string name_;
  double weight_;
  bool mirrorSymmetric_, fullyRandom_;       // crystal/symmetry.h
  std::shared_ptr<const CrystalMesh> mesh_;  // at its only aspect ratio, or at aspect 1 to be stretched
  std::optional<ValueSampler> aspect_;       // when it is spread
  ShapeSettings shape_;
  std::vector<LengthSampler> samplers_;  // of what is spread of the shape
  std::vector<std::uint64_t> steps_;     // from block to block, of 2^64, for each of them
  OrientationSettings orientationSettings_;
  OrientationSampler orientation_;
};

}  // namespace parhelion
